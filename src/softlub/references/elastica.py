"""The elastica: a slender cantilever under a large load across its free end.

An inextensible rod with EI θ'' = -P cos θ, clamped at s = 0 and free of moment at s = L, turns by θ_L at its end. With
α² = P L²/(EI), k² = (1 + sin θ_L)/2 and sin φ = 1/(k √2),

    α = K(k) - F(φ, k),    y_L/L = 1 - (2/α) [E(k) - E(φ, k)],    x_L/L = √(2 sin θ_L)/α

(K. E. Bisshopp, D. C. Drucker, Q. Appl. Math. 3 (1945) 272).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc


@dataclass(frozen=True)
class EndLoadedCantilever:
    """Cantilever under a load that keeps its direction, across the undeformed rod.

    Parameters
    ----------
    load_number : float
        α² = P L²/(EI), above 0; its end turns towards the load's direction as this grows.
    """

    load_number: float

    @cached_property
    def end_angle(self) -> float:
        """θ_L [rad], below π/2."""
        wanted = np.sqrt(self.load_number)
        return float(
            brentq(lambda angle: _root_of_load(angle) - wanted, 1e-12, np.pi / 2 - 1e-12, xtol=1e-15)
        )

    @property
    def deflection(self) -> float:
        """y_L/L of the end along the load."""
        modulus, start = _modulus_and_start(self.end_angle)
        second_kind = ellipe(modulus) - ellipeinc(start, modulus)
        return float(1 - 2 / np.sqrt(self.load_number) * second_kind)

    @property
    def reach(self) -> float:
        """x_L/L of the end along the undeformed rod."""
        return float(np.sqrt(2 * np.sin(self.end_angle) / self.load_number))


def _modulus_and_start(end_angle: float) -> tuple[float, float]:
    """k² and φ."""
    squared = (1 + np.sin(end_angle)) / 2
    return float(squared), float(np.arcsin(1 / np.sqrt(2 * squared)))


def _root_of_load(end_angle: float) -> float:
    """α of an angle."""
    modulus, start = _modulus_and_start(end_angle)
    return float(ellipk(modulus) - ellipkinc(start, modulus))
