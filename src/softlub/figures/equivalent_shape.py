"""Contact edge of a viscoelastic body and of its hyperelastic equivalents (figure 5-15).

The whole edge (a), the contact (b), and how far the nodes are from those of the viscoelastic body (c).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from softlub.figures import style
from softlub.figures.edge_displacements import LINES, MARKERS, marked
from softlub.figures.models import Model, models, scene_sentences
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import FloatArray, quantity

COLOURS = (style.VERMILION, style.GREEN, style.PURPLE, style.ORANGE)
CLOSE_UP = 4.0
"""Half of the width of (b) in half-widths of the contact."""


def draw(
    dataset: xr.Dataset,
    friction: float | None = None,
    load: float | None = None,
    steps: str = "",
    height: float = 2.9,
) -> DataFigure:
    """Draw deformed edges and their distances.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind equivalence.
    friction, load : float, optional
        Which one where several were swept [1], [N/m]; without them the first and the heaviest.
    steps : str, optional
        The same by label; the first without it.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure

    Raises
    ------
    ValueError
        If the dataset lacks one of them.
    """
    everyone = models(dataset, {"friction": friction, "load": load, "steps": steps})
    reference, others = everyone[0], everyone[1:]
    rest = np.stack([reference.data["x"].values, reference.data["base_gap"].values])
    with styled():
        figure = new_figure(style.PAGE, height)
        whole, close, apart = figure.subplots(1, 3)
        left, right, high = _close_up(reference, rest)
        panels = []
        for letter, axes in (("a", whole), ("b", close)):
            x = quantity("x", rest[0] if letter == "a" else np.array([left, right]))
            y = quantity("y", rest[1] if letter == "a" else np.array([high]), label="height y", unit="m")
            panel = Panel(axes, x, y, letter)
            panel.letter(letter)
            panel.line("body at rest", *rest, color=style.GREY, linewidth=0.7, linestyle="--")
            panels.append(panel)
            _draw_edges(panel, everyone, rest)
        panels[1].axes.set_xlim(*panels[1].x.shown([left, right]))
        panels[1].axes.set_ylim(*panels[1].y.shown([_lowest(everyone, rest) - 0.06 * high, high]))
        _draw_distances(apart, reference, others, rest)
        share_legend(figure, panels, columns=4 if len(everyone) < 4 else 3)
        figure.notes += scene_sentences(dataset, everyone) + [
            _sentence(model) for model in others if _known(model)
        ]
        return figure


def _edge(model: Model, rest: FloatArray) -> FloatArray:
    moved = model.along_edge("displacement")
    return rest + np.stack([moved["x"], moved["y"]])


def _lowest(everyone: Sequence[Model], rest: FloatArray) -> float:
    """Height of the lowest node of all edges, 0 at the apex of the body at rest [m]."""
    heights = np.concatenate([_edge(model, rest)[1] for model in everyone])
    return float(np.nanmin(heights)) if np.isfinite(heights).any() else 0.0


def _close_up(model: Model, rest: FloatArray) -> tuple[float, float, float]:
    """Ends in x and upper end in y of the cut-out around the contact [m]."""
    edge = _edge(model, rest)
    touching = np.flatnonzero(model.data["contact_pressure"].values > 0)
    if not np.isfinite(edge).any() or touching.size < 2:
        return float(rest[0, 0]), float(rest[0, -1]), float(rest[1].max())
    middle = float(edge[0, touching].mean())
    reach = CLOSE_UP * float(np.ptp(edge[0, touching])) / 2
    inside = np.abs(edge[0] - middle) <= reach
    return middle - reach, middle + reach, float(edge[1, inside].max())


def _draw_edges(panel: Panel, everyone: Sequence[Model], rest: FloatArray) -> None:
    low, high = (-np.inf, np.inf) if panel.name == "a" else _close_up(everyone[0], rest)[:2]
    for index, model in enumerate(everyone):
        edge = _edge(model, rest)
        if index == 0:
            panel.line(model.label, *edge, color=style.BLUE, zorder=2)
        else:
            shown = int(((edge[0] > low) & (edge[0] < high)).sum())
            panel.line(
                model.label,
                *edge,
                color=COLOURS[(index - 1) % len(COLOURS)],
                linestyle="none",
                marker=MARKERS[(index - 1) % len(MARKERS)],
                markersize=3.2,
                markerfacecolor="white",
                markeredgewidth=0.8,
                markevery=marked((index - 1) % len(MARKERS), shown),
                zorder=3,
            )
        if not np.isfinite(edge).any():
            panel.mark_failed(np.zeros(1), style.BLUE if index == 0 else COLOURS[index - 1], index)


def _draw_distances(axes: Axes, reference: Model, others: Sequence[Model], rest: FloatArray) -> None:
    edges = [_edge(model, rest) - _edge(reference, rest) for model in others]
    distances = [np.hypot(*edge) for edge in edges]
    values = np.concatenate([*distances, np.zeros(1)])
    panel = Panel(
        axes,
        quantity("x", rest[0]),
        quantity("edge_distance", values, label="distance", unit="m"),
        "c",
    )
    panel.letter("c")
    panel.axes.set_yscale("log")
    for index, (model, distance) in enumerate(zip(others, distances, strict=True)):
        panel.line(
            f"{model.label}, distance",
            rest[0],
            distance,
            "",
            color=COLOURS[index % len(COLOURS)],
            linestyle=LINES[index % len(LINES)],
            linewidth=0.9,
        )


def _known(model: Model) -> bool:
    return bool(np.isfinite(model.data["shape_difference"].values))


def _sentence(model: Model) -> str:
    data = model.data
    normalised = float(data["shape_difference_normalised"])
    difference, rigid = (float(data[name]) * 1e6 for name in ("shape_difference", "shape_difference_rigid"))
    return (
        f"Shape difference (equation 5-16) of {style.plain(model.label)}: {difference:.2g} mm², {normalised:.2g} "
        f"of the mean squared displacement; a body that does not deform scores {rigid:.2g} mm²."
    )
