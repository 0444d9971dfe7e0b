#!/usr/bin/env python3
"""Installs the build into a folder of its own; a project that knows only that folder finds, links and runs the library.

usage: install_test.py BUILD WORK CMAKE COMPILER      (folders, programs)
The C++ programs are those of the README and of docs/library.md, byte for byte.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD, WORK, (CMAKE, COMPILER) = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:5]
HEADERS = re.findall(r"^    (\w+/\w+\.h)\b", (ROOT / "cmake/public_headers.cmake").read_text(), re.MULTILINE)


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
        cls.build(cls.project, WORK / "build")

    @classmethod
    def build(cls, project, folder, *options):
        """Configures and builds a project that knows of the installed library only, and not of what that does not need."""
        run(CMAKE, "-S", project, "-B", folder, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={cls.prefix}", *options,
            "-DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON", "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF")
        run(CMAKE, "--build", folder)

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

    def test_headers_are_those_for_users(self):
        """That each compiles alone, beside these and no others, is what the consumer's target `headers` shows."""
        include = self.prefix / "include/sinew"
        self.assertEqual(sorted(path.relative_to(include).as_posix() for path in include.rglob("*.h")), sorted(HEADERS))

    def test_example_needs_no_renderer(self):
        self.build(ROOT / "examples/library", WORK / "example", "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON",
                   "-DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON")
        said = run(WORK / "example" / "waving_arm", WORK).splitlines()
        self.assertEqual(len(said), 4)
        frames = []
        for number, line in enumerate(said[:3]):
            name, vertices = re.fullmatch(r"(.*): (\d+) vertices, \d+ faces", line).groups()
            self.assertEqual(pathlib.Path(name).name, f"frame{number}.obj")
            frames.append([line for line in pathlib.Path(name).read_text().splitlines() if line.startswith("v ")])
            self.assertEqual(len(frames[-1]), int(vertices))
        self.assertTrue(frames[0] != frames[1] != frames[2])
        self.assertTrue((WORK / "control.obj").exists())
        self.assertIn("node 14: the radius must be above 0", said[3])

    def test_handbook_shows_the_example(self):
        program = (ROOT / "examples/library/waving_arm.cpp").read_text()
        self.assertIn(f"```cpp\n{program}```", (ROOT / "docs/library.md").read_text())

    def test_pkg_config(self):
        """Finds the moved folder, and what it says is enough to compile and to link."""
        if not shutil.which("pkg-config"):
            self.skipTest("there is no pkg-config")
        environment = {**os.environ, "PKG_CONFIG_PATH": str(next(self.prefix.rglob("pkgconfig")))}
        for package, program in (("sinew", "tube"), ("sinew-render", "picture")):
            flags = run("pkg-config", "--cflags", "--libs", package, env=environment).split()
            output = WORK / f"{program}_by_pkg_config"
            run(COMPILER, "-std=c++20", HERE / f"{program}.cpp", "-o", output, *flags)
            run(output, cwd=WORK)

    def test_nothing_names_the_folder_it_was_built_in(self):
        for path in [path for end in ("cmake", "h", "pc") for path in self.prefix.rglob(f"*.{end}")]:
            self.assertNotIn(str(ROOT), path.read_text(), path)

    def test_program_runs(self):
        self.assertTrue(run(self.prefix / "bin" / "sinew", "--version").startswith("sinew "))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
