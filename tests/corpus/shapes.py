"""How well the meshes of other people's characters and curve skeletons are shaped, beside those of other programs.

For `run`, which skins what `files` names as each of VARIANTS says, has `measure` look at the meshes
(../shared/tools/shape.py says what the figures are), and asks `page` for its tables and `faults` for what has become worse.
The other programs were measured once, on the same skeletons: ../shared/data/peers-shape.tsv.
"""
import csv
import dataclasses
import pathlib
import sys
import textwrap

KINDS = ("character", "curve")


@dataclasses.dataclass(frozen=True)
class Variant:
    name: str
    level: int
    options: tuple


VARIANTS = (Variant("0", 0, ()), Variant("1", 1, ("--subdivide", "1")), Variant("2", 2, ("--subdivide", "2")),
            Variant("0, aspect 2", 0, ("--aspect", "2")),
            Variant("2, aspect 2", 2, ("--subdivide", "2", "--aspect", "2")))
SMOOTH = ("2", "2, aspect 2")  # the variants that are set beside Blender's, file by file


@dataclasses.dataclass(frozen=True)
class Figure:
    key: str  # as shape.py names it
    head: str
    scale: float = 1
    digits: int = 2
    higher_is_better: bool = False
    of_smooth: bool = False  # says something of subdivided meshes only


FIGURES = (Figure("caved_seen", "caved in, %", 100), Figure("swell99", "swelling, r"),
           Figure("turn99", "turn, degrees", digits=1, of_smooth=True),
           Figure("sj1", "scaled Jacobian", higher_is_better=True),
           Figure("aspect4", "above 4:1, %", 100, 1), Figure("folded", "folded, %", 100))

# At most (of scaled Jacobians at least) so much in the median, at the 90th percentile and at worst: what was measured, and a
# tenth of it or what a change of one joint in one skeleton does, whichever is more.
LIMITS = {
    "0": {"caved_seen": (0.1, 2, 18.7), "swell99": (-0.02, 0.26, 0.7), "sj1": (0.29, -0.11, -0.19),
          "aspect4": (8.9, 54.9, 68.7), "folded": (0.1, 0.1, 0.7)},
    "1": {"caved_seen": (0.1, 0.6, 5.3), "swell99": (0.07, 0.23, 0.49), "turn99": (57, 66, 79),
          "sj1": (0.58, 0.35, 0.22), "aspect4": (2.2, 13.4, 38.9), "folded": (0.1, 0.1, 0.1)},
    "2": {"caved_seen": (0.1, 0.5, 5), "swell99": (0.1, 0.24, 0.54), "turn99": (31, 35, 37), "sj1": (0.69, 0.37, 0.28),
          "aspect4": (2.3, 12.3, 29.7), "folded": (0.1, 0.1, 0.2)},
    "0, aspect 2": {"caved_seen": (0.1, 2, 18.4), "swell99": (-0.02, 0.23, 0.7), "sj1": (0.35, 0.07, -0.13),
                    "aspect4": (1.3, 4.1, 7), "folded": (0.1, 0.1, 0.6)},
    "2, aspect 2": {"caved_seen": (0.1, 0.5, 5), "swell99": (0.1, 0.25, 0.48), "turn99": (30, 32, 35),
                    "sj1": (0.71, 0.49, 0.33), "aspect4": (1.2, 2.2, 2.6), "folded": (0.1, 0.1, 0.2)},
}
# So many files may be worse than Blender's subdivided meshes of the same skeletons (it has 36): what was measured, and one.
WORSE_THAN_BLENDER = {
    "2": {"caved_seen": 3, "swell99": 8, "turn99": 1, "sj1": 7, "aspect4": 15, "folded": 2},
    "2, aspect 2": {"caved_seen": 3, "swell99": 8, "turn99": 1, "sj1": 6, "aspect4": 7, "folded": 1},
}
# Of two meshes whose figures differ by less, neither is worse.
SAME = {"caved_seen": 1e-4, "swell99": 0.01, "turn99": 0.5, "sj1": 0.01, "aspect4": 1e-3, "folded": 1e-4}

