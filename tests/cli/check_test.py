"""sinew check finds what is wrong with a mesh or a skeleton, and nothing where nothing is."""
import json
import unittest

from program import CUBE_OBJ, TRIPOD, ProgramTest, tube


class Meshes(ProgramTest):
    def check(self, text, *options, status=0):
        self.write("mesh.obj", text)
        (said,) = self.objects("check", "mesh.obj", *options, status=status)
        return said

    def test_cube(self):
        said = self.check(CUBE_OBJ)
        for what in ("closed", "manifold", "oriented", "outward", "finite"):
            self.assertIs(said[what], True, what)
        self.assertEqual((said["vertices"], said["edges"], said["faces"], said["euler"]), (8, 12, 6, 2))
        self.assertEqual((said["quads"], said["triangles"], said["components"], said["irregular"]), (6, 0, 1, 8))
        self.assertEqual(said["self_intersections"], 0)
        self.assertAlmostEqual(said["area"], 6)
        self.assertAlmostEqual(said["volume"], 1)

    def test_hole(self):
        said = self.check(CUBE_OBJ.replace("f 4 1 5 8\n", ""), status=1)
        self.assertIs(said["closed"], False)
        self.assertEqual(said["boundary_edges"], 4)

    def test_flipped_face(self):
        said = self.check(CUBE_OBJ.replace("f 4 1 5 8", "f 8 5 1 4"), status=1)
        self.assertIs(said["oriented"], False)
        self.assertEqual(said["flipped_edges"], 4)

    def test_inside_out(self):
        faces = [line.split() for line in CUBE_OBJ.splitlines()]
        text = "\n".join(" ".join(f[:1] + f[:0:-1]) if f[0] == "f" else " ".join(f) for f in faces)
        said = self.check(text + "\n", status=1)
        self.assertIs(said["outward"], False)
        self.assertAlmostEqual(said["volume"], -1)

    def two_cubes(self, offset):
        """A second cube of half the size, moved along x."""
        lines = []
        for line in CUBE_OBJ.splitlines():
            words = line.split()
            if words[0] == "v":
                x, y, z = (0.5 * float(word) + 0.25 for word in words[1:])
                lines.append(f"v {x + offset} {y} {z}")
            else:
                lines.append("f " + " ".join(str(int(word) + 8) for word in words[1:]))
        return CUBE_OBJ + "\n".join(lines) + "\n"

    def test_self_intersections(self):
        apart = self.check(self.two_cubes(2))
        self.assertEqual((apart["components"], apart["self_intersections"]), (2, 0))
        through = self.check(self.two_cubes(0.5))  # four sides of the small cube pass through one of the large
        self.assertEqual((through["components"], through["self_intersections"]), (2, 4))
        self.check(self.two_cubes(0.5), "--strict", status=1)
        self.assertNotIn("self_intersections", self.check(self.two_cubes(0.5), "--fast"))

    def test_faces_of_no_area(self):
        flat = CUBE_OBJ.replace("f 4 3 2 1", "f 4 3 9 2 1\nf 2 9 3") + "v 1 0.5 0\n"
        said = self.check(flat)
        self.assertEqual((said["closed"], said["zero_area_faces"]), (True, 1))
        self.check(flat, "--strict", status=1)

    def test_beside_its_skeleton(self):
        self.done("skin", "tripod.sinew", "-o", "mesh.obj")
        (said,) = self.objects("check", "mesh.obj", "--skeleton", "tripod.sinew")
        self.assertEqual(said["irregular_at_most"], 2 * (3 - 2) + 3)
        self.assertLessEqual(said["irregular"], said["irregular_at_most"])
        self.assertLess(said["deviation"]["mean_abs"], 0.03)
        self.assertEqual((said["poles"], said["stray_triangles"]), (3, 0))

    def test_distance_is_that_of_the_cones(self):
        """The unit cube's corners lie outside a ball of radius 1/2 round its middle by (sqrt 3 - 1)/2."""
        self.write("ball.graph", "n 0.5 0.5 0.5 0.5\n")
        (said,) = self.objects("check", "cube.obj", "--skeleton", "ball.graph")
        self.assertAlmostEqual(said["deviation"]["mean"], 3 ** 0.5 - 1, places=6)
        self.assertAlmostEqual(said["deviation"]["max_abs"], 3 ** 0.5 - 1, places=6)

    def test_text_names_the_places(self):
        self.write("open.obj", CUBE_OBJ.replace("f 4 1 5 8\n", ""))
        run = self.sinew("check", "open.obj", "cube.obj")
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        self.assertIn("open.obj: not closed", run.stdout)
        self.assertIn("4 (between vertices 0-3, 0-4, 3-7, 4-7)", run.stdout)
        self.assertIn("cube.obj: closed, manifold, oriented outwards", run.stdout)


class Skeletons(ProgramTest):
    def test_counts(self):
        (said,) = self.objects("check", "tripod.sinew")
        self.assertEqual((said["nodes"], said["bones"], said["components"], said["cycles"]), (4, 3, 1, 0))
        self.assertEqual((said["leaves"], said["branches"], said["largest_degree"]), (3, 1, 3))

    def test_all_that_is_wrong(self):
        nodes = [dict(node) for node in TRIPOD["nodes"]]
        nodes[1]["radius"] = 0
        nodes[2]["id"] = 1
        nodes[3]["type"] = "cone"
        nodes.append({"id": 9, "parent": 4, "position": [0, 0, 9], "radius": 1})
        self.write("bad.sinew", json.dumps({**TRIPOD, "nodes": nodes}))
        (said,) = self.objects("check", "bad.sinew", status=1)
        paths = {problem["path"] for problem in said["problems"]}
        self.assertEqual(paths, {"/nodes/1/radius", "/nodes/2/id", "/nodes/3/type"})

    def test_repairs_are_told(self):
        self.write("dense.graph", tube(nodes=100, distance=0.1))
        run = self.done("check", "dense.graph")
        self.assertIn("thinned", run.stderr)
        self.assertRegex(run.stdout, r"100, \d+ after conditioning")
        self.refused(1, "check", "dense.graph", "--strict", says="thinned")

    def test_unreadable(self):
        self.write("bad.swc", "1 1 0 0 0 1 -1\n2 3 0 0 nan 1 1\n")
        self.refused(1, "check", "bad.swc", says="bad.swc:2")
        self.refused(2, "check", "tripod.sinew", "--skeleton", "tripod.sinew", says="--skeleton")


if __name__ == "__main__":
    unittest.main()
