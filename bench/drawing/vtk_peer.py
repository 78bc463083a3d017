#!/usr/bin/python3
"""vtk_peer.py FILE WIDTH HEIGHT SECONDS EYE TARGET UP VIEW_ANGLE_DEG [cull]

Draws the surface in FILE (PLY with a colour for each vertex) with VTK as often as it can, seen from
in front, still, and prints one JSON object: frames_per_s.
"""

import json
import sys
import time

from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, which draws


def main():
    file, width, height, seconds = sys.argv[1], *map(float, sys.argv[2:5])
    eye, target, up = (tuple(map(float, word.split(","))) for word in sys.argv[5:8])
    angle_deg = float(sys.argv[8])

    reader = vtkPLYReader()
    reader.SetFileName(file)
    reader.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(reader.GetOutput())
    actor = vtkActor()
    actor.SetMapper(mapper)
    if sys.argv[9:] == ["cull"]:
        actor.GetProperty().BackfaceCullingOn()

    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(int(width), int(height))
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(eye)
    camera.SetFocalPoint(target)
    camera.SetViewUp(up)
    camera.SetViewAngle(angle_deg)
    renderer.ResetCameraClippingRange()

    window.Render()
    frames = 0
    processor_began = time.process_time()
    began = time.monotonic()
    while time.monotonic() - began < seconds:
        window.Render()
        frames += 1
    elapsed = time.monotonic() - began
    triangles = reader.GetOutput().GetNumberOfPolys()
    processor = time.process_time() - processor_began
    print(json.dumps({"frames_per_s": frames / elapsed, "triangles": triangles,
                      "cpu_ms_per_frame": 1e3 * processor / frames}))


main()
