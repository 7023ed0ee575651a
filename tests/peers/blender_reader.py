"""Run by Blender: imports a .glb, and writes what Blender makes of it.

usage: blender --background --factory-startup --python blender_reader.py -- JOB.json

The job has the `file`, the `blends` (weights by key), the `times` (seconds) and the `folder` that receives
the vertices: blend-N.f4 and time-N.f4, three floats per vertex, Y up as in the file. result.json has the
rest.
"""

import json
import math
import sys
from pathlib import Path

import numpy

# The importer of Debian's Blender 3.4 was written for a numpy that still had this name.
if not hasattr(numpy, "bool"):
    numpy.bool = bool

import bpy

job = json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text())
folder = Path(job["folder"])
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=job["file"])
scene = bpy.context.scene
meshes = [thing for thing in scene.objects if thing.type == "MESH"]


def y_up(vectors):
    """Blender's importer turns Y up into Z up: (x, y, z) becomes (x, -z, y)."""
    return numpy.stack([vectors[:, 0], vectors[:, 2], -vectors[:, 1]], 1)


def numbers(things, name):
    values = numpy.empty(3 * len(things), "f4")
    things.foreach_get(name, values)
    return values.reshape(-1, 3)


def vertices(shown):
    mesh = shown.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    return y_up(numbers(mesh.vertices, "co"))


def corner_normals(mesh):
    mesh.calc_normals_split()
    corners = numpy.empty(len(mesh.loops), "i4")
    mesh.loops.foreach_get("vertex_index", corners)
    return corners, y_up(numbers(mesh.loops, "normal"))


def visible():
    """The meshes that the animation does not shrink to nothing."""
    return [shown for shown in meshes if shown.matrix_world.median_scale > 0.5]


shapes = [shown.data.shape_keys for shown in meshes]
actions = [action for action in bpy.data.actions if any("value" in c.data_path for c in action.fcurves)]
result = {
    "version": bpy.app.version_string,
    "meshes": [shown.name for shown in meshes],
    "keys": [block.name for block in shapes[0].key_blocks] if shapes[0] else [],
    "rate": scene.render.fps / scene.render.fps_base,
    "range": [min(a.frame_range[0] for a in actions), max(a.frame_range[1] for a in actions)] if actions else None,
    "actions": [action.name for action in bpy.data.actions],
}
for number, time in enumerate(job["times"]):
    frame = time * result["rate"]
    scene.frame_set(math.floor(frame), subframe=frame - math.floor(frame))
    bpy.context.view_layer.update()
    shown = visible()
    result.setdefault("visible", []).append([each.name for each in shown])
    if len(shown) == 1:
        vertices(shown[0]).astype("<f4").tofile(folder / f"time-{number}.f4")
if job["blends"]:
    shapes[0].animation_data_clear()
    for number, weights in enumerate(job["blends"]):
        for block in shapes[0].key_blocks[1:]:
            block.value = weights.get(block.name, 0)
        vertices(meshes[0]).astype("<f4").tofile(folder / f"blend-{number}.f4")
    for block in shapes[0].key_blocks[1:]:
        block.value = 0
    rest = meshes[0].evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    corners, normals = corner_normals(rest)
    corners.astype("<i4").tofile(folder / "corners.i4")
    normals.astype("<f4").tofile(folder / "normals.f4")
(folder / "result.json").write_text(json.dumps(result))
