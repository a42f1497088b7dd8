# The tool draws a circle without turning.
import math
import mathmodel

x, y, z, roll, pitch, yaw = mathmodel.tool()
radius = 60
for step in range(121):
    angle = 2 * math.pi * step / 120
    mathmodel.move(x + radius * (math.cos(angle) - 1), y + radius * math.sin(angle), z)
    mathmodel.pause(25)
print("back at", mathmodel.tool()[:3])
