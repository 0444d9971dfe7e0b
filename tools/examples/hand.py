#!/usr/bin/env python3
"""A relaxed right hand of 19 cm, palm down, in centimetres: examples/hand.sinew."""
from skeleton import Skeleton

# Joints from the knuckle to the tip: x towards the thumb, -y along the hand, z up, and the radius.
FINGERS = {
    "index": [(3.5, -9.3, 0.3, 0.86), (4.15, -12.5, 0.45, 0.84), (4.5, -14.7, -0.1, 0.78), (4.65, -16.4, -0.95, 0.66)],
    "middle": [(0.95, -10.3, 0.5, 0.88), (1.15, -13.8, 0.7, 0.86), (1.25, -16.3, 0.1, 0.8), (1.3, -18.1, -0.8, 0.67)],
    "ring": [(-1.6, -9.9, 0.35, 0.84), (-2.0, -13.2, 0.45, 0.82), (-2.25, -15.5, -0.2, 0.76), (-2.4, -17.2, -1.05, 0.64)],
    "little": [(-3.85, -8.2, 0.0, 0.76), (-4.95, -10.5, 0.0, 0.72), (-5.6, -12.1, -0.5, 0.66), (-6.05, -13.3, -1.15, 0.56)],
}
THUMB = [(4.6, -4.9, -0.6, 1.1), (5.9, -6.9, -1.3, 1.02), (6.9, -8.9, -1.6, 0.95), (7.5, -10.6, -1.85, 0.76)]


def main():
    s = Skeleton(unit="cm")
    forearm = s.node(None, (0.4, 12.5, 0.1), 3.2, "forearm", type="hemisphere")
    *_, wrist = s.chain(forearm, [(0.2, 7.0, 0.05, 2.85), (0, 3.6, 0, 2.1), (0, 0.9, 0, 1.75)], "wrist", scale=[1.14, 0.88])
    palm = s.node(wrist, (0, -4.9, 0), 2.2, "palm", type="ball", scale=[1.74, 2.05, 0.76], rotation=[0, 0, 0, 1])
    for name, joints in FINGERS.items():
        s.chain(palm, joints, name)
    s.chain(palm, THUMB, "thumb")
    s.save("hand")


if __name__ == "__main__":
    main()
