"""Reads an exported web page by its description in docs/file-formats.md.

usage: check_page.py INTERLEAF FAMILY...

The script checks the content policy and the hashes in it, decodes the keys, and compares their vertices with
those of `interleaf export --weights KEY=1`.
"""

import base64
import hashlib
import html.parser
import json
import re
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path


def expect(holds, what):
    if not holds:
        sys.exit(f"check_page.py: {what}")


class Page(html.parser.HTMLParser):
    """The texts of the page's elements by name or id, its content policy, and its links."""

    def __init__(self, text):
        super().__init__()
        self.texts, self.policy, self.links, self.open = {}, "", [], None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.open = given.get("id", tag)
        self.links += [value for name, value in attributes if name in ("src", "href", "action")]
        if given.get("http-equiv") == "Content-Security-Policy":
            self.policy = given["content"]
        expect("style" not in given and not any(name.startswith("on") for name in given), f"<{tag}> has code")

    def handle_data(self, data):
        self.texts[self.open] = self.texts.get(self.open, "") + data

    def handle_endtag(self, _):
        self.open = None


class Payload:
    def __init__(self, data):
        self.data, self.at = data, 0

    def bytes(self, count):
        self.at += count
        return self.data[self.at - count : self.at]

    def numbers(self, count):
        low, middle, high = (self.bytes(count) for _ in range(3))
        folded = (a | b << 8 | c << 16 for a, b, c in zip(low, middle, high))
        return [n >> 1 if n % 2 == 0 else -(n + 1 >> 1) for n in folded]

    def sums(self, count):
        total, result = 0, []
        for number in self.numbers(count):
            total += number
            result.append(total)
        return result


def positions_of_key(payload, family, key, roots):
    """The positions of the key that comes next in the payload."""
    nodes, vertices = family["roots"] + 2 * key["bisections"], key["vertices"]
    bits = payload.bytes((nodes + 7) // 8)
    midpoints = iter(payload.sums(key["bisections"]))
    numbers = payload.numbers(3 * vertices)
    axes = [numbers[c * vertices : (c + 1) * vertices] for c in range(3)]
    for field in family["fields"]:
        payload.numbers(vertices * (3 if field["kind"] == "color" else 1))
    seen = set(range(family["rootVertices"]))
    node = 0
    for root in range(0, len(roots), 3):
        stack = [tuple(roots[root : root + 3])]
        while stack:
            i, j, k = stack.pop()
            is_bisected = bits[node // 8] >> node % 8 & 1
            node += 1
            if not is_bisected:
                continue
            middle = next(midpoints)
            if middle not in seen:
                seen.add(middle)
                for axis in axes:
                    axis[middle] += (axis[j] + axis[k]) // 2
            stack += [(middle, i, j), (middle, k, i)]
    expect(node == nodes, "the bits are not one forest")
    low = family["box"][0]
    return [low[c] + family["unit"] * axes[c][v] for v in range(vertices) for c in range(3)]


def check(program, family):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "family.html"
        subprocess.run([program, "export", family, "-o", file], check=True)
        page = Page(file.read_text(encoding="utf-8"))
    expect(page.links == [], f"the page links to {page.links}")
    expect(page.policy.startswith("default-src 'none'; "), "the content policy allows more than needed")
    for name in ("script", "style"):
        digest = base64.b64encode(hashlib.sha256(page.texts[name].encode()).digest()).decode()
        expect(f"{name}-src 'sha256-{digest}';" in page.policy, f"the hash of the {name} is wrong")
    described = json.loads(page.texts["family"])
    expect(not re.search("[<>&]", page.texts["family"]), "the description is not escaped")
    payload = Payload(zlib.decompress(base64.b64decode(page.texts["data"], validate=True)))
    roots = payload.sums(3 * described["roots"])
    longest = max(b - a for a, b in zip(*described["box"]))
    worst = 0
    for key in described["keys"]:
        found = positions_of_key(payload, described, key, roots)
        command = [program, "export", family, "--weights", f"{key['name']}=1", "--format", "obj", "-o", "-"]
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        expected = [float(x) for line in text.splitlines() if line[0] == "v" for x in line.split()[1:4]]
        expect(len(found) == len(expected), f"key {key['name']} has another number of vertices")
        worst = max(worst, *(abs(a - b) / longest for a, b in zip(found, expected)))
    expect(payload.at == len(payload.data), "bytes follow the last key")
    expect(worst < 1e-5, f"{family}: a vertex is off by {worst} of the box")
    print(f"{family}: {len(described['keys'])} keys, off by at most {worst:.2g} of the longest side")


for each in sys.argv[2:]:
    check(sys.argv[1], each)
