"""sinew skin, subdivide, convert and grow: what is written is what was asked for."""
import json
import math
import re
import unittest

from program import TRIPOD, ProgramTest, tube


def obj(text):
    """(vertices, faces) of an OBJ file, indices from 0"""
    lines = [line.split() for line in text.splitlines()]
    vertices = [tuple(map(float, line[1:4])) for line in lines if line and line[0] == "v"]
    faces = [tuple(int(word.split("/")[0]) - 1 for word in line[1:]) for line in lines if line and line[0] == "f"]
    return vertices, faces


def euler_number(vertices, faces):
    edges = {frozenset(pair) for face in faces for pair in zip(face, face[1:] + face[:1])}
    return len(vertices) - len(edges) + len(faces)


class Skin(ProgramTest):
    def mesh_of(self, name, *options):
        self.done("skin", name, "-o", "mesh.obj", *options)
        return obj(self.read("mesh.obj"))

    def test_says_what_it_made(self):
        (said,) = self.objects("skin", "tripod.sinew", "-o", "mesh.obj")
        vertices, faces = obj(self.read("mesh.obj"))
        self.assertEqual((said["vertices"], said["faces"]), (len(vertices), len(faces)))
        self.assertEqual(said["quads"], sum(len(face) == 4 for face in faces))
        self.assertEqual(said["triangles"], sum(len(face) == 3 for face in faces))
        self.assertEqual((said["components"], said["cycles"], said["euler"]), (1, 0, euler_number(vertices, faces)))
        self.assertEqual(said["irregular_at_most"], 2 * (3 - 2) + 3)  # a joint of degree 3, three poles
        self.assertEqual(said["warnings"], [])

    def test_a_cycle_is_a_torus(self):
        vertices, faces = self.mesh_of("ring.graph")
        self.assertEqual(euler_number(vertices, faces), 0)
        self.assertEqual({len(face) for face in faces}, {4})

    def test_sides(self):
        for sides in (4, 6, 9):
            _, faces = self.mesh_of("tube.graph", "--sides", str(sides))
            self.assertEqual(sum(len(face) == 3 for face in faces), 2 * sides)  # a fan at each end

    def test_fit(self):
        self.write("tube.graph", tube(nodes=13, distance=5))

        def radius(*options):  # far from the ends
            vertices, _ = self.mesh_of("tube.graph", *options)
            return max((x * x + y * y) ** 0.5 for x, y, z in vertices if 27 < z < 33)
        self.assertAlmostEqual(radius(), 1, delta=0.001)
        for sides in (4, 5, 8):
            self.assertAlmostEqual(radius("--sides", sides, "--fit", "control"), 1, delta=0.001)
            kept = (4 + 2 * math.cos(2 * math.pi / sides)) / 6  # of a ring, in the limit of uniform cubic B-splines
            self.assertAlmostEqual(radius("--sides", sides, "--fit", "limit") * kept, 1, delta=0.02)

    def test_subdivided(self):
        """Four faces of each, a pole's valence doubles; the smooth surface has the radius without being asked."""
        self.write("tube.graph", tube(nodes=13, distance=5))
        _, control = self.mesh_of("tube.graph")
        vertices, faces = self.mesh_of("tube.graph", "--subdivide", "2")
        triangles = sum(len(face) == 3 for face in control)
        self.assertEqual(sum(len(face) == 3 for face in faces), 4 * triangles)
        self.assertEqual(euler_number(vertices, faces), 2)
        radii = [(x * x + y * y) ** 0.5 for x, y, z in vertices if 20 < z < 40]
        self.assertAlmostEqual(sum(radii) / len(radii), 1, delta=0.03)

    def test_fitted_to_the_limit_says_how_to_get_there(self):
        """Mesh files cannot say that only the limit surface has the radii."""
        self.write("tube.graph", tube(nodes=13, distance=5))

        def radii(name):
            vertices, _ = obj(self.read(name))
            return [(x * x + y * y) ** 0.5 for x, y, z in vertices if 20 < z < 40]
        said = self.done("skin", "tube.graph", "-o", "mesh.obj", "--fit", "limit").stdout
        self.assertGreater(max(radii("mesh.obj")), 1.3)
        advice = re.search(r"sinew (subdivide mesh.obj --limit)", said).group(1)
        self.done(*advice.split(), "-o", "smooth.obj")
        self.assertTrue(all(abs(radius - 1) < 0.02 for radius in radii("smooth.obj")))
        for options in ([], ["--subdivide", "1"], ["--subdivide", "1", "--fit", "limit"], ["--stage", "bridge"]):
            self.assertNotIn("limit", self.done("skin", "tube.graph", "-o", "mesh.obj", *options).stdout)

    def test_stages_are_meshes(self):
        for stage in ("polyhedra", "refine", "bridge", "place"):
            vertices, faces = self.mesh_of("tripod.sinew", "--stage", stage)
            self.assertTrue(vertices and faces, stage)
        self.assertEqual((vertices, faces), self.mesh_of("tripod.sinew"))

    def test_same_bytes_twice(self):
        made = [self.done("skin", "tripod.sinew", "-o", name, "--sides", "8") for name in ("a.ply", "b.ply")]
        self.assertEqual(len(made), 2)
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())

    def test_repairs_are_told_and_strictly_refused(self):
        self.write("doubled.graph", "n 0 0 0 1\nn 0 0 5 1\nn 0 0 10 0\nc 0 1\nc 1 2\nc 2 1\n")
        run = self.done("skin", "doubled.graph", "-o", "mesh.obj")
        self.assertIn("warning: doubled.graph: ", run.stderr)
        self.assertNotIn("warning", self.done("skin", "doubled.graph", "-o", "mesh.obj", "--quiet").stderr)
        self.refused(1, "skin", "doubled.graph", "-o", "strict.obj", "--strict", says="doubled.graph")
        self.assertNotIn("strict.obj", self.files())

    def test_keep_nodes(self):
        self.write("dense.graph", tube(nodes=100, distance=0.1))
        (thinned,) = self.objects("skin", "dense.graph", "-o", "mesh.obj")
        (kept,) = self.objects("skin", "dense.graph", "-o", "mesh.obj", "--keep-nodes")
        self.assertLess(thinned["vertices"], kept["vertices"])
        self.assertTrue(thinned["warnings"])
        self.assertFalse(kept["warnings"])

    def test_json_of_an_error(self):
        self.write("bad.sinew", json.dumps({**TRIPOD, "nodes": [{**TRIPOD["nodes"][0], "radius": -1}]}))
        (said,) = self.objects("skin", "bad.sinew", "-o", "mesh.obj", status=1)
        error = said["error"]
        self.assertEqual((error["kind"], error["file"], error["path"], error["node"]),
                         ("input", "bad.sinew", "/nodes/0/radius", 1))


