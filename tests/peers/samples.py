"""Families for the peers, and the surfaces that `interleaf export` says they have."""

import json
import random
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy

SAMPLES = 20  # blends, and times, per family
TYPES = {"float": "<f4", "double": "<f8", "uchar": "u1", "int": "<i4", "uint": "<u4"}


class Mismatch(Exception):
    """A peer reads something else than `interleaf export` writes."""


def expect(holds, what):
    if not holds:
        raise Mismatch(what)


def parse_ply(data):
    """The columns of the vertices by name, and the triangles, of a binary PLY file."""
    head, body = data.split(b"end_header\n", 1)
    lines = [line.split() for line in head.decode().splitlines()]
    vertices = next(int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
    faces = next(int(line[2]) for line in lines if line[:2] == ["element", "face"])
    columns = [(line[2], TYPES[line[1]]) for line in lines if line[0] == "property" and line[1] != "list"]
    table = numpy.frombuffer(body, numpy.dtype(columns), vertices)
    corners = numpy.dtype([("count", "u1"), ("corner", "<i4", 3)])
    return table, numpy.frombuffer(body, corners, faces, table.nbytes)["corner"]


@dataclass
class Surface:
    positions: numpy.ndarray
    triangles: numpy.ndarray
    fields: dict = field(default_factory=dict)


@dataclass
class Sampled:
    """A family, with blends and times that all readers are asked for."""

    name: str
    path: Path
    program: str
    keys: list = field(default_factory=list)
    timeline: list = field(default_factory=list)  # (time, key) pairs, if it is linear
    box: float = 0
    blends: list = field(default_factory=list)
    times: list = field(default_factory=list)

    def run(self, *options):
        command = [self.program, "export", self.path, *map(str, options)]
        return subprocess.run(command, check=True, capture_output=True).stdout

    def surface(self, *options):
        table, triangles = parse_ply(self.run(*options, "--format", "ply", "-o", "-"))
        positions = numpy.stack([table[axis] for axis in "xyz"], 1).astype(float)
        others = {name: table[name].astype(float) for name in table.dtype.names if name not in "xyz"}
        return Surface(positions, triangles, others)

    def blend(self, weights):
        """The blend over the union of all keys: keys that are not named have the weight 0."""
        given = {key: 0 for key in self.keys} | weights
        return self.surface("--weights", ",".join(f"{key}={weight!r}" for key, weight in given.items()))

    def at_time(self, time):
        return self.surface("--time", repr(time))

    def keys_around(self, time):
        """The two keys of the interval that holds \\p time."""
        for (_, a), (end, b) in zip(self.timeline, self.timeline[1:]):
            if time <= end:
                return a, b
        return self.timeline[-2][1], self.timeline[-1][1]

    def places(self, time, streams):
        """The number that each vertex of at_time() has in the union of all keys. Vertices are the same if
        they have the same positions in both keys of the interval, to the last bit.
        streams -- the positions of that union per key"""
        a, b = self.keys_around(time)
        own = [self.surface("--weights", f"{a}={1 - w},{b}={w}" if a != b else f"{a}=1") for w in (0, 1)]
        pairs = numpy.hstack([streams[a], streams[b]])
        numbers = {pair.tobytes(): n for n, pair in enumerate(pairs)}
        found = [numbers.get(pair.tobytes()) for pair in numpy.hstack([s.positions for s in own])]
        expect(None not in found, f"{self.name}: a vertex of time {time} is not in the union of all keys")
        return found

    def difference(self, positions, expected, what):
        """The largest distance of two vertices, as a part of the diagonal of the box."""
        expect(len(positions) == len(expected),
               f"{self.name}: {what}: {len(positions)} vertices, expected {len(expected)}")
        return float(numpy.linalg.norm(positions - expected, axis=1).max()) / self.box


def sampled(name, path, program, chance):
    family = Sampled(name, Path(path), program)
    described = json.loads((family.path / "family.json").read_text())
    family.keys = [key["name"] for key in described["keys"]]
    timeline = described.get("timeline")
    if timeline and timeline["interpolation"] == "linear":
        family.timeline = [(key["time"], key["key"]) for key in timeline["keys"]]
        family.times = sorted(chance.uniform(family.timeline[0][0], family.timeline[-1][0]) for _ in range(SAMPLES))
    for _ in range(SAMPLES):
        # A few keys of many: so each has a weight that counts.
        chosen = chance.sample(family.keys, min(len(family.keys), 5))
        values = [chance.random() for _ in chosen]
        family.blends.append({key: value / sum(values) for key, value in zip(chosen, values)})
    rest = family.blend({family.keys[0]: 1}).positions
    family.box = float(numpy.linalg.norm(rest.max(0) - rest.min(0)))
    return family


def make(program, *options):
    subprocess.run([program, *map(str, options)], check=True, capture_output=True)


def write_step(file, surface):
    """A step of a computation, with a scalar field that the blend of positions does not give."""
    x, y, z = surface.positions.T
    values = numpy.sin(3 * x) + y * z
    lines = ["# vtk DataFile Version 3.0", "step", "ASCII", "DATASET POLYDATA", f"POINTS {len(x)} float"]
    lines += [" ".join(map(repr, point.tolist())) for point in surface.positions.astype("f4")]
    lines += [f"POLYGONS {len(surface.triangles)} {4 * len(surface.triangles)}"]
    lines += ["3 " + " ".join(map(str, triangle.tolist())) for triangle in surface.triangles]
    lines += [f"POINT_DATA {len(x)}", "SCALARS heat float 1", "LOOKUP_TABLE default", *map(repr, values.tolist())]
    file.write_text("\n".join(lines) + "\n")


def with_fields(folder, program):
    steps = []
    for shape in ("star", "cushion"):
        make(program, "make", shape, "--leaves", 3000, "-o", folder / f"{shape}.ilh")
        mesh = Sampled(shape, folder / f"{shape}.ilh", program).surface()
        steps.append(folder / f"{shape}.vtk")
        write_step(steps[-1], mesh)
    make(program, "import", *steps, "-o", folder / "fields")
    return folder / "fields"


def without_timeline(folder, source):
    target = folder / "domain"
    target.mkdir()
    for file in source.iterdir():
        (target / file.name).write_bytes(file.read_bytes())
    described = json.loads((target / "family.json").read_text())
    del described["timeline"]
    (target / "family.json").write_text(json.dumps(described))
    return target


def large(folder, program):
    keys = []
    for shape in ("star", "cushion"):
        keys.append(folder / f"large-{shape}.ilh")
        make(program, "make", shape, "--leaves", 120_000, "-o", keys[-1])
    make(program, "family", *keys, "-o", folder / "large")
    return folder / "large"


def all_families(program, assets, folder, seed):
    chance = random.Random(seed)
    paths = {path.name: path for path in sorted(assets.iterdir()) if (path / "family.json").exists()}
    paths["fields"] = with_fields(folder, program)
    paths["domain"] = without_timeline(folder, assets / "five-keys")
    paths["large"] = large(folder, program)
    return [sampled(name, path, program, chance) for name, path in paths.items()]
