"""Film on the triangular specimen's own nodes: errors of friction and smallest film over the mesh, and their estimate.

Reduced stiffness at rest, rough surface, water, 17 N/m, at speeds from boundary to full film; against 2049 edge nodes.
"""

import time

import numpy as np
import xarray as xr

from softlub.contact.laws.persson import PerssonLaw
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.lubrication import Lubricant, MeshedBody, Problem, sweep
from softlub.solid import Body, MeshedCompliance, ReducedStiffness
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.surfaces import SelfAffine

MATERIAL = NeoHookean(c10=0.5932e6, d1=1e-9)
ROUGHNESS, LOAD = 0.3e-6, 17.0
EDGE_NODES = (129, 257, 513, 1025, 2049)
"""The last is what the others are held against."""
ROWS = 20
SPEEDS = np.geomspace(1e-4, 10.0, 16)
COMPARED = ("friction_coefficient_fluid", "separation_min")
COLOURS = (style.ORANGE, style.GREEN, style.VERMILION, style.BLUE)


def measure() -> xr.Dataset:
    """Friction of the fluid, smallest film and their errors over edge nodes and speed."""
    modulus = MATERIAL.plane_strain_modulus
    law = PerssonLaw(SelfAffine(ROUGHNESS, hurst=0.8, rolloff=1e5, cutoff=1e9), modulus)
    curves, seconds = [], []
    for nodes in EDGE_NODES:
        shape = TriangularSpecimen()
        body = Body(shape.mesh(MeshDensity(edge_nodes=nodes, rows=ROWS, first_height=2e-6)), MATERIAL)
        meshed = MeshedBody(MeshedCompliance.of(ReducedStiffness.of(body)), shape.tip_radius, modulus)
        problem = Problem(meshed, law, Lubricant(1e-3), LOAD, float(SPEEDS[0]), ROUGHNESS)
        began = time.process_time()
        curves.append(sweep(problem, [LOAD], SPEEDS.tolist()).isel(load=0, drop=True))
        seconds.append(time.process_time() - began)
    names = (*COMPARED, "converged", "separation_min_error", "friction_coefficient_fluid_error")
    data = {
        name: (("edge_nodes", "speed"), np.array([curve[name].values for curve in curves])) for name in names
    }
    dataset = xr.Dataset(
        data | {"solver_seconds": ("edge_nodes", seconds)},
        coords={"edge_nodes": list(EDGE_NODES), "speed": SPEEDS},
    )
    true = {
        f"{name}_true_error": np.abs(dataset[name] / dataset[name].isel(edge_nodes=-1) - 1)
        for name in COMPARED
    }
    return dataset.assign(true).assign_attrs(
        title="Film on the nodes of a meshed specimen",
        timed=f"CPU time of {len(SPEEDS)} speeds with error estimates, the stiffness given; {ROWS} rows",
    )


def draw(dataset: xr.Dataset) -> DataFigure:
    """Error of the fluid's friction (a) and of the smallest film (b) over speed; what is estimated dotted."""
    speed = quantity("speed", SPEEDS)
    labels = ("relative error of the fluid's friction", "relative error of the smallest film")
    with styled():
        figure = new_figure(style.PAGE, 2.9)
        axes = figure.subplots(1, 2)
        panels = [
            Panel(axis, speed, quantity("error", label=label, unit="1"), letter)
            for axis, label, letter in zip(axes, labels, "ab", strict=True)
        ]
        for panel, name in zip(panels, COMPARED, strict=True):
            panel.letter(panel.name)
            panel.axes.set(xscale="log", yscale="log", ylim=(1e-5, 1))
            for nodes, colour, marker in zip(EDGE_NODES[:-1], COLOURS, style.MARKERS, strict=False):
                error = dataset[f"{name}_true_error"].sel(edge_nodes=nodes).values
                panel.line(f"{nodes} edge nodes", SPEEDS, error, color=colour, marker=marker)
        estimate = dataset["separation_min_error"].sel(edge_nodes=513).values
        panels[1].line("513, estimated", SPEEDS, estimate, color=COLOURS[2], linestyle=":")
        share_legend(figure, panels, 5)
        figure.notes.append(f"Against {EDGE_NODES[-1]} edge nodes.")
        return figure
