"""Whether a solution of the discrete equations is a film: in deep boundary lubrication they have others besides.

There single nodes may lift off to many times the gap around them: their flow term (H - H_b)/H³ then vanishes, the
polynomial through it still has the right integrals, and every residual is zero. Such a gap is no polynomial, which the
tail of its Legendre coefficients tells. A film's is less than half of what is allowed here, that of a gap with lifted
nodes beyond it; tests over random contacts and over contacts where nodes have lifted off hold both.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray

# The largest tail of a film is this at order 0 and falls by ten every four orders, a multiple of what films have; at
# high orders there is no need to be so strict.
TAIL_AT_ORDER_0 = 6.0
TAIL_FLOOR = 0.02


@njit(cache=True)
def largest_tail(order: int) -> float:
    """What the tail of a film may be."""
    return max(TAIL_AT_ORDER_0 * 10.0 ** (-order / 4), TAIL_FLOOR)


@njit(cache=True)
def tail(gap: FloatArray, basis: Basis) -> float:
    """Largest sum over an element of the sizes of the last two Legendre coefficients of ln H."""
    order = basis.nodes.size - 1
    largest = 0.0
    for e in range((gap.size - 1) // order):
        own = 0.0
        for k in range(order - 1, order + 1):
            coefficient = 0.0
            for j in range(order + 1):
                coefficient += basis.legendre_weights[k, j] * np.log(gap[e * order + j])
            own += abs(coefficient)
        largest = max(largest, own)
    return largest


@njit(cache=True)
def is_film(gap: FloatArray, basis: Basis) -> bool:
    """Whether ln H is as smooth on every element as a film's."""
    return tail(gap, basis) <= largest_tail(basis.nodes.size - 1)
