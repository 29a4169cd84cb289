"""Meshes in a panel: their cells as lines or as colours, whole or cut out around the contact."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from numpy.typing import NDArray

from softlub.figures import style
from softlub.figures.panel import Panel, Series
from softlub.figures.quantities import FloatArray, Quantity, quantity

THICKEST = 0.35
"""Width of a line [point]."""
LINE_SHARE = 0.12
"""Width of a line over the shorter side of its cell as printed, so that fine regions do not turn black."""
MOST_VECTORS = 20000
"""Cells above which they are stored as pixels."""
MARGIN = 0.04
"""Blank around a body, as part of its extent."""


@dataclass(frozen=True, eq=False)
class View:
    """Part of the plane that a panel shows.

    Parameters
    ----------
    left, right, low, high : float
        [m]
    """

    left: float
    right: float
    low: float
    high: float


def corners_of(dataset: xr.Dataset, deformed: float = 0.0) -> FloatArray:
    """Places of the corners of all cells.

    Parameters
    ----------
    dataset : xarray.Dataset
        As `softlub.solid.mesh_dataset.mesh_dataset` makes it.
    deformed : float
        Factor of the displacement; 0 for the mesh at rest.

    Returns
    -------
    ndarray, shape (m, 4, 2)
        [m]
    """
    points = dataset["mesh_point"].values + deformed * dataset["mesh_displacement"].values
    return np.asarray(points[dataset["mesh_cell"].values])


def whole(corners: FloatArray) -> View:
    """All of a body, with a margin."""
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    blank = MARGIN * float((high - low).max())
    return View(low[0] - blank, high[0] + blank, low[1] - blank, high[1] + blank)


def around(x: float, y: float, width: float, like: View) -> View:
    """Cut-out above a point, of a width and as wide over high as another view, so that panels match."""
    height = width * (like.high - like.low) / (like.right - like.left)
    return View(x - width / 2, x + width / 2, y - MARGIN * height, y + (1 - MARGIN) * height)


def mesh_panel(axes: Axes, name: str, view: View) -> Panel:
    """An empty panel with equal scales on both axes."""
    size = np.array([view.right - view.left, view.high - view.low])
    panel = Panel(
        axes,
        quantity("x", size, label="position x"),
        quantity("y", size, label="height y", unit="m"),
        name,
    )
    axes.set_xlim(*panel.x.shown([view.left, view.right]))
    axes.set_ylim(*panel.y.shown([view.low, view.high]))
    axes.set_aspect("equal")
    return panel


def lines(panel: Panel, corners: FloatArray, view: View, width: float) -> None:
    """Draw the sides of the cells, each as thin as the finest cell beside it asks for.

    Parameters
    ----------
    panel : Panel
    corners : ndarray, shape (m, 4, 2)
        [m]
    view : View
    width : float
        Of the panel as printed [inch].
    """
    inside = corners[seen(corners, view)]
    ends = np.stack([inside, np.roll(inside, -1, axis=1)], axis=2)
    lengths = np.hypot(*np.moveaxis(ends[:, :, 1] - ends[:, :, 0], -1, 0))
    short = np.repeat(lengths.min(axis=1), 4) * 72 * width / (view.right - view.left)
    panel.axes.add_collection(
        LineCollection(
            list(_shown(panel, ends.reshape(-1, 2, 2))),
            linewidths=np.minimum(THICKEST, LINE_SHARE * short),
            colors=style.SLATE,
            rasterized=len(inside) > MOST_VECTORS,
        ),
        autolim=False,
    )


def seen(corners: FloatArray, view: View) -> NDArray[np.bool_]:
    """Cells that reach into a view, shape (m,)."""
    low, high = corners.min(axis=1), corners.max(axis=1)
    beside = (high[:, 0] < view.left) | (low[:, 0] > view.right)
    return np.asarray(~(beside | (high[:, 1] < view.low) | (low[:, 1] > view.high)))


def colours(
    panel: Panel, corners: FloatArray, view: View, values: FloatArray, meaning: Quantity, largest: float
) -> PolyCollection:
    """Fill the cells with the colour of a value each, and record them.

    Parameters
    ----------
    panel : Panel
    corners : ndarray, shape (m, 4, 2)
        [m]
    view : View
    values : ndarray, shape (m,)
        In SI.
    meaning : Quantity
        Of the values.
    largest : float
        Value of the last colour, which larger ones get too [SI].

    Returns
    -------
    matplotlib.collections.PolyCollection
        For a scale.
    """
    inside = seen(corners, view)
    # As pixels and with hard borders: cells smaller than a pixel would let the page shine through between them.
    filled = PolyCollection(
        list(_shown(panel, corners[inside])),
        array=meaning.shown(values[inside]),
        cmap="viridis",
        edgecolors="none",
        antialiased=False,
        rasterized=True,
    )
    filled.set_clim(min(0.0, float(meaning.shown(values.min()))), float(meaning.shown(largest)))
    panel.axes.add_collection(filled, autolim=False)
    middle = corners[inside].mean(axis=1)
    panel.record(
        Series(panel.name, "cells", panel.x, panel.y, middle[:, 0], middle[:, 1], meaning, values[inside])
    )
    return filled


def _shown(panel: Panel, places: FloatArray) -> FloatArray:
    return np.stack([panel.x.shown(places[..., 0]), panel.y.shown(places[..., 1])], axis=-1)
