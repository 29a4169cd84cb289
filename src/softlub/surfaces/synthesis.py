"""Synthetic rough surfaces: sums of waves with the spectrum's amplitudes and random phases.

h(x) = Σ_q B(q) exp(i [q·x + φ(q)]) with B = (2π/L) √C(q) and φ(−q) = −φ(q), so that h is real (equation 4-7).
The waves fit the period: q = 2π (m/Lx, n/Ly). Their phases are drawn ring by ring, ring k being
max(|m|, |n|) = k, so that two grids of one size and seed hold the same waves however fine they are.
"""

from __future__ import annotations

import math

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthetic import Target, resolved_cutoff
from softlub.surfaces.topography import Topography

ROUNDING = 1e-9
# Waves that lie on a cut-off but for its last printed digit, the seventh in study files, count as lying on it.
PRINTED = 1e-6


def synthesize(
    spectrum: SelfAffine,
    size: float | tuple[float, float],
    points: int | tuple[int, int],
    seed: int,
    target: Target = "rms_roughness",
) -> Topography:
    """Make a periodic, isotropic, Gaussian, self-affine surface (equation 4-7, linear wavevectors).

    The sum over the waves that the grid carries meets the target exactly: Σ C = h_rms², or Σ q² C = h'_rms². Waves
    at q_L belong to the surface, waves at q_s and on the grid's Nyquist lines do not.

    Parameters
    ----------
    spectrum : SelfAffine
        The power spectrum C(q).
    size : float or (float, float)
        Period along x, or along x and y [m].
    points : int or (int, int)
        Number of points along both axes, or along x and y; the spacings along x and y must agree.
    seed : int
        Seed of the phases; the same seed gives the same surface on every machine.
    target : {"rms_roughness", "rms_slope"}
        Which of the spectrum's two moments the surface has exactly.

    Returns
    -------
    Topography
        Heights of shape (nx, ny) with zero mean [m].

    Raises
    ------
    ValueError
        If the spacings differ, a side has fewer than 2 points, the cut-off lies more than 0.1 % beyond Nyquist, or no
        wave of the grid lies within the spectrum.
    """
    sides, shape = _grid(size, points)
    coefficients = _phasors(shape, sides, seed, resolved_cutoff(spectrum, sides[0] / shape[0]))
    return _superpose(coefficients, spectrum, sides, shape, target)


def synthesize_exponential(
    spectrum: SelfAffine,
    size: float | tuple[float, float],
    points: int | tuple[int, int],
    seed: int,
    ratio: float = math.e,
    target: Target = "rms_roughness",
) -> Topography:
    """Make a surface from exponentially spaced wavevectors, to show what they do to the spectrum (figure 4-5).

    The components of q are 0 and ± the multiples of 2π/L nearest to q_L ratio^n, with the amplitudes B(q) of
    equation 4-7. Short waves are thinned out, so the surface has too much of the long ones: for comparison only.

    Parameters
    ----------
    spectrum, size, points, seed, target
        As in `synthesize`.
    ratio : float
        Ratio of neighbouring wavevector components, above 1.

    Returns
    -------
    Topography
        Heights of shape (nx, ny) with zero mean [m].

    Raises
    ------
    ValueError
        As `synthesize`, or if `ratio` is not above 1.
    """
    if not ratio > 1:
        raise ValueError(f"ratio {ratio:g} of neighbouring wavevectors must be above 1")
    sides, shape = _grid(size, points)
    coefficients = _phasors(shape, sides, seed, resolved_cutoff(spectrum, sides[0] / shape[0]))
    for axis in (0, 1):
        kept = _exponential_indices(spectrum.plateau_start * sides[axis] / (2 * math.pi), shape[axis], ratio)
        indices = np.arange(coefficients.shape[axis])
        indices = np.minimum(indices, shape[axis] - indices)
        dropped = ~np.isin(indices, kept)
        coefficients[dropped if axis == 0 else (slice(None), dropped)] = 0
    return _superpose(coefficients, spectrum, sides, shape, target)


def _grid(
    size: float | tuple[float, float], points: int | tuple[int, int]
) -> tuple[tuple[float, float], tuple[int, int]]:
    shape = points if isinstance(points, tuple) else (points, points)
    if min(shape) < 2:
        raise ValueError(f"points {points}: at least 2 points a side are needed")
    sides = size if isinstance(size, tuple) else (size, size * shape[1] / shape[0])
    if not all(0 < side < math.inf for side in sides):
        raise ValueError(f"size {size} m must be positive and finite")
    spacings = (sides[0] / shape[0], sides[1] / shape[1])
    if abs(spacings[0] / spacings[1] - 1) > ROUNDING:
        raise ValueError(
            f"spacings {spacings[0]:g} m along x and {spacings[1]:g} m along y differ: "
            f"size {size} m and points {points} must be in proportion"
        )
    return sides, shape


