"""Persson's pressure over separation in the units of a rough contact: u over h_rms, p over E* h'_rms.

In these units every spectrum's curve ends alike: near full contact u falls like exp(-2 p²).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicHermiteSpline

from softlub.contact.laws.persson_integral import (
    SMALLEST_PRESSURE,
    Modes,
    ScaledCurve,
    curve_of,
    scaled_curve,
)
from softlub.surfaces.spectrum import SelfAffine

FloatArray = NDArray[np.float64]


def spectrum_curve(spectrum: SelfAffine, gamma: float = 1.0) -> ScaledCurve:
    """Persson's curve of a self-affine surface.

    Parameters
    ----------
    spectrum : SelfAffine
    gamma : float
        γ of the elastic energy, in (0, 1].

    Returns
    -------
    ScaledCurve
        Separations in h_rms, pressures in E* h'_rms.
    """
    curve = scaled_curve(
        spectrum.hurst,
        spectrum.cutoff / spectrum.rolloff,
        spectrum.plateau_start / spectrum.rolloff,
        gamma,
    )
    unit = spectrum.rolloff * spectrum.rms_roughness / spectrum.rms_slope
    return curve._replace(pressure=curve.pressure * unit)


def waves_curve(wavevector: ArrayLike, power: ArrayLike, gamma: float = 1.0) -> ScaledCurve:
    """Persson's curve of a surface by the waves that it is measured to have (equation 4-22).

    With powers h_k², q³C dq becomes q_k² h_k²/2π, so that w(q_k) = (Σ_j≤k q_j² h_j²/2)^(-1/2), the last wave counted
    by half. A wave adds √π q² C w dq = q_k h_k² w/(2√π) to -du/d ln p where it is out of contact.

    Parameters
    ----------
    wavevector : array_like, shape (n,)
        Ascending [1/m].
    power : array_like, shape (n,)
        Mean square height of the waves around each wavevector [m²], positive.
    gamma : float
        As in `spectrum_curve`.

    Returns
    -------
    ScaledCurve

    Raises
    ------
    ValueError
        If fewer than 2 waves have a height.
    """
    q, heights = (np.asarray(values, dtype=float) for values in (wavevector, power))
    q, heights = q[heights > 0], heights[heights > 0]
    if q.size < 2:
        raise ValueError("Persson's theory needs waves of 2 lengths at least")
    squares = q**2 * heights
    height, slope = np.sqrt(heights.sum()), np.sqrt(squares.sum())
    softness = np.sqrt(2 / (np.cumsum(squares) - squares / 2))
    quadrature = Modes(
        stiffness=softness * slope,
        weight=q * heights * softness / (2 * np.sqrt(np.pi) * height),
        softest=float(softness[-1] * slope),
    )
    # The longest wave alone sees the contact as full at p = E* q h_rms; the tail starts far below.
    return curve_of(quadrature, SMALLEST_PRESSURE * float(q[0] * height / slope), gamma)


def separation_at(curve: ScaledCurve, pressure: ArrayLike) -> FloatArray:
    """Separation at given pressures, exponential below the curve's lightest one and 0 beyond its heaviest.

    Parameters
    ----------
    curve : ScaledCurve
    pressure : array_like
        Positive, of any shape.

    Returns
    -------
    ndarray
    """
    log_pressure = np.log(np.asarray(pressure, dtype=float))
    known = np.log(curve.pressure[::-1])
    between = CubicHermiteSpline(known, curve.separation[::-1], -curve.rate[::-1], extrapolate=False)
    tail = curve.separation[-1] + curve.rate[-1] * (known[0] - log_pressure)
    inside = np.nan_to_num(between(log_pressure), nan=0.0)
    return np.where(log_pressure < known[0], tail, np.maximum(inside, 0.0))
