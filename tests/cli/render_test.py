"""sinew render makes pictures without a display."""
import struct
import unittest
import zlib

from program import ProgramTest


def pixels(data):
    """(width, height, rows of bytes) of an 8-bit PNG without interlacing; a row holds its pixels' channels"""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, body, header = 8, b"", None
    while place < len(data):
        (length,), kind = struct.unpack(">I", data[place:place + 4]), data[place + 4:place + 8]
        chunk = data[place + 8:place + 8 + length]
        header = chunk if kind == b"IHDR" else header
        body += chunk if kind == b"IDAT" else b""
        place += length + 12
    width, height, depth, colour = struct.unpack(">IIBB", header[:10])
    channels = {2: 3, 6: 4}[colour]
    raw, rows, before = zlib.decompress(body), [], bytes(width * channels)
    for y in range(height):
        start = y * (width * channels + 1)
        before = unfilter(raw[start], raw[start + 1:start + 1 + width * channels], before, channels)
        rows.append(before)
    return width, height, channels, rows


def unfilter(kind, line, above, step):
    """One row of a PNG (specification, chapter 9)."""
    row = bytearray(line)
    for i in range(len(row)):
        a = row[i - step] if i >= step else 0
        b = above[i]
        c = above[i - step] if i >= step else 0
        nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        row[i] = (row[i] + (0, a, b, (a + b) // 2, nearest)[kind]) & 0xff
    return bytes(row)


class Render(ProgramTest):
    def setUp(self):
        super().setUp()
        probe = self.sinew("render", "cube.obj", "-o", "probe.png", "--size", "8x8")
        if probe.returncode == 3 and "EGL" in probe.stderr:
            self.skipTest(probe.stderr.strip())

    def picture(self, *words):
        self.done("render", *words, "-o", "picture.png")
        return pixels((self.folder / "picture.png").read_bytes())

    def covered(self, *words):
        """Share of the pixels that something is drawn on."""
        width, height, channels, rows = self.picture(*words, "--background", "transparent", "--size", "96x64")
        self.assertEqual(channels, 4)
        return sum(alpha > 0 for row in rows for alpha in row[3::4]) / (width * height)

    def test_size_and_background(self):
        width, height, channels, rows = self.picture("cube.obj", "--size", "120x80", "--background", "102030")
        self.assertEqual((width, height, channels), (120, 80, 3))
        self.assertEqual(rows[0][:3], b"\x10\x20\x30")

    def test_something_is_drawn(self):
        for name in ("cube.obj", "tripod.sinew", "tube.graph"):
            with self.subTest(name):
                self.assertGreater(self.covered(name), 0.05)

    def test_a_skeleton_looks_as_what_skin_makes_of_it(self):
        for name in ("tube.graph", "tripod.sinew"):
            for levels in ([], ["--subdivide", "2"]):
                with self.subTest(name, levels=levels):
                    self.done("skin", name, "-o", "mesh.ply", *levels)
                    self.assertEqual(self.picture(name, *levels, "--size", "160x120"),
                                     self.picture("mesh.ply", "--size", "160x120"))

    def test_views_and_wire_differ(self):
        pictures = [self.picture("tripod.sinew", "--size", "64x64", *options)[3]
                    for options in (["--view", "front"], ["--view", "iso"], ["--wire"], ["--skeleton"],
                                    ["--irregular", "--view", "front"])]
        self.assertEqual(len({b"".join(rows) for rows in pictures}), 5)

    def test_sheet(self):
        width, height, _, _ = self.picture("cube.obj", "tripod.sinew", "tube.graph", "--sheet", "2", "--size", "40x30")
        self.assertEqual((width, height), (80, 60))

    def test_several(self):
        self.done("render", "cube.obj", "tube.graph", "-o", "pictures", "--size", "16x16")
        self.assertEqual(self.files("pictures"), ["cube.png", "tube.png"])

    def test_wrong_calls(self):
        for option in ("--size=0x9", "--size=9", "--view=back", "--background=red", "--opacity=2"):
            self.refused(2, "render", "cube.obj", "-o", "a.png", option, says=option.split("=")[0])
        self.refused(2, "render", "cube.obj", "-o", "a.jpg", says="PNG")


if __name__ == "__main__":
    unittest.main()
