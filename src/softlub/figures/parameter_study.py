"""What one input does: friction (a) and smallest separation (b) over Hersey number (figures 3-18 and 3-19)."""

from __future__ import annotations

import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, place_legend, styled
from softlub.figures.quantities import quantity
from softlub.figures.stribeck import draw_curves


def draw(dataset: xr.Dataset, height: float = 2.6) -> DataFigure:
    """Draw friction and separation side by side, one curve a value of the swept input.

    Parameters
    ----------
    dataset : xarray.Dataset
        Stribeck dataset with one or more swept dimensions.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        hersey = quantity("hersey_number")
        friction = Panel(left, hersey, quantity("friction_coefficient"), "a")
        separation = Panel(right, hersey, quantity("separation_min", 1e-6), "b")
        for panel in (friction, separation):
            panel.axes.set_xscale("log")
            panel.letter(panel.name)
        separation.axes.set_yscale("log")
        draw_curves(friction, dataset, "friction_coefficient")
        draw_curves(separation, dataset, "separation_min", legend=False)
        friction.axes.set_ylim(bottom=0.0)
        friction.explain_doubts_of(separation)
        place_legend(figure, friction)
        return figure
