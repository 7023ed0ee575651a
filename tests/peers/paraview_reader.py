"""Run by ParaView's pvpython: interpolates between the files of a .pvd.

usage: pvpython paraview_reader.py JOB.json

The job and the output are those of vtk_reader.py.
"""

import json
import sys
from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import GetParaViewVersion, PVDReader, TemporalInterpolator, UpdatePipeline
from paraview.vtk.numpy_interface import dataset_adapter


def surface_of(data):
    if data.IsA("vtkMultiBlockDataSet"):
        data = data.GetBlock(0)
    adapted = dataset_adapter.WrapDataObject(data)
    fields = adapted.PointData
    named = {"field " + name.replace(" ", "_"): numpy.array(fields[name]) for name in fields.keys()}
    return {"points": adapted.Points, "triangles": numpy.array(adapted.Polygons).reshape(-1, 4)[:, 1:]} | named


job = json.loads(Path(sys.argv[1]).read_text())
interpolator = TemporalInterpolator(Input=PVDReader(FileName=job["file"]))
for number, time in enumerate(job["times"]):
    UpdatePipeline(time=time, proxy=interpolator)
    numpy.savez(Path(job["folder"]) / f"time-{number}.npz", **surface_of(servermanager.Fetch(interpolator)))
print(f"ParaView {GetParaViewVersion()}")
