"""Friction of the dry contact: the boundary plateau of a Stribeck curve where roughness hardly spreads the load.

The asperities carry Hertz's pressure, and the real area is A/A0 = erf(√2 p/(E* h'_rms)). With b = √2 p₀/(E* h'_rms),

    ∫ A/A0 dx = a ∫ erf(b √(1 - ξ²)) dξ = √π a b exp(-b²/2) [I₀(b²/2) + I₁(b²/2)],

by differentiation for b and d/dz {√z e^(-z) (I₀ + I₁)} = e^(-z) (I₀ - I₁)/(2√z).
"""

from __future__ import annotations

import numpy as np
from scipy.special import ive


def real_contact_width(half_width: float, peak_pressure: float, modulus: float, rms_slope: float) -> float:
    """∫ A/A0 dx over Hertz's line contact.

    Parameters
    ----------
    half_width : float
        a [m].
    peak_pressure : float
        p₀ [Pa].
    modulus : float
        Plane-strain modulus E* [Pa].
    rms_slope : float
        h'_rms.

    Returns
    -------
    float
        In m, at most 2a.
    """
    b = np.sqrt(2) * peak_pressure / (modulus * rms_slope)
    return float(np.sqrt(np.pi) * half_width * b * (ive(0, b**2 / 2) + ive(1, b**2 / 2)))


def friction_coefficient(
    shear_strength: float,
    load: float,
    half_width: float,
    peak_pressure: float,
    modulus: float,
    rms_slope: float,
) -> float:
    """μ = σ₁ ∫ A/A0 dx / W (equation 3-32 with erf), W the load [N/m] and σ₁ the shear strength [Pa]."""
    return shear_strength * real_contact_width(half_width, peak_pressure, modulus, rms_slope) / load
