#!/usr/bin/env python3
"""A dragon, 9 m from snout to tail: wings half raised, horns, jaw, claws, a crest and an arrow at the end of the tail:
examples/dragon.sinew."""
import math

from skeleton import Skeleton, cross, mix, roll_towards, spline, unit


def trunk(s):
    chest = s.node(None, (0, -0.75, 1.75), 0.52, "chest")
    *_, rump = s.chain(chest, [(0, 0.15, 1.62, 0.5), (0, 1.05, 1.6, 0.42)], "back")
    curve = [(0, 1.75, 1.5, 0.3), (0, 2.6, 1.05, 0.23), (0, 3.5, 0.5, 0.17), (0, 4.4, 0.28, 0.125),
             (0, 5.2, 0.5, 0.09), (0, 5.8, 1.0, 0.065)]
    tail = s.chain(rump, spline(curve, 10), "tail")
    x, y, z = s.position(tail[-1])
    arrow = s.node(tail[-1], (x, y + 0.14, z + 0.3), 0.065, "arrow")
    s.node(arrow, (x, y + 0.3, z + 0.85), 0.05, "arrow tip", type="cone")
    s.node(arrow, (x + 0.36, y + 0.06, z + 0.2), 0.05, "arrow barb", type="cone")
    return chest, rump


def head(s, chest):
    curve = [(0, -1.45, 2.2, 0.34), (0, -1.75, 2.85, 0.25), (0, -1.85, 3.4, 0.21), (0, -2.25, 3.85, 0.21)]
    *_, skull = s.chain(chest, spline(curve, 6), "neck")
    s.chain(skull, [(0, -2.75, 3.86, 0.185), (0, -3.15, 3.74, 0.13), (0, -3.42, 3.68, 0.1)], "snout")
    s.chain(skull, [(0, -2.68, 3.56, 0.105), (0, -3.05, 3.4, 0.085), (0, -3.3, 3.36, 0.06)], "jaw")
    s.chain(skull, [(0.24, -2.02, 4.12, 0.075), (0.4, -1.62, 4.32, 0.058), (0.5, -1.15, 4.38, 0.02)], "horn", type="cone")
    s.chain(skull, [(0.3, -2.1, 3.74, 0.065), (0.52, -1.8, 3.68, 0.02)], "cheek spike", type="cone")


def leg(s, parent, name, points, foot):
    *_, ankle = s.chain(parent, points, name)
    x, y, z, _ = points[-1]
    for toe, degrees in (("outer", 42), ("middle", 0), ("inner", -42)):
        a = math.radians(degrees)
        dx, dy = math.sin(a), -math.cos(a)
        s.chain(ankle, [(x + foot * dx, y + foot * dy, 0.085, 0.066), (x + 1.9 * foot * dx, y + 1.9 * foot * dy, 0.03, 0.02)],
                f"{name} {toe} claw", type="cone")


def wing(s, chest):
    """Shoulder, elbow and wrist; three long fingers that would stretch the skin, and the claw of the thumb."""
    *_, wrist = s.chain(chest, [(0.52, -0.42, 2.32, 0.22), (1.1, 0.1, 3.05, 0.16), (1.8, 0.35, 3.6, 0.13), (2.4, -0.5, 4.35, 0.12)], "wing")
    s.node(wrist, (2.5, -1.05, 4.68), 0.05, "thumb claw", type="cone")
    fingers = [((3.95, -0.35, 5.05), (6.0, 0.6, 4.35)), ((3.7, 0.85, 4.35), (5.1, 2.2, 3.2)), ((2.9, 1.35, 3.7), (3.4, 2.7, 2.3))]
    normal = cross(difference(fingers[0][1], s.position(wrist)), difference(fingers[2][1], s.position(wrist)))
    for i, (middle, tip) in enumerate(fingers):
        feather(s, wrist, f"finger {i + 1}", middle, tip, normal)


def difference(a, b):
    return tuple(x - y for x, y in zip(a, b))


def feather(s, wrist, name, middle, tip, normal):
    """A finger with skin on both sides: thin across the wing, wide in it."""
    start = s.position(wrist)
    points = [start, mix(start, middle, 0.3), middle, mix(middle, tip, 0.5), tip]
    parent = wrist
    for i, (radius, wide) in enumerate(((0.075, 1.6), (0.085, 5.6), (0.07, 7.0), (0.03, 1.0)), 1):
        along = unit(difference(points[i], points[i - 1]))
        if i < 4:
            along = tuple(a + b for a, b in zip(along, unit(difference(points[i + 1], points[i]))))
        parent = s.node(parent, points[i], radius, f"{name} {i}", scale=[wide, 0.75],
                        roll=round(roll_towards(along, cross(normal, along)), 2), **({"type": "cone"} if i == 4 else {}))


def main():
    s = Skeleton(mirrored=True)
    chest, rump = trunk(s)
    head(s, chest)
    leg(s, chest, "foreleg", [(0.5, -0.85, 1.3, 0.24), (0.62, -0.6, 0.78, 0.17), (0.62, -0.85, 0.2, 0.12)], 0.26)
    leg(s, rump, "hindleg", [(0.48, 1.0, 1.22, 0.3), (0.68, 0.62, 0.82, 0.21), (0.66, 1.18, 0.45, 0.13), (0.66, 1.0, 0.16, 0.12)], 0.28)
    wing(s, chest)
    s.save("dragon")


if __name__ == "__main__":
    main()
