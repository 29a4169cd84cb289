"""The isochoric response of a viscoelastic material, with its history.

With S̃ = J^(2/3) F^(-1) P_iso the long-term isochoric stress drawn back to the reference (DEV of 2 ∂W/∂C̄ in Simo's
notation), each term of the series keeps

    H_i(t) = r_i ∫ exp(-(t - s)/τ_i) dS̃/ds ds

and the stress is P = P_iso + J^(-2/3) F DEV[Σ H_i], DEV[H] = H - (H : C)/3 C^(-1): the projection keeps the true
mean stress with the element's pressure. Over an increment Δt in which S̃ goes linearly from S̃_n to S̃, with
z_i = Δt/τ_i and a_i = (1 - exp(-z_i))/z_i, the integral is exact:

    H_i = exp(-z_i) H_i,n + r_i a_i (S̃ - S̃_n)

The part with the unknown S̃ is P_iso itself, since J^(-2/3) F DEV[S̃] = P_iso. So

    P = (1 + Σ r_i a_i) P_iso(F) + J^(-2/3) F DEV[M],    M = Σ exp(-z_i) H_i,n - (Σ r_i a_i) S̃_n

with M constant in the increment: the stress has the potential (1 + Σ r a) W_iso + ½ J^(-2/3) M : C, and its
derivative is symmetric.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.solid.materials.isochoric import IsochoricResponse
from softlub.solid.materials.prony import PronySeries

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Increment:
    """What an increment's duration and its start make of the response.

    Parameters
    ----------
    decays, gains : ndarray, shape (terms,)
        exp(-z_i) and r_i a_i.
    factor : float
        1 + Σ r_i a_i.
    metric : ndarray, shape (3, 3, quadrature points, cells), optional
        M [Pa]; none before the first accepted increment.
    """

    decays: FloatArray
    gains: FloatArray
    factor: float
    metric: FloatArray | None


@dataclass(frozen=True)
class ViscoelasticState:
    """What is remembered at the end of an increment.

    Parameters
    ----------
    branches : ndarray, shape (terms, 3, 3, quadrature points, cells)
        H_i [Pa].
    stress : ndarray, shape (3, 3, quadrature points, cells)
        S̃ [Pa].
    """

    branches: FloatArray
    stress: FloatArray


Checkpoint = tuple[ViscoelasticState | None, Increment]


class ViscoelasticResponse:
    """A felupe material that remembers.

    Before any increment, and in one of infinite duration, the response is that of the material at rest; in one of no
    duration it is the instantaneous one. After `accept`, and after `restore`, stress and elasticity stay those of
    the increment that has ended, until the next one begins.

    Parameters
    ----------
    at_rest : IsochoricResponse
        Long-term response.
    prony : PronySeries
        Its relaxation.
    """

    x: Sequence[FloatArray] = (np.eye(3), np.zeros(0))

    def __init__(self, at_rest: IsochoricResponse, prony: PronySeries) -> None:
        self.at_rest = at_rest
        self.terms = prony.long_term_terms
        self.times = prony.relaxation_times
        self._state: ViscoelasticState | None = None
        self._last: FloatArray | None = None
        self.begin_increment(np.inf)

    def begin_increment(self, duration: float) -> None:
        """Begin an increment from the last accepted state, or begin it anew.

        Parameters
        ----------
        duration : float
            Δt [s], not negative; infinite for full relaxation.

        Raises
        ------
        ValueError
            If the duration is negative or NaN.
        """
        if not duration >= 0:
            raise ValueError(f"an increment of {duration:g} s: the duration must be at least 0 s")
        steps = duration / self.times
        # (1 - exp(-z))/z is 1 for z = 0 and 0 for infinite z.
        finite = (steps > 0) & (steps < np.inf)
        safe = np.where(finite, steps, 1.0)
        decays, gains = np.exp(-steps), self.terms * np.where(finite, -np.expm1(-safe) / safe, steps == 0)
        self._increment = Increment(
            decays, gains, 1 + float(gains.sum()), _history(self._state, decays, gains)
        )

    def accept(self) -> None:
        """End the increment with the deformation of the last evaluated stress.

        Raises
        ------
        RuntimeError
            If no stress has been evaluated.
        """
        if self._last is None:
            raise RuntimeError("no stress was evaluated since the material was made: nothing to accept")
        stress = _drawn_back(self.at_rest.stress(self._last), self._last)
        change = stress if self._state is None else stress - self._state.stress
        branches = np.empty((self.terms.size, *stress.shape))
        for term, (decay, gain) in enumerate(zip(self._increment.decays, self._increment.gains, strict=True)):
            np.multiply(gain, change, out=branches[term])
            if self._state is not None and decay > 0:
                branches[term] += decay * self._state.branches[term]
        self._state = ViscoelasticState(branches, stress)

    def checkpoint(self) -> Checkpoint:
        """What `restore` returns to: the last accepted state and the present increment."""
        return self._state, self._increment

    def restore(self, checkpoint: Checkpoint) -> None:
        """Return to what `checkpoint` gave."""
        self._state, self._increment = checkpoint

    def gradient(self, x: Sequence[Any]) -> list[Any]:
        """Stress at [F, state variables], and the state variables as they are."""
        self._last = np.array(x[0])
        return [self.at_rest.stress(x[0], self._increment.factor, self._increment.metric), x[-1]]

    def hessian(self, x: Sequence[Any]) -> list[FloatArray]:
        """Elasticity at [F, state variables]."""
        return [self.at_rest.elasticity(x[0], self._increment.factor, self._increment.metric)]


def _history(state: ViscoelasticState | None, decays: FloatArray, gains: FloatArray) -> FloatArray | None:
    """M of an increment [Pa], shape (3, 3, q, c)."""
    if state is None:
        return None
    metric = -gains.sum() * state.stress
    for branch, decay in zip(state.branches, decays, strict=True):
        if decay > 0:
            metric += decay * branch
    return metric


def _drawn_back(stress: FloatArray, deformation: FloatArray) -> FloatArray:
    """S̃ = J^(2/3) F^(-1) P, symmetric, shape (3, 3, q, c)."""
    points = np.moveaxis(deformation, (0, 1), (-2, -1))
    volume = np.linalg.det(points)[..., None, None] ** (2 / 3)
    drawn = volume * np.linalg.solve(points, np.moveaxis(stress, (0, 1), (-2, -1)))
    symmetric = (drawn + np.swapaxes(drawn, -1, -2)) / 2
    return np.ascontiguousarray(np.moveaxis(symmetric, (-2, -1), (0, 1)))
