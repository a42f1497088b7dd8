# The example of the ABB paper, unchanged in kind: joints 1, 2 and 4 over 70 steps of one degree.
import mathmodel

def checkScript():
    return True

class CRoboControl:
    def getRefreshRate():
        return 20

    def RunScript():
        for i in range(70):
            mathmodel.chain1(i)
            mathmodel.chain2(i + 2)
            mathmodel.chain4(i)
            mathmodel.pause(20)