def _phasors(
    shape: tuple[int, int], sides: tuple[float, float], seed: int, cutoff: float
) -> NDArray[np.complex128]:
    """exp(iφ) of all waves below the cut-off, zero elsewhere, in the layout of a real transform, (nx, ny//2 + 1)."""
    largest = [
        min((count - 1) // 2, math.ceil(cutoff * side / (2 * math.pi)))
        for count, side in zip(shape, sides, strict=True)
    ]
    x_max, y_max = largest
    phasors = np.zeros((shape[0], shape[1] // 2 + 1), dtype=np.complex128)
    words = np.random.PCG64(seed)
    for ring in range(1, max(largest) + 1):
        wave = np.exp(1j * uniform_phases(words, 4 * ring))
        # One half of the ring's 8k waves: n = 1…k at m = k and at m = −k, m = −(k − 1)…k − 1 at n = k, and (k, 0).
        if ring <= x_max:
            width = min(ring, y_max)
            phasors[ring, 1 : width + 1] = wave[:width]
            phasors[-ring, 1 : width + 1] = wave[ring : ring + width]
            phasors[ring, 0] = wave[-1]
            phasors[-ring, 0] = np.conj(wave[-1])
        if ring <= y_max:
            row = wave[2 * ring : -1]
            reach = min(ring - 1, x_max)
            phasors[: reach + 1, ring] = row[ring - 1 : ring + reach]
            if reach:
                phasors[-reach:, ring] = row[ring - 1 - reach : ring - 1]
    return phasors


def uniform_phases(words: np.random.PCG64, count: int) -> NDArray[np.float64]:
    """The next `count` phases, uniform in [0, 2π)."""
    # Raw words, because numpy promises their stream on every machine and in every version.
    fractions = (words.random_raw(count) >> np.uint64(11)).astype(np.float64)
    return fractions * (2 * np.pi * 2.0**-53)


def _superpose(
    coefficients: NDArray[np.complex128],
    spectrum: SelfAffine,
    sides: tuple[float, float],
    shape: tuple[int, int],
    target: Target,
) -> Topography:
    """Give the phasors their amplitudes, normalise to the target and add the waves up; uses `coefficients` up."""
    spacing = sides[0] / shape[0]
    cutoff = resolved_cutoff(spectrum, spacing)
    along_x = 2 * np.pi * np.fft.fftfreq(shape[0], spacing)
    along_y = 2 * np.pi * np.fft.rfftfreq(shape[1], spacing)
    # Each wave with n > 0 stands for itself and its mirror; the column n = 0 holds both.
    weight = np.where(along_y > 0, 2.0, 1.0)
    moment = 0.0
    for row, wavevector in enumerate(along_x):
        magnitude = np.hypot(wavevector, along_y)
        held = (magnitude >= spectrum.plateau_start * (1 - PRINTED)) & (magnitude < cutoff * (1 - PRINTED))
        amplitude = np.zeros_like(magnitude)
        # Where the density is asked for, they do lie on it.
        within = np.clip(magnitude[held], spectrum.plateau_start, spectrum.cutoff)
        amplitude[held] = np.sqrt(spectrum.density(within))
        coefficients[row] *= amplitude
        power = weight * np.abs(coefficients[row]) ** 2
        moment += float(np.sum(power if target == "rms_roughness" else magnitude**2 * power))
    if moment == 0:
        raise ValueError(
            f"no wave of a {sides[0]:g} m × {sides[1]:g} m period with {shape[0]} × {shape[1]} points lies between "
            f"{spectrum.plateau_start:g} and {cutoff:g} 1/m: take a larger size or a wider spectrum"
        )
    wanted = spectrum.rms_roughness if target == "rms_roughness" else spectrum.rms_slope
    coefficients *= wanted / math.sqrt(moment)
    heights = scipy.fft.irfft2(coefficients, s=shape, norm="forward", overwrite_x=True)
    return Topography(heights, spacing)


def _exponential_indices(first: float, count: int, ratio: float) -> NDArray[np.int64]:
    """0 and the rounded first·ratio^n up to count/2."""
    first = max(first, 1.0)
    steps = max(0, math.floor(math.log(max(count / 2 / first, 1.0)) / math.log(ratio)))
    return np.append(0, np.rint(first * ratio ** np.arange(steps + 1))).astype(np.int64)
