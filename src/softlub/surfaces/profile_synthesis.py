"""Synthetic lines: cuts through self-affine surfaces, as the stand-in of figure 4-1."""

from __future__ import annotations

import numpy as np
import scipy.fft

from softlub.surfaces.line_spectrum import line_density
from softlub.surfaces.profile import Profile
from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthesis import uniform_phases
from softlub.surfaces.synthetic import resolved_cutoff


def synthesize_profile(spectrum: SelfAffine, length: float, points: int, seed: int) -> Profile:
    """Make a periodic Gaussian line with the spectrum C1D+(q) of a cut through the surface.

    Amplitudes are √(2 C1D+(q) Δq); the sum over the line's waves meets h_rms exactly. Phases are drawn from the
    longest wave on, so that every grid holds the same waves.

    Parameters
    ----------
    spectrum : SelfAffine
        The surface's power spectrum C(q).
    length : float
        Period [m].
    points : int
        Number of points.
    seed : int
        Seed of the phases.

    Returns
    -------
    Profile
        Heights of shape (points,) with zero mean [m].

    Raises
    ------
    ValueError
        If there are fewer than 3 points, or the cut-off lies more than 0.1 % beyond Nyquist.
    """
    if points < 3:
        raise ValueError(f"points {points}: at least 3 points on a line are needed for a wave")
    if not 0 < length < np.inf:
        raise ValueError(f"length {length:g} m must be positive and finite")
    spacing = length / points
    cutoff = resolved_cutoff(spectrum, spacing)
    wavevector = 2 * np.pi / length * np.arange(1, (points - 1) // 2 + 1)
    amplitude = np.sqrt(line_density(spectrum, wavevector))
    amplitude[wavevector >= cutoff] = 0.0
    square_sum = float(np.sum(amplitude**2))
    if square_sum == 0:
        raise ValueError(
            f"no wave of a {length:g} m period with {points} points lies below {cutoff:g} 1/m: take a longer line"
        )
    coefficients = np.zeros(points // 2 + 1, dtype=np.complex128)
    phases = uniform_phases(np.random.PCG64(seed), wavevector.size)
    coefficients[1 : wavevector.size + 1] = (
        amplitude * np.exp(1j * phases) * spectrum.rms_roughness / np.sqrt(2 * square_sum)
    )
    return Profile(scipy.fft.irfft(coefficients, n=points, norm="forward"), spacing, periodic=True)
