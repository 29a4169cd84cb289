"""Maps of a quantity over the plane of a surface."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from softlub.figures.panel import DataFigure, Panel, Series
from softlub.figures.quantities import FloatArray, Quantity, quantity

FINEST = 512
"""Points a side that are drawn and recorded at most: more than a page shows."""


def draw_map(
    figure: DataFigure,
    axes: Axes,
    name: str,
    x: FloatArray,
    y: FloatArray,
    values: FloatArray,
    meaning: Quantity,
    colours: str = "viridis",
) -> Panel:
    """Draw and record a map with its scale.

    Parameters
    ----------
    figure : DataFigure
    axes : matplotlib.axes.Axes
    name : str
        Of the panel.
    x, y : ndarray, shape (nx,), (ny,)
        [m]
    values : ndarray, shape (nx, ny)
        In SI.
    meaning : Quantity
        Of the values.
    colours : str
        Name of the colour map.

    Returns
    -------
    Panel
    """
    step = max(1, int(np.ceil(max(values.shape) / FINEST)))
    x, y, values = x[::step], y[::step], values[::step, ::step]
    along = quantity("x", x, label="x")
    across = quantity("y", y, label="y", unit="m")
    panel = Panel(axes, along, across, name)
    image = axes.imshow(
        meaning.shown(values.T),
        origin="lower",
        extent=(*along.shown(_ends(x)), *across.shown(_ends(y))),
        cmap=colours,
        interpolation="nearest",
    )
    figure.colorbar(image, ax=axes, label=meaning.axis_label, shrink=0.85)
    grid = np.meshgrid(x, y, indexing="ij")
    panel.record(
        Series(name, meaning.name, along, across, grid[0].ravel(), grid[1].ravel(), meaning, values.ravel())
    )
    return panel


def _ends(points: FloatArray) -> FloatArray:
    half = (points[1] - points[0]) / 2
    return np.array([points[0] - half, points[-1] + half])
