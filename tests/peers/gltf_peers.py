"""glTF: gltf-validator, three.js and Blender read what `interleaf export` writes."""

import base64
import functools
import http.server
import json
import struct
import subprocess
import threading
from pathlib import Path

import numpy

from chromium import Chromium
from samples import expect

HERE = Path(__file__).parent
TOLERANCE = 1e-6  # of the diagonal of the box
NORMALS = 1.0  # degrees, mean


class Exported:
    """A family as .glb, with what all readers must find in it."""

    def __init__(self, family, folder, options=()):
        self.family = family
        self.file = folder / f"{family.name}{''.join(options)}.glb"
        family.run("-o", self.file, *options)
        data = self.file.read_bytes()
        (length,) = struct.unpack_from("<I", data, 12)
        self.document = json.loads(data[20 : 20 + length])
        self.body = data[28 + length :]
        self.has_segments = len(self.document["meshes"]) > 1

    @property
    def name(self):
        return self.file.stem

    @functools.cached_property
    def streams(self):
        """The positions of the union of all keys, in each key."""
        return {key: self.family.blend({key: 1}).positions for key in self.family.keys}

    @functools.cached_property
    def base(self):
        return self.family.timeline[0][1] if self.family.timeline else self.family.keys[0]

    @property
    def targets(self):
        return [key for key in self.family.keys if key != self.base]

    def rest_normals(self):
        number = self.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]
        accessor = self.document["accessors"][number]
        start = self.document["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return numpy.frombuffer(self.body, "<f4", 3 * accessor["count"], start).reshape(-1, 3)

    @functools.cached_property
    def expected_blends(self):
        return [] if self.has_segments else [self.family.blend(b).positions for b in self.family.blends]

    @functools.cached_property
    def expected_times(self):
        """Per time the vertices, and the number of each in the file; None where the numbers are the same."""
        result = []
        for time in self.family.times:
            places = None if self.has_segments else self.family.places(time, self.streams)
            result.append((self.family.at_time(time).positions, places))
        return result

    def check_blends(self, reader, blends):
        worst = max(self.family.difference(found, expected, f"{reader}, blend {n}")
                    for n, (found, expected) in enumerate(zip(blends, self.expected_blends, strict=True)))
        expect(worst < TOLERANCE, f"{self.name}: {reader}: a blend is off by {worst:.2g} of the box")
        return worst

    def check_times(self, reader, times):
        worst = 0
        for time, found, (expected, places) in zip(self.family.times, times, self.expected_times, strict=True):
            own = found if places is None else found[places]
            worst = max(worst, self.family.difference(own, expected, f"{reader}, time {time}"))
        expect(worst < TOLERANCE, f"{self.name}: {reader}: a time is off by {worst:.2g} of the box")
        return worst

    def duration(self):
        return self.family.timeline[-1][0] - self.family.timeline[0][0]


def validate(exports, modules):
    command = ["node", HERE / "validate.mjs", modules, *(each.file for each in exports)]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    for each, line in zip(exports, lines, strict=True):
        found = json.loads(line)
        counts = {kind: found[f"num{kind}"] for kind in ("Errors", "Warnings", "Infos", "Hints")}
        expect(not any(counts.values()), f"{each.name}: gltf-validator: {counts} {found['messages'][:3]}")
        print(f"gltf-validator: {each.name}: no error, warning, info or hint")


class Handler(http.server.SimpleHTTPRequestHandler):
    """Gives the page, the modules and the exported files."""

    folders = {}

    def translate_path(self, path):
        first, _, rest = path.lstrip("/").partition("/")
        return str(self.folders[first] / rest) if first in self.folders else str(HERE / "three_page.html")

    def log_message(self, *_):
        pass


def floats(text):
    return numpy.frombuffer(base64.b64decode(text), "<f4").reshape(-1, 3)


def read_by_three(exports, modules):
    Handler.folders = {"node_modules": modules / "node_modules", "files": exports[0].file.parent}
    Handler.extensions_map = Handler.extensions_map | {".js": "text/javascript"}
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server, Chromium() as browser:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        browser.show(f"http://127.0.0.1:{server.server_port}/")
        for each in exports:
            read_one_by_three(browser, each)
        server.shutdown()


def read_one_by_three(browser, each):
    family = each.family
    found = browser.value(f"peer.load({json.dumps('/files/' + each.file.name)})")
    figures = []
    if not each.has_segments:
        expect(found["keys"] == each.targets, f"{each.name}: three.js has the targets {found['keys']}")
        blends = [floats(browser.value(f"peer.blend({json.dumps(weights)})")) for weights in family.blends]
        figures.append(f"{len(blends)} blends to {each.check_blends('three.js', blends):.1e}")
    if family.timeline:
        [clip] = found["clips"]
        expect(clip["name"] == "timeline", f"{each.name}: three.js has the clip {clip['name']}")
        expect(abs(clip["duration"] - each.duration()) < 1e-5,
               f"{each.name}: three.js: {clip['duration']} s long, expected {each.duration()}")
        answers = [browser.value(f"peer.at({time - min(family.timeline[0][0], 0)!r})") for time in family.times]
        for time, answer in zip(family.times, answers):
            expect(len(answer["shown"]) == 1, f"{each.name}: three.js at {time} shows {answer['shown']}")
        times = [floats(answer["vertices"]) for answer in answers]
        figures.append(f"{len(times)} times to {each.check_times('three.js', times):.1e} of the box")
    print(f"three.js r{found['revision']}: {each.name}: {', '.join(figures)}")


def read_by_blender(each, folder):
    family = each.family
    folder = folder / f"blender-{each.name}"
    folder.mkdir()
    job = {"file": str(each.file), "folder": str(folder), "times": family.times,
           "blends": [] if each.has_segments else family.blends}
    (folder / "job.json").write_text(json.dumps(job))
    command = ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
               HERE / "blender_reader.py", "--", folder / "job.json"]
    done = subprocess.run(command, capture_output=True, text=True)
    expect(done.returncode == 0, f"{each.name}: Blender: {(done.stdout + done.stderr)[-2000:]}")
    found = json.loads((folder / "result.json").read_text())

    def written(kind, count):
        return [numpy.fromfile(folder / f"{kind}-{n}.f4", "<f4").reshape(-1, 3) for n in range(count)]

    figures = []
    if not each.has_segments:
        expect(found["keys"][1:] == each.targets, f"{each.name}: Blender has the shape keys {found['keys']}")
        blends = written("blend", len(family.blends))
        figures.append(f"{len(blends)} blends to {each.check_blends('Blender', blends):.1e}")
        figures.append(f"normals to {normals_off(each, folder):.2g} degrees mean")
    if family.timeline:
        begin, end = (frame / found["rate"] for frame in found["range"])
        expect(abs(begin - max(family.timeline[0][0], 0)) < 1e-4 and abs(end - begin - each.duration()) < 1e-4,
               f"{each.name}: Blender's animation goes from {begin} to {end} s")
        for time, names in zip(family.times, found["visible"]):
            expect(len(names) == 1, f"{each.name}: Blender at {time} shows {names}")
        times = written("time", len(family.times))
        figures.append(f"{len(times)} times to {each.check_times('Blender', times):.1e} of the box")
    print(f"Blender {found['version']}: {each.name}: {', '.join(figures)}")


def normals_off(each, folder):
    """The mean angle between Blender's normals at rest and ours, degrees."""
    corners = numpy.fromfile(folder / "corners.i4", "<i4")
    normals = numpy.fromfile(folder / "normals.f4", "<f4").reshape(-1, 3).astype(float)
    ours = each.rest_normals()[corners].astype(float)
    cosines = (normals * ours).sum(1) / (numpy.linalg.norm(normals, axis=1) * numpy.linalg.norm(ours, axis=1))
    mean = float(numpy.degrees(numpy.arccos(numpy.clip(cosines, -1, 1))).mean())
    expect(mean < NORMALS, f"{each.name}: Blender's normals are {mean:.2g} degrees off on average")
    return mean
