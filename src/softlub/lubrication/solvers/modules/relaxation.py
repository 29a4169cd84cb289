"""Relaxation factors over speed: a stand-in for the ones that the source does not print.

The source gives ranges (table 3-2) and says that the factors grow with speed and that α_f < α_u < α_s in the
boundary-mixed module. The factors below keep to those ranges. Schedules are listed over the speed number
λ = 6ηvR²/(a³p0), 9.87 times the speed in m/s for the system of table 3-1, and interpolated linearly in ln λ.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np


class BoundaryFactors(NamedTuple):
    """Factors of the boundary-mixed module."""

    fluid: float
    """α_f."""
    gap: float
    """α_u."""
    solid: float
    """α_s."""


class MixedFactors(NamedTuple):
    """Factors of the mixed module."""

    fluid: float
    """α_f."""
    approach: float
    """α_c, on the load's deficit in units of p0 a, giving an approach in units of a²/R."""
    fredholm: float
    """α_fs."""


class FilmFactors(NamedTuple):
    """Factors of the full-film module."""

    fluid: float
    """α_l."""
    approach: float
    """α_c of the first correction; later ones take the slope of the last two rounds."""


BOUNDARY_SCHEDULE = {
    1e-4: BoundaryFactors(fluid=0.02, gap=0.05, solid=0.5),
    1e-3: BoundaryFactors(fluid=0.05, gap=0.07, solid=0.7),
    1e-2: BoundaryFactors(fluid=0.07, gap=0.1, solid=1.0),
}
"""λ -> factors; constant outside."""

MIXED_FACTORS = {
    "gauss_seidel": MixedFactors(fluid=1.0, approach=0.6, fredholm=0.5),
    "newton_raphson": MixedFactors(fluid=0.3, approach=0.6, fredholm=0.5),
}
"""Reynolds sweep -> factors, the same at every speed: a Gauss–Seidel pass changes long waves little by itself."""

FILM_SCHEDULE = {
    3e-2: FilmFactors(fluid=0.1, approach=0.1),
    1e0: FilmFactors(fluid=0.7, approach=0.1),
}
"""λ -> factors; constant outside. The source uses 0.6 to 0.8 in the full film, where λ > 1; thinner films need less."""


def boundary_factors(speed_number: float) -> BoundaryFactors:
    """Factors of the boundary-mixed module at λ."""
    return BoundaryFactors(*_interpolate(BOUNDARY_SCHEDULE, speed_number))


def film_factors(speed_number: float) -> FilmFactors:
    """Factors of the full-film module at λ."""
    return FilmFactors(*_interpolate(FILM_SCHEDULE, speed_number))


def _interpolate(schedule: Mapping[float, tuple[float, ...]], speed_number: float) -> list[float]:
    places = np.log(list(schedule))
    columns = np.array(list(schedule.values())).T
    return [float(np.interp(np.log(speed_number), places, column)) for column in columns]
