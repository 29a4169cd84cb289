"""Hertz's line contact: a parabola x²/(2R) on an elastic half-plane, dry and without friction.

K. L. Johnson, Contact Mechanics (1985), sections 4.2 and 2.7. The elliptical pressure makes the surface follow the
parabola within |x| <= a, and outside the gap is (a²/2R) [ξ√(ξ² - 1) - arcosh ξ], ξ = |x|/a.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class HertzLineContact:
    """Dry contact of a smooth cylinder.

    Parameters
    ----------
    radius : float
        R [m].
    modulus : float
        Plane-strain modulus E* [Pa].
    load : float
        W [N/m].
    """

    radius: float
    modulus: float
    load: float

    @property
    def half_width(self) -> float:
        """a = √(4WR/(πE*)) [m]."""
        return float(np.sqrt(4 * self.load * self.radius / (np.pi * self.modulus)))

    @property
    def peak_pressure(self) -> float:
        """p₀ = √(WE*/(πR)) [Pa]."""
        return float(np.sqrt(self.load * self.modulus / (np.pi * self.radius)))

    def pressure(self, position: FloatArray) -> FloatArray:
        """p₀ √(1 - x²/a²) [Pa], zero outside."""
        return self.peak_pressure * np.sqrt(np.maximum(1 - (position / self.half_width) ** 2, 0.0))

    def gap(self, position: FloatArray) -> FloatArray:
        """Distance of the surfaces [m], zero in contact."""
        ratio = np.maximum(np.abs(position) / self.half_width, 1.0)
        bracket = ratio * np.sqrt(ratio**2 - 1) - np.arccosh(ratio)
        return self.half_width**2 / (2 * self.radius) * bracket

    def deflection(self, position: FloatArray) -> FloatArray:
        """What the elliptical pressure adds to the gap, less its value at x = 0 [m]."""
        return self.gap(position) - position**2 / (2 * self.radius)
