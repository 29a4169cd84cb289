"""From the raw measurement to roughness: form and waviness taken off, edges tapered (figure 4-1)."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Generic, NamedTuple, TypeVar

import numpy as np
import scipy.fft
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from softlub.surfaces.measurement import Form
from softlub.surfaces.profile import Profile
from softlub.surfaces.surface_topography import as_surface_topography
from softlub.surfaces.topography import Topography

AnySurface = TypeVar("AnySurface", Topography, Profile)

DETREND_MODES = {"mean": "mean", "tilt": "rms-tilt", "curvature": "rms-curvature"}
"""SurfaceTopography's names of the forms."""


class Separated(NamedTuple, Generic[AnySurface]):
    """A surface in two parts that add up to it."""

    kept: AnySurface
    """What remains."""
    removed: AnySurface
    """What was taken off."""


def separate_form(surface: AnySurface, form: Form = "tilt") -> Separated[AnySurface]:
    """Take the form off in the sense of least squares.

    Parameters
    ----------
    surface : Topography or Profile
        The measurement.
    form : {"mean", "tilt", "curvature"}
        The mean height, the mean plane (line), or the second-order polynomial.

    Raises
    ------
    ValueError
        If the form is none of these.
    """
    if form not in DETREND_MODES:
        raise ValueError(f"form {form!r} is unknown; allowed: {', '.join(DETREND_MODES)}")
    flat = np.asarray(as_surface_topography(surface).detrend(DETREND_MODES[form]).heights(), dtype=np.float64)
    return _separated(surface, surface.heights - flat, periodic=surface.periodic and form == "mean")


def separate_waviness(surface: AnySurface, wavelength: float) -> Separated[AnySurface]:
    """Split roughness (kept) from waviness (removed) by the Gaussian filter of ISO 16610-21 and -61.

    A wave of the cut-off wavelength is halved, a longer one goes to the waviness. Towards the edges of a surface that
    is not periodic the filter averages over the points that are there: take the form off first.

    Parameters
    ----------
    surface : Topography or Profile
        The measurement without its form.
    wavelength : float
        Cut-off wavelength λ_c [m].

    Raises
    ------
    ValueError
        If the cut-off is not longer than two spacings.
    """
    if not 2 * surface.spacing < wavelength < math.inf:
        raise ValueError(
            f"waviness wavelength {wavelength:g} m must be finite and longer than two spacings, "
            f"{2 * surface.spacing:g} m"
        )
    smooth = _periodic_gaussian if surface.periodic else _bounded_gaussian
    return _separated(surface, smooth(surface.heights, wavelength / surface.spacing), surface.periodic)


def taper(surface: AnySurface, fraction: float = 0.2) -> AnySurface:
    """Let the heights fade to their mean at the edges, so that the surface may be continued periodically.

    Parameters
    ----------
    surface : Topography or Profile
        The measurement without its form.
    fraction : float
        Share of each side over which a cosine (Tukey's window) fades the heights, in (0, 1]; 1 is Hann's window.

    Returns
    -------
    Topography or Profile
        Periodic; its h_rms is smaller than the measurement's, since the middle keeps its heights.

    Raises
    ------
    ValueError
        If the fraction lies outside (0, 1].
    """
    if not 0 < fraction <= 1:
        raise ValueError(f"tapered fraction {fraction:g} must be above 0 and at most 1")
    heights = surface.heights - surface.heights.mean()
    for axis, count in enumerate(heights.shape):
        # Distance from the nearer edge over the width of the fade.
        inward = (np.minimum(np.arange(count), np.arange(count)[::-1]) + 0.5) / (count * fraction / 2)
        window = np.sin(np.pi / 2 * np.minimum(inward, 1.0)) ** 2
        heights *= window.reshape([-1 if other == axis else 1 for other in range(heights.ndim)])
    return replace(surface, heights=heights, periodic=True)


def _separated(surface: AnySurface, removed: NDArray[np.float64], periodic: bool) -> Separated[AnySurface]:
    return Separated(
        replace(surface, heights=surface.heights - removed, periodic=periodic),
        replace(surface, heights=removed, periodic=periodic),
    )


def _periodic_gaussian(heights: NDArray[np.float64], wavelength: float) -> NDArray[np.float64]:
    """Multiply each wave by 2^(−(λ_c/λ)²); lengths in spacings."""
    coefficients = scipy.fft.rfftn(heights)
    for axis, count in enumerate(heights.shape):
        last = axis == heights.ndim - 1
        frequency = np.fft.rfftfreq(count) if last else np.fft.fftfreq(count)
        transmission = np.exp2(-((wavelength * frequency) ** 2))
        coefficients *= transmission.reshape([-1 if other == axis else 1 for other in range(heights.ndim)])
    return scipy.fft.irfftn(coefficients, s=heights.shape)


def _bounded_gaussian(heights: NDArray[np.float64], wavelength: float) -> NDArray[np.float64]:
    """Average with Gaussian weights over the points within the edges; lengths in spacings."""
    # The Gaussian whose transform is 2^(−(λ_c/λ)²).
    width = wavelength * math.sqrt(2 * math.log(2)) / (2 * math.pi)
    smooth = heights
    for axis, count in enumerate(heights.shape):
        weight = gaussian_filter1d(np.ones(count), width, mode="constant", truncate=6.0)
        weight = weight.reshape([-1 if other == axis else 1 for other in range(heights.ndim)])
        smooth = gaussian_filter1d(smooth, width, axis=axis, mode="constant", truncate=6.0) / weight
    return smooth
