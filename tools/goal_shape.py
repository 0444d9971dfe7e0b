#!/usr/bin/env python3
"""usage: goal_shape.py ladder|gear|lollipop|head MESH.obj

Writes one of the four goals of docs/goals.md as a mesh: the shape itself, from the formulas below, without any skeleton. A mesh of
the level set, by surface nets: one vertex for each cell of a grid that the surface runs through, drawn onto the surface.
"""
import math
import sys


def length(*v):
    return math.sqrt(sum(x * x for x in v))


def outside(*q):
    """Distance to a box or a cylinder from the distances to its walls."""
    return length(*(max(x, 0) for x in q)) + min(max(q), 0)


def box(p, low, high):
    return outside(*(max(a - x, x - b) for x, a, b in zip(p, low, high)))


def ellipsoid(p, centre, half):
    q = [(x - c) / h for x, c, h in zip(p, centre, half)]
    k, slope = length(*q), length(*(x / h for x, h in zip(q, half)))
    return k * (k - 1) / slope if slope else -min(half)


def ladder(p):
    x, y, z = p
    rails = min(box(p, (s - 0.04, -0.06, 0), (s + 0.04, 0.06, 2)) for s in (-0.3, 0.3))
    rungs = min(outside(length(y + 0.02, z - height) - 0.03, abs(x) - 0.3) for height in (0.5, 1, 1.5))
    return min(rails, rungs)


def gear(p):
    x, y, z = p
    wheel = outside(abs(length(x, y) - 0.75) - 0.25, abs(z) - 0.2)
    turn = math.pi / 4 * round(math.atan2(y, x) / (math.pi / 4))
    c, s = math.cos(turn), math.sin(turn)
    return min(wheel, box((c * x + s * y, c * y - s * x, z), (0.9, -0.15, -0.2), (1.25, 0.15, 0.2)))


def lollipop(p):
    x, y, z = p
    return min(length(*p) - 0.5, outside(length(x, y) - 0.08, abs(z + 1) - 1))


def head(p):
    skull = min(ellipsoid(p, (0, 0, 0), (0.75, 0.9, 1)), ellipsoid(p, (0, -0.92, -0.05), (0.12, 0.2, 0.22)))
    q = (abs(p[0]), p[1], p[2])
    eye = ellipsoid(q, (0.3, -0.8, 0.2), (0.18, 0.25, 0.13))
    mouth = [(0, -0.8, -0.42), (0.15, -0.78, -0.44), (0.3, -0.7, -0.5)]
    lips = 1e9
    for a, b in zip(mouth, mouth[1:]):
        along = [v - u for u, v in zip(a, b)]
        t = sum((x - u) * w for x, u, w in zip(q, a, along)) / sum(w * w for w in along)
        t = min(1, max(0, t))
        lips = min(lips, length(*(x - u - t * w for x, u, w in zip(q, a, along))) - 0.08)
    return max(skull, -eye, -lips)


GOALS = {  # the shape, the corners of a box round it, cells along its longest side
    "ladder": (ladder, (-0.36, -0.08, -0.03), (0.36, 0.08, 2.03), 206),
    "gear": (gear, (-1.3, -1.3, -0.24), (1.3, 1.3, 0.24), 130),
    "lollipop": (lollipop, (-0.55, -0.55, -2.05), (0.55, 0.55, 0.55), 130),
    "head": (head, (-0.8, -1.2, -1.05), (0.8, 0.95, 1.05), 84),
}


def surface(f, low, high, cells):
    step = max(b - a for a, b in zip(low, high)) / cells
    size = [int((b - a) / step) + 2 for a, b in zip(low, high)]
    at = [[a + i * step for i in range(n)] for a, n in zip(low, size)]
    value = [[[f((x, y, z)) for z in at[2]] for y in at[1]] for x in at[0]]
    vertices, number, faces = [], {}, []
    edges = [((0, 0, 0), (1, 0, 0)), ((0, 1, 0), (1, 1, 0)), ((0, 0, 1), (1, 0, 1)), ((0, 1, 1), (1, 1, 1)),
             ((0, 0, 0), (0, 1, 0)), ((1, 0, 0), (1, 1, 0)), ((0, 0, 1), (0, 1, 1)), ((1, 0, 1), (1, 1, 1)),
             ((0, 0, 0), (0, 0, 1)), ((1, 0, 0), (1, 0, 1)), ((0, 1, 0), (0, 1, 1)), ((1, 1, 0), (1, 1, 1))]

    def vertex(i, j, k):
        key = (i, j, k)
        if key not in number:
            hits = []
            for a, b in edges:
                u, v = value[i + a[0]][j + a[1]][k + a[2]], value[i + b[0]][j + b[1]][k + b[2]]
                if (u < 0) != (v < 0):
                    t = u / (u - v)
                    hits.append([m + (n - m) * t for m, n in zip(a, b)])
            middle = [sum(h[c] for h in hits) / len(hits) for c in range(3)]
            number[key] = len(vertices)
            vertices.append([at[c][key[c]] + middle[c] * step for c in range(3)])
        return number[key]

    for i in range(1, size[0] - 1):
        for j in range(1, size[1] - 1):
            for k in range(1, size[2] - 1):
                inside = value[i][j][k] < 0
                for c, other in enumerate(((i + 1, j, k), (i, j + 1, k), (i, j, k + 1))):
                    if (value[other[0]][other[1]][other[2]] < 0) == inside:
                        continue
                    u, v = [0, 0, 0], [0, 0, 0]
                    u[(c + 1) % 3], v[(c + 2) % 3] = 1, 1
                    ring = [vertex(i - a * u[0] - b * v[0], j - a * u[1] - b * v[1], k - a * u[2] - b * v[2])
                            for a, b in ((1, 1), (0, 1), (0, 0), (1, 0))]
                    faces.append(ring if inside else ring[::-1])
    return vertices, faces


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in GOALS:
        sys.exit(__doc__)
    vertices, faces = surface(*GOALS[sys.argv[1]])
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.writelines("v %.6g %.6g %.6g\n" % tuple(v) for v in vertices)
        file.writelines("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


if __name__ == "__main__":
    main()
