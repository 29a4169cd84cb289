"""Statistics of heights: amplitudes, shape of the distribution, and all of them at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from softlub.surfaces.modes import Surface
from softlub.surfaces.slopes import (
    central_difference_rms_slope,
    forward_difference_rms_slope,
    nayak_parameter,
    spectral_rms_slope,
)


@dataclass(frozen=True)
class RoughnessStatistics:
    """What characterises the heights of a surface or a line, about their mean.

    Attributes
    ----------
    average_roughness : float
        h_a [m] (equation 4-1).
    rms_roughness : float
        h_rms [m] (equation 4-2).
    skewness, kurtosis : float
        Third and fourth moments over powers of h_rms; 0 and 3 for Gaussian heights.
    rms_slope_spectral, rms_slope_forward, rms_slope_central : float
        h'_rms by the three estimators of `softlub.surfaces.slopes` (equation 4-3).
    nayak_parameter : float
        Nayak's bandwidth parameter.
    """

    average_roughness: float
    rms_roughness: float
    skewness: float
    kurtosis: float
    rms_slope_spectral: float
    rms_slope_forward: float
    rms_slope_central: float
    nayak_parameter: float


class HeightDistribution(NamedTuple):
    """Probability density of the heights."""

    height: NDArray[np.float64]
    """Middles of the bins, about the mean height [m], shape (bins,)."""
    density: NDArray[np.float64]
    """Probability density [1/m], shape (bins,); its integral is 1."""


def average_roughness(surface: Surface) -> float:
    """h_a, the mean distance from the mean height [m] (equation 4-1)."""
    return float(np.mean(np.abs(surface.heights - surface.heights.mean())))


def rms_roughness(surface: Surface) -> float:
    """h_rms about the mean height [m] (equation 4-2)."""
    return float(np.std(surface.heights))


def skewness(surface: Surface) -> float:
    """⟨z³⟩/h_rms³ about the mean; 0 for Gaussian heights."""
    return _standardised_moment(surface, 3)


def kurtosis(surface: Surface) -> float:
    """⟨z⁴⟩/h_rms⁴ about the mean; 3 for Gaussian heights."""
    return _standardised_moment(surface, 4)


def height_distribution(surface: Surface, bins: int = 101) -> HeightDistribution:
    """Histogram of the heights about their mean as a probability density (figures 4-2 and 4-13).

    Parameters
    ----------
    surface : Topography or Profile
        The heights.
    bins : int
        Number of equal bins from the lowest to the highest point.
    """
    density, edges = np.histogram(surface.heights - surface.heights.mean(), bins=bins, density=True)
    return HeightDistribution((edges[1:] + edges[:-1]) / 2, density)


def describe(surface: Surface) -> RoughnessStatistics:
    """All statistics of a surface or a line.

    Raises
    ------
    ValueError
        If all heights are equal.
    """
    return RoughnessStatistics(
        average_roughness=average_roughness(surface),
        rms_roughness=rms_roughness(surface),
        skewness=skewness(surface),
        kurtosis=kurtosis(surface),
        rms_slope_spectral=spectral_rms_slope(surface),
        rms_slope_forward=forward_difference_rms_slope(surface),
        rms_slope_central=central_difference_rms_slope(surface),
        nayak_parameter=nayak_parameter(surface),
    )


def _standardised_moment(surface: Surface, order: int) -> float:
    scale = rms_roughness(surface)
    if scale == 0:
        raise ValueError("all heights are equal: the surface has no roughness")
    scaled = (surface.heights - surface.heights.mean()) / scale
    square = scaled**2
    return float(np.mean(square * (scaled if order == 3 else square)))
