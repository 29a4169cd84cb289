"""Linear viscoelasticity of a generalised Maxwell model: closed forms (figure 5-11, equation 5-10).

R. M. Christensen, Theory of Viscoelasticity (1982), chapter 1. Moduli are relative to the long-term one:
G(t)/G∞ = 1 + Σ r_i exp(-t/τ_i).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def ramp_and_hold(
    time: FloatArray, ramp: float, relaxation_times: FloatArray, terms: FloatArray
) -> FloatArray:
    """Stress while the long-term stress goes linearly from 0 to 1 and stays there.

    During the ramp t/T + Σ r_i (τ_i/T) (1 - exp(-t/τ_i)), after it 1 + Σ r_i (τ_i/T) (1 - exp(-T/τ_i))
    exp(-(t - T)/τ_i).

    Parameters
    ----------
    time : ndarray, shape (n,)
        t from the start of the ramp [s], not negative.
    ramp : float
        Duration T of the ramp [s].
    relaxation_times, terms : ndarray, shape (terms,)
        τ_i [s] and r_i.

    Returns
    -------
    ndarray, shape (n,)
        Over the long-term stress of the held strain.
    """
    rising = np.minimum(time, ramp)[:, None]
    held = np.maximum(time - ramp, 0)[:, None]
    branches = -np.expm1(-rising / relaxation_times) * np.exp(-held / relaxation_times)
    return rising[:, 0] / ramp + branches @ (terms * relaxation_times) / ramp


def maxwell_moduli(
    angular_frequency: FloatArray, relaxation_time: float, term: float
) -> tuple[FloatArray, FloatArray]:
    """Storage and loss modulus of one Maxwell arm beside a spring, over the spring's.

    Parameters
    ----------
    angular_frequency : ndarray, shape (n,)
        ω [rad/s].
    relaxation_time : float
        τ [s].
    term : float
        r of the arm.

    Returns
    -------
    storage, loss : ndarray, shape (n,)
        1 + r (ωτ)²/(1 + (ωτ)²) and r ωτ/(1 + (ωτ)²).
    """
    phase = angular_frequency * relaxation_time
    return 1 + term * phase**2 / (1 + phase**2), term * phase / (1 + phase**2)


def largest_loss_factor(term: float) -> float:
    """Peak of tan φ of one Maxwell arm beside a spring: r/(2 √(1 + r)), at ωτ = 1/√(1 + r)."""
    return term / (2 * float(np.sqrt(1 + term)))
