#!/usr/bin/env python3
"""Prints the names of the tests that changed files may break, nearest to the change first.

usage: affected_tests.py BUILD SECONDS FILE...

BUILD is a folder that Ninja has built. Ninja's dependencies tell which files each program is made of. The
script chooses all tests of the changed layers. Then it adds the quickest tests of other layers, up to a total
of SECONDS on this machine. It names the tests that it leaves out on standard error.
"""

import json
import os
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

# The labels of the tests that read files at run time, by the path of these files. Ninja does not know them.
READ_BY_TESTS = {
    "assets": {"shapes", "io", "fuzz", "app", "cli", "e2e"},
    "tests/data": {"cli", "e2e", "fuzz"},
    "docs/user-guide.md": {"app"},
}
# A change of these files may affect any test.
BUILD_FILES = ("cmake/", "third_party/", "src/CMakeLists.txt", "tests/CMakeLists.txt", "CMakeLists.txt",
               "CMakePresets.json")


@dataclass
class Test:
    name: str
    seconds: float
    labels: set[str] = field(default_factory=set)
    files: set[str] | None = None  # the files of its program; None for a script, which may read any file


def layer_of(file):
    """The folder of tests/ that tests this file first of all; None if there is none."""
    parts = Path(file).parts
    if len(parts) < 3 or parts[0] not in ("src", "tests"):
        return None
    return "cli" if parts[:3] == ("src", "app", "cli") else parts[1]


def is_affected(test, file):
    if test.files is None or file in test.files or file.startswith(BUILD_FILES):
        return True
    for place, labels in READ_BY_TESTS.items():
        if labels & test.labels and (file == place or file.startswith(place + "/")):
            return True
    # A data file, or a file that configures a layer.
    return layer_of(file) in test.labels and Path(file).suffix not in (".cpp", ".h")


def choose(tests, changed, seconds, jobs):
    """The tests to run, and the tests that are left out."""
    near = {layer_of(file) for file in changed}
    affected = [test for test in tests if any(is_affected(test, file) for file in changed)]
    chosen, left_out, sum_of_seconds = [], [], 0.0
    for test in sorted(affected, key=lambda test: (not test.labels & near, test.seconds)):
        sum_of_seconds += test.seconds
        (chosen if test.labels & near or sum_of_seconds <= seconds * jobs else left_out).append(test)
    return chosen, left_out


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def dependencies(build, top):
    """For each object file, the files of the project that it was compiled from."""
    files, target = {}, None
    for line in output_of("ninja", "-C", str(build), "-t", "deps").splitlines():
        if ": #deps " in line:
            target = line.split(": #deps ")[0]
        elif line.startswith(f"    {top}/"):
            files.setdefault(target, set()).add(line.strip())
    return files


def measured_seconds(build):
    """The durations that ctest has measured so far, by the name of the test."""
    file = build / "Testing" / "Temporary" / "CTestCostData.txt"
    lines = file.read_text().split("---")[0].splitlines() if file.exists() else []
    return {name: float(cost) for name, runs, cost in (line.rsplit(" ", 2) for line in lines) if float(cost) > 0}


def read_tests(build):
    top = Path.cwd()
    compiled_from = dependencies(build, top)
    measured = measured_seconds(build)
    tests = []
    for described in json.loads(output_of("ctest", "--test-dir", str(build), "--show-only=json-v1"))["tests"]:
        properties = {p["name"]: p["value"] for p in described["properties"]}
        test = Test(described["name"], measured.get(described["name"], properties.get("COST", 1.0)),
                    set(properties.get("LABELS", [])))
        programs = [word for word in described["command"] if word.startswith(f"{build.resolve()}/")]
        if programs:
            program = str(Path(programs[0]).relative_to(build.resolve()))
            inputs = output_of("ninja", "-C", str(build), "-t", "inputs", program)
            files = set()
            for name in inputs.splitlines():
                files |= {name} | compiled_from.get(name, set())
            test.files = {str(Path(name).relative_to(top)) for name in files if name.startswith(f"{top}/")}
        tests.append(test)
    return tests


def main():
    build, seconds, changed = Path(sys.argv[1]), float(sys.argv[2]), sys.argv[3:]
    chosen, left_out = choose(read_tests(build), changed, seconds, os.cpu_count())
    print(*(test.name for test in chosen), sep="\n")
    if left_out:
        print("left to ./dev test:", *(f"{test.name} ({test.seconds:.0f} s)" for test in left_out), file=sys.stderr)


if __name__ == "__main__":
    main()
