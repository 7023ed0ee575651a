"""Run by ParaView's pvpython: interpolates between the files of a .pvd, or steps through them.

usage: pvpython paraview_reader.py JOB.json

The job and the output are those of vtk_reader.py. With `steps`, the times are those that the reader finds in the
file, and each output has its `time`.
"""

import json
import sys
from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import GetParaViewVersion, OpenDataFile, TemporalInterpolator, UpdatePipeline
from paraview.vtk.numpy_interface import dataset_adapter


def surface_of(data):
    if data.IsA("vtkMultiBlockDataSet"):
        data = data.GetBlock(0)
    adapted = dataset_adapter.WrapDataObject(data)
    fields = adapted.PointData
    named = {"field " + name.replace(" ", "_"): numpy.array(fields[name]) for name in fields.keys()}
    return {"points": adapted.Points, "triangles": numpy.array(adapted.Polygons).reshape(-1, 4)[:, 1:]} | named


job = json.loads(Path(sys.argv[1]).read_text())
reader = OpenDataFile(job["file"])
source = reader if job["steps"] else TemporalInterpolator(Input=reader)
times = list(reader.TimestepValues) if job["steps"] else job["times"]
for number, time in enumerate(times):
    UpdatePipeline(time=time, proxy=source)
    numpy.savez(Path(job["folder"]) / f"time-{number}.npz", time=time, **surface_of(servermanager.Fetch(source)))
(Path(job["folder"]) / "version.txt").write_text(f"ParaView {GetParaViewVersion()}")
