"""A topography and a modulus as the dimensionless problem that the solver works on, and back.

Heights are counted in h_rms and pressures in E* h_rms / (2 Δx), see `softlub.contact.solver.kernels`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softlub.contact.memory import refuse_what_will_not_fit
from softlub.surfaces.topography import Topography

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Scales:
    """Units of a rough contact.

    Parameters
    ----------
    height : float
        h_rms of the points [m].
    pressure : float
        E* h_rms / (2 Δx) [Pa].
    """

    height: float
    pressure: float


def scales(topography: Topography, modulus: float) -> Scales:
    """Units of a contact, after checking that it can be solved.

    Parameters
    ----------
    topography : Topography
    modulus : float
        E* = E / (1 - ν²) of the elastic body [Pa].

    Raises
    ------
    ValueError
        If the modulus is not positive and finite, or the surface is constant.
    MemoryError
        If the grid will not fit.
    """
    if not 0 < modulus < np.inf:
        raise ValueError(f"modulus {modulus:g} Pa must be above 0 and finite")
    heights = topography.heights
    shape = (heights.shape[0], heights.shape[1])
    refuse_what_will_not_fit(shape, topography.periodic)
    height = float(heights.std())
    if height <= 1e-13 * float(np.abs(heights).max()):
        raise ValueError(
            f"the surface is constant ({float(heights.flat[0]):g} m at every point): "
            "a plane touches everywhere at once, there is no rough contact to solve"
        )
    return Scales(height, modulus * height / (2 * topography.spacing))


def scaled_heights(topography: Topography, height: float) -> FloatArray:
    """Heights over h_rms, of mean zero, shape (nx, ny)."""
    return np.asarray((topography.heights - topography.heights.mean()) / height)


def check_pressure(pressure: float) -> None:
    """Raise ValueError where a nominal pressure is negative or not finite."""
    if not 0 <= pressure < np.inf:
        raise ValueError(f"pressure {pressure:g} Pa must be at least 0 and finite: contact does not pull")


def check_tolerance(tolerance: float) -> None:
    """Raise ValueError where a tolerance cannot be reached in double precision, or means nothing."""
    if not 1e-13 <= tolerance < 1:
        raise ValueError(f"tolerance {tolerance:g} must lie between 1e-13 and 1 (of h_rms)")
