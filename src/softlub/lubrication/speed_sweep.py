"""A contact swept over loads and speeds, as arrays and as a dataset."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

import numpy as np

from softlub.datasets.variables import FLAGS
from softlub.lubrication.meshed_body import MeshedBody
from softlub.lubrication.observables import observe
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact

if TYPE_CHECKING:
    import xarray as xr

Arrays = dict[str, np.ndarray]

FIELDS = ("x", "fluid_pressure", "solid_pressure", "separation")
"""Variables over the nodes of a point's own grid."""

ESTIMATED = ("friction_coefficient_fluid", "separation_min", "real_contact_width")
"""Observables whose error is estimated."""

FRICTION_ERROR_LIMIT = 1e-3
"""Estimated absolute error of μ_fluid above which a point is flagged `inaccurate_friction`."""
SEPARATION_ERROR_LIMIT = 5e-2
"""Estimated relative error of the smallest separation above which a point is flagged `inaccurate_separation`."""
WIDTH_ERROR_LIMIT = 1e-2
"""Estimated relative error of the real contact width above which a point is flagged `inaccurate_area` …"""
NEGLIGIBLE_AREA = 1e-4
"""… unless its real contact area is nowhere larger than this part of the nominal one."""


class Solver(Protocol):
    """What solves a problem at many speeds."""

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        """One result a speed, in the order given."""
        ...


class Corrector(Protocol):
    """What solves again, on a grid of its own, what another grid's solutions begin."""

    def correct(self, problem: Problem, contacts: Sequence[LubricatedContact]) -> list[LubricatedContact]:
        """One result a contact, at its speed; what is not converged as it is."""
        ...


def sweep(
    problem: Problem,
    loads: Sequence[float],
    speeds: Sequence[float],
    solver: Solver,
    finer: Corrector | None = None,
    fields: bool = False,
) -> xr.Dataset:
    """Solve at every load and speed.

    Parameters
    ----------
    problem : Problem
        Its own load and speed are not used.
    loads : sequence of float
        W [N/m].
    speeds : sequence of float
        v [m/s]; each load is continued along them.
    solver : Solver
    finer : Corrector, optional
        The same solver on a finer grid; its difference is the error estimate of each point. A meshed body has no
        finer one: its film on every second node takes that part, where the number of nodes is odd, and the estimate
        is of the coarser one's error.
    fields : bool
        Whether pressures and separation over x are kept.

    Returns
    -------
    xarray.Dataset
        Dimensions load, speed and, for fields, node; variables as in `softlub.datasets.variables`.
    """
    import xarray as xr

    from softlub.datasets.store import describe

    arrays = sweep_arrays(problem, loads, speeds, solver, finer, fields)
    return describe(
        xr.Dataset(
            {name: (dimensions(name), values) for name, values in arrays.items() if name != "x"},
            coords={"load": np.asarray(loads), "speed": np.asarray(speeds)}
            | ({"x": (dimensions("x"), arrays["x"])} if fields else {}),
        )
    )


def dimensions(name: str) -> tuple[str, ...]:
    """Trailing dimensions of a variable of the sweep."""
    return ("load", "speed", "node") if name in FIELDS else ("load", "speed")


def sweep_arrays(
    problem: Problem,
    loads: Sequence[float],
    speeds: Sequence[float],
    solver: Solver,
    finer: Corrector | None = None,
    fields: bool = False,
) -> Arrays:
    """As `sweep`, but bare arrays of shape (loads, speeds) or (loads, speeds, nodes); NaN beyond a point's nodes."""
    rows = [_sweep_speeds(problem.at(load=load), speeds, solver, finer, fields) for load in loads]
    return stack(rows)


def stack(parts: Sequence[Arrays]) -> Arrays:
    """Stack like arrays along a new first dimension, fields padded to the longest with NaN."""
    return {name: _stack_padded([part[name] for part in parts]) for name in parts[0]}


def _stack_padded(arrays: Sequence[np.ndarray]) -> np.ndarray:
    longest = max(array.shape[-1] for array in arrays)
    if all(array.shape[-1] == longest for array in arrays):
        return np.stack(arrays)
    padding = [[(0, 0)] * (array.ndim - 1) + [(0, longest - array.shape[-1])] for array in arrays]
    return np.stack(
        [np.pad(array, pad, constant_values=np.nan) for array, pad in zip(arrays, padding, strict=True)]
    )


def _sweep_speeds(
    problem: Problem, speeds: Sequence[float], solver: Solver, finer: Corrector | None, fields: bool
) -> Arrays:
    contacts, seconds = _timed_sweep(problem, speeds, solver)
    arrays = _observables(contacts, problem)
    arrays["solver_seconds"] = seconds
    if finer is not None:
        _estimate_errors(arrays, problem, contacts, finer)
    if fields:
        arrays.update(_fields(contacts))
    return arrays


def _timed_sweep(
    problem: Problem, speeds: Sequence[float], solver: Solver
) -> tuple[list[LubricatedContact], np.ndarray]:
    """Contacts and the CPU time of each; a solver that keeps no time per point shares out the whole."""
    began = time.process_time()
    contacts = solver.sweep(problem, speeds)
    share = (time.process_time() - began) / len(speeds)
    seconds = np.array([contact.seconds for contact in contacts])
    return contacts, np.where(np.isnan(seconds), share, seconds)


def _observables(contacts: Sequence[LubricatedContact], problem: Problem) -> Arrays:
    points = [observe(contact, problem) for contact in contacts]
    return {name: np.array([point[name] for point in points]) for name in points[0]}


def _estimate_errors(
    arrays: Arrays, problem: Problem, contacts: Sequence[LubricatedContact], finer: Corrector
) -> None:
    """Compare with a second grid: a finer one, or the coarser one that a meshed body leaves."""
    if isinstance(problem.body, MeshedBody):
        if not problem.body.can_be_halved:
            return
        problem = replace(problem, body=problem.body.halved())
    _compare(arrays, _observables(finer.correct(problem, contacts), problem))


def _compare(arrays: Arrays, finer: Arrays) -> None:
    """Add the differences to a solution on another grid, and flag what they cast doubt on where they are large.

    A converged point whose finer copy failed keeps NaN estimates and is flagged too: nothing vouches for it.
    """
    difference = {name: np.abs(arrays[name] - finer[name]) for name in ESTIMATED}
    # Multiplied out, so that a contact without asperities (0 <= 0) is trusted and NaN is not.
    trusted = {
        "inaccurate_friction": difference["friction_coefficient_fluid"] <= FRICTION_ERROR_LIMIT,
        "inaccurate_separation": difference["separation_min"]
        <= SEPARATION_ERROR_LIMIT * finer["separation_min"],
        "inaccurate_area": (
            difference["real_contact_width"] <= WIDTH_ERROR_LIMIT * finer["real_contact_width"]
        )
        | (finer["contact_area_ratio_max"] < NEGLIGIBLE_AREA),
    }
    arrays["friction_coefficient_fluid_error"] = difference["friction_coefficient_fluid"]
    arrays["separation_min_error"] = difference["separation_min"] / finer["separation_min"]
    arrays["real_contact_width_error"] = difference["real_contact_width"]
    for name, good in trusted.items():
        arrays["flags"] = arrays["flags"] | np.where(arrays["converged"] & ~good, FLAGS[name], 0)


def _fields(contacts: Sequence[LubricatedContact]) -> Arrays:
    return stack(
        [
            {
                "x": contact.positions,
                "fluid_pressure": contact.fluid_pressure,
                "solid_pressure": contact.solid_pressure,
                "separation": contact.separation,
            }
            for contact in contacts
        ]
    )
