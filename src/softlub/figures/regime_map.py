"""Regimes of lubrication over the two numbers that scale a contact in Hertz units."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.lines import Line2D

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, Series, new_figure, share_legend, styled
from softlub.figures.quantities import FloatArray, Quantity, quantity
from softlub.figures.sample import roughness_number, speed_number

FEWEST = 3
"""Points that a cell of the map needs to be drawn."""


def draw(dataset: xr.Dataset, cells: int = 40, height: float = 3.0) -> DataFigure:
    """Draw the mean load share of asperities as a map, with the borders of the regimes by the lambda ratio.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimensions sample and speed.
    cells : int
        Cells of the map in each direction.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    shape = dataset["converged"]
    converged = shape.values.astype(bool).ravel()
    across = _flat(speed_number(dataset), shape)[converged]
    upward = _flat(roughness_number(dataset), shape)[converged]
    with styled():
        figure = new_figure(style.COLUMN * 1.3, height)
        x = quantity("speed_number", label=r"speed number $6\eta v R^2/(a^3 p_0)$", unit="1")
        y = quantity("roughness_number", label=r"roughness number $h_\mathrm{rms} R/a^2$", unit="1")
        panel = Panel(figure.subplots(), x, y, "map")
        panel.axes.set_xscale("log")
        panel.axes.set_yscale("log")
        edges = _edges(across, cells), _edges(upward, cells)
        share = _mean(edges, across, upward, _flat(dataset["load_share_solid"], shape)[converged])
        ratio = np.exp(_mean(edges, across, upward, np.log(_flat(dataset["lambda_ratio"], shape)[converged])))
        image = panel.axes.pcolormesh(*edges, share.T, cmap="cividis", vmin=0, vmax=1, rasterized=True)
        figure.colorbar(image, ax=panel.axes, label="share of the load on asperities (–)")
        _record(panel, edges, share, quantity("load_share_solid"))
        _record(panel, edges, ratio, quantity("lambda_ratio"))
        _draw_borders(panel, edges, ratio)
        share_legend(figure, [panel], 2)
        failed = int((~converged).sum())
        panel.axes.set_title(f"{converged.size} points, {failed} not converged", loc="right")
        return figure


def _flat(values: xr.DataArray, shape: xr.DataArray) -> FloatArray:
    return np.asarray(values.broadcast_like(shape).transpose(*shape.dims).values, dtype=float).ravel()


def _edges(values: FloatArray, cells: int) -> FloatArray:
    return np.geomspace(values.min(), values.max() * (1 + 1e-9), cells + 1)


def _mean(
    edges: tuple[FloatArray, FloatArray], across: FloatArray, upward: FloatArray, values: FloatArray
) -> FloatArray:
    """Mean in each cell, NaN where too few points fall."""
    known = np.isfinite(values)
    count = np.histogram2d(across[known], upward[known], bins=edges)[0]
    total = np.histogram2d(across[known], upward[known], bins=edges, weights=values[known])[0]
    return np.where(count >= FEWEST, total / np.maximum(count, 1), np.nan)


def _centres(edges: FloatArray) -> FloatArray:
    return np.sqrt(edges[1:] * edges[:-1])


def _record(
    panel: Panel, edges: tuple[FloatArray, FloatArray], values: FloatArray, meaning: Quantity
) -> None:
    x, y = np.meshgrid(*map(_centres, edges), indexing="ij")
    panel.record(
        Series(panel.name, meaning.name, panel.x, panel.y, x.ravel(), y.ravel(), meaning, values.ravel())
    )


def _draw_borders(panel: Panel, edges: tuple[FloatArray, FloatArray], ratio: FloatArray) -> None:
    """Lines where the smallest separation is once and three times the roughness."""
    if not np.nanmin(ratio) < 1 < 3 < np.nanmax(ratio):
        return
    borders: dict[float, tuple[Any, str]] = {
        1.0: ("-", "smallest separation = roughness"),
        3.0: ("--", "three times the roughness"),
    }
    panel.axes.contour(
        *map(_centres, edges),
        np.ma.masked_invalid(ratio.T),
        levels=list(borders),
        colors=style.VERMILION,
        linewidths=1.2,
        linestyles=[look for look, _ in borders.values()],
    )
    panel.handles += [
        Line2D([], [], color=style.VERMILION, linestyle=look, label=label) for look, label in borders.values()
    ]
