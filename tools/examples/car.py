#!/usr/bin/env python3
"""A saloon of 4.2 m, as flat and square as a toy: examples/car.sinew."""
from skeleton import Skeleton

WIDTH, DEPTH = 1.36, 0.5  # of the body's box: across, and from sill to waist
WAIST = 0.56              # height of its middle
WHEEL = 0.34


def beam(s, parent, position, width, height, name, **keys):
    """A rectangular section, width along the frame's x and height along its y."""
    return s.node(parent, position, height / 2, name, section="rectangular", scale=[round(width / height, 4), 1], **keys)


def wheel(s, axle, y, name):
    """On a hub: a flat inner side, the tread, a flat outer side with a cap."""
    z = WHEEL + 0.02
    hub = s.node(axle, (0.72, y, z), 0.06, f"{name} axle", joint="sharp")
    inner = s.node(hub, (0.722, y, z), WHEEL, f"{name} inner side", joint="sharp")
    outer = s.node(inner, (0.95, y, z), WHEEL, f"{name} outer side", joint="sharp")
    rim = s.node(outer, (0.951, y, z), 0.23, f"{name} rim", joint="sharp")
    dish = s.node(rim, (0.9, y, z), 0.19, f"{name} dish", joint="sharp")
    cap = s.node(dish, (0.901, y, z), 0.08, f"{name} hub", joint="sharp")
    s.node(cap, (0.955, y, z), 0.06, f"{name} cap", type="hemisphere")


def main():
    s = Skeleton(mirrored=True)
    front = s.node(None, (0, -1.3, WAIST), 0.06, "front axle", type="cube", size=[WIDTH, 0.7, DEPTH])
    beam(s, beam(s, front, (0, -1.7, WAIST), WIDTH, DEPTH, "bonnet", joint="sharp"), (0, -2.1, WAIST - 0.06), WIDTH - 0.1, DEPTH - 0.14,
         "nose", type="hemisphere")
    before = beam(s, front, (0, -0.8, WAIST), WIDTH, DEPTH, "front wings")
    middle = s.node(before, (0, 0.15, WAIST), 0.1, "doors", type="cube", size=[WIDTH, 1.7, DEPTH])
    belt = beam(s, middle, (0, 0.15, WAIST + DEPTH / 2 + 0.04), WIDTH, 1.7, "belt", joint="sharp")
    beam(s, belt, (0, 0.15, WAIST + DEPTH / 2 + 0.5), WIDTH - 0.3, 0.95, "roof", type="hemisphere")
    behind = beam(s, middle, (0, 1.05, WAIST), WIDTH, DEPTH, "rear wings")
    rear = s.node(behind, (0, 1.45, WAIST), 0.06, "rear axle", type="cube", size=[WIDTH, 0.7, DEPTH])
    beam(s, beam(s, rear, (0, 1.85, WAIST), WIDTH, DEPTH, "boot", joint="sharp"), (0, 2.1, WAIST), WIDTH - 0.1, DEPTH - 0.1, "tail",
         type="hemisphere")
    wheel(s, front, -1.3, "front")
    wheel(s, rear, 1.45, "rear")
    s.save("car")


if __name__ == "__main__":
    main()
