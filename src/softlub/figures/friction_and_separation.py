"""Friction coefficient and smallest separation over Hersey number, on two axes (figure 3-17)."""

from __future__ import annotations

import xarray as xr

from softlub.figures import style
from softlub.figures.load_share import newton_curves
from softlub.figures.looks import MOST_DASHED, dashes, handles, refuse_many
from softlub.figures.panel import DataFigure, Panel, new_figure, place_legend, styled
from softlub.figures.quantities import quantity

COLOURS = (style.BLACK, style.SEPARATION)
"""Of friction and separation."""


def draw(dataset: xr.Dataset, height: float = 2.7) -> DataFigure:
    """Draw friction on the left axis and the smallest separation on the right one.

    Parameters
    ----------
    dataset : xarray.Dataset
        Stribeck dataset. Along `solver` only the Newton solution is drawn.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    with styled():
        figure = new_figure(style.COLUMN, height)
        left = figure.subplots()
        left.tick_params(right=False)
        hersey = quantity("hersey_number")
        friction = Panel(left, hersey, quantity("friction_coefficient"), "left axis")
        # Micrometres whatever the largest value: films of interest lie around one.
        separation = Panel(left.twinx(), hersey, quantity("separation_min", 1e-6), "right axis")
        left.set_xscale("log")
        separation.axes.set_yscale("log")
        chosen = newton_curves(dataset)
        refuse_many("friction_and_separation", len(chosen), MOST_DASHED)
        named = {friction.y.label: COLOURS[0], separation.y.label: COLOURS[1]}
        friction.handles += handles(named, chosen)
        for curve in chosen:
            suffix = f", {curve.label}" if curve.label else ""
            for panel, colour in zip((friction, separation), COLOURS, strict=True):
                panel.line(
                    f"{panel.y.label}{suffix}",
                    curve.hersey_number,
                    curve.values(panel.y.name),
                    label="",
                    flags=curve.flags,
                    color=colour,
                    linestyle=dashes(curve),
                )
            friction.mark_failed(curve.hersey_number[curve.failed])
        colour_axis(separation, style.SEPARATION)
        left.set_ylim(bottom=0.0)
        friction.explain_doubts_of(separation)
        place_legend(figure, friction, loc="upper center")
        return figure


def colour_axis(panel: Panel, colour: str) -> None:
    """Give a right-hand axis the colour of its curves."""
    panel.axes.yaxis.label.set_color(colour)
    panel.axes.tick_params(axis="y", which="both", colors=colour)
    panel.axes.spines["right"].set_color(colour)
