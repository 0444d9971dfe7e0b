#!/usr/bin/env python3
"""tools/mutate: which changes it finds, and what it says of them in a project of one source and three tests."""
import contextlib
import importlib.machinery
import importlib.util
import io
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True


def load(name, path):
    loader = importlib.machinery.SourceFileLoader(name, str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    sys.modules[name] = module
    loader.exec_module(module)
    return module


mutate = load("mutate", ROOT / "tools" / "mutate")
changes = mutate.changes

TOY = """\
#include "toy.h"

constexpr int count = 3;
static_assert(count < 9);
int larger(int a, int b) { return a > b ? a : b; }
int nobody_asks(int a) { return a + 20; }
int steps_down(int n) {
    int steps = 0;
    while (n > 0) {
        n -= 1;
        steps += 1;
    }
    return steps;
}
int table_size() { int table[count] = {}; return sizeof(table) / sizeof(int); }
bool both(bool a, bool b) { return a && b; }
"""
TEST = """\
#include <gtest/gtest.h>
#include "toy.h"
TEST(Toy, Larger) { EXPECT_EQ(larger(2, 1), 2); }
TEST(Toy, Steps) { EXPECT_EQ(steps_down(2), 2); }
TEST(Toy, Rest) { EXPECT_EQ(table_size(), 3); EXPECT_TRUE(both(true, true)); }
"""
PROJECT = """\
cmake_minimum_required(VERSION 3.22)
project(toy LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
find_package(GTest REQUIRED)
add_library(sinew STATIC src/sinew/toy/toy.cpp)
function(sinew_test name)
    add_executable(test_${name} ${ARGN})
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src/sinew/toy)
    target_link_libraries(test_${name} PRIVATE sinew GTest::gtest_main)
endfunction()
target_include_directories(sinew PRIVATE src/sinew/toy)
add_subdirectory(tests/toy)
"""


class Changes(unittest.TestCase):
    def said(self, text):
        return [change.says for change in changes.changes_of(text)]

    def test_of_code_only(self):
        for line in ('#include "a<1.h"', "// a + 1", "/* a < 2 */", 'f("a < 3 && b");', "v.reserve(4 + n);", "assert(a < 5);",
                     "static_assert(n == 6);", "Vec<7> v;", "std::array<Vec, 3> v;", "progress(0.5);", 'return fail(Error{.line = 3});', "void f(int&& a);"):
            found = [s for s in self.said(line + "\n") if line != 'f("a < 3 && b");' or "dropped" not in s]
            self.assertEqual(found, [], line)

    def test_of_every_kind(self):
        self.assertEqual(set(self.said("if (a < 2 && !b) c = -d;\n")),
                         {"< -> >=", "< -> <=", "2 -> 3", "&& a < 2 dropped", "&& !b dropped", "if (a < 2 && !b) never",
                          "c = -d; dropped", "- dropped"})
        self.assertEqual(self.said("double x = std::min(0.5, y * 1e-9);\n"),
                         ["min -> max", "0.5 -> 0.75", "* -> /", "1e-9 -> 1e-06"])
        self.assertEqual(self.said("for (i = 0; go(i);) f(i), g(i);\n"), ["0 -> 1", "f(i), g(i); dropped"])

    def test_one_is_made(self):
        text = "bool f(int a) { return a < 2; }\n"
        made = [changes.with_one(text, change) for change in changes.changes_of(text)]
        self.assertEqual(made, [text.replace("<", now) for now in ("<=", ">=")] + [text.replace("2", "3")])


@unittest.skipUnless(shutil.which("ninja") and shutil.which("cmake"), "needs cmake and ninja")
class Mutate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        header = "#pragma once\nint larger(int, int);\nint nobody_asks(int);\nint steps_down(int);\nint table_size();\nbool both(bool, bool);\n"
        files = {"CMakeLists.txt": PROJECT, "src/sinew/toy/toy.cpp": TOY, "src/sinew/toy/toy.h": header,
                 "tests/toy/CMakeLists.txt": "sinew_test(toy toy_test.cpp)\n", "tests/toy/toy_test.cpp": TEST}
        for name, text in files.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text)

    def run_on(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = mutate.main(list(arguments), self.root)
        return status, out.getvalue(), err.getvalue()

    def test_says_what_is_caught(self):
        subprocess.run(["cmake", "-S", self.root, "-B", self.root / "build/release", "-G", "Ninja",
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], check=True, stdout=subprocess.DEVNULL)
        mutate.SECONDS_MORE = 2
        status, out, err = self.run_on(str(self.root / "src/sinew/toy"), "-n", "0")
        self.assertEqual((status, err), (0, ""))
        for line in ("toy.cpp:5: > -> <=: caught by Toy.Larger", "toy.cpp:5: > -> >=: SURVIVED",
                     "toy.cpp:6: + -> -: SURVIVED: no test comes by",
                     "toy.cpp:10: n -= 1; dropped: caught by Toy.Steps (takes too long)",
                     "toy.cpp:3: 3 -> 4: caught by Toy.Rest",  # its value is needed while compiling
                     "toy.cpp:16: && a dropped: SURVIVED"):
            self.assertIn("src/sinew/toy/" + line + "\n", out)
        self.assertRegex(out, r"\n\d+ caught, \d+ survived, \d+ not possible\n$")
        self.assertEqual((self.root / "src/sinew/toy/toy.cpp").read_text(), TOY)

    def test_the_same_seed_chooses_the_same(self):
        folder = str(self.root / "src/sinew/toy")
        first = self.run_on(folder, "-n", "5", "--list")
        self.assertEqual(first, self.run_on(folder, "-n", "5", "--list", "--seed", "1"))
        self.assertEqual(len(first[1].splitlines()), 5)
        self.assertNotEqual(first, self.run_on(folder, "-n", "5", "--list", "--seed", "2"))

    def test_refuses_what_is_no_folder_of_the_library(self):
        status, _, err = self.run_on(str(self.root / "tests"))
        self.assertEqual(status, 1)
        self.assertIn("is no folder in src/sinew", err)


if __name__ == "__main__":
    unittest.main()
