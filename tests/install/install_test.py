#!/usr/bin/env python3
"""Installs the build into a folder of its own; a project that knows only that folder finds, links and runs the library.

usage: install_test.py BUILD WORK CMAKE      (folders, the cmake program)
The C++ program is the one of the README, byte for byte.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD, WORK, CMAKE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        cls.prefix, cls.project = WORK / "prefix", WORK / "consumer"
        run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)
        cls.project.mkdir(parents=True)
        for name in ("tube.cpp", "picture.cpp"):
            shutil.copy(HERE / name, cls.project / name)
        shutil.copy(HERE / "consumer.cmake", cls.project / "CMakeLists.txt")
        run(CMAKE, "-S", cls.project, "-B", WORK / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={cls.prefix}",
            "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF")
        run(CMAKE, "--build", WORK / "build")

    def test_readme_program_makes_a_mesh(self):
        said = run(WORK / "build" / "tube", cwd=WORK)
        vertices, faces = map(int, re.fullmatch(r"(\d+) vertices, (\d+) faces\n", said).groups())
        lines = (WORK / "bone.obj").read_text().splitlines()
        self.assertEqual(sum(line.startswith("v ") for line in lines), vertices)
        self.assertEqual(sum(line.startswith("f ") for line in lines), faces)

    def test_readme_shows_this_program(self):
        program = (HERE / "tube.cpp").read_text()
        self.assertIn(f"```cpp\n{program}```", (ROOT / "README.md").read_text())

    def test_renderer_links(self):
        run(WORK / "build" / "picture", cwd=WORK)

    def test_headers_stand_alone(self):
        """Nothing that is installed names the folder it was built in."""
        for path in [*self.prefix.rglob("*.cmake"), *self.prefix.rglob("*.h")]:
            self.assertNotIn(str(ROOT), path.read_text(), path)

    def test_program_runs(self):
        self.assertTrue(run(self.prefix / "bin" / "sinew", "--version").startswith("sinew "))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
