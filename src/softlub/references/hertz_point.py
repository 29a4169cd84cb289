"""Hertz's contact of a sphere with a plane, one of the two elastic (Johnson, Contact Mechanics, 3.4 and 4.2).

a³ = 3FR/(4E*), p0 = 3F/(2πa²), p = p0 √(1 - r²/a²). The source's chapter 2 calls a an area; it is a radius.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class HertzPoint:
    """Sphere on a plane.

    Parameters
    ----------
    radius : float
        R of the sphere [m].
    modulus : float
        E* [Pa].
    force : float
        F [N].
    """

    radius: float
    modulus: float
    force: float

    @property
    def contact_radius(self) -> float:
        """a [m]."""
        return float((3 * self.force * self.radius / (4 * self.modulus)) ** (1 / 3))

    @property
    def peak_pressure(self) -> float:
        """p0 [Pa]."""
        return float(3 * self.force / (2 * np.pi * self.contact_radius**2))

    @property
    def approach(self) -> float:
        """a²/R [m]."""
        return self.contact_radius**2 / self.radius

    def pressure(self, distance: ArrayLike) -> NDArray[np.float64]:
        """p(r) [Pa] at distances from the axis [m], of any shape."""
        inside = 1 - (np.asarray(distance, dtype=float) / self.contact_radius) ** 2
        return np.asarray(self.peak_pressure * np.sqrt(np.maximum(inside, 0)))

    def deflection(self, distance: ArrayLike) -> NDArray[np.float64]:
        """Displacement of the half-space's surface [m] at distances from the axis [m], of any shape.

        Inside π p0 (2a² - r²)/(4 E* a), outside p0 [(2a² - r²) asin(a/r) + a √(r² - a²)]/(2 E* a).
        """
        r, a = np.asarray(distance, dtype=float), self.contact_radius
        beyond = np.maximum(r, a)
        angle = np.arcsin(a / beyond)
        outside = (2 * a**2 - r**2) * angle + a * np.sqrt(beyond**2 - a**2)
        return np.asarray(self.peak_pressure / (2 * self.modulus * a) * outside)
