"""The short-wave half of the preconditioner: a stencil of 5 by 5 points in the place of the stiffness |θ|.

The stiffness of the half-space, |θ| in wave space, decays like the cube of the distance in real space. What it
does within two points of distance is all that a preconditioner of the contact's short waves needs, and costs no
transform. Long waves, which the stencil makes too stiff, are the business of `coarse`.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver.kernels import phases

OFFSETS = ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2))
"""Distances of the six coefficients; each stands for all its mirror images."""

LEAST_PHASE = 0.15
"""Phase below which the error is no longer weighed relative to |θ|: the coarse correction takes over there."""


@cache
def stencil_taps() -> NDArray[np.float64]:
    """Coefficients at `OFFSETS`, by least squares of the relative error over all phases.

    Returns
    -------
    ndarray, shape (6,)
    """
    phase = phases(128)
    stiffness = np.hypot(phase[:, None], phase[None, :])
    columns = [_waves(phase, *offset) for offset in OFFSETS]
    scale = np.maximum(stiffness, LEAST_PHASE)
    system = np.stack([(column / scale).ravel() for column in columns], axis=1)
    taps = np.linalg.lstsq(system, (stiffness / scale).ravel(), rcond=None)[0]
    taps.flags.writeable = False
    return np.asarray(taps)


def _waves(phase: NDArray[np.float64], far: int, near: int) -> NDArray[np.float64]:
    """Symbol of a unit coefficient at (far, near) and all its mirror images."""
    images = {(sx * a, sy * b) for a, b in ((far, near), (near, far)) for sx in (1, -1) for sy in (1, -1)}
    return np.asarray(sum(np.cos(a * phase[:, None] + b * phase[None, :]) for a, b in images))
