#!/usr/bin/env python3
"""A capillary bed, in tenths of a millimetre: an artery forks five times, the finest vessels cross to the other side and
gather in a vein. Radii follow Murray's law (the cubes of the branches' radii add up to the trunk's):
examples/vessels.sinew."""
import math

from skeleton import Skeleton

LEVELS = 5
ALONG = [15.5, 11.5, 8.3, 5.7, 3.5, 1.5]  # distance of the forks of each level from the middle of the bed
SPREAD = [4.9, 4.2, 2.4, 2.1, 1.2] # how far the branches of a fork lie apart, half


def meander(k, size):
    """A small displacement across the vessel; the formula only has to look unplanned."""
    return size * math.sin(2.4 * k + 0.7), size * math.cos(3.1 * k)


class Tree:
    """The vessels of one side: side = -1 for the artery, which comes from the left, 1 for the vein."""

    def __init__(self, s, side, radius, name):
        self.s, self.side, self.name, self.tips, self.bones = s, side, name, [], 0
        root = s.node(None, (side * (ALONG[0] + 5), 0.6 * side, -1.2), radius, name)
        first = self.vessel(root, (side * ALONG[0], 0, 0), radius)
        self.fork(first, 0.0, 0.0, radius, 0)

    def vessel(self, parent, end, radius):
        """A bone with a bend in its middle."""
        start = self.s.position(parent)
        self.bones += 1
        dy, dz = meander(self.bones + 5 * self.side, 0.3)
        x, y, z = (0.5 * (a + b) for a, b in zip(start, end))
        return self.s.chain(parent, [(x, y + dy, z + dz, radius), (*end, radius)])[-1]

    def fork(self, parent, y, z, radius, level):
        if level == LEVELS:
            self.tips.append(parent)
            return
        for sign in (-1, 1):
            apart = sign * SPREAD[level]
            v, w = (y, z + apart) if level % 2 == 0 else (y + apart, z)
            share = 0.5 + 0.12 * sign * (-1) ** level
            dy, dz = meander(3 * level + sign, 0.25)
            end = (self.side * ALONG[level + 1], v + dy, w + dz)
            thinner = radius * share ** (1 / 3)
            self.fork(self.vessel(parent, end, thinner), v, w, thinner, level + 1)


def main():
    s = Skeleton(unit="0.1 mm")
    artery, vein = Tree(s, -1, 0.95, "artery"), Tree(s, 1, 1.1, "vein")
    for k, (a, b) in enumerate(zip(artery.tips, vein.tips)):
        p, q = s.position(a), s.position(b)
        dy, dz = meander(k, 0.45)
        middle = s.node(a, (0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]) + dy, 0.5 * (p[2] + q[2]) + dz), 0.22, f"capillary {k + 1}")
        s.link(middle, b)
    s.save("vessels")


if __name__ == "__main__":
    main()
