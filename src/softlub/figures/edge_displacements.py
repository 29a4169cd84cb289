"""Displacements of a contact edge in four panels: away from the plate and along it, and the differences below them.

The eye sees no difference of a percent in the panels above, so that those below show nothing else.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend
from softlub.figures.quantities import FloatArray, quantity

DIRECTIONS = {"y": "vertical", "x": "lateral"}
"""Components in the order of the panels: away from the plate, along it."""
COLOURS = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE)
LINES: tuple[Any, ...] = ("-", "--", ":", "-.")
MARKERS = ("o", "s", "^", "D")
MOST_MARKERS = 22
"""Markers along one curve."""
STAGGER = (0.0, 0.5, 0.25, 0.75)
"""Where the markers of each curve lie between those of the first, so that none hides another."""


@dataclass(frozen=True, eq=False)
class EdgeCurve:
    """Displacement of one contact edge.

    Parameters
    ----------
    label : str
    x : ndarray, shape (k,)
        Places of the nodes along the unloaded body [m].
    displacement : mapping
        Component -> values [m], shape (k,); NaN where the body did not get to its end.
    look : dict
        Keywords of `matplotlib.lines.Line2D`.
    reference : mapping, optional
        What the displacement is taken from for the panels below, like it.
    """

    label: str
    x: FloatArray
    displacement: dict[str, FloatArray]
    look: dict[str, Any]
    reference: dict[str, FloatArray] | None = field(default=None)

    @property
    def difference(self) -> dict[str, FloatArray]:
        """From the reference [m]; empty without one."""
        if self.reference is None:
            return {}
        return {name: values - self.reference[name] for name, values in self.displacement.items()}


def line(index: int) -> dict[str, Any]:
    """Look of finite elements: a line."""
    return {"color": COLOURS[index], "linestyle": LINES[index], "linewidth": 1.2}


def markers(index: int, colour: int, nodes: int) -> dict[str, Any]:
    """Look of what stands for finite elements: sparse markers, those of one curve between those of the others."""
    return {
        "color": COLOURS[colour],
        "linestyle": "none",
        "marker": MARKERS[index],
        "markersize": 3.6,
        "markerfacecolor": "white",
        "markeredgewidth": 0.8,
        "markevery": marked(index, nodes),
        "zorder": 3,
    }


def marked(index: int, nodes: int) -> tuple[int, int]:
    """First marked node of a curve, and from one to the next."""
    every = max(1, nodes // MOST_MARKERS)
    return int(STAGGER[index] * every), every


def draw_edges(curves: Sequence[EdgeCurve], height: float) -> DataFigure:
    """Draw displacements above and differences below.

    Parameters
    ----------
    curves : sequence of EdgeCurve
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    figure = new_figure(style.PAGE, height)
    axes = figure.subplots(2, 2, sharex=True, height_ratios=(2.4, 1))
    position = quantity("x", np.concatenate([curve.x for curve in curves]))
    above = []
    for column, (component, direction) in enumerate(DIRECTIONS.items()):
        every = np.concatenate([curve.displacement[component] for curve in curves])
        off = np.concatenate([curve.difference.get(component, np.zeros(1)) for curve in curves])
        shown = quantity("displacement", every, label=f"{direction} displacement")
        upper = Panel(axes[0, column], position, shown, "ab"[column])
        upper.axes.set_xlabel("")
        difference = quantity("displacement_difference", off, label="difference", unit="m")
        lower = Panel(axes[1, column], position, difference, "cd"[column])
        lower.axes.axhline(0, color=style.GREY, linewidth=0.4, zorder=0)
        for panel in (upper, lower):
            panel.letter(panel.name)
        for curve in curves:
            _draw(upper, lower, curve, component)
        above.append(upper)
    share_legend(figure, above, columns=2 if len(above[0].handles) > 3 else 3)
    return figure


def _draw(upper: Panel, lower: Panel, curve: EdgeCurve, component: str) -> None:
    upper.line(curve.label, curve.x, curve.displacement[component], **curve.look)
    if curve.reference is not None:
        index = MARKERS.index(curve.look["marker"])
        lower.line(
            f"{curve.label}, difference",
            curve.x,
            curve.difference[component],
            "",
            color=curve.look["color"],
            linestyle=LINES[index],
            linewidth=0.9,
        )
    if not np.isfinite(curve.displacement[component]).any():
        upper.mark_failed(np.zeros(1), curve.look["color"])


def difference_sentence(label: str, whole: float, lateral: float, vertical: float) -> str:
    """By how much a displacement differs from that by finite elements under the same nodal forces.

    Parameters
    ----------
    label : str
    whole, lateral, vertical : float
        Largest difference over the largest displacement, and of the components over their own largest.

    Returns
    -------
    str
    """
    name = style.plain(label)
    return (
        f"{name[:1].upper()}{name[1:]} differs from finite elements under the same nodal forces by at most "
        f"{percent(whole)} of the largest displacement, {percent(lateral)} of the largest lateral and "
        f"{percent(vertical)} of the largest vertical one."
    )


def percent(share: float) -> str:
    """A share as a caption gives it: 0.83 %, 11 %."""
    return f"{100 * share:.2g} %" if abs(share) < 0.995 else f"{100 * share:.0f} %"
