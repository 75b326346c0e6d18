"""Paint the frames of runs with ParaView, without labels.

pvbatch paint.py '{"directories": [...], "field": ..., "size": [w, h],
"view": [across, along], "range": null}'

All runs share the camera and the colour range, so that their pictures can be
compared. Writes DIR/render/plain/NNNN.png and view.json (colours, and where in
the picture the blade's forces act) for each DIR.
"""

import json
import os
import sys

import matplotlib
import numpy as np
from paraview import simple as pv

sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[0])))
from blade import Blade  # noqa: E402
from camera import Camera  # noqa: E402
from frame import Frame, array, read_grid  # noqa: E402
from run_directory import RunDirectory  # noqa: E402

ARROW = 0.35     # length of the largest force's arrow, of the body's size
MAPS = {"positive": "YlOrRd", "signed": "coolwarm"}


def main(options):
    runs = [RunDirectory(path) for path in options["directories"]]
    frames = [[Frame(run, number) for number in run.frames] for run in runs]
    every = [frame for of_run in frames for frame in of_run]
    low, high = options["range"] or colour_range(every, options["field"])
    colours = {"field": options["field"], "range": [low, high],
               "map": MAPS["signed" if low < 0 else "positive"]}
    scale_arrows(every)

    camera = Camera(Blade(runs[0].parameters), options["view"])
    camera.fit(np.concatenate([frame.extent() for frame in every]),
               options["size"])
    view = new_view(options["size"])
    camera.aim(view)
    for run, of_run in zip(runs, frames):
        paint_run(view, camera, run, of_run, colours)


def colour_range(frames, field):
    """Nearly all values: the few at a blade's force grow without bound."""
    values = np.concatenate([frame.values(field) for frame in frames])
    low, high = values.min(), np.percentile(np.abs(values), 99.5)
    high = high or 1.0
    return (-high, high) if low < -0.01 * high else (0.0, high)


def scale_arrows(frames):
    forces = [np.linalg.norm(force) for frame in frames
              for _, force in frame.arrows]
    size = np.ptp(frames[0].places, axis=0).max()
    for frame in frames:
        frame.arrows = [(tip, tip - force * ARROW * size / max(forces),
                         np.linalg.norm(force))
                        for tip, force in frame.arrows]


def new_view(size):
    view = pv.CreateRenderView(ViewSize=size)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    return view


def paint_run(view, camera, run, frames, colours):
    folder = os.path.join(run.path, "render", "plain")
    os.makedirs(folder, exist_ok=True)
    outline = draw_outline(view, read_grid(run.frames[min(run.frames)]))
    description = dict(colours, unit=run.unit(colours["field"]), frames={})
    for frame in frames:
        body = draw_body(view, frame.grid, colours)
        pv.SaveScreenshot(os.path.join(folder, f"{frame.number:04d}.png"),
                          view)
        pv.Delete(body)
        description["frames"][frame.number] = {
            "apart": frame.is_apart,
            "arrows": [{"tip": camera.pixels(tip)[0],
                        "tail": camera.pixels(tail)[0], "force": force}
                       for tip, tail, force in frame.arrows]}
    pv.Delete(outline)
    with open(os.path.join(folder, "view.json"), "w") as file:
        json.dump(description, file, indent=1)


def draw_body(view, grid, colours):
    source = produce(grid)
    body = pv.Show(source, view)
    body.Representation = "Surface With Edges"
    body.NonlinearSubdivisionLevel = subdivisions(grid.GetNumberOfCells())
    body.EdgeColor = [0.15, 0.15, 0.15]
    body.LineWidth = 2
    body.Ambient, body.Diffuse, body.Specular = 0.6, 0.42, 0.0
    pv.ColorBy(body, ("POINTS", colours["field"]))
    body.SetScalarBarVisibility(view, False)
    table = pv.GetColorTransferFunction(colours["field"])
    if array(grid, colours["field"]).ndim > 1:
        table.VectorMode = "Magnitude"
    table.RGBPoints = colour_points(colours)
    return source


def colour_points(colours):
    """Matplotlib's map, so that the colour bar drawn with it agrees."""
    low, high = colours["range"]
    colour = matplotlib.colormaps[colours["map"]]
    return [number for t in np.linspace(0, 1, 65)
            for number in (low + t * (high - low), *colour(t)[:3])]


def draw_outline(view, grid):
    """The edges of the body at rest."""
    whole = pv.CleantoGrid(Input=produce(grid))  # elements come unconnected
    surface = pv.ExtractSurface(Input=whole)
    surface.NonlinearSubdivisionLevel = 2
    edges = pv.FeatureEdges(Input=surface)
    edges.NonManifoldEdges = 0
    outline = pv.Show(edges, view)
    outline.ColorArrayName = ["POINTS", ""]
    outline.AmbientColor = outline.DiffuseColor = [0.6, 0.6, 0.6]
    outline.LineWidth = 1.5
    return edges


def produce(grid):
    source = pv.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    return source


def subdivisions(n_cells):
    """How finely curved faces are drawn; many small ones need it less."""
    return 4 if n_cells < 1000 else 2 if n_cells < 20000 else 1


main(json.loads(sys.argv[1]))
