"""Richardson's extrapolation from two nested grids.

The nodes of n are every second one of 2n - 1, so that the leading error, of second order in the spacing, falls by
four; what is left is that of the rupture between two nodes, which has no expansion, and of fourth order.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.solver import FiniteVolume
from softlub.protocols import FloatArray


def richardson(coarse: FloatArray, fine: FloatArray) -> FloatArray:
    """(4 f - c)/3: the second-order error of two nested grids taken out.

    Parameters
    ----------
    coarse, fine : ndarray
        The same quantity on n and on 2n - 1 nodes.

    Returns
    -------
    ndarray
    """
    return (4 * fine - coarse) / 3


def extrapolated_sweep(
    solver: FiniteVolume,
    problem: Problem,
    speeds: Sequence[float] | FloatArray,
    quantity: Callable[[LubricatedContact], float],
) -> FloatArray:
    """One quantity at every speed, extrapolated from the solver's grid and the one of half the intervals.

    Parameters
    ----------
    solver : FiniteVolume
        Its number of nodes is odd.
    problem : Problem
    speeds : sequence of float
        v [m/s].
    quantity : callable
        What is taken of each contact, NaN of one that did not converge.

    Returns
    -------
    ndarray, shape (speeds,)

    Raises
    ------
    ValueError
        If the number of nodes is even.
    """
    coarse, fine = nested_pair(solver, problem, speeds)
    return richardson(
        np.array([quantity(contact) for contact in coarse]), np.array([quantity(contact) for contact in fine])
    )


def nested_pair(
    solver: FiniteVolume, problem: Problem, speeds: Sequence[float] | FloatArray
) -> tuple[list[LubricatedContact], list[LubricatedContact]]:
    """Contacts on (n + 1)/2 and n nodes; the coarser ones are a by-product where the solver passes them."""
    if solver.nodes % 2 == 0:
        raise ValueError(f"nested grids need an odd number of nodes, not {solver.nodes}")
    levels = solver.sweep_levels(problem, list(speeds))
    if len(levels) > 1:
        return levels[-2], levels[-1]
    half = FiniteVolume((solver.nodes + 1) // 2, solver.grid, solver.tolerance, solver.most_steps)
    return half.sweep(problem, list(speeds)), levels[-1]
