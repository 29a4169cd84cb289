"""Two solvers of one rough contact (figure 4-11): separation (a) and area (b) over the load, by several counts."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import contact_curve, contacts
from softlub.figures import style
from softlub.figures.area_and_separation import PRESSURE, SEPARATION
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import FloatArray, quantity

NAMES = {
    "conjugate_gradients": "ours",
    "polonsky_keer": "Polonsky–Keer",
    "periodic": "periodic",
    "free": "finite patch (DC-FFT)",
}
"""How a solver or a boundary reads in a legend."""
LOOKS: tuple[dict[str, Any], ...] = (
    {"color": style.BLUE, "linewidth": 2.4, "alpha": 0.5},
    {"color": style.VERMILION, "linestyle": "--"},
    {"color": style.BLACK, "linestyle": "none", "marker": "o", "markersize": 4, "markerfacecolor": "none"},
    {"color": style.GREEN, "linestyle": ":"},
)
THRESHOLD_LOOKS: tuple[dict[str, Any], ...] = (
    {"marker": "^", "color": style.GREEN},
    {"marker": "v", "color": style.PURPLE},
)


def draw(dataset: xr.Dataset, height: float = 3.1) -> DataFigure:
    """Draw what each method finds, and the area that a threshold of the gap would count.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of one surface by several solvers, or periodic and finite; contact_area_ratio_gap over
        `threshold` [m] where it was counted.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    area_axis = quantity("contact_area_ratio_pixel", label=r"area by pixels $A/A_0$", unit="1")
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        separation, area = Panel(left, PRESSURE, SEPARATION, "a"), Panel(right, PRESSURE, area_axis, "b")
        for panel in (separation, area):
            panel.letter(panel.name)
            panel.axes.set_xscale("log")
        everyone = list(contacts(dataset))
        for index, (labels, contact) in enumerate(everyone):
            name, look = contact_name(labels), LOOKS[index % len(LOOKS)]
            curve = contact_curve(contact)
            separation.line(name, curve.reduced_pressure, curve.relative_separation(), **look)
            area.line(name, curve.reduced_pressure, curve.mean["contact_area_ratio_pixel"], "", **look)
            for panel in (separation, area):
                panel.mark_failed(curve.reduced_pressure[curve.failed], str(look["color"]), index)
        if "contact_area_ratio_gap" in dataset:
            _draw_thresholds(area, everyone[0][1])
        separation.axes.set_ylim(bottom=0.0)
        area.axes.set_ylim(0.0, 1.03)
        share_legend(figure, [separation, area], 2)
        return figure


def contact_name(labels: dict[str, str]) -> str:
    """A contact as a legend names it: ``"ours, finite patch (DC-FFT)"``."""
    first_words = [labels[name].split()[0] for name in sorted(labels, key=lambda name: name != "solver")]
    return ", ".join(NAMES.get(word, word) for word in first_words) or "contact"


def _draw_thresholds(panel: Panel, one: xr.Dataset) -> None:
    """Area by gap < threshold, of the first contact."""
    counted = one["contact_area_ratio_gap"]
    if "realisation" in counted.dims:
        counted = counted.mean("realisation")
    loads: FloatArray = np.asarray(contact_curve(one).reduced_pressure)
    order = np.argsort(np.asarray(one["reduced_pressure"].values).reshape(-1, loads.size)[0])
    for number, look in zip(range(one.sizes["threshold"]), THRESHOLD_LOOKS, strict=False):
        threshold = float(one["threshold"].values[number])
        panel.line(
            f"gap < {style.power(threshold)} m",
            loads,
            counted.isel(threshold=number).values[order],
            linestyle="none",
            markersize=3,
            markerfacecolor="none",
            **look,
        )
