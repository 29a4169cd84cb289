"""Autocorrelation of heights, the Fourier transform of the power spectrum (equation 4-4, figure 4-4)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from softlub.surfaces.modes import Surface


class Autocorrelation(NamedTuple):
    """⟨z(x) z(x + r)⟩ averaged over directions."""

    distance: NDArray[np.float64]
    """Mean r of each bin [m], from 0, ascending, shape (n,)."""
    covariance: NDArray[np.float64]
    """⟨z(x) z(x + r)⟩ about the mean height [m²]; h_rms² at r = 0, shape (n,)."""


def autocorrelation(surface: Surface) -> Autocorrelation:
    """Autocorrelation of a topography (averaged over directions) or a profile, up to half the shorter side.

    Where the surface is not periodic, each distance averages over the pairs of points that lie on it.
    """
    heights = surface.heights - surface.heights.mean()
    shape = heights.shape
    padded = shape if surface.periodic else tuple(scipy.fft.next_fast_len(2 * n, real=True) for n in shape)
    coefficients = scipy.fft.rfftn(heights, s=padded)
    powers = coefficients.real**2 + coefficients.imag**2
    products = scipy.fft.irfftn(powers, s=padded)
    reach = min(shape) // 2
    square = np.zeros(())
    pairs = np.ones(())
    for axis, (count, length) in enumerate(zip(shape, padded, strict=True)):
        # Lags of one half of the plane suffice, since the covariance at −r is that at r.
        lags = np.arange(reach + 1) if axis == len(shape) - 1 else np.arange(-reach, reach + 1)
        products = np.take(products, lags % length, axis=axis)
        square = np.add.outer(square, (lags * surface.spacing) ** 2)
        pairs = np.multiply.outer(
            pairs, np.full(lags.size, count) if surface.periodic else count - np.abs(lags)
        )
    distance = np.sqrt(square).ravel()
    bins = np.rint(distance / surface.spacing).astype(np.int64)
    kept = bins <= reach
    counts = np.bincount(bins[kept])
    return Autocorrelation(
        np.bincount(bins[kept], distance[kept]) / counts,
        np.bincount(bins[kept], (products / pairs).ravel()[kept]) / counts,
    )
