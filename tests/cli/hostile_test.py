"""What an attacker or a bad day brings: files that reach for others, grow without end or write to the terminal, and
targets that are open, linked or full. Larger cases of ../shared are run where they are."""
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

from program import CUBE_OBJ, ROOT, SINEW, TRIPOD, ProgramTest

SHARED = pathlib.Path(os.environ.get("SINEW_SHARED") or ROOT.parent / "shared") / "cases" / "hostile"


def gltf(uri, count=3, **more):
    """A mesh of bytes that lie in another file."""
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": uri, "byteLength": 3 * count}], "bufferViews": [{"buffer": 0, "byteLength": 3 * count}],
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": count, "type": "VEC3"}], **more})


class OtherFiles(ProgramTest):
    def setUp(self):
        super().setUp()
        self.secret = self.write("secret.txt", "abcdefghi and more")
        (self.folder / "model").mkdir()
        (self.folder / "model/data.bin").write_bytes(bytes([0, 0, 0, 9, 0, 0, 0, 9, 0]))
        os.symlink("../secret.txt", self.folder / "model/link.bin")

    def test_beside_the_file_are_read(self):
        self.write("model/a.gltf", gltf("data.bin"))
        self.done("convert", "model/a.gltf", "-o", "a.obj")
        self.assertIn("v 9 ", self.read("a.obj"))

    def test_elsewhere_are_not(self):
        for uri in [str(self.secret), "file://" + str(self.secret), "../secret.txt", "%2e%2e/secret.txt", "link.bin",
                    "..%2Fsecret.txt", "/dev/stdin", "/proc/self/environ"]:
            self.write("model/a.gltf", gltf(uri))
            for command in [("convert", "model/a.gltf", "-o", "a.obj"), ("check", "model/a.gltf")]:
                run = self.refused(1, *command, says=["/buffers/0/uri: names the file"])
                self.assertNotIn(str(len(self.secret.read_text())), run.stderr.replace(str(self.folder), ""))
            self.assertNotIn("a.obj", self.files())

    def test_are_not_named_by_standard_input(self):
        for uri in ["secret.txt", "model/data.bin"]:
            self.refused(1, "convert", "-", "--from", "gltf", "-o", "a.obj", stdin=gltf(uri), says="standard input may name none")


class BrokenGltf(ProgramTest):
    def test_is_called_broken_by_every_command(self):
        texts = {"depth": gltf("a.bin", extras=0).replace('"extras": 0', '"extras": ' + "[" * 50_000 + "]" * 50_000),
                 "list": json.dumps({"asset": {"version": "2.0"}, "accessors": [{"count": 1}], "meshes": []}),
                 "text": '{"asset": {"version": "2.0"}, "nodes": ['}
        for name, text in texts.items():
            self.write(f"{name}.gltf", text)
            for command in [("check",), ("convert", "-o", "a.obj"), ("convert", "-o", "a.sinew"), ("skin", "-o", "b.obj"),
                            ("subdivide", "-o", "c.obj"), ("render", "-o", "d.png")]:
                run = self.sinew(command[0], f"{name}.gltf", *command[1:])
                self.assertEqual(run.returncode, 1, (name, command, run.stderr))
                self.assertIn("the glTF file is broken: ", run.stderr)
                self.assertIn("; ", run.stderr)  # what to do


class Messages(ProgramTest):
    def assert_clean(self, run):
        for character in run.stdout + run.stderr:
            self.assertTrue(character == "\n" or character.isprintable(), repr(character))

    def test_hold_nothing_that_a_terminal_obeys(self):
        evil = "\x1b]0;owned\x07\x1b[31m\x7f\x9b31m\u202e"
        node = {"id": 1, "position": [0, 0, 0], "radius": 1, "type": evil}
        self.write("a.sinew", json.dumps({"format": "sinew", "version": 1, "nodes": [node]}))
        self.write(f"{evil}.sinew", json.dumps(TRIPOD))
        self.write(f"{evil}.obj", CUBE_OBJ)
        for words in [("check", "a.sinew"), ("check", f"{evil}.sinew"), ("check", f"{evil}.obj"), ("check", evil),
                      ("skin", f"{evil}.sinew", "-o", f"{evil}2.obj"), ("check", f"{evil}.obj", "--json"), (evil,),
                      ("convert", f"{evil}.sinew", "-o", "x.graph"), ("check", "a.sinew", "--json")]:
            self.assert_clean(self.sinew(*words))

    def test_show_a_line_end_in_a_name_by_its_code(self):
        run = self.sinew("check", "a\nsinew: all is well")
        self.assertIn(r"a\x0asinew: all is well", run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1)

    def test_are_cut(self):
        node = {"id": 1, "position": [0, 0, 0], "radius": 1, "type": "x" * 100_000}
        self.write("a.sinew", json.dumps({"format": "sinew", "version": 1, "nodes": [node]}))
        run = self.sinew("check", "a.sinew")
        self.assertEqual(run.returncode, 1)
        self.assertIn("a.sinew", run.stdout + run.stderr)
        self.assertLess(len(run.stdout + run.stderr), 5000)

    def test_agree_in_number(self):
        self.write("one.graph", "n 0 0 0 1\n")
        self.assertEqual(self.done("convert", "one.graph", "-o", "one.sinew").stdout, "one.sinew: 1 node\n")
        self.assertEqual(self.done("convert", "tripod.sinew", "-o", "four.graph").stdout, "four.graph: 4 nodes\n")


