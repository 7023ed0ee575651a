"""The web page in Chromium: its vertices, its requests, its size, and how it stands on a phone's screen."""

import json
import re
import subprocess
from dataclasses import replace

import numpy

from chromium import Chromium
from samples import SAMPLES, expect, make

TOLERANCE = 2e-5  # of the diagonal of the box
LARGEST_FIVE_KEYS = 150_000  # bytes
SCREENS = {"desk": (1280, 800, False), "phone": (390, 844, True), "phone-on-its-side": (844, 390, True)}

# Everything that must be within the screen, and what is not.
OUTSIDE = """
[...document.querySelectorAll("body *")].filter(part => {
    const { left, right, top, bottom, width, height } = part.getBoundingClientRect();
    const shown = width > 0 && height > 0 && part.checkVisibility({ visibilityProperty: true });
    return shown && (left < -1 || top < -1 || right > innerWidth + 1 || bottom > innerHeight + 1);
}).map(part => part.id || part.tagName)
"""


def check_pages(families, scratch, pictures=None):
    with Chromium() as browser:
        # No page reaches anything but its own file.
        browser.call("Network.setBlockedURLs", urls=["http://*", "https://*", "ws://*", "wss://*", "data:*"])
        for family in families:
            check_page(browser, family, scratch)
            if family.name == "five-keys":
                for other in of_all_interpolations(family, scratch):
                    check_page(browser, other, scratch)
        for name, (width, height, phone) in SCREENS.items():
            for dark in (False, True):
                browser.screen(width, height, dark, phone)
                check_screen(browser, scratch / "five-keys.html", name)
                if pictures:
                    browser.picture(pictures / f"page-{name}-{'dark' if dark else 'light'}.png")


def check_page(browser, family, scratch):
    file = scratch / f"{family.name}.html"
    family.run("-o", file)
    browser.show(f"file://{file}")
    browser.value("interleaf.ready.then(() => 0)")
    expect(browser.requests() == [f"file://{file}"], f"{family.name}: the page asks for {browser.requests()}")
    if family.name == "five-keys":
        expect(file.stat().st_size <= LARGEST_FIVE_KEYS, f"the page has {file.stat().st_size} bytes")

    def difference(call, surface, what):
        answer = browser.value(f"({call}, [Array.from(interleaf.positions()), Array.from(interleaf.triangles())])")
        positions, triangles = (numpy.array(numbers).reshape(-1, 3) for numbers in answer)
        expect(numpy.array_equal(triangles, surface.triangles), f"{family.name}: {what}: other triangles")
        return family.difference(positions, surface.positions, what)

    worst, count = 0, 0
    for time in family.times:
        worst = max(worst, difference(f"interleaf.setTime({time!r})", family.at_time(time), f"time {time}"))
        count += 1
    for weights in family.blends[:5]:
        given = ",".join(f"{key}={weight!r}" for key, weight in weights.items())
        surface = family.surface("--weights", given)
        worst = max(worst, difference(f"interleaf.setWeights({json.dumps(weights)})", surface, f"blend {given}"))
        count += 1
    for u, v in points_of(family):
        surface = family.surface("--at", f"{u!r},{v!r}")
        worst = max(worst, difference(f"interleaf.setPoint({u!r}, {v!r})", surface, f"point {u}, {v}"))
        count += 1
    expect(worst < TOLERANCE, f"{family.name}: the page is off by {worst:.2g} of the box")
    print(f"page: {family.name}: {count} blends to {worst:.1e} of the box, {file.stat().st_size} bytes")


def of_all_interpolations(family, scratch):
    """The family with each interpolation that the program knows: the page computes the weights by itself."""
    refused = subprocess.run([family.program, "family", family.path, "--interpolation", "?", "-o", scratch / "none"],
                             capture_output=True, text=True)
    listed = re.search(r"expected (.*), got", refused.stderr)
    expect(listed, f"no list of interpolations: {refused.stderr}")
    names = re.split(", | or ", listed[1])
    expect("linear" in names and "bernstein" in names, f"unusual interpolations: {names}")
    for options in [[name] for name in names] + [["bernstein", "--degree", 2]]:
        name = f"{family.name}-{'-'.join(map(str, options))}"
        make(family.program, "family", family.path, "--interpolation", *options, "-o", scratch / name)
        yield replace(family, name=name, path=scratch / name, blends=[])


def points_of(family):
    """Points within the box of the domain."""
    described = json.loads((family.path / "family.json").read_text())
    if "domain" not in described:
        return []
    corners = numpy.array([vertex["at"] for vertex in described["domain"]["vertices"]])
    numbers = numpy.random.default_rng(1).uniform(corners.min(0), corners.max(0), (SAMPLES, 2))
    return numbers.tolist()


def check_screen(browser, file, screen):
    browser.show("about:blank")  # or only the part after # would change
    browser.show(f"file://{file}#time=1.2")
    browser.value("interleaf.ready.then(() => new Promise(done => requestAnimationFrame(() => setTimeout(done, 200))))")
    outside = browser.value(OUTSIDE)
    expect(outside == [], f"{screen}: outside the screen: {outside}")
    expect(browser.value("document.getElementById('message').hidden"), f"{screen}: the page shows an error")
    overlap = browser.value("""(() => {
        const [a, b] = ["panel", "timeline"].map(id => document.getElementById(id).getBoundingClientRect());
        return a.bottom > b.top && a.top < b.bottom && a.right > b.left && a.left < b.right;
    })()""")
    expect(not overlap, f"{screen}: the panel covers the timeline")
