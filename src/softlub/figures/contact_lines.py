"""Contact pressure (left) and gap (right) along the central line of a rough contact at several loads (figure 4-10)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import FloatArray, quantity

COLUMNS = (
    ("contact_pressure", "pressure", "Pa", style.SOLID),
    ("gap", "gap", "m", style.SEPARATION),
)
"""Variable, label, unit and colour of each column."""


def draw(dataset: xr.Dataset, height: float = 5.2) -> DataFigure:
    """Draw a row a load, all rows on the same scales.

    Parameters
    ----------
    dataset : xarray.Dataset
        With contact_pressure and gap over load_step and x, and over y where whole maps are kept.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    loads = dataset["pressure"].values
    order = np.argsort(loads)
    position = dataset["x"].values
    pressure, gap = (central_line(dataset[name])[order] for name in ("contact_pressure", "gap"))
    with styled():
        figure = new_figure(style.PAGE, height)
        x = quantity("x", position, label="position x")
        axes = figure.subplots(len(loads), 2, sharex=True, sharey="col", squeeze=False)
        for column, (values, (name, label, unit, colour)) in enumerate(
            zip((pressure, gap), COLUMNS, strict=True)
        ):
            y = quantity(name, values[np.isfinite(values)], label=label, unit=unit)
            for row, step in enumerate(order):
                panel = Panel(axes[row, column], x, y, f"{'ab'[column]}{row + 1}")
                load = quantity("pressure", loads[step], unit="Pa")
                series = f"p = {load.shown(loads[step]):.4g} {load.shown_unit}"
                panel.line(series, position, values[row], "", color=colour, linewidth=0.7)
                state = "" if bool(dataset["converged"].values[step]) else ", did not converge"
                panel.axes.set_title(series + state, loc="right", pad=2, fontsize=7)
                if row == 0:
                    panel.letter("ab"[column])
                if row < len(loads) - 1:
                    panel.axes.set_xlabel("")
            panel.axes.set_xlim(float(x.shown(position[0])), float(x.shown(position[-1])))
            panel.axes.set_ylim(0.0, 1.05 * float(np.nanmax(y.shown(values))))
        return figure


def central_line(field: xr.DataArray) -> FloatArray:
    """Values along x in the middle of y, shape (loads, nx)."""
    if "y" in field.dims:
        field = field.isel(y=field.sizes["y"] // 2)
    return np.asarray(field.transpose("load_step", "x").values, dtype=float)
