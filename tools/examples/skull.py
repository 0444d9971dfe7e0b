#!/usr/bin/env python3
"""A skull, its sockets, nose and mouth pressed in by negative leaves, in decimetres: examples/skull.sinew."""
from skeleton import Skeleton


def main():
    s = Skeleton(unit="dm", mirrored=True)
    brain = s.node(None, (0, 0, 0), 1, "braincase", type="ball", scale=[0.78, 1.0, 0.84])
    s.node(brain, (0.35, -1.06, -0.2), 0.22, "eye socket", type="negative", scale=[1.1, 1])
    face = s.node(brain, (0, -0.56, -0.86), 0.38, "face", scale=[1.1, 0.95])
    s.node(face, (0, -1.1, -0.82), 0.08, "nose", type="negative", scale=[0.8, 1.5])
    jaw = s.node(face, (0, -0.6, -1.34), 0.33, "jaws", scale=[1.1, 0.9])
    s.node(jaw, (0, -1.04, -1.33), 0.05, "mouth", type="negative", scale=[4.2, 1])
    s.save("skull")


if __name__ == "__main__":
    main()
