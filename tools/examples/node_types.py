#!/usr/bin/env python3
"""One small skeleton for every node type and for each thing that node types can say: examples/types/*.sinew."""
import math
import pathlib
import sys

from skeleton import EXAMPLES, Skeleton

MADE = {}


def example(make):
    """Collects the function that makes examples/types/<its name>.sinew."""
    MADE[make.__name__] = make
    return make


def drawn(nodes, links=(), mirrored=False):
    """Nodes as (parent's place in the list from 1 on or None, position, radius, further keys)."""
    s = Skeleton(unit="", mirrored=mirrored)
    for parent, position, radius, *keys in nodes:
        s.node(parent, position, radius, **(keys[0] if keys else {}))
    for a, b in links:
        s.link(a, b)
    return s


FLAT = {"type": "hemisphere"}
SHARP = {"joint": "sharp"}


def beam(width, height, **keys):
    """Keys of a rectangular section of radius 0.5."""
    return {"section": "rectangular", "scale": [2 * width, 2 * height], **keys}


# The eight types.

@example
def sphere():
    return drawn([(None, (0, 0, 0), 0.5), (1, (0, 0, 2), 0.3)])


@example
def cone():
    return drawn([(None, (0, 0, 0), 0.5, FLAT), (1, (0, 0, 1), 0.5, SHARP), (2, (0, 0, 3), 0.2, {"type": "cone"})])


@example
def hemisphere():
    return drawn([(None, (0, 0, 0), 0.5, FLAT), (1, (0, 0, 2), 0.3, FLAT)])


@example
def cube_leaf():
    return drawn([(None, (0, 0, 0), 0.2), (1, (0, 0, 2), 0.2, {"type": "cube", "size": [1, 0.8, 0.6]})])


@example
def cube_connection():
    return drawn([(None, (0, 0, -2), 0.2), (1, (0, 0, 0), 0.25, {"type": "cube", "size": [1, 1, 0.6], "roll": 45}),
                  (2, (0, 0, 2), 0.3)])


@example
def cube_branch():
    return drawn([(None, (0, 0, 0), 0.25, {"type": "cube", "size": [1, 1.2, 0.8]}), (1, (2, 0, 0), 0.25), (1, (-2, 0, 0), 0.25),
                  (1, (0, -2, 0), 0.25), (1, (0, 0, 2), 0.25)])


@example
def ball():
    return drawn([(None, (0, 0, 0), 0.8, {"type": "ball", **SHARP}), (1, (0, 0, -2), 0.15, FLAT), (1, (1.5, 0, 1), 0.2)])


@example
def negative():
    return drawn([(None, (0, 0, 0), 1, {"type": "ball"}), (1, (0, -1.4, 0), 0.35, {"type": "negative"})])


# What the thesis listed as missing.

@example
def root_without_branches():
    return drawn([(None, (0, 0, 0), 0.5), (None, (2, 0, 0), 0.5, {"type": "cube"}), (None, (4, 0, 0), 0.4), (3, (4, 0, 2), 0.2),
                  (None, (6, 0, 0), 0.3), (5, (5, 0, 1.5), 0.2), (5, (7, 0, 1.5), 0.2)])


@example
def boxes():
    return drawn([(None, (0, 0, 0), 0.2, {"type": "cube", "size": [1.2, 1.2, 0.4]}),
                  (1, (0, 0, 0.9), 0.2, {"type": "cube", "size": [0.8, 0.8, 0.5]}),
                  (2, (0, 0, 1.8), 0.2, {"type": "cube", "size": [0.4, 0.4, 0.6], "roll": 45})])


@example
def sharp_edges():
    return drawn([(None, (0, 0, 0), 0.5, beam(0.5, 0.3, **FLAT)), (1, (0, 0, 2), 0.5, beam(0.5, 0.3, **SHARP)),
                  (2, (1.5, 0, 3), 0.5, beam(0.3, 0.5, roll=90, **FLAT))])


