"""How the program is called: help, version, wrong calls."""
import os
import pathlib
import unittest

from program import ProgramTest

GOLDEN = pathlib.Path(__file__).parent / "golden"
COMMANDS = ["skin", "check", "convert", "render", "grow", "subdivide", "edit", "formats"]


class Help(ProgramTest):
    """The help texts are those in golden/. After a wanted change run this file with SINEW_UPDATE_GOLDEN=1, and read them."""

    def assert_golden(self, name, text):
        path = GOLDEN / name
        if os.environ.get("SINEW_UPDATE_GOLDEN"):
            path.write_text(text)
        self.assertEqual(text, path.read_text())

    def test_of_the_program(self):
        self.assert_golden("help.txt", self.done("--help").stdout)

    def test_of_every_command(self):
        for command in COMMANDS:
            with self.subTest(command):
                text = self.done(command, "--help").stdout
                self.assert_golden(f"help_{command}.txt", text)
                self.assertIn("Examples:\n  sinew " + command, text)
                self.assertLessEqual(max(map(len, text.splitlines())), 120)

    def test_names_every_command(self):
        listed = self.done("--help").stdout.split("Commands:")[1].split("\n\n")[0]
        self.assertEqual([line.split()[0] for line in listed.strip().splitlines()], COMMANDS)

    def test_version(self):
        self.assertRegex(self.done("--version").stdout, r"^sinew \d+\.\d+\.\d+\n$")


class WrongCalls(ProgramTest):
    """Status 2, a hint on standard error, nothing on standard output."""

    def test_no_command(self):
        self.refused(2, says=["a command is needed", "Try 'sinew --help'."])

    def test_unknown_command(self):
        self.refused(2, "skni", says=["no command 'skni'", "did you mean 'skin'?"])

    def test_unknown_option(self):
        run = self.refused(2, "skin", "tripod.sinew", "-o", "a.obj", "--subdivde", "2",
                           says=["no option '--subdivde'", "did you mean '--subdivide'?", "Try 'sinew skin --help'."])
        self.assertEqual(len(run.stderr.splitlines()), 2)

    def test_nothing_near(self):
        self.assertNotIn("did you mean", self.refused(2, "skin", "--zzzzzzzzz").stderr)

    def test_missing_parts(self):
        self.refused(2, "skin", "tripod.sinew", says="--output is required")
        self.refused(2, "skin", "-o", "a.obj", says="IN is required")
        self.refused(2, "check", says="IN is required")

    def test_values_out_of_range(self):
        for option, value in [("--sides", "3"), ("--sides", "many"), ("--sides", "1025"), ("--subdivide", "-1"),
                              ("--subdivide", "11"), ("--subdivide", "x"), ("--fit", "tight"), ("--stage", "last")]:
            with self.subTest(option=option, value=value):
                self.refused(2, "skin", "tripod.sinew", "-o", "a.obj", f"{option}={value}", says=[option, value])
        self.assertNotIn("a.obj", self.files())

    def test_formats_that_do_not_fit(self):
        self.refused(2, "skin", "tripod.sinew", "-o", "a.swc", says=["'swc' cannot be written as a mesh", "obj"])
        self.refused(2, "skin", "tripod.sinew", "-o", "a", says="does not say which format")
        self.refused(2, "skin", "tripod.sinew", "-o", "a.xyz", says="'.xyz' is of no known format")
        self.refused(2, "skin", "cube.obj", "-o", "a.obj", says="'obj' cannot be read as a skeleton")
        self.refused(2, "skin", "-", "-o", "a.obj", says="does not say which format")
        self.refused(2, "convert", "tripod.sinew", "-o", "a.obj", says="sinew skin tripod.sinew -o a.obj")

    def test_missing_input(self):
        self.refused(1, "skin", "nobody.sinew", "-o", "a.obj", says=["nobody.sinew", "No such file"])

    def test_missing_output_folder(self):
        self.refused(2, "skin", "tripod.sinew", "-o", "no/where/a.obj", says=["no/where/a.obj", "make the folder first"])


class Formats(ProgramTest):
    def test_table_and_json_agree(self):
        table = self.done("formats").stdout.splitlines()[1:]
        (listed,) = self.objects("formats")
        self.assertEqual([line.split()[0] for line in table], [each["name"] for each in listed])
        uses = {each["name"]: each["uses"] for each in listed}
        self.assertIn("read skeleton", uses["swc"])
        self.assertIn("write mesh", uses["usda"])


if __name__ == "__main__":
    unittest.main()
