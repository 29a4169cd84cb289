"""Friction coefficient over Hersey number (figure 3-15): one curve a scene, each module's points over Newton's."""

from __future__ import annotations

import xarray as xr

from softlub.figures import style
from softlub.figures.curves import curves
from softlub.figures.looks import MOST_CURVES, looks, refuse_many
from softlub.figures.panel import DataFigure, Panel, new_figure, place_legend, styled
from softlub.figures.quantities import quantity


def draw(dataset: xr.Dataset, variable: str = "friction_coefficient", height: float = 2.7) -> DataFigure:
    """Draw one variable over Hersey number.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimension speed; every further dimension gives curves of its own. Along `solver`, Newton solvers are
        drawn as lines and the source's modules as points over them.
    variable : str
        What to draw.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    with styled():
        figure = new_figure(style.COLUMN, height)
        values = dataset[variable].values
        panel = Panel(figure.subplots(), quantity("hersey_number"), quantity(variable, values), "a")
        panel.axes.set_xscale("log")
        if variable.startswith("separation"):
            panel.axes.set_yscale("log")
        draw_curves(panel, dataset, variable)
        if dataset.sizes.get("solver", 1) > 1:
            figure.notes.append(style.SOLVERS_EXPLAINED)
        if not variable.startswith("separation"):
            panel.axes.set_ylim(bottom=min(0.0, panel.axes.get_ylim()[0]))
        place_legend(figure, panel)
        return figure


def draw_curves(panel: Panel, dataset: xr.Dataset, variable: str, legend: bool = True) -> None:
    """Every curve of the dataset into one panel, failed points marked on its lower edge.

    Parameters
    ----------
    panel : Panel
    dataset : xarray.Dataset
    variable : str
    legend : bool
        Whether the curves are named in the panel's legend.
    """
    all_curves = list(curves(dataset))
    refuse_many("this figure", len(all_curves), MOST_CURVES)
    rows = {curve.position: row for row, curve in enumerate(c for c in all_curves if c.failed.any())}
    for curve, look in zip(all_curves, looks(all_curves), strict=True):
        # A single curve needs no name: the axis says what it is.
        name = curve.label or panel.y.label
        shown = None if legend and curve.label else ""
        panel.line(name, curve.hersey_number, curve.values(variable), shown, curve.flags, **look)
        panel.mark_failed(curve.hersey_number[curve.failed], look["color"], rows.get(curve.position, 0))
