#!/usr/bin/env python3
"""An octopus on the sea floor: a mantle that leans back, two eyes, eight arms that wander off and curl: examples/octopus.sinew."""
import math

from skeleton import Skeleton

ARMS, SEGMENTS = 8, 11


def arm(index):
    """Points of one arm. Each has its own swing and curl; the formulas only have to look unplanned."""
    heading = math.radians(22.5 + 360 / ARMS * index)
    swing = math.radians(26 * math.sin(2.1 * index + 0.4))
    curl = (1 if index % 2 else -1) * math.radians(9 + 5 * math.cos(1.7 * index))
    x, y, points = 0.58 * math.cos(heading), 0.58 * math.sin(heading), []
    z, radius = 0.42, 0.17
    step = 0.3
    for k in range(SEGMENTS):
        points.append((x, y, z, radius))
        t = (k + 1) / SEGMENTS
        heading += (swing / SEGMENTS + curl * 3.2 * t ** 2.2)
        x += step * math.cos(heading)
        y += step * math.sin(heading)
        radius = 0.17 * (1 - t) ** 0.8 + 0.018
        floor = radius + 0.01
        z = max(floor, z - 0.16) if t < 0.55 else floor + 0.35 * max(0.0, math.sin(1.3 * index)) * (t - 0.55)
        step *= 0.945
    return points


def main():
    s = Skeleton()
    body = s.node(None, (0, 0, 0.5), 0.36, "body")
    head = s.node(body, (0, 0.06, 1.0), 0.3, "head")
    s.chain(head, [(0, 0.28, 1.42, 0.42), (0, 0.6, 1.82, 0.5), (0, 0.9, 2.1, 0.36)], "mantle")
    for name, side in (("left eye", 1), ("right eye", -1)):
        s.node(head, (0.32 * side, -0.16, 1.2), 0.12, name)
    for index in range(ARMS):
        s.chain(body, arm(index), f"arm {index + 1}", type="cone")
    s.save("octopus")


if __name__ == "__main__":
    main()
