"""The finite volume solver of lubricated line contacts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from softlub.lubrication.meshed_body import MeshedBody
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.fields import contact_fields
from softlub.lubrication.solvers.finite_volume.grid import GRIDS, OwnNodes
from softlub.lubrication.solvers.finite_volume.level import Level, make_level, state_of
from softlub.lubrication.solvers.finite_volume.march import march, march_refined
from softlub.lubrication.solvers.finite_volume.newton import Iterate

COARSEST = 129
"""Grids of fewer nodes are not used to prepare finer ones."""


@dataclass(frozen=True)
class FiniteVolume:
    """Monolithic semi-smooth Newton method with continuation in speed.

    Parameters
    ----------
    nodes : int
        Number of nodes n on a half-space; a meshed body brings its own.
    grid : {"graded", "even"}
        Where they lie on a half-space, see `grid`.
    tolerance : float
        Largest residual of a converged point, in units of the Hertz pressure.
    most_steps : int
        Newton steps after which a continuation step is halved.
    """

    nodes: int = 257
    grid: Literal["graded", "even"] = "graded"
    tolerance: float = 1e-10
    most_steps: int = 15

    def refined(self) -> FiniteVolume:
        """The solver on 2n - 1 nodes, against which this one's error is estimated."""
        return replace(self, nodes=2 * self.nodes - 1)

    def solve(self, problem: Problem, start: LubricatedContact | None = None) -> LubricatedContact:
        """Solve one point.

        Parameters
        ----------
        problem : Problem
        start : LubricatedContact, optional
            A solution nearby, of any solver; where it does not lead to the solution the point is solved from cold.

        Returns
        -------
        LubricatedContact
            Flagged as not converged where no way led to the solution.
        """
        if start is not None:
            found = self._from_start(problem, self.level(problem, self.node_count(problem)), start)
            if found.converged:
                return found
        return self.sweep(problem, [problem.speed])[0]

    def correct(self, problem: Problem, contacts: Sequence[LubricatedContact]) -> list[LubricatedContact]:
        """Solve the points of given contacts on this grid, each begun from the contact.

        Parameters
        ----------
        problem : Problem
            That of the contacts; its own speed is not used.
        contacts : sequence of LubricatedContact
            Of any solver and grid.

        Returns
        -------
        list of LubricatedContact
            Contacts that are not converged as they are; those that lead to no solution are solved by `sweep`.
        """
        corrected = list(contacts)
        known = [k for k, contact in enumerate(contacts) if contact.converged]
        if known:
            # The grid of a sweep is that of its slowest speed.
            slowest = problem.at(speed=min(contact.speed for contact in contacts))
            level = self.level(slowest, self.node_count(problem))
            for k in known:
                corrected[k] = self._from_start(problem.at(speed=contacts[k].speed), level, contacts[k])
        failed = [k for k in known if not corrected[k].converged]
        if failed:
            swept = self.sweep(problem, [contacts[k].speed for k in failed])
            for k, contact in zip(failed, swept, strict=True):
                corrected[k] = contact
        return corrected

    @staticmethod
    def _from_start(problem: Problem, level: Level, start: LubricatedContact) -> LubricatedContact:
        # An iteration that diverges overflows; its residual tells.
        with np.errstate(all="ignore"):
            iterate = level.correct(problem.speed_number, state_of(level, problem, start))
            return contact_fields(problem, level.contact, iterate)

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        """Solve at every speed, continued along speed.

        Parameters
        ----------
        problem : Problem
            Its own speed is not used.
        speeds : sequence of float
            v [m/s], in any order.

        Returns
        -------
        list of LubricatedContact
            In the order of `speeds`.

        Raises
        ------
        ValueError
            If there is no speed, or one is not positive and finite.
        """
        return self.sweep_levels(problem, speeds)[-1]

    def sweep_levels(self, problem: Problem, speeds: Sequence[float]) -> list[list[LubricatedContact]]:
        """As `sweep`, on each of the nested grids that lead to this one, the coarsest first."""
        wanted = np.asarray(speeds, dtype=float)
        if wanted.size == 0 or not np.all(np.isfinite(wanted) & (wanted > 0)):
            raise ValueError(f"speeds must be positive and finite, not {wanted}")
        unique, place = np.unique(wanted, return_inverse=True)
        points = [problem.at(speed=float(speed)) for speed in unique]
        # A diverging iteration overflows; it is found by its residual and flagged.
        with np.errstate(all="ignore"):
            levels = self._solve_levels(points)
        return [[contacts[k] for k in place] for contacts in levels]

    def _solve_levels(self, points: Sequence[Problem]) -> list[list[LubricatedContact]]:
        """One contact a point, speeds ascending, on each of the nested grids."""
        speed_numbers = [point.speed_number for point in points]
        results: list[list[LubricatedContact]] = []
        iterates: list[Iterate] = []
        for nodes in self.nested(points[0]):
            level = self.level(points[0], nodes)
            if iterates:
                iterates = march_refined(level, speed_numbers, iterates)
            else:
                iterates = march(level, speed_numbers)
            pairs = zip(points, iterates, strict=True)
            results.append([contact_fields(point, level.contact, iterate) for point, iterate in pairs])
        return results

    def node_count(self, problem: Problem) -> int:
        """Number of nodes of the finest grid."""
        body = problem.body
        return body.node_count if isinstance(body, MeshedBody) else self.nodes

    def nested(self, problem: Problem) -> list[int]:
        """Numbers of nodes n of the grids on the way to the finest, each 2n - 1 of the one before."""
        counts = [self.node_count(problem)]
        while counts[0] % 2 and (counts[0] + 1) // 2 >= COARSEST:
            counts.insert(0, (counts[0] + 1) // 2)
        return counts

    def level(self, problem: Problem, nodes: int) -> Level:
        """The problem on a grid of so many nodes."""
        body = problem.body
        grid = OwnNodes(body) if isinstance(body, MeshedBody) else GRIDS[self.grid]
        return make_level(problem, grid, nodes, self.tolerance, self.most_steps)
