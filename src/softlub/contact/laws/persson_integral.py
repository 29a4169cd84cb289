"""Persson's pressure–separation integral in scaled form (equations 4-18 to 4-22, corrected).

The elastic energy per area of a contact at nominal pressure p is, in Persson's theory,

    U = E* (π/2) ∫ q² C(q) P [γ + (1 - γ) P²] dq,   P(q, p) = erf(w(q) p/E*),   w(q) = (π ∫_{q_L}^q q'³ C dq')^(-1/2),

with P the relative contact area seen at magnification q/q_L. The work of the pressure, p du = -dU, gives

    du/d ln p = -√π ∫ q² C w [γ + 3 (1 - γ) P²] exp(-(w p/E*)²) dq,   u = 0 at p = ∞.

Lengths in units of h_rms and 1/q_r and pressures in units of E* q_r h_rms leave a function of the Hurst exponent, the
two ratios of wavevectors and γ alone. With m(κ) = ∫ κ'³ c dκ', c = C/C(q_r), κ = q/q_r, and M = ∫ κ c dκ, it reads

    w p/E* = p √(2M/m),   du/d ln p = -(2πM)^(-1/2) ∫ (√m/κ) [γ + 3 (1 - γ) P²] exp(-2M p²/m) d ln m.

In ln m the integrand is smooth over lengths of order one, whatever p is: Gauss–Legendre panels there converge
geometrically, where a rule in q meets an essential singularity at q_L.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline, make_interp_spline
from scipy.special import erf

FloatArray = NDArray[np.float64]

PANEL_WIDTH = 4.0
"""Longest panel in ln m."""
PANEL_POINTS = 12
"""Gauss points of a panel; 16 change ln p by less than 1e-7."""
LEAST_WEIGHT = 44.0
"""Panels reach this far below the bulk in ln m: what is left out weighs e⁻²²."""
SAMPLE_SPACING = 0.06
"""Distance of the pressures at which the integral is evaluated, in ln p at light loads."""
LARGEST_ARGUMENT = 6.0
"""w(q_s) p/E* of the largest pressure; the separation beyond it, e⁻³⁶ h_rms, counts as zero."""
SMALLEST_PRESSURE = 1e-10
"""p/(E* q_L h_rms) of the smallest pressure; the rate of the exponential tail below it is off by as little."""


class Modes(NamedTuple):
    """Quadrature over the spectrum.

    Attributes
    ----------
    stiffness : ndarray, shape (modes,)
        √(2M/m): the argument w p/E* of a mode per unit of scaled pressure.
    weight : ndarray, shape (modes,)
        Contribution of a mode to -du/d ln p where it is out of contact.
    softest : float
        √(2M/m) at q_s: the least of all.
    """

    stiffness: FloatArray
    weight: FloatArray
    softest: float


class ScaledCurve(NamedTuple):
    """Scaled pressure over scaled separation, by ascending separation.

    Attributes
    ----------
    separation : ndarray, shape (samples,)
        u/h_rms.
    pressure : ndarray, shape (samples,)
        p/(E* q_r h_rms).
    rate : ndarray, shape (samples,)
        -du/d ln p in units of h_rms.
    """

    separation: FloatArray
    pressure: FloatArray
    rate: FloatArray

    def at(self, separation: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Pressure and rate at given separations within the curve, interpolated in ln p over ln u."""
        logarithm = CubicHermiteSpline(
            np.log(self.separation), np.log(self.pressure), -self.separation / self.rate
        )
        position = np.log(separation)
        return np.exp(logarithm(position)), -separation / logarithm(position, 1)


