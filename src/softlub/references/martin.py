"""Martin's rigid roller: a parabolic gap with Reynolds exit (p = dp/dx = 0 at the rupture) and a flooded inlet.

With x = √(2R h₀) tan γ, h = h₀/cos²γ, the pressure is elementary in γ, and p = 0 at the rupture γ_b is one equation
for a number, γ_b = 0.4436. Integrated by parts, the load is W = -∫ x dp = 3ηvR/h_b, so that W = 3 cos²γ_b ηvR/h₀
= 2.447 ηvR/h₀ with one moving wall (4.9 with the mean of two speeds). H. M. Martin, Engineering 102 (1916).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

FloatArray = NDArray[np.float64]


def _primitive(angle: FloatArray | float, rupture_angle: float) -> FloatArray:
    """∫ (cos²γ - cos⁴γ/cos²γ_b) dγ."""
    square = angle / 2 + np.sin(2 * angle) / 4
    fourth = 3 * angle / 8 + np.sin(2 * angle) / 4 + np.sin(4 * angle) / 32
    return np.asarray(square - fourth / np.cos(rupture_angle) ** 2)


RUPTURE_ANGLE: float = brentq(
    lambda angle: _primitive(angle, angle) - _primitive(-np.pi / 2, angle), 0.1, 1.0, xtol=1e-15
)
"""γ_b, where the film ruptures."""
LOAD_COEFFICIENT: float = 3 * float(np.cos(RUPTURE_ANGLE)) ** 2
"""W h₀/(ηvR) = 2.447."""


@dataclass(frozen=True)
class MartinRoller:
    """Rigid roller on a rigid wall, one of them moving.

    Parameters
    ----------
    radius : float
        R [m].
    viscosity : float
        η [Pa s].
    speed : float
        v of the wall [m/s].
    load : float
        W [N/m].
    """

    radius: float
    viscosity: float
    speed: float
    load: float

    @cached_property
    def smallest_separation(self) -> float:
        """h₀ = 2.447 ηvR/W [m]."""
        return LOAD_COEFFICIENT * self.viscosity * self.speed * self.radius / self.load

    @property
    def length_scale(self) -> float:
        """√(2R h₀) [m]."""
        return float(np.sqrt(2 * self.radius * self.smallest_separation))

    @property
    def rupture_position(self) -> float:
        """x_b = √(2R h₀) tan γ_b [m]."""
        return self.length_scale * float(np.tan(RUPTURE_ANGLE))

    def separation(self, position: FloatArray) -> FloatArray:
        """h [m] at any position [m]."""
        return self.smallest_separation + position**2 / (2 * self.radius)

    def pressure(self, position: FloatArray) -> FloatArray:
        """p [Pa] at any position [m]; zero beyond the rupture."""
        angle = np.arctan(np.minimum(position, self.rupture_position) / self.length_scale)
        scale = 6 * self.viscosity * self.speed * self.length_scale / self.smallest_separation**2
        return scale * (_primitive(angle, RUPTURE_ANGLE) - _primitive(-np.pi / 2, RUPTURE_ANGLE))
