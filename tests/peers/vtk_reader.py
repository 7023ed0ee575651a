"""Run by Debian's Python with VTK's modules: interpolates between the files of a .pvd as VTK does.

usage: vtk_reader.py JOB.json

The job has the `file`, the `times`, and the `folder` that receives time-N.npz: points, triangles and the fields of
the points. The folder also receives version.txt.
"""

import json
import sys
import xml.etree.ElementTree
from pathlib import Path

import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersHybrid import vtkTemporalInterpolator
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


class Series(VTKPythonAlgorithmBase):
    """The files of a .pvd as a source of data at times. VTK itself leaves .pvd to ParaView."""

    def __init__(self, file):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        steps = xml.etree.ElementTree.parse(file).iter("DataSet")
        self.files = sorted((float(step.get("timestep")), file.parent / step.get("file")) for step in steps)

    def RequestInformation(self, _request, _inputs, outputs):
        times = [time for time, _ in self.files]
        information = outputs.GetInformationObject(0)
        information.Set(Pipeline.TIME_STEPS(), times, len(times))
        information.Set(Pipeline.TIME_RANGE(), [times[0], times[-1]], 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        information = outputs.GetInformationObject(0)
        wanted = information.Get(Pipeline.UPDATE_TIME_STEP())
        time, file = min(self.files, key=lambda step: abs(step[0] - wanted))
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
        output = self.GetOutputData(outputs, 0)
        output.ShallowCopy(reader.GetOutput())
        output.GetInformation().Set(output.DATA_TIME_STEP(), time)
        return 1


def surface_of(data):
    adapted = dataset_adapter.WrapDataObject(data)
    fields = adapted.PointData
    named = {"field " + name.replace(" ", "_"): numpy.array(fields[name]) for name in fields.keys()}
    return {"points": adapted.Points, "triangles": numpy.array(adapted.Polygons).reshape(-1, 4)[:, 1:]} | named


def main():
    job = json.loads(Path(sys.argv[1]).read_text())
    series = Series(Path(job["file"]))
    interpolator = vtkTemporalInterpolator()
    interpolator.SetInputConnection(series.GetOutputPort())
    for number, time in enumerate(job["times"]):
        interpolator.UpdateTimeStep(time)
        numpy.savez(Path(job["folder"]) / f"time-{number}.npz", **surface_of(interpolator.GetOutputDataObject(0)))
    (Path(job["folder"]) / "version.txt").write_text(f"VTK {vtkVersion.GetVTKVersion()}")


main()
