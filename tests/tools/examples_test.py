#!/usr/bin/env python3
"""tools/examples: every script makes its example again, byte by byte, and the documents are what the scripts promise."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = sorted(p for p in (ROOT / "tools" / "examples").glob("*.py") if p.name not in ("skeleton.py", "node_types.py"))
MIRRORED = {"ant", "dragon", "goat", "humanoid", "car", "chair", "skull", "tap"}


class Examples(unittest.TestCase):
    def test_scripts_make_the_examples(self):
        self.assertGreaterEqual(len(SCRIPTS), 8)
        with tempfile.TemporaryDirectory() as folder:
            for script in SCRIPTS:
                subprocess.run([sys.executable, script, folder], check=True, stdout=subprocess.DEVNULL)
                name = script.stem + ".sinew"
                made = (pathlib.Path(folder) / name).read_text(encoding="utf-8")
                self.assertEqual(made, (ROOT / "examples" / name).read_text(encoding="utf-8"), f"run {script}")

    def test_one_script_makes_all_of_types(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "tools/examples/node_types.py", folder], check=True, stdout=subprocess.DEVNULL)
            made = {p.name: p.read_text(encoding="utf-8") for p in (pathlib.Path(folder) / "types").iterdir()}
        self.assertEqual(made, {p.name: p.read_text(encoding="utf-8") for p in (ROOT / "examples/types").iterdir()})

    def test_bones_reach_out_of_the_smaller_ball(self):
        """A bone that ends inside its neighbour's ball draws nothing; but sharp joints and flat ends make steps."""
        steps = ("joint", "type")
        for script in SCRIPTS:
            nodes = self.document(script.stem)["nodes"]
            by_id = {node["id"]: node for node in nodes}
            for node in nodes:
                parent = by_id.get(node.get("parent"))
                if parent and not any(key in n for key in steps for n in (node, parent)):
                    length = math.dist(node["position"], parent["position"])
                    reach = length + node["radius"]
                    self.assertGreater(reach, parent["radius"], f"{script.stem}, node {node['id']}")

    def test_creatures_are_drawn_on_one_side(self):
        for name in MIRRORED:
            document = self.document(name)
            self.assertEqual(document["symmetry"], {"mirror": "x"}, name)
            sides = [node["position"][0] for node in document["nodes"]]
            self.assertGreaterEqual(min(sides), 0, name)
            self.assertIn(0, sides, f"{name}: nothing joins the two sides")

    @staticmethod
    def document(name):
        return json.loads((ROOT / "examples" / f"{name}.sinew").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