class Subdivide(ProgramTest):
    def test_cube(self):
        """Catmull-Clark: new points of faces, edges and vertices of the unit cube are known."""
        self.done("subdivide", "cube.obj", "-o", "fine.obj")
        vertices, faces = obj(self.read("fine.obj"))
        self.assertEqual((len(vertices), len(faces)), (8 + 12 + 6, 24))
        rounded = {tuple(round(x, 5) for x in vertex) for vertex in vertices}
        for point in ((0.22222, 0.22222, 0.22222), (0.5, 0.125, 0.125), (0.5, 0.5, 0)):
            self.assertIn(point, rounded)

    def test_levels_and_limit(self):
        for levels in (0, 1, 3):
            (said,) = self.objects("subdivide", "cube.obj", "-o", "fine.obj", "--levels", str(levels))
            self.assertEqual(said["faces"], 6 * 4 ** levels)
        self.done("subdivide", "cube.obj", "-o", "control.obj", "--levels", "0", "--limit")
        vertices, _ = obj(self.read("control.obj"))
        self.assertTrue(all(0.2 < x < 0.8 for vertex in vertices for x in vertex))

    def test_too_many_levels(self):
        self.refused(2, "subdivide", "cube.obj", "-o", "fine.obj", "--levels", "20", says="faces")
        self.assertNotIn("fine.obj", self.files())


class Convert(ProgramTest):
    def test_keeps_every_key(self):
        document = {**TRIPOD, "author": {"name": "somebody"}, "links": [[2, 3]]}
        self.write("a.sinew", json.dumps(document))
        self.done("convert", "a.sinew", "-o", "b.sinew")
        self.assertEqual(json.loads(self.read("b.sinew")), document)
        self.done("convert", "b.sinew", "-o", "b.sinew")  # in place
        self.assertEqual(json.loads(self.read("b.sinew")), document)

    def test_tells_what_is_lost(self):
        run = self.done("convert", "ring.graph", "-o", "ring.swc")
        self.assertIn("warning: ring.swc: ", run.stderr)
        self.refused(1, "convert", "ring.graph", "-o", "strict.swc", "--strict", says="strict.swc")

    def test_meshes_keep_vertices_and_faces(self):
        self.done("convert", "cube.obj", "-o", "cube.ply", "--ascii")
        self.assertTrue(self.read("cube.ply").startswith("ply\nformat ascii 1.0\n"))
        self.done("convert", "cube.ply", "-o", "back.obj")
        self.assertEqual(obj(self.read("back.obj")), obj(self.read("cube.obj")))

    def test_newer_version_is_refused(self):
        self.write("new.sinew", json.dumps({**TRIPOD, "version": 2}))
        self.refused(1, "convert", "new.sinew", "-o", "b.sinew", says=["new.sinew", "/version", "2"])


class Grow(ProgramTest):
    GRAMMAR = "%steps 3\n%axiom A\nturn = 30\nA -> !(0.1) F(1) [+(turn) A] [-(turn) A]\n"

    def test_binary_tree(self):
        self.write("tree.lsys", self.GRAMMAR)
        self.done("grow", "tree.lsys", "-o", "tree.sinew")
        nodes = json.loads(self.read("tree.sinew"))["nodes"]
        self.assertEqual(len(nodes), 2 ** 3)  # a root and 1 + 2 + 4 segments
        self.done("grow", "tree.lsys", "-o", "tree.sinew", "--steps", "5")
        self.assertEqual(len(json.loads(self.read("tree.sinew"))["nodes"]), 2 ** 5)

    def test_constants(self):
        self.write("tree.lsys", self.GRAMMAR)
        trees = {self.done("grow", "tree.lsys", "-o", "-", "--to", "graph", "--set", f"turn={turn}").stdout
                 for turn in (30, 60)}
        self.assertEqual(len(trees), 2)
        self.refused(2, "grow", "tree.lsys", "-o", "t.sinew", "--set", "twist=1", says="twist")
        self.refused(2, "grow", "tree.lsys", "-o", "t.sinew", "--set", "turn", says="NAME=NUMBER")

    def test_mistakes_have_a_place(self):
        self.write("bad.lsys", self.GRAMMAR + "F -> (\n")
        self.refused(1, "grow", "bad.lsys", "-o", "t.sinew", says="bad.lsys:5:")


if __name__ == "__main__":
    unittest.main()
