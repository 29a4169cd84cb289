"""Friction coefficient and smallest separation over Hersey number, on two axes (figure 3-17)."""

from __future__ import annotations

import xarray as xr

from softlub.figures import style
from softlub.figures.load_share import newton_curves
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity


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
        for curve in chosen:
            suffix = f", {curve.label}" if curve.label else ""
            linestyle = style.LINE_STYLES[curve.position % len(style.LINE_STYLES)]
            for panel, colour in ((friction, style.BLACK), (separation, style.SEPARATION)):
                panel.line(
                    f"{panel.y.label}{suffix}",
                    curve.hersey_number,
                    curve.values(panel.y.name),
                    flags=curve.flags,
                    color=colour,
                    linestyle=linestyle,
                )
            friction.mark_failed(curve.hersey_number[curve.failed])
        colour_axis(separation, style.SEPARATION)
        left.set_ylim(bottom=0.0)
        friction.handles.extend(handle for handle in separation.handles if handle.get_gid() is None)
        friction.legend(loc="upper center")
        return figure


def colour_axis(panel: Panel, colour: str) -> None:
    """Give a right-hand axis the colour of its curves."""
    panel.axes.yaxis.label.set_color(colour)
    panel.axes.tick_params(axis="y", which="both", colors=colour)
    panel.axes.spines["right"].set_color(colour)
