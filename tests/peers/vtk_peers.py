"""VTK and ParaView interpolate between the files of a .pvd as the timeline does."""

import json
import os
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy

from samples import expect

HERE = Path(__file__).parent
TOLERANCE = 1e-6  # of the diagonal of the box, and of the range of a field
PACKAGE = "python3-vtk9"


def read_by_vtk(families, scratch, kept):
    modules = kept / "vtk"
    if not modules.exists():
        # The package excludes ParaView's. Its files, beside them, disturb nothing.
        unpacked = scratch / "package"
        unpacked.mkdir()
        subprocess.run(["apt-get", "-q", "download", PACKAGE], cwd=unpacked, check=True, capture_output=True)
        [package] = unpacked.glob(f"{PACKAGE}_*.deb")
        subprocess.run(["dpkg", "-x", package, modules], check=True)
    path = modules / "usr" / "lib" / "python3" / "dist-packages"
    command = ["/usr/bin/python3", "-B", HERE / "vtk_reader.py"]
    read_series("VTK", command, os.environ | {"PYTHONPATH": str(path)}, families, scratch)


def read_by_paraview(families, scratch):
    command = ["pvpython", HERE / "paraview_reader.py"]
    read_series("ParaView", command, os.environ, families, scratch)
    named = {family.name: family for family in families}
    expect("fields" in named, f"ParaView: no family is called fields, but {', '.join(named)}")
    read_steps("ParaView", command, os.environ, named["fields"], scratch)


def read_steps(reader, command, environment, family, scratch):
    """The files of 60 frames per unit of time one after the other, as the program opens them by itself."""
    first, last = family.timeline[0][0], family.timeline[-1][0]
    steps = replace(family, times=[first + n / 60 for n in range(int((last - first) * 60) + 1)])
    folder = scratch / f"{reader}-{family.name}-steps"
    folder.mkdir()
    file = folder / f"{family.name}.pvd"
    family.run("-o", file, "--fps", 60, "--union", "all")
    read = read_job(reader, command, environment, steps, {"file": str(file), "steps": True}, folder)
    times = numpy.array([float(found["time"]) for found in read])
    expect(numpy.abs(times - steps.times).max() < 1e-9, f"{family.name}: {reader} has the times {times}")
    print(f"{reader}: {family.name}, 60 frames per unit of time: {compared(reader, steps, 'all', read)}")


def read_job(reader, command, environment, family, job, folder):
    """What the program of \p command reads: per time, the arrays that it leaves in \p folder."""
    (folder / "job.json").write_text(json.dumps(job | {"times": family.times, "folder": str(folder)}))
    done = subprocess.run([*command, folder / "job.json"], env=environment, capture_output=True, text=True)
    expect(done.returncode == 0, f"{family.name}: {reader}: {(done.stdout + done.stderr)[-2000:]}")
    read = [numpy.load(folder / f"time-{n}.npz") for n in range(len(list(folder.glob("time-*.npz"))))]
    expect(len(read) == len(family.times),
           f"{family.name}: {reader} has {len(read)} times, expected {len(family.times)}")
    return read


def read_series(reader, command, environment, families, scratch):
    for family in families:
        if not family.timeline:
            continue
        for union in ("all", "interval"):
            folder = scratch / f"{reader}-{family.name}-{union}"
            folder.mkdir()
            file = folder / f"{family.name}.pvd"
            family.run("-o", file, "--union", union)
            read = read_job(reader, command, environment, family, {"file": str(file), "steps": False}, folder)
            version = (folder / "version.txt").read_text()
            print(f"{version}: {family.name}, --union {union}: {compared(reader, family, union, read)}")


def compared(reader, family, union, read):
    worst, worst_field, names = 0, 0, set()
    # Over the union of all keys, the streams that tell which vertex is which.
    streams = {key: family.blend({key: 1}).positions for key in family.keys} if union == "all" else {}
    numbers = numbers_in_series(family, streams, read[0]) if union == "all" else None
    for time, found in zip(family.times, read):
        expected = family.at_time(time)
        points = found["points"].astype(float)
        places = slice(None)
        if union == "all":
            places = numbers[family.places(time, streams)]
        else:
            expect(numpy.array_equal(found["triangles"], expected.triangles),
                   f"{family.name}: {reader} at {time} has other triangles")
        worst = max(worst, family.difference(points[places], expected.positions, f"{reader}, time {time}"))
        for name, values in expected.fields.items():
            if f"field {name}" not in found:
                expect(name in ("red", "green", "blue"), f"{family.name}: {reader} has no field {name}")
                continue
            names.add(name)
            span = float(numpy.ptp(values)) or 1
            worst_field = max(worst_field, float(numpy.abs(found[f"field {name}"][places] - values).max()) / span)
    expect(worst < TOLERANCE, f"{family.name}: {reader}: a time is off by {worst:.2g} of the box")
    expect(worst_field < TOLERANCE, f"{family.name}: {reader}: a field is off by {worst_field:.2g} of its range")
    fields = f", fields {', '.join(sorted(names))} to {worst_field:.1e} of their range" if names else ""
    return f"{len(read)} times to {worst:.1e} of the box{fields}"


def numbers_in_series(family, streams, found):
    """The number in the series of each vertex of the union of all keys. Both meshes have the same triangles in
    the same order, over vertices that may be numbered otherwise."""
    triangles = family.blend({family.keys[0]: 1}).triangles
    expect(found["triangles"].shape == triangles.shape, f"{family.name}: the series has another number of triangles")
    numbers = numpy.empty(len(found["points"]), int)
    numbers[triangles.ravel()] = found["triangles"].ravel()
    expect(numpy.array_equal(numbers[triangles], found["triangles"]), f"{family.name}: the series has other triangles")
    return numbers
