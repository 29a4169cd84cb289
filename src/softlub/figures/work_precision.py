"""Run time against error: one line a method, one panel a sort of error."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity


def draw(dataset: xr.Dataset, height: float = 3.0) -> DataFigure:
    """Draw errors over CPU time, both logarithmic.

    Parameters
    ----------
    dataset : xarray.Dataset
        Dimensions method (names) and step (one resolution each). Variables ``cpu_time`` [s] and any number of
        ``error_…``, whose `long_name` goes on the axis; ``resolution``, where given, is written at the points.
        NaN where a method has fewer steps or failed.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    errors = [str(name) for name in dataset.data_vars if str(name).startswith("error_")]
    if not errors:
        raise ValueError(
            "a work-precision dataset needs at least one variable whose name begins with 'error_'"
        )
    with styled():
        figure = new_figure(style.COLUMN if len(errors) == 1 else style.PAGE, height)
        axes = np.atleast_1d(figure.subplots(1, len(errors)))
        panels = [_panel(axis, dataset, name, letter) for axis, name, letter in zip(axes, errors, "abcd")]  # noqa: B905
        share_legend(figure, panels, 2)
        return figure


def _panel(axes: Axes, dataset: xr.Dataset, error: str, letter: str) -> Panel:
    label = dataset[error].attrs.get("long_name", error.replace("_", " "))
    panel = Panel(
        axes, quantity("cpu_time", label="CPU time", unit="s"), quantity(error, label=label), letter
    )
    panel.axes.set_xscale("log")
    panel.axes.set_yscale("log")
    panel.letter(letter)
    panel.axes.margins(0.17, 0.1)
    for index, method in enumerate(dataset["method"].values):
        row = dataset.isel({"method": index})
        time, value = row["cpu_time"].values, row[error].values
        panel.line(
            str(method).replace("_", " "),
            time,
            value,
            color=style.CYCLE[index % len(style.CYCLE)],
            marker=style.MARKERS[index % len(style.MARKERS)],
            linestyle=style.LINE_STYLES[index // len(style.CYCLE)],
        )
        if "resolution" in row:
            _label_ends(panel, time, value, row["resolution"].values)
    return panel


def _label_ends(panel: Panel, time: np.ndarray, error: np.ndarray, resolution: np.ndarray) -> None:
    """Write the coarsest and the finest resolution at the ends of a line."""
    drawn = np.flatnonzero(np.isfinite(time) & np.isfinite(error))
    for position in {drawn[0], drawn[-1]} if drawn.size else set():
        panel.axes.annotate(
            f"{resolution[position]:g}"
            if np.issubdtype(resolution.dtype, np.number)
            else str(resolution[position]),
            (panel.x.shown(time[position]), panel.y.shown(error[position])),
            xytext=(3, 3),
            textcoords="offset points",
            fontsize=6,
        )
