#!/usr/bin/env python3
"""tools/check-includes: the project passes, and every kind of wrong include is caught at its file and line."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(root):
    run = subprocess.run([sys.executable, ROOT / "tools" / "check-includes", root], capture_output=True, text=True)
    return run.returncode, run.stdout


class CheckIncludes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)
        for folder in ("base", "skeleton", "mesh", "io"):
            self.write(f"src/sinew/{folder}/plain.h", "#pragma once\n#include <vector>\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def assert_caught(self, name, text, place):
        self.write(name, text)
        status, output = check(self.root)
        self.assertEqual(status, 1)
        self.assertIn(place, output)
        self.assertEqual(len(output.splitlines()), 1, output)

    def test_the_project_itself(self):
        status, output = check(ROOT)
        self.assertEqual(status, 0, output)

    def test_right_includes_pass(self):
        self.write("src/sinew/io/read.cpp", '#include "sinew/io/plain.h"\n#include "sinew/mesh/plain.h"\n')
        self.assertEqual(check(self.root)[0], 0)

    def test_against_the_flow(self):
        text = '// a comment\n#include "sinew/io/plain.h"\n'
        self.assert_caught("src/sinew/base/bad.cpp", text, "src/sinew/base/bad.cpp:2: base includes io")

    def test_between_strangers(self):
        self.assert_caught("src/sinew/mesh/bad.h", '  #  include "sinew/skeleton/plain.h"\n', "bad.h:1: mesh includes skeleton")

    def test_against_the_order_inside_a_folder(self):
        self.write("src/sinew/sqm/rings/ring.h", "#pragma once\n")
        self.write("src/sinew/sqm/network.h", "#pragma once\n")
        self.write("src/sinew/sqm/place/good.cpp", '#include "sinew/sqm/rings/ring.h"\n#include "sinew/sqm/network.h"\n')
        self.assertEqual(check(self.root)[0], 0)
        self.assert_caught("src/sinew/sqm/cells/bad.cpp", '#include "sinew/sqm/rings/ring.h"\n', "bad.cpp:1: cells includes rings")

    def test_loops(self):
        self.write("src/sinew/mesh/a.h", '#include "sinew/mesh/b.h"\n')
        self.write("src/sinew/mesh/b.h", "#pragma once\n")
        self.write("src/sinew/mesh/c.h", '#include "sinew/mesh/a.h"\n')
        self.assertEqual(check(self.root)[0], 0)
        self.assert_caught("src/sinew/mesh/b.cpp", '#include "sinew/mesh/c.h"\n',
                           "loop: src/sinew/mesh/a -> src/sinew/mesh/b -> src/sinew/mesh/c")

    def test_round_the_prefix(self):
        self.assert_caught("src/sinew/mesh/bad.h", '#include "../skeleton/plain.h"\n', "bad.h:1")
        self.assert_caught("src/sinew/mesh/bad.h", '#include "plain.h"\n', "write the whole path")

    def test_qt(self):
        self.assert_caught("src/sinew/mesh/bad.h", "#include <QVector3D>\n", "knows nothing of Qt")
        (self.root / "src/sinew/mesh/bad.h").unlink()
        self.assert_caught("apps/modeler/document/bad.h", "#include <QWidget>\n", "apps/modeler/document/bad.h:1")

    def test_unknown_folder(self):
        self.assert_caught("src/sinew/odd/some.h", "#pragma once\n", "src/sinew/odd: unknown folder")


if __name__ == "__main__":
    unittest.main()
