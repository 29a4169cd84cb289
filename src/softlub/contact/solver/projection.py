"""Projection of a pressure onto those that press only and carry the load."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver import steps

STEPS = 60
"""Newton steps at most; each at least halves the distance to the shift where the load is far off."""


def project_onto_load(values: NDArray[Any], load: float, out: NDArray[Any]) -> None:
    """Fill `out` with max(0, values + shift), the shift such that it sums to the load.

    The sum is convex and increasing in the shift, so that Newton's method comes down from above without fail.

    Parameters
    ----------
    values : ndarray, shape (nx, ny)
    load : float
        Sum to reach, above 0.
    out : ndarray, shape (nx, ny)
    """
    number = values.dtype.type
    shift = load / values.size - float(values.mean(dtype=float))
    for _ in range(STEPS):
        total, count = steps.clipped(values, number(shift), out)
        excess = total - load
        if excess <= 1e-6 * load or count == 0:
            break
        shift -= excess / count
    if total > 0:
        out *= number(load / total)
    else:  # a load too light for the precision of the values: it rests on the highest point
        out.flat[np.argmax(values)] = load
