"""A body at rest (a) and pressed on the plate (b), and its surface beside that of the half-space (c) (figure 5-1)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.bodies import one_body, with_mesh
from softlub.figures.edge_displacements import LINES
from softlub.figures.mesh_panels import corners_of, lines, mesh_panel, whole
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity

MESHES = 2.6
"""Width of a panel with a mesh [inch]."""
COLOURS = (style.VERMILION, style.GREEN, style.PURPLE, style.ORANGE)


def draw(dataset: xr.Dataset, load: float | None = None, height: float = 3.3) -> DataFigure:
    """Draw the mesh, the deformed mesh, and the vertical displacement of the contact edge.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind solid that compares with the half-space and keeps its meshes.
    load : float, optional
        The one drawn [N/m]; the heaviest without it.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure

    Raises
    ------
    ValueError
        If the dataset lacks the load, the meshes or the half-space.
    """
    mesh, notes = with_mesh(dataset, load=load)
    if "displacement_half_space" not in mesh:
        raise ValueError("the dataset has no half-space; add compare: [half_space] and datum to the study")
    rest, moved = corners_of(mesh), corners_of(mesh, deformed=1.0)
    view = whole(np.concatenate([rest, moved]))
    with styled():
        figure = new_figure(style.PAGE, height)
        axes = figure.subplot_mosaic("ac;bc", width_ratios=(1, 1.5))
        for letter, corners in zip("ab", (rest, moved), strict=True):
            panel = mesh_panel(axes[letter], letter, view)
            lines(panel, corners, view, MESHES)
            edge = mesh["mesh_point"].values + (letter == "b") * mesh["mesh_displacement"].values
            panel.line("contact edge", *edge[mesh["mesh_edge"].values].T, color=style.BLUE, linewidth=1.2)
            panel.letter(letter)
        axes["a"].set_xlabel("")
        share_legend(figure, [_draw_surface(axes["c"], mesh)], columns=4)
        figure.notes += notes + _sentences(one_body(dataset, load=load).data)
        return figure


def _draw_surface(axes: Any, body: xr.Dataset) -> Panel:
    """Vertical displacement by finite elements and by the half-space for every datum."""
    x = body["x"].values
    full = _vertical(body["displacement"].sel({"method": "full"}))
    label = "vertical displacement"
    panel = Panel(axes, quantity("x", x), quantity("displacement", full, label=label), "c")
    panel.letter("c")
    ready = bool(body["converged"])
    panel.line("finite elements", x, full if ready else np.full_like(full, np.nan), color=style.BLUE)
    for index, datum in enumerate(body["datum"].values):
        theory = _vertical(body["displacement_half_space"].isel(datum=index))
        panel.line(
            f"half-space, datum {quantity('datum', unit='m').text(float(datum))}",
            x,
            theory if ready else np.full_like(theory, np.nan),
            color=COLOURS[index % len(COLOURS)],
            linestyle=LINES[1 + index % (len(LINES) - 1)],
        )
    if not ready:
        panel.mark_failed(np.zeros(1), style.BLUE)
    return panel


def _vertical(displacement: xr.DataArray) -> np.ndarray:
    return np.asarray(displacement.sel(component="y").values, dtype=float)


def _sentences(body: xr.Dataset) -> list[str]:
    """Displacement in the middle by each, and what no datum changes: that against the ends of the edge."""
    if not bool(body["converged"]):
        return []
    middle = int(np.argmin(np.abs(body["x"].values)))
    length = quantity("displacement")
    theory = [_vertical(body["displacement_half_space"].isel(datum=i)) for i in range(body.sizes["datum"])]
    full = _vertical(body["displacement"].sel({"method": "full"}))
    each = ", ".join(
        f"{length.text(values[middle]).replace('-', '−')} (datum {quantity('datum', unit='m').text(float(datum))})"
        for values, datum in zip(theory, body["datum"].values, strict=True)
    )
    beyond = [values[middle] - (values[0] + values[-1]) / 2 for values in (full, theory[0])]
    return [
        f"The middle of the contact moves by {length.text(full[middle])} in finite elements; the half-space under the "
        f"same nodal forces gives {each}: the distance at which its logarithm is zero decides which is larger.",
        f"No datum changes by how much the middle moves further than the ends of the contact edge: "
        f"{length.text(beyond[0])} in finite elements, {length.text(beyond[1])} in the half-space.",
    ]
