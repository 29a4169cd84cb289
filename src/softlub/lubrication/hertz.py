"""Hertz's dry line contact, which scales every lubricated one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class HertzLine:
    """Dry contact of a smooth cylinder, and the dimensionless numbers built on it.

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
        """p0 = 2W/(πa) [Pa]."""
        return float(2 * self.load / (np.pi * self.half_width))

    @property
    def gap_scale(self) -> float:
        """a²/R [m]: the unit of separation in the scaled problem."""
        return self.half_width**2 / self.radius

    def speed_number(self, viscosity: float, speed: float) -> float:
        """λ = 6ηvR²/(a³p0): the only number of the smooth isoviscous contact."""
        return 6 * viscosity * speed * self.radius**2 / (self.half_width**3 * self.peak_pressure)
