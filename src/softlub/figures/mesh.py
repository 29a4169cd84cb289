"""The mesh of a body with its contact edge and its held nodes (a), and the cells at the contact (b) (figure 5-2)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.bodies import with_mesh
from softlub.figures.mesh_panels import around, corners_of, lines, mesh_panel, whole
from softlub.figures.panel import DataFigure, new_figure, share_legend, styled

PANEL = 2.9
"""Width of a panel [inch]."""
CUT_OUT = 0.12
"""Width of the cut-out in parts of the contact edge."""


def draw(dataset: xr.Dataset, close_up: float | None = None, height: float = 3.0) -> DataFigure:
    """Draw a mesh at rest.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study that keeps its meshes, the first of which is drawn, or as `softlub.solid.mesh_dataset.mesh_dataset`
        makes it.
    close_up : float, optional
        Width of the cut-out around the lowest point of the contact edge [m]; an eighth of the edge without it.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    dataset, _ = with_mesh(dataset)
    corners, points = corners_of(dataset), dataset["mesh_point"].values
    edge, held = points[dataset["mesh_edge"].values], points[dataset["mesh_held"].values]
    held = held[np.argsort(held[:, 0])]
    # Where all of the edge is level, its middle.
    lowest = edge[edge[:, 1] == edge[:, 1].min()]
    apex = lowest[len(lowest) // 2]
    width = close_up if close_up is not None else CUT_OUT * float(np.ptp(edge[:, 0]))
    with styled():
        figure = new_figure(style.PAGE, height)
        panels = []
        body = whole(corners)
        views = (body, around(float(apex[0]), float(apex[1]), width, body))
        for letter, axes, view in zip("ab", figure.subplots(1, 2), views, strict=True):
            panel = mesh_panel(axes, letter, view)
            lines(panel, corners, view, PANEL)
            panel.line("contact edge", *edge.T, color=style.VERMILION, linewidth=1.4)
            panel.letter(letter)
            panels.append(panel)
        panels[1].axes.plot(
            panels[1].x.shown(edge[:, 0]),
            panels[1].y.shown(edge[:, 1]),
            ".",
            color=style.VERMILION,
            markersize=2,
        )
        panels[0].line(
            "nodes held by the holder",
            *held.T,
            color=style.BLUE,
            linestyle="none",
            marker="s",
            markersize=1.6,
            markeredgewidth=0,
        )
        share_legend(figure, panels, columns=2)
        figure.notes.append(
            f"The mesh has {len(points)} nodes and {len(corners)} cells, {len(edge)} nodes of them on the contact edge."
        )
        return figure
