"""What the scripts that make our examples share: a skeleton under construction, and its file.

World: z is up, models face -y, lengths are in the document's unit. A symmetric skeleton is drawn on the side x >= 0; nodes
with x = 0 are drawn once.
"""
import json
import math
import pathlib
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent.parent / "examples"


class Skeleton:
    def __init__(self, unit="m", mirrored=False):
        self.unit = unit
        self.symmetry = {"mirror": "x"} if mirrored else None
        self.nodes = []
        self.links = []

    def node(self, parent, position, radius, name=None, **keys):
        """Adds a node; returns its id. `parent` is an id, None for a root; `keys` are further keys of the format."""
        node = {"id": len(self.nodes) + 1}
        if parent is not None:
            node["parent"] = parent
        node["position"] = [round(float(x), 4) + 0.0 for x in position]
        node["radius"] = round(float(radius), 4)
        if name:
            node["name"] = name
        node.update(keys)
        self.nodes.append(node)
        return node["id"]

    def chain(self, parent, points, name=None, scale=None, **tip):
        """Adds nodes (x, y, z, radius), each the child of the one before; returns the ids. `scale` is the keys' of all,
        `tip` are keys of the last."""
        ids = []
        for i, (x, y, z, r) in enumerate(points):
            numbered = name and (name if len(points) == 1 else f"{name} {i + 1}")
            keys = {"scale": scale} if scale else {}
            if i + 1 == len(points):
                keys.update(tip)
            parent = self.node(parent, (x, y, z), r, numbered, **keys)
            ids.append(parent)
        return ids

    def link(self, a, b):
        """A bone more, between nodes that are there: it closes a cycle."""
        self.links.append([a, b])

    def position(self, node):
        return self.nodes[node - 1]["position"]

    def save(self, name):
        """Writes NAME.sinew, a node a line, into the folder named on the command line or else into examples/."""
        lines = ['"format": "sinew"', '"version": 1'] + ([f'"unit": {json.dumps(self.unit)}'] if self.unit else [])
        if self.symmetry:
            lines.append(f'"symmetry": {json.dumps(self.symmetry)}')
        lines.append('"nodes": [\n' + ",\n".join("  " + json.dumps(node) for node in self.nodes) + "]")
        if self.links:
            lines.append(f'"links": {json.dumps(self.links)}')
        path = (pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else EXAMPLES) / f"{name}.sinew"
        path.write_text("{" + ",\n ".join(lines) + "}\n", encoding="utf-8")
        print(f"{path}: {len(self.nodes)} nodes drawn")


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def spline(points, count):
    """`count` tuples along a smooth curve through the points (Catmull-Rom), evenly over its parameter, ends included."""
    result = []
    spans = len(points) - 1
    for i in range(count):
        t = i * spans / (count - 1)
        k = min(int(t), spans - 1)
        t -= k
        b, c = points[k], points[k + 1]
        a = points[k - 1] if k > 0 else mix(c, b, 2)
        d = points[k + 2] if k + 2 <= spans else mix(b, c, 2)
        result.append(tuple(0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t ** 3)
                            for p, q, r, s in zip(a, b, c, d)))
    return result


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(v):
    length = math.sqrt(dot(v, v))
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def roll_towards(along, wide):
    """The `roll` with which the first axis of a section of a bone lies as near to the direction `wide` as can be."""
    z = unit(along)
    start = (0, 1, 0) if abs(z[0]) > 0.9 else (1, 0, 0)
    x = unit(tuple(s - dot(start, z) * c for s, c in zip(start, z)))
    return math.degrees(math.atan2(dot(wide, cross(z, x)), dot(wide, x)))


def turn(vector, axis, degrees):
    """The vector turned about a unit axis."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    (x, y, z), (u, v, w) = vector, axis
    d = (x * u + y * v + z * w) * (1 - c)
    return (x * c + (v * z - w * y) * s + u * d, y * c + (w * x - u * z) * s + v * d, z * c + (u * y - v * x) * s + w * d)
