"""Root mean square slopes by named estimators, and Nayak's parameter.

The slope of an area is the length of its gradient, h'_rms² = ⟨h_x² + h_y²⟩; that of a line is dz/dx (equation 4-3).
At a spacing of half the shortest wavelength the three estimators differ by up to 15 %.
"""

from __future__ import annotations

import numpy as np

from softlub.surfaces.modes import Surface, mode_powers, wavevectors


def spectral_rms_slope(surface: Surface) -> float:
    """h'_rms of the surface that the Fourier series through the points describes: √(Σ q² |h_q|²)."""
    return float(np.sqrt(np.sum(wavevectors(surface) ** 2 * mode_powers(surface))))


def forward_difference_rms_slope(surface: Surface) -> float:
    """h'_rms from neighbouring points, (h_(i+1) − h_i)/Δx; across the edge only where the surface is periodic."""
    return _difference_rms_slope(surface, 1)


def central_difference_rms_slope(surface: Surface) -> float:
    """h'_rms from next-nearest points, (h_(i+1) − h_(i−1))/(2Δx); across the edge only where it is periodic."""
    return _difference_rms_slope(surface, 2)


def _difference_rms_slope(surface: Surface, reach: int) -> float:
    heights = surface.heights
    if min(heights.shape) <= reach:
        raise ValueError(f"{heights.shape} points: more than {reach} along each axis are needed")
    total = 0.0
    for axis in range(heights.ndim):
        along = np.moveaxis(heights, axis, 0)
        inner = along[reach:] - along[:-reach]
        squares, count = float(np.vdot(inner, inner)), inner.size
        if surface.periodic:
            across = along[:reach] - along[-reach:]
            squares, count = squares + float(np.vdot(across, across)), count + across.size
        total += squares / count
    return float(np.sqrt(total) / (reach * surface.spacing))


def nayak_parameter(surface: Surface) -> float:
    """Nayak's bandwidth m0 m4 / m2² from the measured modes; 3/2 for an isotropic surface of one wavelength.

    The moments of a line follow from those of an isotropic area: m2 = ⟨q²⟩/2, m4 = 3⟨q⁴⟩/8.
    """
    powers = mode_powers(surface)
    square = wavevectors(surface) ** 2
    second = float(np.sum(square * powers))
    if second == 0:
        raise ValueError("all heights are equal: the surface has no roughness")
    bandwidth = float(np.sum(powers)) * float(np.sum(square**2 * powers)) / second**2
    return 1.5 * bandwidth if powers.ndim == 2 else bandwidth
