"""Where inputs come from and results go: pipes, folders, targets that cannot be written."""
import json
import os
import resource
import shutil
import subprocess
import unittest

from program import CUBE_OBJ, RING_GRAPH, SINEW, TRIPOD, ProgramTest


class Pipes(ProgramTest):
    def test_standard_input_and_output(self):
        self.done("skin", "tube.graph", "-o", "tube.obj")
        run = self.done("skin", "-", "--from", "graph", "-o", "-", "--to", "obj", stdin=self.read("tube.graph"))
        self.assertEqual(run.stdout, self.read("tube.obj"))
        self.assertEqual(run.stderr, "")

    def test_silent_in_a_pipe(self):
        self.assertEqual(self.done("skin", "tube.graph", "-o", "tube.obj").stderr, "")
        self.assertEqual(self.done("skin", "tube.graph", "-o", "tube.obj", "--quiet").stdout, "")

    def test_names_for_standard_input(self):
        self.refused(1, "skin", "-", "--from", "graph", "-o", "a.obj", stdin="n 0 0 nan 1\n", says="standard input:1")

    def test_json_needs_standard_output_for_itself(self):
        self.refused(2, "skin", "tube.graph", "-o", "-", "--to", "obj", "--json", says="--json")

    def test_standard_input_once(self):
        self.refused(2, "skin", "-", "-", "--from", "graph", "-o", "out/", says="once")

    def test_conversions_chain(self):
        graph = self.done("convert", "tripod.sinew", "-o", "-", "--to", "graph").stdout
        sinew = self.done("convert", "-", "--from", "graph", "-o", "-", "--to", "sinew", stdin=graph).stdout
        positions = [node["position"] for node in json.loads(sinew)["nodes"]]
        self.assertEqual(positions, [node["position"] for node in TRIPOD["nodes"]])


class SeveralInputs(ProgramTest):
    def test_go_into_a_folder(self):
        lines = self.objects("skin", "tube.graph", "ring.graph", "tripod.sinew", "-o", "new/meshes")
        self.assertEqual(self.files("new/meshes"), ["ring.obj", "tripod.obj", "tube.obj"])
        self.assertEqual([line["input"] for line in lines], ["tube.graph", "ring.graph", "tripod.sinew"])
        self.assertEqual([line["cycles"] for line in lines], [0, 1, 0])

    def test_take_the_format_from_to(self):
        self.done("skin", "tube.graph", "ring.graph", "-o", "meshes", "--to", "ply")
        self.assertEqual(self.files("meshes"), ["ring.ply", "tube.ply"])

    def test_one_input_into_a_folder(self):
        self.done("skin", "tube.graph", "-o", "meshes/")
        self.done("skin", "ring.graph", "-o", "meshes")  # a folder by now
        self.assertEqual(self.files("meshes"), ["ring.obj", "tube.obj"])

    def test_a_bad_one_does_not_stop_the_others(self):
        self.write("bad.graph", "n 0 0 0\n")
        run = self.sinew("skin", "bad.graph", "tube.graph", "-o", "meshes", "--json")
        self.assertEqual(run.returncode, 1)
        first, second = map(json.loads, run.stdout.splitlines())
        self.assertEqual((first["error"]["file"], first["error"]["line"]), ("bad.graph", 1))
        self.assertEqual(second["output"], "meshes/tube.obj")
        self.assertEqual(self.files("meshes"), ["tube.obj"])

    def test_must_not_fall_together(self):
        self.write("other/tube.graph", RING_GRAPH)
        self.refused(2, "skin", "tube.graph", "other/tube.graph", "-o", "meshes", says="both be written to meshes/tube.obj")

    def test_do_not_go_into_a_file(self):
        self.refused(2, "skin", "tube.graph", "ring.graph", "-o", "cube.obj", says="folder")
        self.assertEqual(self.read("cube.obj"), CUBE_OBJ)

    def test_need_a_format(self):
        self.refused(2, "convert", "tube.graph", "ring.graph", "-o", "out", says="--to")


class FailedWrites(ProgramTest):
    """The old file stays as it was, and nothing is left beside it."""

    def assert_untouched(self, *words, status, says, **options):
        before = self.files()
        self.write("old.obj", "the old file")
        self.refused(status, *words, "-o", "old.obj", says=says, **options)
        self.assertEqual(self.read("old.obj"), "the old file")
        self.assertEqual(self.files(), sorted(before + ["old.obj"]))

    def test_full_target(self):
        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64))
        self.assert_untouched("skin", "tube.graph", status=2, says="old.obj: cannot be written", preexec_fn=little_room)

    def test_full_device(self):
        self.refused(2, "skin", "tube.graph", "-o", "/dev/full", "--to", "obj", says="No space left")
        with open("/dev/full", "w") as full:
            run = self.sinew_into(full, "check", "cube.obj")
        self.assertEqual(run.returncode, 2)

    def sinew_into(self, target, *words):
        return subprocess.run([str(SINEW), *words], cwd=self.folder, stdout=target, stderr=subprocess.PIPE, text=True)

    def test_read_only_folder(self):
        """As somebody who is not root, whom permissions do not stop."""
        program = self.folder / "bin" / "sinew"
        program.parent.mkdir()
        shutil.copy(SINEW, program)
        (self.folder / "locked").mkdir()
        old = self.write("locked/old.obj", "the old file")
        (self.folder / "locked").chmod(0o555)
        self.folder.chmod(0o755)
        self.addCleanup((self.folder / "locked").chmod, 0o755)

        def somebody():
            if os.geteuid() == 0:
                os.setgid(65534)
                os.setuid(65534)
        run = subprocess.run([str(program), "skin", "tube.graph", "-o", "locked/old.obj"], cwd=self.folder,
                             capture_output=True, text=True, preexec_fn=somebody)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("locked/old.obj: cannot be written (Permission denied)", run.stderr)
        self.assertEqual(old.read_text(), "the old file")
        self.assertEqual(self.files("locked"), ["old.obj"])

    def test_bad_input(self):
        self.write("bad.graph", "n 0 0 0 1\nn 0 0 nan 1\nc 0 1\n")
        self.assert_untouched("skin", "bad.graph", status=1, says="bad.graph:2")


if __name__ == "__main__":
    unittest.main()
