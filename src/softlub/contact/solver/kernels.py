"""Influence of pressure on the surface displacement of an elastic half-space, dimensionless.

Throughout `softlub.contact.solver` lengths in the plane are counted in grid spacings Δx, heights and gaps in
h_rms, and pressures in E* h_rms / (2 Δx). In these units the half-space's compliance 2 / (E* |q|) is 1 / |θ|,
with θ = q Δx the phase per grid spacing (|θ_x|, |θ_y| <= π).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def phases(points: int) -> FloatArray:
    """Phase per grid spacing of every wave along an axis of `points` points, shape (points,)."""
    return np.asarray(2 * np.pi * np.fft.fftfreq(points), dtype=np.float64)


def half_phases(points: int) -> FloatArray:
    """The same for the last axis of a real transform, shape (points // 2 + 1,)."""
    return np.asarray(2 * np.pi * np.fft.rfftfreq(points), dtype=np.float64)


def love_rectangle(x: FloatArray, y: FloatArray) -> FloatArray:
    """Displacement at distance (x, y) from the centre of a unit square under unit pressure.

    The source's equation 4-26 with its leading factors signed (they are not absolute values), times the
    1 / (2π) that its equation 4-25 leaves in these units:
    u = (1/2π) ∫∫ dξ dη / √((x-ξ)² + (y-η)²) over the square (Love 1929).

    Parameters
    ----------
    x, y : ndarray
        Distances in grid spacings, broadcast against each other.

    Returns
    -------
    ndarray
    """
    east, west, north, south = x + 0.5, x - 0.5, y + 0.5, y - 0.5
    total = (
        east * np.log(_reach(north, east) / _reach(south, east))
        + west * np.log(_reach(south, west) / _reach(north, west))
        + north * np.log(_reach(east, north) / _reach(west, north))
        + south * np.log(_reach(west, south) / _reach(east, south))
    )
    return np.asarray(total / (2 * np.pi))


def _reach(along: FloatArray, across: FloatArray) -> FloatArray:
    """a + √(a² + b²), without the cancellation for a < 0."""
    length = np.hypot(along, across)
    return np.where(along >= 0, length + along, across**2 / (length + np.abs(along)))


def love_spectrum(shape: tuple[int, int]) -> FloatArray:
    """Transfer function of the free half-space on a grid padded to twice its size (DC-FFT).

    Parameters
    ----------
    shape : tuple of int
        Shape (nx, ny) of the grid that carries pressure.

    Returns
    -------
    ndarray, shape (2 nx, ny + 1)
        Real: the wrapped-around coefficients are even along both axes (source equations 4-27 to 4-29, with the
        index (k - n) mod N).
    """
    distances = [np.minimum(np.arange(2 * points), 2 * points - np.arange(2 * points)) for points in shape]
    x, y = (along.astype(float) for along in distances)
    return np.ascontiguousarray(np.fft.rfft2(love_rectangle(x[:, None], y[None, :])).real)
