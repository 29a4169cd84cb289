"""A deformed body coloured by a field: all of it over its outline at rest (a), and the contact (b) (figure 5-1)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.bodies import with_mesh
from softlub.figures.mesh_panels import around, colours, corners_of, lines, mesh_panel, seen, whole
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import FloatArray, quantity

PANEL = 2.4
"""Width of a panel [inch]."""
CUT_OUT = 0.3
"""Width of the cut-out in parts of the contact edge."""


def draw(
    dataset: xr.Dataset,
    friction: float | None = None,
    load: float | None = None,
    close_up: float | None = None,
    height: float = 3.0,
) -> DataFigure:
    """Draw a mesh as it is deformed, to scale.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study that keeps its meshes, or as `softlub.solid.mesh_dataset.mesh_dataset` makes it, with
        stress_von_mises over cell.
    friction, load : float, optional
        Of the body drawn, where a study swept several [1], [N/m].
    close_up : float, optional
        Width of the cut-out around the lowest point of the contact edge [m]; a third of the edge without it.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    dataset, notes = with_mesh(dataset, friction, load)
    corners = corners_of(dataset, deformed=1.0)
    values = np.asarray(dataset["stress_von_mises"].values, dtype=float)
    edge = dataset["mesh_edge"].values
    points = dataset["mesh_point"].values
    moved = points + dataset["mesh_displacement"].values
    apex = moved[edge[np.argmin(moved[edge, 1])]]
    # The middle of what touches, since a flat contact has its lowest node anywhere.
    touching = moved[edge][moved[edge, 1] <= apex[1] + 1e-3 * float(np.ptp(points[edge, 1])), 0]
    width = close_up if close_up is not None else CUT_OUT * float(np.ptp(points[edge, 0]))
    body = whole(np.concatenate([corners, corners_of(dataset)]))
    cut_out = around(float(touching.mean()), float(apex[1]), width, body)
    # The corners of the held side would take all colours: the stress grows there without bound as cells shrink.
    largest = float(values[seen(corners, cut_out)].max())
    meaning = quantity("stress_von_mises", largest, label="von Mises stress")
    with styled():
        figure = new_figure(style.PAGE, height)
        both = figure.subplots(1, 2)
        for letter, axes, view in zip("ab", both, (body, cut_out), strict=True):
            panel = mesh_panel(axes, letter, view)
            filled = colours(panel, corners, view, values, meaning, largest)
            if letter == "b":
                lines(panel, corners, view, PANEL)
            _outline(panel, points, dataset["mesh_cell"].values)
            panel.letter(letter)
        beyond = "max" if values.max() > largest else "neither"
        figure.colorbar(filled, ax=both, label=meaning.axis_label, extend=beyond, shrink=0.8, pad=0.01)
        figure.notes.append(
            "The colours reach up to the largest value in (b); dashed: the border of the body at rest."
        )
        figure.notes += notes
        return figure


def _outline(panel: Panel, points: FloatArray, cells: np.ndarray) -> None:
    """The border of the body at rest, dashed."""
    start, end = cells.ravel(), np.roll(cells, -1, axis=1).ravel()
    key = np.minimum(start, end) * len(points) + np.maximum(start, end)
    _, first, count = np.unique(key, return_index=True, return_counts=True)
    outer = first[count == 1]
    follower = dict(zip(start[outer].tolist(), end[outer].tolist(), strict=True))
    node = int(start[outer][0])
    border = [node]
    while follower:
        node = follower.pop(node)
        border.append(node)
    panel.line("body at rest", *points[border].T, color=style.GREY, linestyle="--", linewidth=0.7)
