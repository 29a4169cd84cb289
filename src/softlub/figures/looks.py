"""Looks of the curves of one figure: no two alike, the first swept dimension by colour, the others by dashes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.lines import Line2D

from softlub.figures import style
from softlub.figures.curves import Curve

MOST_CURVES = 16
"""Curves over speed that one figure tells apart."""
MOST_DASHED = len(style.LINE_STYLES)
"""Curves of figures in which colours name the quantities, so that only dashes are left for the curves."""
FEW_POINTS = 25
"""Points below which a curve shows each by a marker."""


def refuse_many(drawing: str, number: int, most: int) -> None:
    """Refuse more curves than a drawing tells apart.

    Raises
    ------
    ValueError
        In words for somebody who has written the study file.
    """
    if number > most:
        raise ValueError(
            f"{drawing} would show {number} curves and tells {most} apart; sweep fewer values, or make a study for "
            "each part of them"
        )


def handles(quantities: Mapping[str, str], curves: Sequence[Curve]) -> list[Line2D]:
    """Entries of a legend where colours name quantities and dashes name curves.

    Parameters
    ----------
    quantities : mapping
        Name -> colour.
    curves : sequence of Curve
        The curves drawn; one alone needs no entry.

    Returns
    -------
    list of matplotlib.lines.Line2D
    """
    named = [curve for curve in curves if curve.label]
    return [Line2D([], [], color=colour, label=name) for name, colour in quantities.items()] + [
        Line2D([], [], color=style.SLATE, linestyle=dashes(curve), label=curve.label) for curve in named
    ]


def dashes(curve: Curve) -> Any:
    """Dashes of one of at most `MOST_DASHED` curves."""
    return style.LINE_STYLES[curve.position]


def looks(curves: Sequence[Curve]) -> list[dict[str, Any]]:
    """A look for each curve, as keywords of `matplotlib.lines.Line2D`.

    Where solvers are compared, Newton's curves are lines and the source's modules points over them.

    Parameters
    ----------
    curves : sequence of Curve
        All of one dataset.

    Returns
    -------
    list of dict

    Raises
    ------
    ValueError
        If two curves would look alike.
    """
    found = _looks(curves)
    kinds = {(look["color"], look["linestyle"], look.get("marker")) for look in found}
    if len(kinds) < len(found):
        raise ValueError(
            f"the {len(found)} curves cannot all be told apart: a figure has {len(style.CYCLE)} colours for the first "
            f"swept input and {len(style.LINE_STYLES)} dashes for the others; sweep fewer values"
        )
    return found


def _looks(curves: Sequence[Curve]) -> list[dict[str, Any]]:
    inputs = [tuple(place for name, place in curve.places if name != "solver") for curve in curves]
    scenes = list(dict.fromkeys(inputs))
    if not any(name == "solver" for curve in curves for name, _ in curve.places):
        rest = list(dict.fromkeys(place[1:] for place in inputs))
        return [
            _look_of_scene(curve, place[0] if place else 0, rest.index(place[1:]) if place[1:] else None)
            for curve, place in zip(curves, inputs, strict=True)
        ]
    by_solver = _looks_of_solvers(list(dict.fromkeys(_solver(curve) for curve in curves)))
    found = []
    for curve, place in zip(curves, inputs, strict=True):
        # With inputs swept besides, colours belong to them.
        own = {"color": style.CYCLE[scenes.index(place) % len(style.CYCLE)]} if len(scenes) > 1 else {}
        found.append(by_solver[_solver(curve)] | own)
    return found


def _solver(curve: Curve) -> str:
    return str(curve.data["solver"].values)


def _look_of_scene(curve: Curve, first: int, others: int | None) -> dict[str, Any]:
    """Colour by the first swept input, dashes by the others; with one input alone both change together."""
    dash = first if others is None else others
    few = np.isfinite(curve.values("friction_coefficient")).sum() < FEW_POINTS
    return {
        "color": style.CYCLE[first % len(style.CYCLE)],
        "linestyle": style.LINE_STYLES[dash % len(style.LINE_STYLES)],
        "marker": style.MARKERS[dash % len(style.MARKERS)] if few else None,
        "markersize": 2.5,
    }


def _looks_of_solvers(solvers: Sequence[str]) -> dict[str, dict[str, Any]]:
    newton = [name for name in solvers if style.solver_of(name) in style.NEWTON_SOLVERS]
    found: dict[str, dict[str, Any]] = {}
    for index, name in enumerate(newton):
        colour = style.BLACK if index == 0 else style.GREY
        found[name] = {"color": colour, "linestyle": style.LINE_STYLES[index % len(style.LINE_STYLES)]}
    spare = [
        marker
        for marker in (*style.MARKERS, "<", ">", "*", "h")
        if marker not in style.SOLVER_MARKERS.values()
    ]
    taken: list[str] = []
    for name in solvers:
        if name in found:
            continue
        module = style.solver_of(name)
        marker = style.SOLVER_MARKERS.get(module, spare[0])
        if marker in taken:
            marker = next(one for one in spare if one not in taken)
        taken.append(marker)
        found[name] = {
            "color": style.SOLVER_COLOURS.get(module, style.GREY),
            "marker": marker,
            "linestyle": "none",
            "markerfacecolor": "white",
            "zorder": 3,
        }
    return found
