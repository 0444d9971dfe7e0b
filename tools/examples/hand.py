#!/usr/bin/env python3
"""A relaxed right hand of 19 cm, palm down, in centimetres: examples/hand.sinew."""
from skeleton import Skeleton

# Finger: the part of the palm it leaves, and its joints from the knuckle to the tip (x to the thumb, -y along the hand, z up).
FINGERS = {
    "index": ("radial", [(2.9, -9.3, 0.35, 0.98), (3.5, -12.6, 0.35, 0.86), (3.75, -14.8, -0.2, 0.78), (3.85, -16.5, -1.0, 0.66)]),
    "middle": ("radial", [(0.75, -9.8, 0.55, 1.0), (0.9, -13.6, 0.6, 0.88), (0.95, -16.1, 0.0, 0.8), (0.95, -17.9, -0.9, 0.67)]),
    "ring": ("ulnar", [(-1.45, -9.2, 0.4, 0.95), (-1.85, -12.8, 0.4, 0.83), (-2.0, -15.2, -0.25, 0.76), (-2.05, -16.9, -1.1, 0.64)]),
    "little": ("ulnar", [(-3.45, -8.0, 0.05, 0.85), (-4.35, -10.6, 0.0, 0.72), (-4.75, -12.2, -0.5, 0.66), (-4.95, -13.5, -1.1, 0.56)]),
}


def main():
    s = Skeleton(unit="cm")
    forearm = s.node(None, (0.3, 9.0, 0.0), 3.0, "forearm")
    *_, carpus = s.chain(forearm, [(0.15, 4.5, 0.0, 2.6), (0, 1.2, 0, 2.3), (0, -1.8, 0, 2.1)], "wrist")
    palm = {"radial": s.node(carpus, (1.55, -5.6, 0.05), 1.65, "radial palm"),
            "ulnar": s.node(carpus, (-1.75, -5.2, -0.05), 1.6, "ulnar palm")}
    for name, (part, joints) in FINGERS.items():
        s.chain(palm[part], joints, name)
    s.chain(carpus, [(2.9, -3.2, -1.0, 1.45), (4.9, -6.1, -1.7, 1.12), (6.1, -8.5, -1.9, 0.98), (6.7, -10.4, -2.1, 0.78)], "thumb")
    s.save("hand")


if __name__ == "__main__":
    main()
