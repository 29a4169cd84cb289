"""The law of a surface itself: a sweep of its rough contact over the load, averaged over realisations."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.special import erf, erfinv

from softlub.contact.laws.monotone import monotone_spline
from softlub.contact.laws.persson_integral import ScaledCurve
from softlub.pressure_table import FloatArray, PressureTable, tabulate

CLOSED_SEPARATION = 1e-3
"""u/h_rms below which the sweep's gap is too close to its error to be followed; Persson's curve goes on from there."""
DEEPEST_SEPARATION = 1e-5
"""u/h_rms down to which the table follows that curve at least."""
HARDENING_DEPTH = 1e-3
"""The table goes on below the deepest separation by this factor, as a hyperbola."""
REACH = 12.0
"""Largest u/h_rms of the table's exponential tail, which its own continuation carries on."""
KNOT_SPACING = 0.02
"""Largest distance of the table's knots in ln u."""
FULL_AREA = 1 - 1e-9
"""A/A0 above which a contact counts as full."""


@dataclass(frozen=True, eq=False)
class ContactCurve:
    """Separation and area of a rough contact over its load, averaged over realisations.

    Parameters
    ----------
    pressure : ndarray, shape (n,)
        p/(E* h'_rms), ascending.
    separation, area : ndarray, shape (n,)
        Mean separation over h_rms, and A/A0.
    separation_spread, area_spread : ndarray, shape (n,)
        Standard deviation over the realisations; 0 for a single one.
    """

    pressure: FloatArray
    separation: FloatArray
    area: FloatArray
    separation_spread: FloatArray
    area_spread: FloatArray


def averaged(pressure: FloatArray, separation: FloatArray, area: FloatArray) -> ContactCurve:
    """Average the sweeps of several realisations at equal loads.

    Parameters
    ----------
    pressure : ndarray, shape (n,)
        p/(E* h'_rms), in any order.
    separation, area : ndarray, shape (realisations, n)
        Over h_rms, and A/A0; NaN where a load did not converge, which leaves the load out.

    Returns
    -------
    ContactCurve

    Raises
    ------
    ValueError
        If fewer than 4 loads have converged in all realisations, or separation and area do not fall and rise with
        the load.
    """
    order = np.argsort(pressure)
    known = order[np.all(np.isfinite(separation) & np.isfinite(area), axis=0)[order]]
    if known.size < 4:
        raise ValueError(
            f"only {known.size} loads have converged in all realisations: a contact law needs at least 4"
        )
    curve = ContactCurve(
        pressure[known],
        separation[:, known].mean(axis=0),
        area[:, known].mean(axis=0),
        separation[:, known].std(axis=0),
        area[:, known].std(axis=0),
    )
    open_gap = curve.separation > CLOSED_SEPARATION
    partial = curve.area < FULL_AREA
    if np.any(np.diff(curve.separation[open_gap]) >= 0) or np.any(np.diff(curve.area[partial]) <= 0):
        raise ValueError("separation and area of the sweep are not monotone in the load: was it converged?")
    return curve


