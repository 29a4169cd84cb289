"""Displacement of the contact edge by finite elements and by what stands for them (figures 5-4 to 5-10)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.bodies import Body, bodies, stopped
from softlub.figures.edge_displacements import (
    DIRECTIONS,
    EdgeCurve,
    difference_sentence,
    draw_edges,
    line,
    markers,
    percent,
)
from softlub.figures.panel import DataFigure, styled
from softlub.figures.quantities import FloatArray, quantity

NAMES = {
    "full": "finite elements",
    "reduced": "reduced stiffness",
    "constrained": "reduced stiffness, constraint kept",
}
"""Methods of a dataset as a legend names them."""
KEPT: dict[str, Any] = {"color": style.BLACK, "linestyle": "--", "linewidth": 0.9}
PLANE_LINES: tuple[Any, ...] = (":", (0, (5, 1, 1, 1)), (0, (1, 3)), (0, (8, 2)))


def draw(
    dataset: xr.Dataset, friction: float | None = None, load: float | None = None, height: float = 4.1
) -> DataFigure:
    """Draw the displacement of each body: finite elements as a line, the reduced stiffness as markers.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind solid.
    friction : float, optional
        The only one drawn, where several were swept.
    load : float, optional
        The same [N/m].
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure

    Raises
    ------
    ValueError
        If the dataset lacks the friction or the load, or has more bodies than a figure tells apart.
    """
    everyone = bodies(dataset, {"friction": friction, "load": load})
    with styled():
        curves = [curve for body in everyone for curve in _curves(body)] + _half_spaces(everyone[0])
        figure = draw_edges(curves, height)
        figure.notes += [sentence for body in everyone for sentence in _differences(body)]
        figure.notes += _half_space_differences(everyone[0])
        figure.notes += stopped(everyone)
        return figure


def _curves(body: Body) -> list[EdgeCurve]:
    """One curve a method."""
    methods = [str(name) for name in body.data["method"].values]
    looks = {
        "full": line(body.position),
        "reduced": markers(body.position, body.position, body.x.size),
        # A line, since a single node holds it.
        "constrained": KEPT,
    }
    moved = {name: _components(body, body.data["displacement"].sel({"method": name})) for name in methods}
    return [
        EdgeCurve(
            body.named(NAMES[name]),
            body.x,
            moved[name],
            looks[name],
            moved["full"] if name == "reduced" else None,
        )
        for name in methods
    ]


def _components(body: Body, displacement: xr.DataArray) -> dict[str, FloatArray]:
    return {name: body.reached(np.asarray(displacement.sel(component=name).values)) for name in DIRECTIONS}


def _datum(body: Body) -> list[str]:
    """Datums of the half-planes, as text."""
    if "displacement_half_space" not in body.data:
        return []
    return [quantity("datum", unit="m").text(float(value)) for value in body.data["datum"].values]


def _half_spaces(body: Body) -> list[EdgeCurve]:
    """The half-plane under a body's nodal forces, for every datum of its logarithm."""
    return [
        EdgeCurve(
            f"half-space, datum {text}",
            body.x,
            _components(body, body.data["displacement_half_space"].isel(datum=index)),
            {
                "color": style.BLACK,
                "linestyle": PLANE_LINES[index % len(PLANE_LINES)],
                "linewidth": 0.9,
            },
        )
        for index, text in enumerate(_datum(body))
    ]


def _differences(body: Body) -> list[str]:
    """By how much each method differs from finite elements, of the largest displacement and of each direction's."""
    if not body.converged:
        return []
    found = []
    for method in (str(name) for name in body.data["method"].values if name != "full"):
        whole = float(body.data["displacement_error"].sel({"method": method}))
        each = body.data["displacement_error_component"].sel({"method": method})
        lateral, vertical = (float(each.sel(component=name)) for name in "xy")
        found.append(difference_sentence(body.named(NAMES[method]), whole, lateral, vertical))
    return found


def _half_space_differences(body: Body) -> list[str]:
    if not (_datum(body) and body.converged):
        return []
    errors = body.data["displacement_half_space_error"].values
    each = ", ".join(
        f"{percent(value)} (datum {text})" for value, text in zip(errors, _datum(body), strict=True)
    )
    return [
        f"The half-space under the same forces differs by at most {each} of the largest displacement; the datum is the "
        "distance from a line load at which its logarithm is zero."
    ]
