#!/usr/bin/env python3
"""A worker ant of 8 mm: head with jaws and elbowed feelers, six legs, waist and abdomen: examples/ant.sinew."""
from skeleton import Skeleton


def main():
    s = Skeleton(unit="mm", mirrored=True)
    thorax = s.node(None, (0, -0.1, 2.0), 0.5, "thorax")
    back = s.node(thorax, (0, 0.95, 1.95), 0.42, "back")
    s.chain(back, [(0, 1.75, 1.85, 0.16), (0, 2.2, 2.05, 0.24), (0, 2.75, 2.05, 0.3), (0, 3.6, 2.2, 0.85), (0, 4.6, 2.0, 0.82),
                   (0, 5.55, 1.6, 0.35)], "abdomen")
    pronotum = s.node(thorax, (0, -1.0, 2.1), 0.42, "pronotum")
    *_, head = s.chain(pronotum, [(0, -1.65, 2.2, 0.22), (0, -2.4, 2.3, 0.68)], "neck")
    s.chain(head, [(0, -3.3, 2.0, 0.42)], "face")
    face = len(s.nodes)
    s.chain(face, [(0.42, -3.85, 1.72, 0.16), (0.36, -4.35, 1.55, 0.1), (0.08, -4.65, 1.5, 0.05)], "jaw", type="cone")
    s.chain(head, [(0.62, -3.1, 2.75, 0.1), (1.35, -3.6, 3.65, 0.085), (1.65, -4.5, 3.35, 0.085), (1.75, -5.4, 2.75, 0.09)], "feeler")
    legs = {"foreleg": (pronotum, [(0.75, -1.25, 1.75), (2.1, -2.2, 2.45), (2.9, -3.2, 0.9), (3.2, -3.85, 0.1)]),
            "midleg": (thorax, [(0.8, -0.1, 1.65), (2.4, -0.2, 2.6), (3.6, -0.1, 0.9), (4.3, 0.1, 0.1)]),
            "hindleg": (back, [(0.72, 1.15, 1.6), (2.1, 2.1, 2.7), (3.2, 3.4, 0.95), (3.7, 4.3, 0.1)])}
    for name, (parent, joints) in legs.items():
        s.chain(parent, [(*p, r) for p, r in zip(joints, (0.22, 0.15, 0.11, 0.08))], name)
    s.save("ant")


if __name__ == "__main__":
    main()