@dataclass(frozen=True, eq=False)
class TabulatedLaw:
    """Contact law from a swept rough contact.

    Between the loads of the sweep ln p is a monotone cubic of ln u + u/h_rms. Above the largest separation the
    pressure decays exponentially. Where the gap closes, Persson's curve goes on, its separation scaled to join the
    sweep's last open gap.

    Parameters
    ----------
    curve : ContactCurve
    closing : ScaledCurve
        Persson's curve of the surface, as `softlub.contact.laws.persson_curve` gives it.
    rms_roughness : float
        h_rms [m].
    rms_slope : float
        Spectral h'_rms.
    modulus : float
        Plane-strain modulus E* [Pa].
    pressure_factor : float, optional
        Multiplies the contact stiffness of the asperities, as in `PerssonLaw`.

    Raises
    ------
    ValueError
        If fewer than 3 loads leave the gap open.
    """

    curve: ContactCurve
    closing: ScaledCurve
    rms_roughness: float
    rms_slope: float
    modulus: float
    pressure_factor: float = 1.0

    def __post_init__(self) -> None:
        open_loads = int(np.count_nonzero(self.curve.separation > CLOSED_SEPARATION))
        if open_loads < 3:
            raise ValueError(f"{open_loads} loads leave the gap open: a contact law needs at least 3")

    @property
    def stiffness(self) -> float:
        """E* of the asperities, pressure_factor included [Pa]."""
        return self.pressure_factor * self.modulus

    @property
    def separation_range(self) -> tuple[float, float]:
        """Separations of the sweep's loads with an open gap [m]."""
        swept = self.curve.separation[self.curve.separation > CLOSED_SEPARATION]
        return self.rms_roughness * float(swept.min()), self.rms_roughness * float(swept.max())

    @cached_property
    def table(self) -> PressureTable:
        """Asperity pressure over mean separation."""
        first, last = np.log(DEEPEST_SEPARATION * HARDENING_DEPTH), np.log(REACH)
        separation = np.exp(np.linspace(first, last, int((last - first) / KNOT_SPACING) + 2))
        pressure, slope = self._scaled_law(separation)
        scale = self.stiffness * self.rms_slope
        return tabulate(separation * self.rms_roughness, pressure * scale, slope * scale / self.rms_roughness)

    def area_ratio(self, pressure: FloatArray) -> FloatArray:
        """Real over nominal contact area, corrected for the pixels along its edge.

        Interpolated as erf(√2 g(p)), g a monotone power of p in pieces: in proportion to p at light loads, 1 where
        the contact is full. For Persson's theory g = p/(E* h'_rms).

        Parameters
        ----------
        pressure : ndarray
            Asperity pressure [Pa].

        Returns
        -------
        ndarray
            A/A0, of the shape of `pressure`.
        """
        spline = self._area_spline
        low, high = spline.x[0], spline.x[-1]
        scaled = np.asarray(pressure, dtype=float) / (self.stiffness * self.rms_slope)
        position = np.log(np.maximum(scaled, np.finfo(float).tiny))
        inside = spline(np.clip(position, low, high))
        # A power of at least one beyond the heaviest load, so that the contact closes no later than Persson's.
        rate = max(1.0, float(spline(high, 1)))
        measure = np.exp(inside + np.minimum(position - low, 0) + rate * np.maximum(position - high, 0))
        return np.where(scaled > 0, erf(np.sqrt(2) * measure), 0.0)

    @cached_property
    def _area_spline(self) -> CubicHermiteSpline:
        partial = self.curve.area < FULL_AREA
        measure = erfinv(self.curve.area[partial]) / np.sqrt(2)
        return monotone_spline(np.log(self.curve.pressure[partial]), np.log(measure))

    def _scaled_law(self, separation: FloatArray) -> tuple[FloatArray, FloatArray]:
        """p/(E* h'_rms) and its derivative by u/h_rms, at separations in h_rms."""
        spline, deepest, farthest = self._spline
        held = np.clip(separation, deepest, farthest)
        log_pressure = spline(np.log(held) + held)
        rate = spline(np.log(held) + held, 1) * (1 / held + 1)
        pressure = np.exp(log_pressure + rate * np.maximum(separation - farthest, 0))
        slope = rate * pressure
        # Below the deepest separation p = p1 (1 + n (u1/u - 1)), with n = -d ln p/d ln u at u1, as in Persson's law.
        deep = separation < deepest
        exponent, ratio = -rate[deep] * deepest, deepest / separation[deep]
        slope[deep] = -pressure[deep] * exponent * ratio / separation[deep]
        pressure[deep] *= 1 + exponent * (ratio - 1)
        return pressure, slope

    @cached_property
    def _spline(self) -> tuple[CubicHermiteSpline, float, float]:
        """ln p over ln u + u/h_rms, from Persson's last separation to the sweep's largest one, and these two."""
        open_gap = np.flatnonzero(self.curve.separation > CLOSED_SEPARATION)[::-1]
        swept, load = self.curve.separation[open_gap], self.curve.pressure[open_gap]
        # From half the last open gap on, so that the two meet without a knot on top of another.
        deeper = (self.closing.separation < swept[0] / 2) & (self.closing.separation > DEEPEST_SEPARATION / 2)
        joined = float(self.closing.at(swept[:1])[0][0])
        separation = np.concatenate([self.closing.separation[deeper], swept])
        pressure = np.concatenate([self.closing.pressure[deeper] * load[0] / joined, load])
        spline = monotone_spline(np.log(separation) + separation, np.log(pressure))
        return spline, float(separation[0]), float(separation[-1])