class Targets(ProgramTest):
    def test_that_are_open_are_written_where_they_stand(self):
        for target in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"]:
            self.write("log", "before\n")
            with open(self.folder / "log", "a") as log:
                subprocess.run([str(SINEW), "convert", "cube.obj", "-o", target, "--to", "obj", "-q"], cwd=self.folder,
                               stdout=log, check=True)
            self.assertTrue(self.read("log").startswith("before\n"))
            self.assertIn("\nf ", self.read("log"))

    def test_of_several_names_keep_them(self):
        self.write("a.obj", "old")
        os.link(self.folder / "a.obj", self.folder / "b.obj")
        self.done("convert", "cube.obj", "-o", "a.obj")
        self.assertEqual(self.read("a.obj"), self.read("b.obj"))
        self.assertNotEqual(self.read("a.obj"), "old")

    def test_with_what_a_killed_run_left(self):
        self.write(".a.obj.part", "half")
        self.done("convert", "cube.obj", "-o", "a.obj")
        self.assertNotIn(".a.obj.part", self.files())

    def test_that_lead_in_a_circle(self):
        os.symlink("b.obj", self.folder / "a.obj")
        os.symlink("a.obj", self.folder / "b.obj")
        self.refused(2, "convert", "cube.obj", "-o", "a.obj", says="circle")

    def test_with_names_that_are_too_long(self):
        self.refused(2, "convert", "cube.obj", "-o", "a" * 300 + ".obj", says="take a shorter name")

    def test_that_are_their_own_input_in_another_format(self):
        text = self.read("tripod.sinew")
        os.symlink("tripod.sinew", self.folder / "link.obj")
        self.refused(2, "convert", "tripod.sinew", "-o", "tripod.sinew", "--to", "graph", says="another format")
        self.refused(2, "skin", "tripod.sinew", "-o", "link.obj", says="another format")
        self.assertEqual(self.read("tripod.sinew"), text)
        self.done("convert", "tripod.sinew", "-o", "tripod.sinew")

    def test_that_are_full(self):
        with open("/dev/full", "w") as full:
            for words in [("--help",), ("--version",), ("skin", "--help"), ("formats",), ("formats", "--json"),
                          ("check", "cube.obj"), ("check", "cube.obj", "--json")]:
                run = subprocess.run([str(SINEW), *words], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, text=True)
                self.assertEqual(run.returncode, 2, (words, run.stderr))
                self.assertIn("make room", run.stderr)

    def test_do_not_run_as_somebody_else(self):
        self.write("a.obj", "old").chmod(0o6755)
        self.done("convert", "cube.obj", "-o", "a.obj")
        self.assertEqual((self.folder / "a.obj").stat().st_mode & 0o7777, 0o755)


class WithoutEnd(ProgramTest):
    def test_devices_are_no_input(self):
        self.refused(1, "check", "/dev/zero", "--from", "obj", says="is a device")

    def stops(self, number, *words, after=0.5):
        process = subprocess.Popen([str(SINEW), *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(after)
        if process.poll() is None:
            process.send_signal(number)
        try:
            _, error = process.communicate(timeout=20)
        finally:
            process.kill()
        return process.returncode, error.decode()

    def test_pipes_that_nobody_opens_do_not_hold_it(self):
        os.mkfifo(self.folder / "pipe.obj")
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]:
            for words in [("check", "pipe.obj"), ("convert", "cube.obj", "-o", "pipe.obj"),
                          ("check", "cube.obj", "--skeleton", "pipe.obj", "--from", "obj")]:
                status, error = self.stops(number, *words)
                self.assertIn(status, (1, 2, 3), (words, error))

    def test_growing_stops_on_request(self):
        self.write("a.lsys", "%axiom A\n%steps 60\nA -> (1) AA\nA -> (1) AAA\n")
        status, error = self.stops(signal.SIGINT, "grow", "a.lsys", "-o", "a.sinew")
        self.assertEqual((status, self.files().count("a.sinew")), (3, 0), error)

    def test_steps_that_change_nothing_are_over(self):
        self.write("a.lsys", "%axiom A F\n%steps 1000000000\nA < A -> A\n")
        self.done("grow", "a.lsys", "-o", "a.sinew")

    def test_faces_that_lie_over_each_other(self):
        self.write("pile.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 50_000)
        run = self.sinew("check", "pile.obj")
        self.assertEqual(run.returncode, 1)
        self.assertIn("too many faces lie over each other to find all", run.stdout)
        line, = self.objects("check", "pile.obj", status=1)
        self.assertIs(line["self_intersections_complete"], False)

    @unittest.skipUnless(SHARED.exists(), "no ../shared")
    def test_cases_of_others(self):
        """Each ends, and well or with a message; none with a signal."""
        for name, command in [("read_any_file_absolute_uri.gltf", "convert"), ("leak_link.gltf", "convert"),
                              ("segv_nested_extras.gltf", "convert"), ("bomb_small.glb", "convert"),
                              ("dup4000.ply", "check"), ("fan4000.ply", "check"), ("deep4000.usda", "check"),
                              ("manymods.lsys", "grow"), ("steps3.lsys", "grow"), ("esctype.sinew", "check")]:
            output = {"convert": ["-o", self.folder / "out.obj"], "grow": ["-o", self.folder / "out.sinew"]}
            with self.subTest(name):
                run = self.sinew(command, SHARED / name, *output.get(command, []))
                self.assertIn(run.returncode, (0, 1))
                self.assertNotIn("\x1b", run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
