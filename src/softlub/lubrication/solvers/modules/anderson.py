"""Anderson's acceleration of a fixed-point iteration.

The modules iterate x <- G(x). Relaxation is all that the source has against the strong coupling of film and body: a
pressure wave of wavenumber k comes back from one round of Reynolds equation and elasticity as -i c/k² times itself,
with c a² in the hundreds, and only factors below some 1e-3 damp that. But these are the few longest waves, and
Anderson's method finds them in its last `memory` iterates and removes them. It is ours, beside the source's
relaxation; with a memory of 0 the plain relaxed iteration remains.

D. G. Anderson, J. ACM 12 (1965) 547; H. F. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011) 1715 (type II).
"""

from __future__ import annotations

import numpy as np

from softlub.protocols import FloatArray

REGULARISATION = 1e-12
"""Relative Tikhonov term of the normal equations."""


class Anderson:
    """Differences of the last iterates, and the next iterate that they suggest.

    Parameters
    ----------
    memory : int
        Number of differences kept.
    size : int
        Length of the iterates.
    """

    def __init__(self, memory: int, size: int) -> None:
        self.memory = memory
        self._states = np.empty((memory, size))
        self._changes = np.empty((memory, size))
        self._products = np.empty((memory, memory))
        self.forget()

    def forget(self) -> None:
        """Start afresh."""
        self._count = 0
        self._last: tuple[FloatArray, FloatArray] | None = None

    def next(self, state: FloatArray, change: FloatArray) -> FloatArray:
        """The iterate to go on with after `state` has been found to change by `change` = G(x) - x.

        It minimises the linearised change over the affine span of the remembered iterates.
        """
        if self.memory == 0:
            return state + change
        if self._last is not None:
            self._remember(state - self._last[0], change - self._last[1])
        self._last = (state, change)
        kept = min(self._count, self.memory)
        if kept == 0:
            return state + change
        changes = self._changes[:kept]
        products = self._products[:kept, :kept]
        scaling = 1 / np.sqrt(np.maximum(np.diagonal(products), np.finfo(float).tiny))
        matrix = products * scaling[:, None] * scaling + REGULARISATION * np.eye(kept)
        try:
            share = scaling * np.linalg.solve(matrix, scaling * (changes @ change))
        except np.linalg.LinAlgError:
            # Iterates that overflowed: the plain step is as good as any.
            return state + change
        return state + change - share @ self._states[:kept] - share @ changes

    def _remember(self, state_difference: FloatArray, change_difference: FloatArray) -> None:
        slot = self._count % self.memory
        self._count += 1
        kept = min(self._count, self.memory)
        self._states[slot] = state_difference
        self._changes[slot] = change_difference
        product = self._changes[:kept] @ change_difference
        self._products[slot, :kept] = product
        self._products[:kept, slot] = product
