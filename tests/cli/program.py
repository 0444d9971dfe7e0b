"""What the tests of the command line share: running the program, small inputs, a folder to work in."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SINEW = pathlib.Path(os.environ.get("SINEW") or ROOT / "build/release/bin/sinew")

# three bones that meet
TRIPOD = {"format": "sinew", "version": 1, "unit": "mm", "nodes": [
    {"id": 1, "position": [0, 0, 0], "radius": 0.5, "name": "middle"},
    {"id": 2, "parent": 1, "position": [3, 0, 0], "radius": 0.3},
    {"id": 3, "parent": 1, "position": [0, 3, 0], "radius": 0.3},
    {"id": 4, "parent": 1, "position": [0, 0, 3], "radius": 0.3, "colour": "red"}]}
RING_GRAPH = "n 0 0 0 1\nn 9 0 0 1\nn 9 9 0 1\nn 0 9 0 1\nc 0 1\nc 1 2\nc 2 3\nc 3 0\n"
CUBE_OBJ = ("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
            "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n")


def tube(nodes, distance):
    """A straight .graph of radius 1 along z."""
    return ("".join(f"n 0 0 {distance * k} 1\n" for k in range(nodes)) +
            "".join(f"c {k} {k + 1}\n" for k in range(nodes - 1)))


class ProgramTest(unittest.TestCase):
    """Each test works in an empty folder of its own."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="sinew-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("tripod.sinew", json.dumps(TRIPOD))
        self.write("tube.graph", tube(nodes=3, distance=5))
        self.write("ring.graph", RING_GRAPH)
        self.write("cube.obj", CUBE_OBJ)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def read(self, name):
        return (self.folder / name).read_text()

    def files(self, folder="."):
        """Names of all files in a folder, hidden ones too."""
        return sorted(path.name for path in (self.folder / folder).iterdir() if path.is_file())

    def sinew(self, *words, stdin="", **options):
        """Runs the program; standard output and error as text."""
        return subprocess.run([str(SINEW), *map(str, words)], cwd=self.folder, input=stdin, capture_output=True,
                              text=True, timeout=120, **options)

    def done(self, *words, **options):
        """Runs the program, which must leave with status 0."""
        run = self.sinew(*words, **options)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def refused(self, status, *words, says=(), **options):
        """Runs the program, which must leave with this status and say each of these on standard error."""
        run = self.sinew(*words, **options)
        self.assertEqual(run.returncode, status, run.stderr)
        self.assertEqual(run.stdout, "")
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, run.stderr)
        return run

    def objects(self, *words, status=0):
        """Runs the program with --json: what it prints, an object a line."""
        run = self.sinew(*words, "--json")
        self.assertEqual(run.returncode, status, run.stderr)
        return [json.loads(line) for line in run.stdout.splitlines()]
