#!/usr/bin/env python3
"""A round castle tower: battlements, a turret with a pointed roof, a door: examples/tower.sinew."""
import math

from skeleton import Skeleton

TOP = 9.0        # height of the platform
RADIUS = 1.35    # of the tower
MERLONS = 12
WALL = (2.01, 0.5, 0.8)   # of the battlements: radius of the middle, thickness, height of the wall
MERLON = (0.52, 0.55)     # width and height above the wall


def battlements(s):
    """A ring of cubes with bent beams between them, and a beam upwards on each: a merlon."""
    radius, thick, high = WALL
    ids = []
    between = []
    for i in range(MERLONS):
        a = 2 * math.pi * i / MERLONS
        z = TOP + 0.1

        def at(angle, r=radius, height=z):
            return (r * math.cos(a + angle), r * math.sin(a + angle), height)

        turned = [0, 0, round(math.sin(a / 2), 12), round(math.cos(a / 2), 12)]
        cube = s.node(None, at(0), thick / 2, f"wall {i + 1}", type="cube", size=[thick, MERLON[0], high], rotation=turned)
        s.node(cube, at(0, height=z + high / 2 + MERLON[1]), thick / 2, f"merlon {i + 1}", type="hemisphere", section="rectangular",
               scale=[1, round(MERLON[0] / thick, 4)], roll=round(math.degrees(a), 6))
        bends = []
        for share in (0.33, 0.67):
            bends.append(s.node(bends[-1] if bends else cube, at(share * 2 * math.pi / MERLONS), thick / 2,
                                section="rectangular", scale=[1, round(high / thick, 4)]))
        ids.append(cube)
        between.append(bends[-1])
    for i in range(MERLONS):
        s.link(between[i], ids[(i + 1) % MERLONS])


def main():
    s = Skeleton()
    foot = s.node(None, (0, 0, 0), 1.75, "foot", type="hemisphere")
    plinth = s.node(foot, (0, 0, 0.35), 1.7, "plinth", joint="sharp")
    base = s.node(plinth, (0, 0, 0.36), 1.5, "wall", joint="sharp")
    door = s.node(base, (0, 0, 2.25), 1.45, "at the door")
    s.node(door, (0, -1.45 - 0.75, 2.05), 0.52, "door", type="negative", scale=[1, 1.9], joint="sharp")
    window = s.node(door, (0, 0, 6.3), 1.4, "at the window")
    s.node(window, (0, -1.4 - 0.5, 6.3), 0.2, "window", type="negative", scale=[1, 2.6], joint="sharp")
    top = s.node(window, (0, 0, TOP - 0.9), RADIUS, "below the corbels", joint="sharp")
    out = s.node(top, (0, 0, TOP - 0.5), 1.75, "corbels", joint="sharp")
    wide = s.node(out, (0, 0, TOP), 1.75, "platform", joint="sharp")
    turret = s.node(wide, (0, 0, TOP + 0.01), 0.95, "turret", joint="sharp")
    eaves = s.node(turret, (0, 0, TOP + 2), 0.95, "below the roof", joint="sharp")
    roof = s.node(eaves, (0, 0, TOP + 2.01), 1.3, "eaves", joint="sharp")
    s.node(roof, (0, 0, TOP + 5), 0.3, "roof", type="cone")
    battlements(s)
    s.save("tower")


if __name__ == "__main__":
    main()
