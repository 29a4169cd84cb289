"""The spectral solver as a configured callable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.spectral import outcome as columns
from softlub.lubrication.solvers.spectral.basis import FloatArray, lobatto_basis
from softlub.lubrication.solvers.spectral.correction import known, settle
from softlub.lubrication.solvers.spectral.equations import Scene
from softlub.lubrication.solvers.spectral.march import MAX_ELEMENTS, march
from softlub.lubrication.solvers.spectral.outcome import Outcome, make_outcome
from softlub.lubrication.solvers.spectral.remainder import remainder_rule
from softlub.pressure_table import PressureTable

# Solid pressure in units of p0 below which it is left out: e^-26.
LOG_DEAD_PRESSURE = -26.0


def dead_gap(first: float, step: float, coefficients: FloatArray) -> float:
    """Separation at which a scaled law has fallen to e^-26 p0; 0 without a law."""
    if not len(coefficients):
        return 0.0
    values = coefficients[:, 0]
    below = np.flatnonzero(values < LOG_DEAD_PRESSURE)
    if len(below):
        return float(np.exp(first + step * below[0]))
    c = coefficients[-1]
    end = float(np.exp(first + step * len(coefficients)))
    rate = float(c[1] + 2 * c[2] + 3 * c[3]) / step / end
    return end + max(LOG_DEAD_PRESSURE - float(c.sum()), 0.0) / rate if rate < 0 else end


@dataclass(frozen=True)
class Spectral:
    """Spectral elements with the rupture point as an unknown, continued along speed.

    Parameters
    ----------
    order : int
        Polynomial order p of the elements; the error falls geometrically with it.
    tolerance : float
        Largest residual of a row relative to its own terms, in Hertz units.
    load_tolerance : float
        Largest relative error of the load of a converged point.
    """

    order: int = 8
    tolerance: float = 1e-9
    load_tolerance: float = 1e-10

    def refined(self) -> Spectral:
        """The solver two orders higher, against which this one's error is estimated."""
        return replace(self, order=self.order + 2)

    def solve(self, problem: Problem, start: LubricatedContact | None = None) -> LubricatedContact:
        """Solve one point.

        Parameters
        ----------
        problem : Problem
            On a half-space, with the cavitation condition "reynolds".
        start : LubricatedContact, optional
            Not needed: the march begins from a thick film whatever the speed.

        Returns
        -------
        LubricatedContact
            Flagged as not converged where the march did not arrive.

        Raises
        ------
        ValueError
            If the body, the cavitation condition or the speed is not one that this solver knows.
        """
        return self.sweep(problem, [problem.speed])[0]

    def sweep(self, problem: Problem, speeds: Sequence[float] | FloatArray) -> list[LubricatedContact]:
        """Solve one problem at many speeds, in the order in which they are given.

        Parameters
        ----------
        problem : Problem
            As in `solve`; its own speed is not used.
        speeds : sequence of float
            Sliding speeds [m/s], in any order.

        Returns
        -------
        list of LubricatedContact

        Raises
        ------
        ValueError
            As in `solve`.
        """
        wanted = np.asarray(speeds, dtype=float)
        self._check(problem, wanted)
        unique, place = np.unique(wanted, return_inverse=True)
        scene = hertz_scene(problem)
        outcome = make_outcome(len(unique), MAX_ELEMENTS, self.order)
        march(
            log_speed_numbers(problem, unique),
            scene,
            lobatto_basis(self.order),
            remainder_rule(self.order),
            dead_gap(scene.first, scene.step, scene.coefficients),
            self.tolerance,
            outcome,
        )
        contacts = self._contacts(problem, unique, outcome)
        return [contacts[k] for k in place]

    def correct(self, problem: Problem, contacts: Sequence[LubricatedContact]) -> list[LubricatedContact]:
        """Solve the points of given contacts at this order, each begun from the contact.

        Parameters
        ----------
        problem : Problem
            That of the contacts; its own speed is not used.
        contacts : sequence of LubricatedContact
            Of this solver at another order.

        Returns
        -------
        list of LubricatedContact
            Contacts that are not converged as they are; those that lead to no solution are solved by `sweep`.

        Raises
        ------
        ValueError
            As in `solve`, and if a contact is another solver's, whose nodes make no elements.
        """
        solved = [contact for contact in contacts if contact.converged]
        if not solved:
            return list(contacts)
        speeds = np.array([contact.speed for contact in solved])
        self._check(problem, speeds)
        self._check_own(solved)
        scene, hertz = hertz_scene(problem), problem.hertz
        outcome = make_outcome(len(solved), MAX_ELEMENTS, self.order)
        basis, rule = lobatto_basis(self.order), remainder_rule(self.order)
        for row, log_speed in enumerate(log_speed_numbers(problem, speeds)):
            start = known(solved[row], hertz, scene.half_domain, log_speed)
            settle(row, start, scene, basis, rule, self.tolerance, outcome)
        corrected = self._contacts(problem, speeds, outcome)
        astray = [contact.speed for contact in corrected if not contact.converged]
        swept = iter(self.sweep(problem, astray) if astray else ())
        settled = iter([one if one.converged else next(swept) for one in corrected])
        return [next(settled) if one.converged else one for one in contacts]

    @staticmethod
    def _check_own(contacts: Sequence[LubricatedContact]) -> None:
        others = sorted({contact.solver for contact in contacts if not contact.breaks})
        if others:
            raise ValueError(
                f"the spectral solver corrects its own contacts alone, not those of {', '.join(others)}; "
                "use the refined copy of the solver that found them"
            )

    @staticmethod
    def _check(problem: Problem, speeds: FloatArray) -> None:
        problem.refuse_meshed("spectral")
        cavitation = problem.lubricant.cavitation
        if cavitation != "reynolds":
            raise ValueError(
                f"the spectral solver knows no cavitation {cavitation!r}, only 'reynolds'; use finite_volume"
            )
        if not (speeds.ndim == 1 and np.all(np.isfinite(speeds)) and np.all(speeds > 0)):
            raise ValueError(f"speeds must be positive and finite, not {speeds}")

    def _breaks(self, elements: float) -> range:
        return range(0, int(elements) * self.order + 1, self.order)

    def _contacts(self, problem: Problem, speeds: FloatArray, outcome: Outcome) -> list[LubricatedContact]:
        """Results in SI units, as views of a few arrays."""
        hertz = problem.hertz
        half_width, pressure, gap = hertz.half_width, hertz.peak_pressure, hertz.gap_scale
        numbers = outcome.numbers
        reached = np.isfinite(numbers[:, columns.COUNT])
        counts = np.where(reached, numbers[:, columns.COUNT], 1).astype(int)
        most = int(counts.max(initial=1))
        units = np.array([half_width, half_width, pressure, pressure, gap, pressure / half_width])
        fields = outcome.fields[:, :, :most] * units[:, None, None]
        fields[:, ~reached] = np.nan
        converged = (
            (numbers[:, columns.RESIDUAL] <= self.tolerance * 100)
            & (numbers[:, columns.LOAD_ERROR] <= self.load_tolerance)
            & (numbers[:, columns.GAP_MIN] > 0)
            & (numbers[:, columns.FLUID_MIN] > -1e-6)
        )
        contacts = []
        for row, speed in enumerate(speeds.tolist()):
            x, weight, fluid, solid, separation, gradient = fields[:, row, : counts[row]]
            scalars = numbers[row].tolist()
            contacts.append(
                LubricatedContact(
                    load=problem.load,
                    speed=speed,
                    positions=x,
                    weights=weight,
                    fluid_pressure=fluid,
                    solid_pressure=solid,
                    separation=separation,
                    fluid_pressure_gradient=gradient,
                    rigid_approach=scalars[columns.APPROACH] * gap,
                    separation_min=scalars[columns.GAP_MIN] * gap,
                    separation_central=scalars[columns.GAP_CENTRAL] * gap,
                    rupture=scalars[columns.RUPTURE] * half_width,
                    breaks=self._breaks(scalars[columns.ELEMENTS]) if reached[row] else range(0),
                    converged=bool(converged[row]),
                    iterations=int(scalars[columns.STEPS]) if reached[row] else 0,
                    residual=scalars[columns.RESIDUAL],
                    load_error=scalars[columns.LOAD_ERROR],
                    solver="spectral",
                )
            )
        return contacts


def log_speed_numbers(problem: Problem, speeds: FloatArray) -> FloatArray:
    """ln λ; rounded, so that the same contact in other units takes the same path, decision by decision."""
    numbers = problem.hertz.speed_number(1.0, 1.0) * (problem.lubricant.viscosity * speeds)
    return np.round(np.log(numbers), 12).astype(np.float64)


def hertz_scene(problem: Problem) -> Scene:
    """Domain, roughness and contact law of a problem in Hertz units."""
    hertz = problem.hertz
    table: PressureTable = problem.law.table
    coefficients: NDArray[np.float64] = table.coefficients.copy()
    coefficients[:, 0] -= np.log(hertz.peak_pressure)
    return Scene(
        problem.domain / hertz.half_width,
        problem.rms_roughness / hertz.gap_scale,
        table.first - float(np.log(hertz.gap_scale)),
        table.step,
        coefficients,
    )
