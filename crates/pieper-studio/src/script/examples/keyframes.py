# Makes a motion of keyframes: play it with the space bar.
import mathmodel

low = [pair[0] for pair in mathmodel.limits()]
high = [pair[1] for pair in mathmodel.limits()]
for second, part in enumerate([0.5, 0.62, 0.4, 0.5]):
    mathmodel.joints([a + part * (b - a) for a, b in zip(low, high)])
    mathmodel.keyframe(2 * second)
