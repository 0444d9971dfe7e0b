#!/usr/bin/env python3
"""A relaxed right hand of 19 cm, palm down, in centimetres: examples/hand.sinew."""
from skeleton import Skeleton

# Joints from the knuckle to the tip: x towards the thumb, -y along the hand, z up, and the radius.
FINGERS = {
    "index": [(3.2, -9.2, 0.3, 0.98), (3.75, -12.6, 0.45, 0.86), (4.05, -14.8, -0.1, 0.78), (4.2, -16.5, -0.95, 0.66)],
    "middle": [(0.85, -9.9, 0.5, 1.0), (0.95, -13.7, 0.7, 0.88), (1.05, -16.2, 0.1, 0.8), (1.1, -18.0, -0.8, 0.67)],
    "ring": [(-1.4, -9.3, 0.35, 0.95), (-2.0, -12.9, 0.45, 0.83), (-2.25, -15.3, -0.2, 0.76), (-2.4, -17.0, -1.05, 0.64)],
    "little": [(-3.4, -7.8, 0.0, 0.85), (-4.7, -10.3, 0.0, 0.72), (-5.35, -11.9, -0.5, 0.66), (-5.8, -13.1, -1.15, 0.56)],
}
THUMB = [(2.9, -3.2, -1.0, 1.3), (5.0, -6.2, -1.6, 1.1), (6.3, -8.5, -1.85, 0.98), (6.9, -10.3, -2.05, 0.78)]


def main():
    s = Skeleton(unit="cm")
    forearm = s.node(None, (0.4, 10.5, 0.1), 3.1, "forearm")
    *_, carpus = s.chain(forearm, [(0.2, 5.0, 0.0, 2.7), (0, 2.0, 0, 2.3), (0, -1.6, 0, 1.9)], "wrist")
    radial = s.node(carpus, (1.95, -5.3, 0.1), 1.5, "radial palm")
    ulnar = s.node(carpus, (-2.0, -4.9, 0.0), 1.45, "ulnar palm")
    for palm, names in ((radial, ("index", "middle")), (ulnar, ("ring", "little"))):
        for name in names:
            s.chain(palm, FINGERS[name], name)
    s.chain(carpus, THUMB, "thumb")
    s.save("hand")


if __name__ == "__main__":
    main()
