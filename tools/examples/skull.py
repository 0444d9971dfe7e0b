#!/usr/bin/env python3
"""A skull, its sockets, nose and mouth pressed in by negative leaves, in decimetres: examples/skull.sinew."""
from skeleton import Skeleton


def main():
    s = Skeleton(unit="dm", mirrored=True)
    brain = s.node(None, (0, 0, 0), 1, "braincase", type="ball", scale=[0.78, 0.97, 0.85])
    s.node(brain, (0.37, -1.12, -0.14), 0.2, "eye socket", type="negative", scale=[1.15, 1])
    s.node(brain, (0, -1.08, -0.44), 0.085, "nose", type="negative", scale=[0.85, 1.3])
    palate = s.node(brain, (0, -0.44, -0.84), 0.3, "palate")
    jaw = s.node(palate, (0, -0.52, -1.12), 0.4, "jaws", scale=[1, 0.85])
    s.node(jaw, (0, -1.12, -1.12), 0.05, "mouth", type="negative", scale=[4.4, 1])
    s.save("skull")


if __name__ == "__main__":
    main()