SIZES = ((20, "up to 20 nodes"), (60, "21 to 60 nodes"), (10**9, "above 60 nodes"))


def files(index, data):
    """Characters and curve skeletons of one piece: INDEX rows by file. No skeleton of these is there twice."""
    return {data / name: row for name, row in index.items() if row["kind"] in KINDS and row["components"] == "1"}


def measure(task):
    """(file, name of the variant, figures of its mesh); runs in a worker, which finds the tools of ../shared."""
    file, variant, mesh, shared = task
    sys.path.insert(0, str(shared / "tools"))
    from deviation import read_graph
    from meshstats import read_obj
    from shape import shape

    return file, variant, shape(*read_obj(mesh), *read_graph(file))


def read_peers(path):
    """(program, level) -> stem of the file -> figures; nothing where the table is missing"""
    peers = {}
    if not path.is_file():
        return peers
    with open(path, newline="") as file:
        for row in csv.DictReader((line for line in file if not line.startswith("#")), delimiter="\t"):
            found = {figure.key: float(row[figure.key]) for figure in FIGURES if row[figure.key] not in ("", "nan")}
            peers.setdefault((row["who"], row["level"]), {})[row["file"]] = found
    return peers


def spread(figure, rows):
    """Median, 90th percentile and worst, scaled; None where nothing was measured."""
    values = sorted((row[figure.key] * figure.scale for row in rows if figure.key in row), reverse=figure.higher_is_better)
    if not values:
        return None
    last = len(values) - 1
    middle = (values[last // 2] + values[(last + 1) // 2]) / 2
    return middle, values[int(0.9 * last + 0.5)], values[-1]


def is_worse(figure, ours, theirs):
    less = ours[figure.key] - theirs[figure.key]
    return (-less if figure.higher_is_better else less) > SAME[figure.key]


def in_words(figure, values):
    return " / ".join(f"{value:.{figure.digits}f}" for value in values)


def table(heads, body):
    lines = [heads, *[[str(cell) for cell in line] for line in body]]
    widths = [max(len(line[k]) for line in lines) for k in range(len(heads))]
    text = ["| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths)) + " |" for line in lines]
    text.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return text


def all_cells(rows, level):
    cells = []
    for figure in FIGURES:
        values = None if figure.of_smooth and level == 0 else spread(figure, rows)
        cells.append(in_words(figure, values) if values else "-")
    return cells


def everybody(shapes, peers):
    """The first table: each variant, and the other programs at its level."""
    stems = {file.stem for file, _ in shapes}
    body = []
    for variant in VARIANTS:
        rows = [row for (_, name), row in shapes.items() if name == variant.name]
        body.append([variant.name, "Sinew", len(rows), *all_cells(rows, variant.level)])
        if variant.name not in ("0", "2"):
            continue
        for who, name in (("blender", "Blender"), ("feq", "GEL")):
            rows = [row for stem, row in peers.get((who, variant.name), {}).items() if stem in stems]
            if rows:
                body.append([variant.name, name, len(rows), *all_cells(rows, variant.level)])
    return table(["level", "program", "files", *[figure.head for figure in FIGURES]], body)


def pairs_of(shapes, peers, variant):
    """Files that Blender has a mesh of, with (ours, Blender's)."""
    theirs = peers.get(("blender", "2"), {})
    return {file: (row, theirs[file.stem]) for (file, name), row in shapes.items()
            if name == variant and file.stem in theirs}


def worse_files(figure, pairs):
    return sorted(file.stem for file, pair in pairs.items() if is_worse(figure, *pair))


def groups(chosen, shapes, peers):
    """(title, pairs) by kind, by size, and all as both variants are"""
    pairs = pairs_of(shapes, peers, SMOOTH[0])

    def size(file):
        return next(title for most, title in SIZES if int(chosen[file]["nodes"]) <= most)
    for kind in KINDS:
        yield kind, [pair for file, pair in pairs.items() if chosen[file]["kind"] == kind]
    for _, title in SIZES:
        yield title, [pair for file, pair in pairs.items() if size(file) == title]
    yield "all", list(pairs.values())
    yield "all, aspect 2", list(pairs_of(shapes, peers, SMOOTH[1]).values())


def beside_blender(chosen, shapes, peers):
    """The second table: medians of both at level 2, and how often ours is worse."""
    body = []
    for title, some in groups(chosen, shapes, peers):
        cells = []
        for figure in FIGURES:
            middles = [spread(figure, [pair[k] for pair in some]) for k in (0, 1)]
            worse = sum(is_worse(figure, *pair) for pair in some)
            both = [f"{values[0]:.{figure.digits}f}" for values in middles if values]
            cells.append(f"{' : '.join(both)} ({worse})" if both else "-")
        body.append([title, len(some), *cells])
    return table(["", "files", *[figure.head for figure in FIGURES]], body)


def page(shapes, chosen, peers):
    """The section of docs/measurements.md."""
    lines = ["", "## Shape", "", *textwrap.wrap(
        f"Of {len(chosen)} characters and curve skeletons of one piece; no skeleton is there twice. Each cell is the median, the "
        "90th percentile and the worst of the files. Levels: 0 is the control mesh, 1 and 2 are subdivided so often; "
        "`aspect 2` is made with `--aspect 2`.", 120), "", *everybody(shapes, peers), "", *textwrap.wrap(
        "Caved in: the share of the surface that is seen and lies deeper in the union of the round cones than half of the radius "
        "there (a joint that falls in). Swelling: the 99th percentile, by area, of the distance outside the cones over the radius "
        "(below 0: all is inside). Turn: the 99th percentile of the angle between neighbouring faces. Scaled Jacobian: the 1st "
        "percentile over the quads; 1 is a rectangle, below 0 folded. Above 4:1: the share of quads that are so long. Folded: the "
        "share of quads with two corners or more that turn against the face. At level 0 Blender's and GEL's hollows were not "
        "told from those that the mesh itself hides, and turns say nothing.", 120), "", *textwrap.wrap(
        "Blender: the Skin modifier of Blender 3.4 with its own subdivision. GEL: FEQ of GEL 0.7.3, subdivided by Sinew; it "
        "makes no mesh of some of the files.", 120)]
    if pairs := pairs_of(shapes, peers, SMOOTH[0]):
        caved = worse_files(FIGURES[0], pairs)
        lines += ["", *textwrap.wrap(
            "Level 2 beside Blender's, by kind and by size: the medians (Sinew : Blender), and in brackets how many files are "
            f"worse than Blender's. Those that cave in more: {', '.join(caved) or 'none'}.", 120), "",
            *beside_blender(chosen, shapes, peers)]
    return lines


def faults(shapes, chosen, peers):
    """What is worse than it was."""
    found = []
    for variant in VARIANTS:
        rows = [row for (_, name), row in shapes.items() if name == variant.name]
        for figure in FIGURES:
            if figure.of_smooth and variant.level == 0:
                continue
            limits = LIMITS[variant.name][figure.key]
            for what, value, limit in zip(("median", "90th percentile", "worst"), spread(figure, rows), limits):
                if (value < limit) if figure.higher_is_better else (value > limit):
                    found.append(f"shape, level {variant.name}: {figure.head}: the {what} is {value:.4g}, the limit {limit:g}")
    for variant, most in WORSE_THAN_BLENDER.items():
        pairs = pairs_of(shapes, peers, variant)
        for figure in FIGURES:
            worse = worse_files(figure, pairs)
            if len(worse) > most[figure.key]:
                found.append(f"shape, level {variant}: {figure.head}: {len(worse)} files are worse than Blender's, at most "
                             f"{most[figure.key]} are allowed: {', '.join(worse)}")
    return found
