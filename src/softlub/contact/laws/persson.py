"""Persson's theory of rough contact: the full pressure–separation integral and the real contact area."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Annotated

import numpy as np

from softlub.contact.laws.persson_integral import scaled_curve
from softlub.contact.real_area import persson_area_ratio
from softlub.pressure_table import FloatArray, PressureTable, tabulate
from softlub.surfaces.spectrum import SelfAffine
from softlub.units import Pressure, Unit

KNOT_SPACING = 0.035
"""Largest distance of the table's knots in ln u: ln p within 1e-7 of the integral."""
DEEPEST_SEPARATION = 1e-5
"""u/h_rms down to which the table follows the integral."""
HARDENING_DEPTH = 1e-3
"""The table goes on below the deepest separation by this factor."""


@dataclass(frozen=True)
class PerssonLaw:
    """Persson's pressure–separation integral (equation 4-22, corrected) with the area of equation 4-13.

    Parameters
    ----------
    spectrum : SelfAffine
        Roughness.
    modulus : float
        Plane-strain modulus E* [Pa].
    gamma : float, optional
        γ of the elastic energy, in (0, 1]; 1 is the plain theory, some 0.45 agrees with simulations.
    pressure_factor : float, optional
        Multiplies the contact stiffness of the asperities, and so the pressure at a given separation; the area at
        that separation stays. 1 is the theory; 1/π and 1/4 are variants for comparison with the source.

    Notes
    -----
    The integral holds for every positive separation, and p(u) has an exact exponential tail. The table follows it
    down to u = 1e-5 h_rms, less than an atom for any roughness below 10 µm. Below, the pressure goes on as a
    hyperbola, p = p₁ (1 + n (u₁/u - 1)) with n = -d ln p/d ln u at u₁, so that any load finds a positive separation
    that is still a number; the integral's own falls like exp(-p²).
    """

    spectrum: SelfAffine
    modulus: Pressure
    gamma: Annotated[float, Unit("1", above=0, at_most=1)] = 1.0
    pressure_factor: Annotated[float, Unit("1", above=0)] = 1.0

    def __post_init__(self) -> None:
        if not 0 < self.gamma <= 1:
            raise ValueError(f"gamma {self.gamma:g} must lie in (0, 1]")

    @property
    def stiffness(self) -> float:
        """E* of the asperities, pressure_factor included [Pa]."""
        return self.pressure_factor * self.modulus

    @property
    def separation_range(self) -> tuple[float, float]:
        """Separations between which the table is the theory's [m]."""
        return DEEPEST_SEPARATION * self.spectrum.rms_roughness, float("inf")

    @cached_property
    def table(self) -> PressureTable:
        """Asperity pressure over mean separation."""
        surface = self.spectrum
        scaled = _scaled_table(
            surface.hurst,
            surface.cutoff / surface.rolloff,
            surface.plateau_start / surface.rolloff,
            self.gamma,
        )
        coefficients = scaled.coefficients.copy()
        coefficients[:, 0] += np.log(self.stiffness * surface.rolloff * surface.rms_roughness)
        return PressureTable(scaled.first + np.log(surface.rms_roughness), scaled.step, coefficients)

    def area_ratio(self, pressure: FloatArray) -> FloatArray:
        """Real over nominal contact area (equation 4-13).

        Parameters
        ----------
        pressure : ndarray
            Asperity pressure [Pa].

        Returns
        -------
        ndarray
            A/A0, of the shape of `pressure`.
        """
        return persson_area_ratio(pressure, self.stiffness, self.spectrum.rms_slope)


@lru_cache(maxsize=256)
def _scaled_table(hurst: float, cutoff_ratio: float, plateau_ratio: float, gamma: float) -> PressureTable:
    """p/(E* q_r h_rms) over u/h_rms: one table for every modulus and roughness."""
    curve = scaled_curve(hurst, cutoff_ratio, plateau_ratio, gamma)
    span = np.log(curve.separation[-1] / DEEPEST_SEPARATION)
    intervals = int(np.ceil(span / KNOT_SPACING))
    step = span / intervals
    # The last knot stays a little inside the curve, so that rounding never leaves it.
    separation = DEEPEST_SEPARATION * np.exp(step * np.arange(intervals + 1) * (1 - 1e-12))
    pressure, rate = curve.at(separation)

    below = int(np.ceil(-np.log(HARDENING_DEPTH) / step))
    depth = np.exp(-step * np.arange(below, 0, -1))
    exponent = DEEPEST_SEPARATION / rate[0]
    hardened = pressure[0] * (1 + exponent * (1 / depth - 1))
    deep = DEEPEST_SEPARATION * depth
    return tabulate(
        np.concatenate([deep, separation]),
        np.concatenate([hardened, pressure]),
        np.concatenate([-pressure[0] * exponent / depth / deep, -pressure / rate]),
    )
