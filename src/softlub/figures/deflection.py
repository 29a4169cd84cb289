"""Deflection of a half-space under Hertz's pressure along its central line, by several methods (figure 4-9)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity

NAMES = {"direct": "direct summation", "dc_fft": "DC-FFT"}
LOOKS: tuple[dict[str, Any], ...] = (
    {"color": style.BLUE, "linewidth": 3.0, "alpha": 0.5},
    {"color": style.VERMILION, "linestyle": "--"},
    {"color": style.GREEN, "linestyle": ":"},
)
REFERENCE = "deflection_hertz"


def draw(dataset: xr.Dataset, height: float = 2.7) -> DataFigure:
    """Draw the deflection by each method, its CPU time in the legend, and the error against the closed form below.

    Parameters
    ----------
    dataset : xarray.Dataset
        With deflection and seconds over `method`, and the closed form, over x.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    position, exact = dataset["x"].values, dataset[REFERENCE].values
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        x = quantity("x", position, label="position x")
        panel = Panel(left, x, quantity("deflection", exact, label="deflection w", unit="m"), "a")
        error = Panel(right, x, quantity("deflection_error", label="relative error of w", unit="1"), "b")
        error.axes.set_yscale("log")
        for each in (panel, error):
            each.letter(each.name)
        for index, (method, look) in enumerate(zip(dataset["method"].values, LOOKS, strict=False)):
            one = dataset.isel(method=index)
            values = one["deflection"].values
            name = f"{NAMES.get(str(method), str(method))}: {float(one['seconds']):.2g} s"
            panel.line(name, position, values, **look)
            difference = np.maximum(np.abs(values / exact - 1), 1e-16)
            error.line(name, position, difference, "", **look)
        panel.line("Hertz", position, exact, color=style.BLACK, linestyle="none", marker=".", markevery=0.06)
        bottom, top = panel.axes.get_ylim()
        panel.axes.set_ylim(bottom, top + 0.5 * (top - bottom))
        panel.legend(loc="upper right", title="CPU time")
        return figure
