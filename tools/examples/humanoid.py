#!/usr/bin/env python3
"""A standing person of 1.80 m, seven and a half heads tall, arms lowered by half: examples/humanoid.sinew."""
import math

from skeleton import Skeleton


def trunk(s):
    """Spine and head, on the plane of symmetry; returns the pelvis and the collar."""
    pelvis = s.node(None, (0, 0.005, 0.985), 0.112, "pelvis")
    *_, collar = s.chain(pelvis, [(0, -0.01, 1.12, 0.106), (0, -0.005, 1.27, 0.132), (0, 0.015, 1.4, 0.112)], "spine",
                         scale=[1.14, 0.86])
    neck = s.node(collar, (0, 0.022, 1.54), 0.057, "neck")
    s.chain(neck, [(0, -0.018, 1.622, 0.065), (0, 0.004, 1.714, 0.088)], "head", scale=[0.92, 1.06])
    return pelvis, collar


def leg(s, pelvis):
    *_, ankle = s.chain(pelvis, [(0.09, 0.012, 0.87, 0.09), (0.1, -0.006, 0.71, 0.078), (0.104, -0.004, 0.5, 0.056),
                                 (0.106, 0.016, 0.375, 0.06), (0.108, 0.02, 0.2, 0.041), (0.11, 0.022, 0.085, 0.04)], "leg")
    s.node(ankle, (0.112, 0.075, 0.034), 0.034, "heel")
    s.chain(ankle, [(0.122, -0.07, 0.038, 0.037), (0.13, -0.135, 0.026, 0.026)], "foot", scale=[1.25, 0.85])


class Arm:
    """The lowered arm: `along` it, and `forward`, where the thumb is."""
    along = (math.cos(math.radians(48)), 0.0, -math.sin(math.radians(48)))
    forward = (0.0, -1.0, 0.0)

    def __init__(self, shoulder):
        self.shoulder = shoulder

    def at(self, reach, side=0.0):
        return tuple(p + reach * a + side * f for p, a, f in zip(self.shoulder, self.along, self.forward))

    def build(self, s, collar):
        profile = [(0.0, 0.0, 0.07), (0.13, 0.0, 0.052), (0.29, 0.0, 0.041), (0.36, 0.004, 0.043), (0.53, 0.016, 0.028)]
        *_, wrist = s.chain(collar, [(*self.at(reach, side), r) for reach, side, r in profile], "arm")
        half = math.radians(24)  # the frame of the palm: x along the arm, y to the back, z off its back
        palm = s.node(wrist, self.at(0.592, 0.02), 0.034, "palm", type="ball", scale=[1.3, 1.32, 0.6],
                      rotation=[0, round(math.sin(half), 6), 0, round(math.cos(half), 6)])
        for name, degrees, length in (("index", 44, 0.082), ("middle", 14, 0.09), ("ring", -16, 0.084), ("little", -47, 0.068)):
            self.finger(s, palm, name, degrees, length)
        s.chain(palm, [(*self.at(0.602, 0.066), 0.0125), (*self.at(0.632, 0.088), 0.0105), (*self.at(0.66, 0.096), 0.009)], "thumb")

    def finger(self, s, palm, name, degrees, length):
        """Leaves the palm fanned out, and runs nearly along the arm from the knuckle on."""
        c, f = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        reach, side, lean = 0.592 + 0.056 * c, 0.02 + 0.05 * f, 0.25 * f
        points = [(*self.at(reach + (length - 0.008) * t, side + lean * length * t), r)
                  for t, r in ((0, 0.0092), (0.5, 0.0088), (1, 0.0076))]
        s.chain(palm, points, name)


def main():
    s = Skeleton(mirrored=True)
    pelvis, collar = trunk(s)
    leg(s, pelvis)
    Arm((0.19, 0.015, 1.425)).build(s, collar)
    s.save("humanoid")


if __name__ == "__main__":
    main()
