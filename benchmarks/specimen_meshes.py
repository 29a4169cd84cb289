"""Time against error of the triangular specimen pressed on the plate and slid, over the density of its mesh.

Errors are relative to what the plate's height and the contact's peak and half-width tend to, taken from the finest mesh
of each refinement; the time of the finite elements stands beside that of condensing the same mesh and of one
deflection by the reduced stiffness.
"""

import time

import numpy as np
import xarray as xr
from measuring import cpu_seconds

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.solid.body import Body
from softlub.solid.contact_patch import hertz_patch
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.mesh import BodyMesh
from softlub.solid.plate import PlateContact
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.solid.steps import InContact, Loading, Sliding, run

MATERIAL = NeoHookean(c10=0.5932e6, d1=1e-9)
LOAD, FRICTION = 17.0, 0.4
STEPS = (InContact(), Loading(LOAD), Sliding(FRICTION))
REFINED = {
    "rows, 513 edge nodes": [(513, rows, 30) for rows in (8, 11, 16, 20, 30, 40)],
    "edge nodes, 20 rows": [(nodes, 20, 30) for nodes in (129, 257, 513, 1025)],
    "all at once": [(129, 10, 15), (257, 20, 30), (513, 40, 60), (1025, 80, 120)],
}
"""Edge nodes, rows, flank columns; the last of the last is what all are held against."""
QUANTITIES = {
    "plate_height": "height of the plate",
    "peak_pressure": "peak pressure",
    "half_width": "half-width",
}
COLOURS = (style.BLUE, style.VERMILION, style.GREEN)
REPEATS = 3


def measure() -> xr.Dataset:
    """One row a mesh."""
    rows = [_trial(series, *mesh) for series, meshes in REFINED.items() for mesh in meshes]
    dataset = xr.Dataset(
        {name: ("trial", np.array([row[name] for row in rows])) for name in rows[0]},
        attrs={
            "title": "Time against error of the loaded and slid triangular specimen",
            "timed": f"CPU time of the steps into contact, to {LOAD:g} N/m and to friction {FRICTION:g}, warm, "
            "the mesh given; condensation and one product with its inverse likewise",
        },
    )
    errors = {f"{name}_error": np.abs(dataset[name] / dataset[name][-1] - 1) for name in QUANTITIES}
    return dataset.assign(errors)


def _trial(series: str, edge_nodes: int, rows: int, flank_columns: int) -> dict[str, object]:
    mesh = TriangularSpecimen().mesh(
        MeshDensity(edge_nodes=edge_nodes, rows=rows, flank_columns=flank_columns)
    )
    began = time.process_time()
    history = run(Body(mesh, MATERIAL), PlateContact(), STEPS)
    seconds = time.process_time() - began
    last = history.last
    patch = hertz_patch(mesh.edge_positions + last.edge_displacement[:, 0], last.normal / mesh.edge_widths)
    return {
        "series": series,
        "edge_nodes": edge_nodes,
        "rows": rows,
        "degrees_of_freedom": mesh.free_dofs.size,
        "solver_seconds": seconds,
        "iterations": history.iterations,
        "increments": len(history.increments),
        "converged": history.converged,
        "plate_height": last.plate_height,
        "peak_pressure": patch.peak_pressure,
        "half_width": patch.half_width,
        **_reduced(mesh),
    }


def _reduced(mesh: BodyMesh) -> dict[str, float]:
    body = Body(mesh, MATERIAL)
    began = time.process_time()
    reduced = ReducedStiffness.of(body)
    condensation = time.process_time() - began
    forces = np.zeros((mesh.edge.size, 2))
    forces[:, 1] = 1.0
    reduced.displacement(forces)
    return {
        "condensation_seconds": condensation,
        "deflection_seconds": cpu_seconds(lambda: reduced.displacement(forces), REPEATS),
    }


def draw(dataset: xr.Dataset) -> DataFigure:
    """Error of the plate's height (a) and of the peak pressure (b) over time; time over the size (c)."""
    seconds = quantity("solver_seconds", label="CPU time", unit="s")
    size = quantity("degrees_of_freedom", label="free degrees of freedom", unit="1")
    with styled():
        figure = new_figure(style.PAGE, 2.9)
        axes = figure.subplots(1, 3)
        heights = quantity("error", label="relative error of the plate's height", unit="1")
        peaks = quantity("error", label="relative error of the peak pressure", unit="1")
        panels = [
            Panel(axes[0], seconds, heights, "a"),
            Panel(axes[1], seconds, peaks, "b"),
            Panel(axes[2], size, seconds, "c"),
        ]
        for panel in panels:
            panel.letter(panel.name)
            panel.axes.set(xscale="log", yscale="log")
        panels[2].axes.set(xlim=(1e3, 1e6))
        for panel, name in zip(panels, ("plate_height_error", "peak_pressure_error"), strict=False):
            panel.axes.set(xlim=(0.1, 10), ylim=(1e-4, 0.1))
            _errors(panel, dataset, name)
        _times(panels[2], dataset)
        share_legend(figure, panels, 3)
        figure.notes.append("Errors against 1025 edge nodes, 80 rows and 120 flank columns.")
        return figure


def _errors(panel: Panel, dataset: xr.Dataset, name: str) -> None:
    for index, series in enumerate(REFINED):
        own = dataset.isel(trial=dataset["series"].values == series)
        error = own[name].values
        panel.line(
            series,
            own["solver_seconds"].values,
            np.where(error > 0, error, np.nan),
            color=COLOURS[index],
            marker=style.MARKERS[index],
        )


def _times(panel: Panel, dataset: xr.Dataset) -> None:
    own = dataset.isel(trial=np.argsort(dataset["degrees_of_freedom"].values, kind="stable"))
    names = {
        "solver_seconds": "loading and sliding by finite elements",
        "condensation_seconds": "condensation",
        "deflection_seconds": "one deflection by the reduced stiffness",
    }
    for index, (name, label) in enumerate(names.items()):
        panel.line(
            label,
            own["degrees_of_freedom"].values,
            own[name].values,
            color=style.CYCLE[index + 3],
            marker=style.MARKERS[index + 3],
            linestyle="",
        )
