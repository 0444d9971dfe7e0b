"""sinew-modeler from outside: its help, the calls it refuses, no display, and what belongs to it on a desktop."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELER = os.environ.get("SINEW_MODELER") or str(ROOT / "build/release/bin/sinew-modeler")
BUILD = os.environ.get("SINEW_BUILD") or str(ROOT / "build/release")
DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")


def run(*words, **environment):
    variables = {key: value for key, value in os.environ.items() if key not in DISPLAYS}
    return subprocess.run([MODELER, *words], capture_output=True, text=True, timeout=300,
                          env={**variables, **environment})


class Calls(unittest.TestCase):
    def test_help_needs_no_display(self):
        for word in ("--help", "-h"):
            done = run(word)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            for said in ("Usage: sinew-modeler [FILE]", ".sinew", ".swc", "--version", "--keys", "Exit status"):
                self.assertIn(said, done.stdout)
            self.assertLessEqual(max(map(len, done.stdout.splitlines())), 110)

    def test_version_is_that_of_the_project(self):
        project = re.search(r"project\(sinew VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
        for word in ("--version", "-V"):
            done = run(word)
            self.assertEqual((done.returncode, done.stdout), (0, f"sinew-modeler {project}\n"))

    def test_keys_are_tables(self):
        done = run("--keys")
        self.assertEqual(done.returncode, 0)
        self.assertIn("| Undo | Ctrl+Z |", done.stdout)
        self.assertIn("| Orbit |", done.stdout)

    def test_wrong_calls_are_refused_in_one_line(self):
        for words in (("--no-such-option",), ("one.sinew", "two.sinew"), ("-x",)):
            done = run(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertIn("--help", done.stderr)


class Display(unittest.TestCase):
    def assert_one_line(self, done):
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("sinew-modeler: "), done.stderr)
        self.assertIn("display", done.stderr)

    def test_none_is_said_in_one_line(self):
        self.assert_one_line(run())
        self.assert_one_line(run("goat.sinew"))
        self.assert_one_line(run(DISPLAY=""))

    def test_one_that_cannot_be_opened_is_said_in_one_line(self):
        self.assert_one_line(run(DISPLAY=":98765"))


class Desktop(unittest.TestCase):
    """What cmake --install puts beside the program."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="sinew-")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.place = pathlib.Path(cls.folder.name)
        # The modeler's own rules: the rest of the project may not be built.
        subprocess.run(["cmake", "-DCMAKE_INSTALL_PREFIX=" + str(cls.place), "-P",
                        BUILD + "/apps/modeler/cmake_install.cmake"], check=True, capture_output=True)

    def entry(self):
        text = (self.place / "share/applications/sinew-modeler.desktop").read_text(encoding="utf-8")
        self.assertTrue(text.startswith("[Desktop Entry]\n"))
        return dict(line.split("=", 1) for line in text.splitlines()[1:] if line)

    def test_program_is_installed_and_runs(self):
        done = subprocess.run([str(self.place / "bin/sinew-modeler"), "--version"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_entry_starts_the_program_with_a_file(self):
        entry = self.entry()
        self.assertEqual((entry["Type"], entry["Terminal"]), ("Application", "false"))
        self.assertTrue((self.place / "bin" / entry["Exec"].split()[0]).exists())
        self.assertIn("%f", entry["Exec"])
        self.assertTrue(entry["Categories"].endswith(";"))

    def test_entry_is_valid(self):
        if not shutil.which("desktop-file-validate"):
            self.skipTest("desktop-file-validate is not installed (Debian: desktop-file-utils)")
        done = subprocess.run(["desktop-file-validate", self.place / "share/applications/sinew-modeler.desktop"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_icon_is_where_the_entry_says(self):
        icon = self.place / "share/icons/hicolor/scalable/apps" / (self.entry()["Icon"] + ".svg")
        root = xml.etree.ElementTree.parse(icon).getroot()
        self.assertTrue(root.tag.endswith("svg"))
        self.assertTrue(list(root), "an icon without anything in it")


if __name__ == "__main__":
    unittest.main()
