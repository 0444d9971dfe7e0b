#!/usr/bin/env python3
"""A human skull, sockets and mouth pressed in by negative leaves, in units of half its height: examples/skull.sinew."""
from skeleton import Skeleton


def main():
    s = Skeleton(unit="", mirrored=True)
    brain = s.node(None, (0, 0.12, 0.25), 0.8, "braincase", type="ball", scale=[0.92, 1.15, 0.95])
    face = s.node(brain, (0, -0.42, -0.35), 0.52, "face", scale=[1.05, 0.85])
    chin = s.node(face, (0, -0.5, -0.95), 0.36, "jaw", scale=[1.1, 0.9])
    s.node(brain, (0.36, -1.1, -0.02), 0.2, "eye socket", type="negative", scale=[1.15, 1])
    s.node(face, (0, -1.12, -0.38), 0.11, "nose", type="negative", scale=[0.9, 1.5])
    s.node(chin, (0, -1.0, -0.85), 0.07, "mouth", type="negative", scale=[3.2, 1])
    s.save("skull")


if __name__ == "__main__":
    main()
