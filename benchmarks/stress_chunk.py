"""A part of the stress test: random contacts by the default solver, from cold, along speeds, and from other solutions.

A family is ten points: one random contact at four random speeds in one sweep, and at two more from a solution at one
of those; and four random contacts at one speed each, from cold. One point in ten is solved again by spectral elements
of order 16, which the estimated error is held against. (Spectral elements need no start and do not use the one they
are given; so some points are solved by finite volumes from such a start, beside the ten.)
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import xarray as xr
from random_scenes import STRESS_RANGES, STRESS_SPEEDS, Scene, log_uniform, random_scenes

from softlub.datasets.variables import FLAGS
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.auto import Auto
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.spectral import Spectral
from softlub.lubrication.speed_sweep import ESTIMATED, Corrector, Solver, sweep_arrays

FAMILIES = 250
CONTINUED, COLD, STARTED = 4, 4, 2
TRUE_ORDER = 16
CHECK_EVERY = 10
"""One family member in so many is solved again at order 16, and by finite volumes from a random start."""
KINDS = ("continued", "cold", "started", "finite volumes, started")

Row = dict[str, float | int | str | bool]


@dataclass
class Recording:
    """A solver that remembers the contacts of its last sweep."""

    solver: Solver
    contacts: list[LubricatedContact] = field(default_factory=list)

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        self.contacts = self.solver.sweep(problem, speeds)
        return self.contacts


@dataclass(frozen=True)
class FromStart:
    """A solver that begins every point at one given solution."""

    solver: Auto | FiniteVolume
    start: LubricatedContact

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        return [self.solver.solve(problem.at(speed=float(speed)), self.start) for speed in speeds]


def measure(chunk: int, families: int = FAMILIES) -> xr.Dataset:
    """One chunk, drawn from its own seed."""
    generator = np.random.default_rng([8, chunk])
    rows: list[Row] = []
    for index in range(families):
        rows += _family(generator, index % CHECK_EVERY)
    return xr.Dataset(
        {name: ("point", np.array([row[name] for row in rows])) for name in rows[0]},
        attrs={
            "title": f"Stress test, part {chunk}",
            "chunk": chunk,
            "timed": f"{families} families of {CONTINUED + COLD + STARTED} random points by the solver auto",
        },
    )


def _family(generator: np.random.Generator, checked: int) -> list[Row]:
    """Ten points by the default solver, of which the one numbered `checked` is checked, and one by finite volumes."""
    swept, *single = random_scenes(generator, STRESS_RANGES, 1 + COLD)
    speeds = log_uniform(generator, STRESS_SPEEDS, CONTINUED + COLD + STARTED)
    checks = [position == checked for position in range(CONTINUED + COLD + STARTED)]
    along = Recording(Auto())
    rows = _points("continued", swept, speeds[:CONTINUED], along, Auto().refined(), checks[:CONTINUED])
    for position, scene in enumerate(single, start=CONTINUED):
        chosen = slice(position, position + 1)
        rows += _points("cold", scene, speeds[chosen], Recording(Auto()), Auto().refined(), checks[chosen])
    solved = [contact for contact in along.contacts if contact.converged]
    start = solved[int(generator.integers(len(solved)))] if solved else None
    if start is None:
        return rows
    for position in range(CONTINUED + COLD, CONTINUED + COLD + STARTED):
        solver, finer = FromStart(Auto(), start), Auto().refined()
        chosen = slice(position, position + 1)
        rows += _points("started", swept, speeds[chosen], Recording(solver), finer, checks[chosen])
    if checked == 0:
        solver, finer = FromStart(FiniteVolume(), start), FiniteVolume().refined()
        rows += _points("finite volumes, started", swept, speeds[-1:], Recording(solver), finer, [True])
    return rows


def _points(
    kind: str, scene: Scene, speeds: np.ndarray, solver: Recording, finer: Corrector, checked: Sequence[bool]
) -> list[Row]:
    """Rows of one scene at some speeds."""
    problem = scene.problem()
    arrays = sweep_arrays(problem, [scene.load], speeds.tolist(), solver, finer)
    found = {name: values[0] for name, values in arrays.items()}
    strength = scene.shear_strength / scene.load
    rows = []
    for index, speed in enumerate(speeds.tolist()):
        point = {name: values[index].item() for name, values in found.items()}
        row: Row = {"kind": kind, "solver": solver.contacts[index].solver, "speed": speed, **scene._asdict()}
        row |= {
            name: point[name] for name in ("converged", "flags", "residual", "load_error", "solver_seconds")
        }
        row["friction_coefficient"] = point[ESTIMATED[0]] + strength * point[ESTIMATED[2]]
        row["separation_min"] = point["separation_min"]
        row["error_friction"] = point[f"{ESTIMATED[0]}_error"] + strength * point[f"{ESTIMATED[2]}_error"]
        row["error_separation"] = point["separation_min_error"]
        rows.append(row | _true_errors(row, scene, problem, checked[index]))
    return rows


def _true_errors(row: Row, scene: Scene, problem: Problem, is_checked: bool) -> Row:
    """Differences to order 16 where the point is checked; NaN elsewhere."""
    unknown = {"true_error_friction": np.nan, "true_error_separation": np.nan, "checked": is_checked}
    if not (is_checked and row["converged"]):
        return unknown
    exact = sweep_arrays(problem, [scene.load], [row["speed"]], Spectral(order=TRUE_ORDER))
    point = {name: values[0, 0] for name, values in exact.items()}
    if point["flags"] & FLAGS["not_converged"]:
        return unknown
    friction = point[ESTIMATED[0]] + scene.shear_strength / scene.load * point[ESTIMATED[2]]
    return unknown | {
        "true_error_friction": abs(row["friction_coefficient"] - friction),
        "true_error_separation": abs(row["separation_min"] / point["separation_min"] - 1),
    }
