"""`sinew edit`: each operation on a small skeleton, their order, and calls that are wrong."""
import json
import unittest

from program import ProgramTest


class Edit(ProgramTest):
    def edited(self, *operations, source="tripod.sinew"):
        """The nodes by id, and the links."""
        self.done("edit", source, "-o", "out.sinew", *(word for op in operations for word in ("--op", op)))
        document = json.loads(self.read("out.sinew"))
        return {node["id"]: node for node in document["nodes"]}, document.get("links", [])

    def test_consolidate(self):
        nodes, _ = self.edited("consolidate:1,0.5")
        self.assertEqual(len(nodes), 7)
        self.assertEqual([node["radius"] for node in nodes.values()][4:], [0.4] * 3)
        self.assertAlmostEqual(nodes[5]["position"][0], 2.7)
        self.assertEqual((nodes[2]["parent"], nodes[5]["parent"]), (5, 1))

    def test_merge(self):
        nodes, links = self.edited("merge:2,3")
        self.assertEqual(nodes[2]["position"], [1.5, 1.5, 0])
        self.assertEqual((sorted(nodes), links), ([1, 2, 4], []))

    def test_merge_close(self):
        self.assertEqual(len(self.edited("merge-close:4")[0]), 4)
        self.assertEqual(len(self.edited("merge-close:4.5")[0]), 3)

    def test_insert_and_dissolve(self):
        nodes, _ = self.edited("insert:4,0.25")
        self.assertEqual(nodes[5]["position"], [0, 0, 2.25])
        self.assertEqual(sorted(self.edited("insert:4", "dissolve:5")[0]), [1, 2, 3, 4])

    def test_reroot(self):
        nodes, _ = self.edited("reroot:3")
        self.assertNotIn("parent", nodes[3])
        self.assertEqual((nodes[1]["parent"], nodes[2]["parent"]), (3, 1))

    def test_mirror_keeps_unknown_keys(self):
        nodes, _ = self.edited("mirror:z")
        self.assertEqual(nodes[5]["position"], [0, 0, -3])
        self.assertEqual((nodes[4]["colour"], nodes[5]["colour"]), ("red", "red"))

    def test_radial(self):
        self.assertEqual(len(self.edited("radial:z,4")[0]), 1 + 4 + 1)  # the arms along x and y are each other's images

    def test_expand(self):
        document = json.loads(self.read("tripod.sinew"))
        document["symmetry"] = {"mirror": "x"}
        self.write("half.sinew", json.dumps(document))
        nodes, _ = self.edited("expand", source="half.sinew")
        self.assertEqual(len(nodes), 5)
        self.assertNotIn("symmetry", self.read("out.sinew"))

    def test_snap(self):
        self.assertEqual(self.edited("grid:2")[0][2]["position"], [4, 0, 0])
        self.assertEqual(self.edited("angle:45")[0][2]["position"], [3, 0, 0])

    def test_operations_go_in_their_order(self):
        self.assertEqual(len(self.edited("mirror:z", "consolidate")[0]), 5 + 4)
        self.assertEqual(len(self.edited("consolidate", "mirror:z")[0]), 7 + 2)

    def test_wrong_calls(self):
        for op, says in (("polish", "no such operation"), ("mirror:w", "x, y or z"), ("merge:2", "two nodes"),
                         ("merge:2,2", "with itself"), ("merge:2,99", "no node 99"), ("insert:1", "root"),
                         ("insert:2,1.5", "share"), ("grid:0", "above 0"), ("grid:nan", "above 0"), ("angle:7", "7"),
                         ("radial:z", "missing"), ("radial:z,9999", "1000"), ("reroot:2,3", "too many"),
                         ("dissolve", "missing"), ("insert:two", "no number")):
            with self.subTest(op):
                self.refused(2, "edit", "tripod.sinew", "-o", "out.sinew", "--op", op, says=says)
        self.refused(2, "edit", "tripod.sinew", "-o", "out.sinew", says="--op")
        self.assertNotIn("out.sinew", self.files())


if __name__ == "__main__":
    unittest.main()
