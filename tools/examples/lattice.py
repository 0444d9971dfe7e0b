#!/usr/bin/env python3
"""A block of a body-centred cubic lattice, three cells a side with a frame round it, as it is printed to save weight:
examples/lattice.sinew. 91 nodes and 252 struts close 162 cycles."""
import itertools

from skeleton import Skeleton

CELLS, SIZE = 3, 10.0


def main():
    s = Skeleton(unit="mm")
    corners, bones = {}, []
    for at in itertools.product(range(CELLS + 1), repeat=3):
        corners[at] = None
    for at in corners:
        for axis in range(3):
            step = tuple(x + (i == axis) for i, x in enumerate(at))
            on_edge = sum(x in (0, CELLS) for i, x in enumerate(at) if i != axis) == 2
            if step in corners and on_edge:
                bones.append((at, step))
    for cell in itertools.product(range(CELLS), repeat=3):
        middle = tuple(x + 0.5 for x in cell)
        for offset in itertools.product((0, 1), repeat=3):
            bones.append((middle, tuple(x + o for x, o in zip(cell, offset))))
    build(s, bones)
    s.save("lattice")


def build(s, bones):
    """Makes the first bone to a new node its parent bone, and every other one a link."""
    neighbours = {}
    for a, b in bones:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    start = min(neighbours)
    ids = {start: add(s, None, start)}
    queue, done = [start], set()
    while queue:
        at = queue.pop(0)
        for other in neighbours[at]:
            bone = frozenset((at, other))
            if bone in done:
                continue
            done.add(bone)
            if other in ids:
                s.link(ids[at], ids[other])
            else:
                ids[other] = add(s, ids[at], other)
                queue.append(other)


def add(s, parent, at):
    x, y, z = (SIZE * (c - CELLS / 2) for c in at)
    return s.node(parent, (x, y, z + SIZE * CELLS / 2), 1.0 if at[0] != int(at[0]) else 1.1)


if __name__ == "__main__":
    main()
