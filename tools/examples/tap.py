#!/usr/bin/env python3
"""A garden tap with a cross handle, in centimetres: examples/tap.sinew."""
from skeleton import Skeleton


def main():
    s = Skeleton(unit="cm", mirrored=True)
    body = s.node(None, (0, 0, 0), 1.7, "valve body", type="ball", scale=[1, 1, 1.1], joint="sharp")

    # To the wall: a pipe, a hexagon nut's worth of collar, a flange with a flat back.
    pipe = s.node(body, (0, 3.2, 0), 0.95, "inlet", joint="sharp")
    collar = s.node(pipe, (0, 3.22, 0), 1.35, "collar", joint="sharp")
    back = s.node(collar, (0, 4.2, 0), 1.35, "collar's end", joint="sharp")
    thin = s.node(back, (0, 4.22, 0), 1.0, "neck", joint="sharp")
    neck = s.node(thin, (0, 5.6, 0), 1.0, "neck's end", joint="sharp")
    face = s.node(neck, (0, 5.62, 0), 2.4, "flange", joint="sharp")
    s.node(face, (0, 6.3, 0), 2.4, "wall", type="hemisphere")

    # The spout: out, round and down, with a lip and an opening.
    spout = s.chain(body, [(0, -2.9, 0.15, 0.95), (0, -4.6, 0.2, 0.92), (0, -5.9, -0.25, 0.9), (0, -6.75, -1.3, 0.88),
                           (0, -6.95, -2.7, 0.86)], "spout")[-1]
    top = s.node(spout, (0, -6.95, -3.4, ), 0.86, "lip", joint="sharp")
    lip = s.node(top, (0, -6.95, -3.42), 1.12, "lip's rim", joint="sharp")
    end = s.node(lip, (0, -6.95, -4.0), 1.12, "opening", joint="sharp")
    inside = s.node(end, (0, -6.95, -4.01), 0.7, "opening's rim", joint="sharp")
    s.node(inside, (0, -6.95, -3.2), 0.68, "inside", type="hemisphere")

    # The bonnet: a square nut, the stem, and the handle with four balls.
    stem = s.node(body, (0, 0, 2.5), 1.0, "bonnet", joint="sharp")
    nut = s.node(stem, (0, 0, 3.4), 0.75, "nut", type="cube", size=[2.6, 2.6, 1.3])
    gland = s.node(nut, (0, 0, 5.0), 0.75, "gland", joint="sharp")
    thin = s.node(gland, (0, 0, 5.02), 0.4, "stem", joint="sharp")
    hub = s.node(thin, (0, 0, 6.6), 0.72, "hub", type="ball", joint="sharp")
    for name, x, y in (("right", 1, 0), ("front", 0, -1), ("back", 0, 1)):
        arm = s.node(hub, (1.6 * x, 1.6 * y, 6.6), 0.3, f"{name} arm")
        s.node(arm, (2.6 * x, 2.6 * y, 6.6), 0.55, f"{name} knob", type="ball")
    s.save("tap")


if __name__ == "__main__":
    main()
