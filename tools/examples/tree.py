#!/usr/bin/env python3
"""A broad-leaved tree in winter, 8 m high, with roots: examples/tree.sinew.

The branches fork by Leonardo's rule (the cross-sections of the children add up to the parent's), turn towards the light
and away from each other. The numbers are drawn from a fixed sequence, so that the tree is always the same one.
"""
import math

from skeleton import Skeleton, turn, unit


class Sequence:
    """Numbers between two bounds (a linear congruential generator: the same on every machine)."""

    def __init__(self, seed):
        self.state = seed

    def between(self, low, high):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2 ** 64
        return low + (high - low) * (self.state >> 11) / 2 ** 53


def across(v):
    """A unit vector at right angles to v."""
    x, y, z = v
    return unit((y, -x, 0)) if abs(z) < 0.9 else unit((0, z, -y))


def limb(s, numbers, parent, position, direction, radius, length):
    """A run of segments that bends a little, then a fork of two or three; ends where it is thin."""
    for _ in range(2):
        direction = unit((direction[0] + numbers.between(-0.16, 0.16), direction[1] + numbers.between(-0.16, 0.16),
                          direction[2] + numbers.between(0.0, 0.14)))
        position = tuple(p + length / 2 * d for p, d in zip(position, direction))
        radius *= 0.95
        parent = s.node(parent, position, radius)
    if radius < 0.022:
        tip = tuple(p + 0.75 * length * d for p, d in zip(position, direction))
        s.node(parent, tip, radius * 0.4, type="cone")
        return
    shares = (0.62, 0.38) if radius < 0.09 else (0.44, 0.32, 0.24)
    azimuth = numbers.between(0, 360)
    for i, share in enumerate(shares):
        side = turn(across(direction), direction, azimuth + 360 / len(shares) * i + numbers.between(-15, 15))
        lean = math.radians(numbers.between(24, 32) + 26 * (1 - share))
        heading = unit(tuple(d * math.cos(lean) + e * math.sin(lean) for d, e in zip(direction, side)))
        limb(s, numbers, parent, position, heading, radius * math.sqrt(share), length * (0.72 + 0.24 * share))


def main():
    s, numbers = Skeleton(), Sequence(17)
    base = s.node(None, (0, 0, 0.25), 0.34, "base")
    for i in range(5):
        a = math.radians(72 * i + numbers.between(-14, 14))
        reach = numbers.between(0.85, 1.2)
        s.chain(base, [(0.55 * math.cos(a), 0.55 * math.sin(a), 0.13, 0.15),
                       (reach * math.cos(a + 0.15), reach * math.sin(a + 0.15), 0.07, 0.085),
                       (1.6 * reach * math.cos(a + 0.1), 1.6 * reach * math.sin(a + 0.1), 0.0, 0.03)], f"root {i + 1}", type="cone")
    trunk = s.chain(base, [(0.04, 0.02, 0.85, 0.25), (0.02, -0.05, 1.5, 0.225)], "trunk")
    limb(s, numbers, trunk[-1], s.position(trunk[-1]), (0, 0, 1), 0.22, 1.1)
    s.save("tree")


if __name__ == "__main__":
    main()
