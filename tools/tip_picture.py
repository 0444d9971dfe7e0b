#!/usr/bin/python3
"""Draws docs/images/tips.png: reflection lines on a tip under Catmull-Clark (left) and under the pole rule (right).

usage: tools/tip_picture.py [build/release/bin/sinew]

Stripes follow the normal, so that they break where the curvature does; seen from above, the pole in the middle.
"""
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIDES, RINGS = 9, [(0.55, 0.80), (0.95, 0.35), (1.1, -0.3), (1.1, -1.2)]  # radius and height of each ring
PIXELS, REACH, STRIPES = 560, 0.75, 26.0


def write_tip(path):
    with open(path, "w") as out:
        print("v 0 0 1", file=out)
        for r, z in RINGS:
            for j in range(SIDES):
                a = 2 * math.pi * j / SIDES
                print("v", r * math.cos(a), r * math.sin(a), z, file=out)
        at = lambda k, j: 2 + k * SIDES + j % SIDES
        for j in range(SIDES):
            print("f", 1, at(0, j), at(0, j + 1), file=out)
            for k in range(len(RINGS) - 1):
                print("f", at(k, j), at(k + 1, j), at(k + 1, j + 1), at(k, j + 1), file=out)


def read_obj(path):
    lines = [line.split() for line in open(path)]
    points = numpy.array([[float(x) for x in l[1:4]] for l in lines if l and l[0] == "v"])
    faces = [[int(w.split("/")[0]) - 1 for w in l[1:]] for l in lines if l and l[0] == "f"]
    return points, numpy.array([f if len(f) == 4 else f + f[:1] for f in faces])


def normals_of(points, faces):
    corners = points[faces]
    area = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals = numpy.zeros_like(points)
    for i in range(4):
        numpy.add.at(normals, faces[:, i], area)
    return normals / numpy.linalg.norm(normals, axis=1, keepdims=True)


def draw(points, faces):
    """Scatters points of each small face into a picture, with the stripes of their normals."""
    normals, picture, count = normals_of(points, faces), numpy.zeros((PIXELS, PIXELS)), numpy.zeros((PIXELS, PIXELS))
    near = numpy.abs(points[faces][:, :, :2]).max(axis=(1, 2)) < 1.1 * REACH
    faces, steps = faces[near], 13
    for i in range(steps):
        for j in range(steps):
            u, v = (i + 0.5) / steps, (j + 0.5) / steps
            weights = numpy.array([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
            p = numpy.einsum("k,fkx->fx", weights, points[faces])
            n = numpy.einsum("k,fkx->fx", weights, normals[faces])
            n /= numpy.linalg.norm(n, axis=1, keepdims=True)
            stripe = 0.5 + 0.5 * numpy.tanh(5 * numpy.sin(STRIPES * numpy.arcsin(0.8 * n[:, 0] + 0.6 * n[:, 1])))
            x = numpy.rint((p[:, 0] / REACH + 1) / 2 * PIXELS).astype(int)
            y = numpy.rint((1 - p[:, 1] / REACH) / 2 * PIXELS).astype(int)
            inside = (x >= 0) & (x < PIXELS) & (y >= 0) & (y < PIXELS)
            numpy.add.at(picture, (y[inside], x[inside]), stripe[inside])
            numpy.add.at(count, (y[inside], x[inside]), 1)
    return 40 + 200 * picture / numpy.maximum(count, 1)


def write_png(path, grey):
    height, width = grey.shape
    rows = b"".join(b"\0" + row.tobytes() for row in grey.astype(numpy.uint8))
    chunk = lambda kind, data: (struct.pack(">I", len(data)) + kind + data +
                                struct.pack(">I", zlib.crc32(kind + data)))
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 0, 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    sinew = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/sinew"
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        write_tip(folder / "tip.obj")
        pictures = []
        for options in (["--catmull-clark"], []):
            subprocess.run([sinew, "subdivide", folder / "tip.obj", "-o", folder / "fine.obj", "--levels", "6",
                            "--limit", "--quiet", *options], check=True)
            pictures.append(draw(*read_obj(folder / "fine.obj")))
    gap = numpy.full((PIXELS, 16), 255)
    (ROOT / "docs/images").mkdir(parents=True, exist_ok=True)
    write_png(ROOT / "docs/images/tips.png", numpy.hstack([pictures[0], gap, pictures[1]]))


if __name__ == "__main__":
    main()
