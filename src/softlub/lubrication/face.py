"""For notebooks: solve one contact or sweep it, by the name of a solver."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from softlub.lubrication import speed_sweep
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers import finer, make_solver

if TYPE_CHECKING:
    import xarray as xr


def solve(
    problem: Problem, start: LubricatedContact | None = None, *, solver: str = "auto"
) -> LubricatedContact:
    """Solve one lubricated contact.

    Parameters
    ----------
    problem : Problem
    start : LubricatedContact, optional
        A solution nearby.
    solver : str
        A key of `softlub.lubrication.solvers.SOLVERS`, with its usual settings.

    Returns
    -------
    LubricatedContact
        Look at ``converged``: a hard problem is returned, not raised.

    Raises
    ------
    TypeError
        If `start` is not a solution.
    ValueError
        If there is no such solver, or it cannot treat this sort of problem.
    """
    if start is not None and not isinstance(start, LubricatedContact):
        raise TypeError(f"start is {start!r}: a solution is needed; a solver is named by solver=")
    contact: LubricatedContact = make_solver(solver).solve(problem, start)
    return contact


def sweep(
    problem: Problem,
    loads: Sequence[float],
    speeds: Sequence[float],
    *,
    shear_strength: float | None = None,
    solver: str = "auto",
    fields: bool = False,
) -> xr.Dataset:
    """Solve at every load and speed, with an error estimate where the solver has one.

    Parameters
    ----------
    problem : Problem
        Its own load and speed are not used.
    loads, speeds : sequence of float
        W [N/m] and v [m/s], at least one of each.
    shear_strength : float, optional
        σ1 of the real contact [Pa]. Without it the dataset holds the fluid part of friction alone, and the
        ``real_contact_width`` that the solid part is made of.
    solver : str
        A key of `softlub.lubrication.solvers.SOLVERS`, with its usual settings.
    fields : bool
        Whether pressures and separation over x are kept.

    Returns
    -------
    xarray.Dataset
        See `softlub.lubrication.speed_sweep.sweep`.

    Raises
    ------
    ValueError
        If a list is empty, there is no such solver, or it cannot treat this sort of problem.
    """
    if not (len(loads) and len(speeds)):
        raise ValueError(f"{len(loads)} loads and {len(speeds)} speeds: at least one of each is needed")
    chosen = make_solver(solver)
    dataset = speed_sweep.sweep(problem, loads, speeds, chosen, finer(chosen), fields)
    if shear_strength is None:
        return dataset
    import xarray as xr

    from softlub.lubrication.total_friction import with_total_friction

    return with_total_friction(dataset, xr.DataArray(shear_strength))
