"""Entries of reduced stiffnesses: the diagonal over the edge (a), the row of the apex over the distance from it (b).

For figure 5-9, whose text compares entries of two meshes. Far entries change their sign from node to node, so that (b)
shows their root mean square in classes of the distance.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.bodies import Body, bodies
from softlub.figures.edge_displacements import COLOURS, DIRECTIONS
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import FloatArray, quantity

DASHES: dict[str, Any] = {"y": "-", "x": "--"}
CLASSES_A_DECADE = 8


def draw(
    dataset: xr.Dataset, friction: float | None = None, load: float | None = None, height: float = 2.9
) -> DataFigure:
    """Draw entries of the matrix of each body.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind solid that compares with the reduced stiffness.
    friction, load : float, optional
        The only ones drawn, where several were swept [1], [N/m].
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure

    Raises
    ------
    ValueError
        If the dataset holds no reduced stiffness.
    """
    if "stiffness_diagonal" not in dataset:
        raise ValueError("the dataset has no reduced stiffness; add compare: [reduced] to the study")
    everyone = bodies(dataset, {"friction": friction, "load": load})
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        position = quantity("x", np.concatenate([body.x for body in everyone]))
        away = quantity("distance", 1e-4, label="distance from the apex", unit="m")
        diagonal = Panel(
            left, position, quantity("stiffness_diagonal", label="diagonal entry", unit="N/m²"), "a"
        )
        row = Panel(
            right,
            away,
            quantity("stiffness_apex_row", label="rms entry in the row of the apex", unit="N/m²"),
            "b",
        )
        for panel in (diagonal, row):
            panel.letter(panel.name)
            panel.axes.set_yscale("log")
        row.axes.set_xscale("log")
        for body in everyone:
            _draw_body(diagonal, row, body)
        share_legend(figure, [diagonal], columns=2)
        figure.notes += [_sentence(body) for body in everyone]
        return figure


def _apex(body: Body) -> int:
    return int(np.argmin(body.data["base_gap"].values))


def _draw_body(diagonal: Panel, row: Panel, body: Body) -> None:
    right = body.x > body.x[_apex(body)]
    distance = body.x[right] - body.x[_apex(body)]
    for component, direction in DIRECTIONS.items():
        look = {"color": COLOURS[body.position], "linestyle": DASHES[component], "linewidth": 1.0}
        entries = body.data["stiffness_diagonal"].sel(component=component).values
        diagonal.line(body.named(direction), body.x, entries, **look)
        # The two sides are mirror images; one of them is drawn.
        entries = body.data["stiffness_apex_row"].sel(component=component).values[right]
        row.line(body.named(f"{direction}, row of the apex"), *_classes(distance, entries), "", **look)


def _classes(distance: FloatArray, entries: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Mean distance and root mean square entry of classes of the distance, evenly wide in its logarithm."""
    number = np.floor(CLASSES_A_DECADE * np.log10(distance / distance[0]) + 1e-9).astype(int)
    count = np.bincount(number)
    there = count > 0
    mean = np.bincount(number, distance)[there] / count[there]
    square = np.bincount(number, entries**2)[there] / count[there]
    return mean, np.sqrt(square)


def _sentence(body: Body) -> str:
    apex, data = _apex(body), body.data
    entry = float(data["stiffness_diagonal"].sel(component="y").values[apex])
    name = style.plain(body.label) or "The body"
    freedoms, seconds = int(data["degrees_of_freedom"]), float(data["condensation_seconds"])
    return (
        f"{name}: vertical diagonal entry at the apex {entry / 1e6:.3g} N/mm², condensed from {freedoms} degrees of "
        f"freedom in {seconds:.2g} s of CPU time."
    )
