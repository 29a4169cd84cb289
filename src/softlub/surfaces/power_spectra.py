"""Power spectra of topographies and profiles: over the plane, averaged over directions, and of lines.

The conventions of the source: h_rms² = ∫ C(q) d²q = 2π ∫ C(q) q dq (equation 4-4), and h_rms² = ∫ C1D+(q) dq over
positive q. SurfaceTopography's spectra are (2π)² and π times these. Surfaces that are not periodic are windowed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from softlub.surfaces.modes import Surface, mirror_weights, mode_powers, wavevectors
from softlub.surfaces.profile import Profile
from softlub.surfaces.topography import Topography


class PowerSpectrum(NamedTuple):
    """A power spectrum over one wavevector."""

    wavevector: NDArray[np.float64]
    """Mean |q| of the modes of each bin [1/m], ascending, shape (n,)."""
    density: NDArray[np.float64]
    """C(q) [m⁴] of areas averaged over directions, C1D+(q) [m³] of lines, shape (n,)."""
    modes: NDArray[np.int64]
    """Number of modes averaged over, shape (n,)."""


class PowerSpectrumMap(NamedTuple):
    """A power spectrum over the plane of wavevectors, the origin in the middle."""

    wavevector_x: NDArray[np.float64]
    """q_x [1/m], ascending, shape (nx,)."""
    wavevector_y: NDArray[np.float64]
    """q_y [1/m], ascending, shape (ny,)."""
    density: NDArray[np.float64]
    """C(q) [m⁴], shape (nx, ny)."""


def power_spectrum_map(topography: Topography) -> PowerSpectrumMap:
    """C(q) of a topography over both components of q (equation 4-4)."""
    nx, ny = topography.heights.shape
    half = mode_powers(topography) / mirror_weights(ny)
    rows = -np.arange(nx) % nx
    mirrored = half[rows][:, (ny - 1) // 2 : 0 : -1]
    full = np.concatenate([half, mirrored], axis=1) * _per_mode(topography)
    along_x, along_y = (2 * np.pi * np.fft.fftfreq(count, topography.spacing) for count in (nx, ny))
    return PowerSpectrumMap(
        scipy.fft.fftshift(along_x), scipy.fft.fftshift(along_y), scipy.fft.fftshift(full)
    )


def radial_power_spectrum(topography: Topography, bins_per_decade: int | None = None) -> PowerSpectrum:
    """C(q) of a topography averaged over directions (figures 4-4, 4-5, 4-13).

    Parameters
    ----------
    topography : Topography
        The surface.
    bins_per_decade : int, optional
        Bins of equal width on a logarithmic scale; without it rings of the width of the lowest wavevector. Bins
        without a mode are left out.

    Returns
    -------
    PowerSpectrum
        Up to the Nyquist wavevector along the axes: the corners beyond it hold part of the directions only.
    """
    magnitude = wavevectors(topography)
    lowest = 2 * np.pi / max(topography.size)
    nyquist = np.pi / topography.spacing
    if bins_per_decade is None:
        edges = lowest * (np.arange(1, int(nyquist / lowest + 1e-9) + 2) - 0.5)
    else:
        count = max(1, int(np.ceil(np.log10(nyquist / lowest) * bins_per_decade)))
        edges = np.geomspace(lowest * (1 - 1e-9), nyquist * (1 + 1e-9), count + 1)
    weights = np.broadcast_to(mirror_weights(topography.heights.shape[1]), magnitude.shape)
    inside = magnitude <= nyquist * (1 + 1e-9)
    inside.flat[0] = False
    bins = np.searchsorted(edges, magnitude[inside], side="right")

    def total(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.bincount(bins, values[inside], minlength=edges.size + 1)[1:-1].astype(np.float64)

    modes = total(weights)
    kept = modes > 0
    density = total(mode_powers(topography))[kept] / modes[kept] * _per_mode(topography)
    return PowerSpectrum(
        total(magnitude * weights)[kept] / modes[kept], density, modes[kept].astype(np.int64)
    )


def profile_power_spectrum(surface: Surface) -> PowerSpectrum:
    """C1D+(q) of a line, or the mean over all lines of an area along x (figure 4-4).

    Returns
    -------
    PowerSpectrum
        At every q = 2πk/L, k >= 1, up to Nyquist; `modes` counts the lines.
    """
    lines = np.atleast_2d(surface.heights.T)
    powers = np.mean(
        [mode_powers(Profile(line, surface.spacing, surface.periodic)) for line in lines], axis=0
    )
    count = lines.shape[1]
    step = 2 * np.pi / (count * surface.spacing)
    wavevector = step * np.arange(1, count // 2 + 1)
    return PowerSpectrum(wavevector, powers[1:] / step, np.full(wavevector.size, len(lines)))


def _per_mode(topography: Topography) -> float:
    """Density over power of one mode: the inverse area of its cell in the plane of wavevectors [m²]."""
    return topography.size[0] * topography.size[1] / (2 * np.pi) ** 2
