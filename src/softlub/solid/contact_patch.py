"""Half-width and peak pressure of a contact found on nodes, and whether the nodes suffice for it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

FEWEST_NODES = 5
"""Nodes in contact below which a parabola says nothing."""
NEGLIGIBLE = 1e-3
"""Part of the largest nodal force that an outermost node may carry."""


class ContactPatch(NamedTuple):
    """A line contact as Hertz describes it.

    Attributes
    ----------
    half_width : float
        a [m].
    peak_pressure : float
        p0 [Pa].
    middle : float
        Where the pressure is highest [m].
    """

    half_width: float
    peak_pressure: float
    middle: float


def hertz_patch(positions: FloatArray, pressure: FloatArray) -> ContactPatch:
    """Parabola through the square of the pressure, p² = p0² (1 - (x - m)²/a²).

    Counting the nodes in contact quantises the half-width by their spacing; the fit does not.

    Parameters
    ----------
    positions : ndarray, shape (k,)
        Of the nodes along the plate [m].
    pressure : ndarray, shape (k,)
        Contact pressure, zero out of contact [Pa].

    Returns
    -------
    ContactPatch
        NaN where fewer than five nodes are in contact or the pressure is not highest between them.
    """
    inside = pressure > 0
    if np.count_nonzero(inside) < FEWEST_NODES:
        return ContactPatch(np.nan, np.nan, np.nan)
    length, highest = float(np.ptp(positions[inside])), float(pressure.max())
    middle = float(positions[inside].mean())
    curvature, slope, top = np.polyfit(
        (positions[inside] - middle) / length, (pressure[inside] / highest) ** 2, 2
    )
    if curvature >= 0:
        return ContactPatch(np.nan, np.nan, np.nan)
    summit = top - slope**2 / (4 * curvature)
    return ContactPatch(
        length * float(np.sqrt(-summit / curvature)),
        highest * float(np.sqrt(summit)),
        middle - length * float(slope / (2 * curvature)),
    )


def reaches_end(normal: FloatArray) -> bool:
    """Whether the contact goes beyond the nodes, so that more of the body would touch.

    Parameters
    ----------
    normal : ndarray, shape (k,)
        Nodal forces along the edge [N/m]; NaN where they are not known.

    Returns
    -------
    bool
        True where an outermost node carries more than a thousandth of the largest nodal force.
    """
    return bool(normal[[0, -1]].max() > NEGLIGIBLE * normal.max())
