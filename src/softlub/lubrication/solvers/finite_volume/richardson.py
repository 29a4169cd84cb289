"""Richardson's extrapolation over two nested grids of the finite volumes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.solver import FiniteVolume
from softlub.protocols import FloatArray

ORDER = 2
"""Of the scheme."""


def extrapolate(coarse: FloatArray, fine: FloatArray) -> FloatArray:
    """Values on n and 2n - 1 nodes without their error of second order: (4 f - c)/3."""
    return fine + (fine - coarse) / (2**ORDER - 1)


def extrapolated_sweep(
    solver: FiniteVolume,
    problem: Problem,
    speeds: Sequence[float],
    observe: Callable[[LubricatedContact], Sequence[float]],
) -> FloatArray:
    """Observables at every speed, extrapolated from the solver's grid and the one it is a refinement of.

    Parameters
    ----------
    solver : FiniteVolume
        On 2n - 1 nodes with n at least `COARSEST`: its own sweep passes the coarser grid on the way, so the
        extrapolation costs nothing more.
    problem : Problem
    speeds : sequence of float
        v [m/s], in any order.
    observe : callable
        Numbers of one contact, such as its friction and its smallest separation.

    Returns
    -------
    ndarray, shape (speeds, observables)
        NaN where either grid did not converge.

    Raises
    ------
    ValueError
        If the solver's grid is not a refinement of another.
    """
    if len(solver.nested()) < 2:
        raise ValueError(
            f"{solver.nodes} nodes refine no grid that the solver passes; take 257, 513, 1025, …"
        )
    coarse, fine = (
        np.array([_observed(contact, observe) for contact in level])
        for level in solver.sweep_levels(problem, speeds)[-2:]
    )
    return extrapolate(coarse, fine)


def _observed(
    contact: LubricatedContact, observe: Callable[[LubricatedContact], Sequence[float]]
) -> FloatArray:
    """What is observed of a contact, NaN if it did not converge."""
    values = np.asarray(observe(contact), dtype=float)
    return values if contact.converged else np.full_like(values, np.nan)
