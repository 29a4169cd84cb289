"""Where the march begins: the thick film between a rigid parabola and the wall (Martin's isoviscous roller).

In Hertz units H = H_0 + X²/2 from -L to the rupture point b, with Reynolds' conditions p(-L) = p(b) = p'(b) = 0:
the load is λ/(2 H_b) (1 - H_b/H_L)² = π/2, and p(b) = 0 fixes b/√(2 H_0), in closed form in X = √(2 H_0) tan θ.
"""

from __future__ import annotations

import numpy as np
from numba import njit

# tan θ_b of an unbounded inlet.
UNBOUNDED = 0.475


@njit(cache=True)
def _end_pressure(inlet: float, outlet: float) -> float:
    """∫ cos²θ - cos⁴θ / cos²θ_b dθ between two angles: proportional to p(b)."""
    square = 0.5 * (outlet - inlet) + 0.25 * (np.sin(2 * outlet) - np.sin(2 * inlet))
    fourth = (
        0.375 * (outlet - inlet)
        + 0.25 * (np.sin(2 * outlet) - np.sin(2 * inlet))
        + (np.sin(4 * outlet) - np.sin(4 * inlet)) / 32
    )
    return square - fourth / np.cos(outlet) ** 2


@njit(cache=True)
def rigid_rupture(film: float, half_domain: float) -> float:
    """Rupture point b of a rigid parabola with film H_0 = `film`, inlet at -L."""
    width = np.sqrt(2 * film)
    inlet = -np.arctan(half_domain / width)
    low, high = 0.0, min(0.5, np.arctan(half_domain / width))
    for _ in range(50):
        middle = 0.5 * (low + high)
        if _end_pressure(inlet, middle) > 0:
            low = middle
        else:
            high = middle
    return width * np.tan(0.5 * (low + high))


@njit(cache=True)
def rigid_film(speed_number: float, half_domain: float) -> tuple[float, float]:
    """Film H_0 and rupture point b that carry the load π/2 at λ = `speed_number`."""
    low, high = -60.0, np.log(speed_number) + 1.0
    rupture = 0.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        film = np.exp(middle)
        rupture = rigid_rupture(film, half_domain)
        outlet = film + 0.5 * rupture**2
        share = 1 - outlet / (film + 0.5 * half_domain**2)
        if speed_number / (2 * outlet) * share**2 > 0.5 * np.pi:
            low = middle
        else:
            high = middle
    return np.exp(0.5 * (low + high)), rupture
