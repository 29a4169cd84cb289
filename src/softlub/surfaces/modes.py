"""Wavevectors and powers of the Fourier modes of a topography or a profile.

h(x) = Σ_q h_q exp(i q·x): Σ |h_q|² is the mean square height. Real transforms hold half the modes; each power here
is that of a mode together with its mirror image, so that plain sums are sums over all modes.
"""

from __future__ import annotations

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from softlub.surfaces.profile import Profile
from softlub.surfaces.topography import Topography

Surface = Topography | Profile


def mode_powers(surface: Surface) -> NDArray[np.float64]:
    """|h_q|² of each mode and its mirror image [m²], shape (nx, ny//2 + 1) or (n//2 + 1,); zero for the mean.

    Surfaces that are not periodic are weighted by a Hann window of unit mean square first, so that their jump from
    edge to edge does not count as roughness.
    """
    heights = surface.heights - surface.heights.mean()
    if not surface.periodic:
        for axis, count in enumerate(heights.shape):
            window = np.sin(np.pi * (np.arange(count) + 0.5) / count) ** 2
            window /= np.sqrt(np.mean(window**2))
            heights *= window.reshape([-1 if other == axis else 1 for other in range(heights.ndim)])
        heights -= heights.mean()
    coefficients = scipy.fft.rfftn(heights, norm="forward")
    powers = coefficients.real**2 + coefficients.imag**2
    powers *= mirror_weights(heights.shape[-1])
    powers.flat[0] = 0.0
    return powers


def mirror_weights(count: int) -> NDArray[np.float64]:
    """How many modes each column of a real transform of `count` points stands for, shape (count//2 + 1,)."""
    weights = np.full(count // 2 + 1, 2.0)
    weights[0] = 1.0
    if count % 2 == 0:
        weights[-1] = 1.0
    return weights


def wavevectors(surface: Surface) -> NDArray[np.float64]:
    """|q| of each mode [1/m], in the layout of `mode_powers`."""
    shape = surface.heights.shape
    along: NDArray[np.float64] = np.asarray(2 * np.pi * np.fft.rfftfreq(shape[-1], surface.spacing))
    if len(shape) == 1:
        return along
    return np.hypot(2 * np.pi * np.fft.fftfreq(shape[0], surface.spacing)[:, None], along)
