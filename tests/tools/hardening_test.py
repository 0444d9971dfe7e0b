#!/usr/bin/env python3
"""Are the programs of a release build hardened (cmake/hardening.cmake)? Reads them with readelf.

usage: hardening_test.py PROGRAM...
"""
import platform
import shutil
import subprocess
import sys
import unittest

PROGRAMS = []


def readelf(*arguments):
    return subprocess.run(["readelf", "-W", *arguments], check=True, capture_output=True, text=True).stdout


class Hardening(unittest.TestCase):
    def holds(self, what, rule):
        for program in PROGRAMS:
            with self.subTest(program=program):
                self.assertTrue(rule(program), what)

    def test_lands_anywhere_in_memory(self):
        self.holds("position-independent", lambda program: "DYN (Position-Independent" in readelf("-h", program))

    def test_tables_of_functions_are_bound_at_once_and_read_only(self):
        self.holds("full RELRO", lambda program: "GNU_RELRO" in readelf("-l", program))
        self.holds("BIND_NOW", lambda program: any("FLAGS" in line and "NOW" in line
                                                   for line in readelf("-d", program).splitlines()))

    def test_stacks_are_guarded_and_hold_no_code(self):
        self.holds("stack protector", lambda program: "__stack_chk_fail" in readelf("--dyn-syms", program))
        self.holds("no code on the stack", lambda program: not any(
            "GNU_STACK" in line and "RWE" in line for line in readelf("-l", program).splitlines()))

    def test_copies_are_checked(self):
        self.holds("FORTIFY", lambda program: "_chk@" in readelf("--dyn-syms", program).replace("__stack_chk", ""))

    @unittest.skipUnless(platform.machine() == "x86_64", "no such thing here")
    def test_jumps_go_to_marked_places(self):
        def marked(program):
            # The libraries of the system have a say in the note of the file; our own functions are marked or not.
            code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True, capture_output=True,
                                  text=True).stdout
            return "endbr64" in code[code.index("<main>:"):][:200]
        self.holds("CET", marked)


if __name__ == "__main__":
    PROGRAMS = sys.argv[1:]
    if not shutil.which("readelf") or not shutil.which("objdump"):
        print("readelf and objdump (binutils) are not there")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
