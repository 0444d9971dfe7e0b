#!/usr/bin/env python3
"""A garden chair of slats on square posts: examples/chair.sinew."""
import math

from skeleton import Skeleton

SIDE = 0.21        # the posts stand so far from the middle
RAIL = 0.045       # thickness of posts and rails
SEAT = 0.43        # height of the rails
LEAN = 10          # degrees that the back leans
SLATS = [-0.125, -0.02, 0.085]  # along the rails
DEEP, THIN = 0.085, 0.022       # of a slat


def beam(s, parent, position, width, height, name=None, **keys):
    """A rectangular section, width along the frame's x and height along its y."""
    return s.node(parent, position, height / 2, name, section="rectangular", scale=[round(width / height, 4), 1], **keys)


def slat(s, cube, position, high, deep, name):
    """From a cube to its twin on the other side, as a beam that goes on flush from its face."""
    x, y, z = position
    beam(s, beam(s, cube, (x - RAIL, y, z), deep, high, name), (0, y, z), deep, high, name)


def main():
    s = Skeleton(mirrored=True)
    cubes = [("front post", -0.22, RAIL)] + [(f"rail {i + 1}", y, DEEP) for i, y in enumerate(SLATS)] + [("back post", 0.18, RAIL)]
    parent = None
    ids = []
    for i, (name, y, deep) in enumerate(cubes):
        if parent is not None:
            before = cubes[i - 1]
            gap = ((before[1] + before[2] / 2) + (y - deep / 2)) / 2
            parent = beam(s, parent, (SIDE, gap, SEAT), RAIL, RAIL)
        parent = s.node(parent, (SIDE, y, SEAT), RAIL / 2, name, type="cube", size=[RAIL, deep, RAIL])
        ids.append((parent, name, y, deep))
    for cube, name, y, deep in ids[:-1]:
        slat(s, cube, (SIDE, y, SEAT), RAIL, deep, "apron" if "post" in name else "slat")
    for cube, name, y, deep in (ids[0], ids[-1]):
        beam(s, cube, (SIDE, y, 0), RAIL, RAIL, name.replace("post", "leg"), type="hemisphere")

    # The back leans: its cubes are turned about x.
    turned = [round(-math.sin(math.radians(LEAN) / 2), 9), 0, 0, round(math.cos(math.radians(LEAN) / 2), 9)]

    def on_back(height):
        return (SIDE, 0.18 + math.sin(math.radians(LEAN)) * height, SEAT + RAIL / 2 + math.cos(math.radians(LEAN)) * height)

    parent = beam(s, ids[-1][0], on_back(0.03), RAIL, RAIL, "back post")
    for i, height in enumerate((0.16, 0.27, 0.38)):
        cube = s.node(parent, on_back(height), RAIL / 2, f"back {i + 1}", type="cube", size=[RAIL, RAIL, 0.07], rotation=turned)
        x, y, z = on_back(height)
        beam(s, beam(s, cube, (x - RAIL, y, z), RAIL, 0.07, "back slat", roll=LEAN), (0, y, z), RAIL, 0.07, "back slat", roll=LEAN)
        parent = beam(s, cube, on_back(height + 0.055), RAIL, RAIL, **({} if i < 2 else {"type": "hemisphere"}))
    s.save("chair")


if __name__ == "__main__":
    main()
