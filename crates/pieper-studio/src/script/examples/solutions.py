# Shows every solution for the present pose, one after the other.
import mathmodel

found = mathmodel.solutions()
print(len(found), "solutions")
for values in found:
    print(["%.1f" % value for value in values])
    mathmodel.joints(values)
    mathmodel.pause(800)