@example
def sharp_joints():
    return drawn([(None, (0, 0, 0), 0.3, {"joint": 2}), (1, (1.2, 0, 0), 0.3, SHARP), (2, (2, 0, 1), 0.3), (1, (-1, 1.2, 0), 0.3),
                  (4, (-1.4, 1.8, 0.01), 0.5, SHARP), (5, (-2, 2.7, 0), 0.5, {"type": "cone"}), (1, (-1, -1.4, 0), 0.2)])


@example
def mirror_pattern():
    return drawn([(None, (0, 0, 0), 0.4), (1, (0, 0, 1.2), 0.3), (2, (1, 0, 1.6), 0.2), (3, (1.8, 0, 1.2), 0.15, {"type": "cube", "size": [0.5, 0.5, 0.3]}),
                  (1, (0.5, 0, -1.2), 0.2, FLAT)], mirrored=True)


@example
def radial_pattern():
    s = drawn([(None, (0, 0, 0), 0.4), (1, (1.2, 0, 0), 0.15), (2, (2, 0, 0), 0.3, {"type": "ball"})])
    s.symmetry = {"radial": {"axis": "z", "count": 8}}
    return s


@example
def cycle():
    corners = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)]
    return drawn([(i if i else None, at, 0.2) for i, at in enumerate(corners)], links=[(4, 1)])


@example
def width_and_height():
    return drawn([(None, (0, 0, 0), 0.5, {"scale": [1.6, 0.5], **FLAT}), (1, (0, 0, 1.5), 0.5, {"scale": [1, 1]}),
                  (2, (0, 0, 3), 0.5, {"scale": [0.5, 1.6], **FLAT})])


@example
def flat_sides():
    return drawn([(None, (0, 0, 0), 0.5, beam(0.5, 0.2, **FLAT)), (1, (1, 0, 0), 0.5, beam(0.5, 0.2)),
                  (2, (2, 0, 0.2), 0.5, beam(0.4, 0.2)), (3, (3, 0, 0.2), 0.5), (4, (4, 0, 0.2), 0.5, FLAT)])


@example
def ball_with_five_limbs():
    nodes = [(None, (0, 0, 0), 1, {"type": "ball"})]
    for i in range(5):
        a = 2 * math.pi * i / 5
        nodes.append((1, (2.5 * math.cos(a), 2.5 * math.sin(a), 0.6), 0.15))
    return drawn(nodes)


@example
def ellipsoid():
    return drawn([(None, (0, 0, 0), 1, {"type": "ball", "scale": [0.6, 0.8, 1]}),
                  (None, (2, 0, 0), 1, {"type": "ball", "scale": [0.6, 0.8, 1]}), (2, (2, 0, -2), 0.1, FLAT)])


# Concavities.

@example
def eye_socket():
    return drawn([(None, (0, 0, 0), 1, {"type": "ball", "scale": [0.8, 0.9, 1]}),
                  (1, (0.35, -1.1, 0.2), 0.18, {"type": "negative", "scale": [1.3, 1]})], mirrored=True)


@example
def mouth():
    """A chain of negative leaves that overlap, and one that is drawn wide."""
    chain = [(1, (1.25 * math.sin(a), -1.25 * math.cos(a), -0.3), 0.22, {"type": "negative"}) for a in (-0.38, 0, 0.38)]
    return drawn([(None, (0, 0, 0), 1, {"type": "ball"})] + chain +
                 [(1, (0, -1.1, 0.55), 0.1, {"type": "negative", "scale": [4, 1]})])


@example
def bowl():
    return drawn([(None, (0, 0, 0), 0.8, FLAT), (1, (0, 0, 0.2), 0.35), (2, (0, 0, 1.5), 1),
                  (3, (0, 0, 3.1), 0.8, {"type": "negative"})])


@example
def bore():
    """A path that turns straight back into itself: a cup."""
    return drawn([(None, (0, 0, 0), 0.6, FLAT), (1, (0, 0, 2), 0.8, SHARP), (2, (0, 0, 2.001), 0.7, SHARP), (3, (0, 0, 0.3), 0.5, FLAT)])


def main():
    folder = (pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else EXAMPLES) / "types"
    folder.mkdir(exist_ok=True)
    for name, make in MADE.items():
        make().save(f"types/{name}")


if __name__ == "__main__":
    main()