def modes(hurst: float, cutoff_ratio: float, plateau_ratio: float) -> Modes:
    """Quadrature points of a self-affine spectrum in ln m.

    Parameters
    ----------
    hurst : float
        H in (0, 1].
    cutoff_ratio : float
        q_s/q_r > 1.
    plateau_ratio : float
        q_L/q_r <= 1; 1 means no plateau.

    Returns
    -------
    Modes
    """
    exponent = 2 - 2 * hurst
    span = np.log(cutoff_ratio)
    plateau = (1 - plateau_ratio**4) / 4
    largest = plateau + (span if exponent == 0 else np.expm1(exponent * span) / exponent)
    first_moment = -np.expm1(-2 * hurst * span) / (2 * hurst) + (1 - plateau_ratio**2) / 2

    floor = min(0.0, np.log(plateau_ratio**4 / 4), np.log(largest)) - LEAST_WEIGHT
    kinks = [np.log(plateau)] if plateau > 0 else []
    position, width = _panels([floor, *kinks, np.log(largest)])
    moment = np.exp(position)
    beyond = np.maximum(moment - plateau, 0.0)
    wavevector = np.where(
        moment < plateau,
        (plateau_ratio**4 + 4 * moment) ** 0.25,
        np.exp(beyond if exponent == 0 else np.log1p(exponent * beyond) / exponent),
    )
    return Modes(
        stiffness=np.sqrt(2 * first_moment / moment),
        weight=width * np.sqrt(moment) / wavevector / np.sqrt(2 * np.pi * first_moment),
        softest=float(np.sqrt(2 * first_moment / largest)),
    )


def _panels(stops: list[float]) -> tuple[FloatArray, FloatArray]:
    """Gauss–Legendre points and weights on panels between the stops, finer below the last one.

    In deep contact the integrand falls off within a fraction of one below its upper end.
    """
    below, end = stops[-2:]
    stops = [*stops[:-1], *(end - depth for depth in (3.0, 1.0) if end - depth > below), end]
    edges = [stops[0]]
    for start, stop in pairwise(stops):
        edges.extend(np.linspace(start, stop, int(np.ceil((stop - start) / PANEL_WIDTH)) + 1)[1:])
    breaks = np.array(edges)
    points, weights = np.polynomial.legendre.leggauss(PANEL_POINTS)
    centre, half = (breaks[1:] + breaks[:-1]) / 2, np.diff(breaks) / 2
    return (centre[:, None] + half[:, None] * points).ravel(), (half[:, None] * weights).ravel()


@lru_cache(maxsize=256)
def scaled_curve(hurst: float, cutoff_ratio: float, plateau_ratio: float, gamma: float) -> ScaledCurve:
    """Scaled pressure over separation, from vanishing to full contact.

    Parameters
    ----------
    hurst, cutoff_ratio, plateau_ratio : float
        As in `modes`.
    gamma : float
        γ in (0, 1]: the energy of a contacting mode at small contact areas, over that in full contact.

    Returns
    -------
    ScaledCurve
    """
    quadrature = modes(hurst, cutoff_ratio, plateau_ratio)
    return curve_of(quadrature, SMALLEST_PRESSURE * plateau_ratio, gamma)


def curve_of(quadrature: Modes, smallest: float, gamma: float) -> ScaledCurve:
    """Pressure over separation of any spectrum, in the units that its modes are given in.

    Parameters
    ----------
    quadrature : Modes
    smallest : float
        Smallest scaled pressure; the tail is exponential there.
    gamma : float
        As in `scaled_curve`.

    Returns
    -------
    ScaledCurve
    """
    # The samples are even in ln p at light loads and in p near full contact, where u falls like exp(-p²):
    # argument = ln(1 + e^t).
    lightest = np.log(np.expm1(smallest * quadrature.softest))
    samples = int((LARGEST_ARGUMENT - lightest) / SAMPLE_SPACING) + 2
    parameter = np.linspace(lightest, LARGEST_ARGUMENT, samples)
    argument = np.log1p(np.exp(parameter))
    pressure = argument / quadrature.softest
    ratio = np.outer(pressure, quadrature.stiffness)
    share = np.exp(-(ratio**2))
    if gamma != 1:
        share *= gamma + 3 * (1 - gamma) * erf(ratio) ** 2
    rate = share @ quadrature.weight
    log_pressure_slope = 1 / (argument * (1 + np.exp(-parameter)))
    primitive = make_interp_spline(parameter, rate * log_pressure_slope, k=5).antiderivative()(parameter)
    separation = (primitive[-1] - primitive)[:-1]
    # The last samples lie below the rounding of the first and may come out unsorted.
    kept = np.flatnonzero(separation > 1e-9 * separation[0])[::-1]
    return ScaledCurve(separation[kept], pressure[:-1][kept], rate[:-1][kept])
