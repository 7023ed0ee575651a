"""Compares an exported .glb with the exported blends of the same family.

usage: check_glb.py INTERLEAF FAMILY...

The script decodes the file by itself, from the glTF 2.0 specification. It checks the container and every
accessor, then blends base and targets with random weights and compares the vertices with those of
`interleaf export`.
"""

import array
import json
import math
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

SEED = 1
COMPONENTS = {5123: "H", 5125: "I", 5126: "f"}
WIDTHS = {"SCALAR": 1, "VEC3": 3}


def expect(holds, what):
    if not holds:
        sys.exit(f"check_glb.py: {what} (seed {SEED})")


class Glb:
    def __init__(self, data):
        magic, version, length, text_length, text_kind = struct.unpack_from("<4sIII4s", data)
        expect((magic, version, length, text_kind) == (b"glTF", 2, len(data), b"JSON"), "the header is wrong")
        body_length, body_kind = struct.unpack_from("<I4s", data, 20 + text_length)
        expect(body_kind == b"BIN\0", "the second chunk is not binary")
        expect(28 + text_length + body_length == length, "the chunks do not fill the file")
        self.document = json.loads(data[20 : 20 + text_length])
        self.body = data[28 + text_length :]

    def values(self, number):
        """The numbers of an accessor, whose bounds must be right where it has some."""
        accessor = self.document["accessors"][number]
        view = self.document["bufferViews"][accessor["bufferView"]]
        expect(view["byteOffset"] % 4 == 0, f"accessor {number} is not aligned")
        end = view["byteOffset"] + view["byteLength"]
        expect(end <= len(self.body), f"accessor {number} leaves the buffer")
        values = array.array(COMPONENTS[accessor["componentType"]])
        values.frombytes(self.body[view["byteOffset"] : end])
        width = WIDTHS[accessor["type"]]
        expect(len(values) == width * accessor["count"], f"accessor {number} has another count")
        if "min" in accessor:
            columns = [values[c::width] for c in range(width)]
            expect(accessor["min"] == [min(column) for column in columns], f"accessor {number}: min is wrong")
            expect(accessor["max"] == [max(column) for column in columns], f"accessor {number}: max is wrong")
        return values

    def positions(self, attributes):
        expect("min" in self.document["accessors"][attributes["POSITION"]], "a POSITION has no bounds")
        return self.values(attributes["POSITION"])


def exported(program, family, weights):
    """Vertices and faces of a blend, as flat lists."""
    given = ",".join(f"{name}={weight!r}" for name, weight in weights.items())
    command = [program, "export", family, "--weights", given, "--format", "obj", "-o", "-"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    lines = [line.split() for line in text.splitlines()]
    vertices = [float(x) for line in lines if line[0] == "v" for x in line[1:4]]
    faces = [int(x) - 1 for line in lines if line[0] == "f" for x in line[1:4]]
    return vertices, faces


def check(program, family):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "family.glb"
        subprocess.run([program, "export", family, "-o", file], check=True)
        glb = Glb(file.read_bytes())
    for number in range(len(glb.document["accessors"])):
        glb.values(number)
    mesh = glb.document["meshes"][0]
    primitive = mesh["primitives"][0]
    base = glb.positions(primitive["attributes"])
    targets = [glb.positions(target) for target in primitive["targets"]]
    names = mesh["extras"]["targetNames"]
    normals = glb.values(primitive["attributes"]["NORMAL"])
    for v in range(0, len(normals), 3):
        expect(abs(math.hypot(*normals[v : v + 3]) - 1) < 1e-6, "a normal has not the length 1")

    worst = 0
    for _ in range(2):
        values = [random.random() for _ in range(len(names) + 1)]
        values = [value / sum(values) for value in values]
        keys = [mesh["extras"]["interleaf"]["base"], *names]
        vertices, faces = exported(program, family, dict(zip(keys, values)))
        expect(list(glb.values(primitive["indices"])) == faces, "the faces differ")
        expect(len(vertices) == len(base), "the numbers of vertices differ")
        box = math.dist([min(vertices[c::3]) for c in range(3)], [max(vertices[c::3]) for c in range(3)])
        for n, expected in enumerate(vertices):
            blended = base[n] + sum(weight * target[n] for weight, target in zip(values[1:], targets))
            worst = max(worst, abs(blended - expected) / box)
    expect(worst < 1e-6, f"{family}: a vertex is off by {worst} of the box")
    print(f"{family}: {len(base) // 3} vertices, {len(targets)} targets, off by {worst:.2g} of the box")


random.seed(SEED)
for each in sys.argv[2:]:
    check(sys.argv[1], each)
