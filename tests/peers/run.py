#!/usr/bin/python3
"""Lets other programs read what Interleaf exports, and compares what they see with `interleaf export`.

usage: run.py INTERLEAF FOLDER [PEER...]

FOLDER keeps npm's modules and VTK's between runs. A PEER is gltf-validator, three.js, blender, vtk, paraview
or page; all unless given. `./dev test --peers` calls this with Debian's Python.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from samples import Mismatch, all_families  # noqa: E402

SEED = 19


def installed_modules(folder):
    """npm's modules, installed as package.json names them."""
    wanted = (HERE / "package.json").read_text()
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / "installed.json").exists() or (folder / "installed.json").read_text() != wanted:
        (folder / "package.json").write_text(wanted)
        options = ["--no-package-lock", "--no-fund", "--no-audit", "--silent"]
        subprocess.run(["npm", "install", *options], cwd=folder, check=True)
        (folder / "installed.json").write_text(wanted)
    return folder


def check(name, action):
    started = time.monotonic()
    try:
        action()
    except Mismatch as error:
        print(f"FAILED {name}: {error} (seed {SEED})")
        return False
    print(f"---- {name}: {time.monotonic() - started:.0f} s")
    return True


def main():
    import gltf_peers
    import page_peer
    import vtk_peers

    program, kept, *wanted = sys.argv[1:]
    program, kept = str(Path(program).resolve()), Path(kept).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        families = all_families(program, HERE.parent.parent / "assets" / "families", scratch, SEED)
        small = [family for family in families if family.name != "large"]
        exports = [gltf_peers.Exported(family, scratch) for family in families]
        exports.append(gltf_peers.Exported(families[0], scratch, ["--segments"]))
        peers = {
            "gltf-validator": lambda: gltf_peers.validate(exports, installed_modules(kept)),
            "three.js": lambda: gltf_peers.read_by_three(exports, installed_modules(kept)),
            "blender": lambda: [gltf_peers.read_by_blender(each, scratch) for each in exports],
            "vtk": lambda: vtk_peers.read_by_vtk(small, scratch, kept),
            "paraview": lambda: vtk_peers.read_by_paraview(small, scratch),
            "page": lambda: page_peer.check_pages(small, scratch),
        }
        unknown = set(wanted) - set(peers)
        if unknown:
            sys.exit(f"run.py: there is no peer {', '.join(sorted(unknown))}; there are: {', '.join(peers)}")
        results = [check(name, peers[name]) for name in wanted or peers]
    sys.exit(not all(results))


main()
