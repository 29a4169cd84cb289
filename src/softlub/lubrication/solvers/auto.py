"""The default: spectral elements, then two orders more of them, then finite volumes for what is left or beyond them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from softlub.lubrication.meshed_body import MeshedBody
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.spectral import Spectral


@dataclass(frozen=True)
class Auto:
    """Spectral elements with higher orders and finite volumes to fall back on.

    What one order leaves unsolved the one two above mostly solves, and far better than finite volumes would: such
    points lie in deep boundary lubrication, with films of a nanometre. Mass-conserving films and meshed bodies go to
    finite volumes at once.

    Parameters
    ----------
    spectral : Spectral
    finite_volume : FiniteVolume
    """

    spectral: Spectral = field(default_factory=Spectral)
    finite_volume: FiniteVolume = field(default_factory=FiniteVolume)

    def solve(self, problem: Problem, start: LubricatedContact | None = None) -> LubricatedContact:
        """Solve one point.

        Parameters
        ----------
        problem : Problem
        start : LubricatedContact, optional
            A solution nearby, of use to finite volumes alone.

        Returns
        -------
        LubricatedContact
        """
        if _beyond_spectral(problem):
            return self.finite_volume.solve(problem, start)
        return self.sweep(problem, [problem.speed])[0]

    def sweep(self, problem: Problem, speeds: Sequence[float]) -> list[LubricatedContact]:
        """Solve at every speed, continued along speed.

        Parameters
        ----------
        problem : Problem
        speeds : sequence of float
            v [m/s], in any order.

        Returns
        -------
        list of LubricatedContact
            In the order of `speeds`.
        """
        if _beyond_spectral(problem):
            return self.finite_volume.sweep(problem, speeds)
        contacts = self.spectral.sweep(problem, speeds)
        for fallback in (self.spectral.refined(), self.finite_volume):
            unsolved = [i for i, contact in enumerate(contacts) if not contact.converged]
            if not unsolved:
                break
            repairs = fallback.sweep(problem, [speeds[i] for i in unsolved])
            for i, repair in zip(unsolved, repairs, strict=True):
                contacts[i] = repair if repair.converged else contacts[i]
        return contacts

    def correct(self, problem: Problem, contacts: Sequence[LubricatedContact]) -> list[LubricatedContact]:
        """Solve the points of given contacts on these grids or finer ones, each by the solver that found it.

        Parameters
        ----------
        problem : Problem
            That of the contacts; its own speed is not used.
        contacts : sequence of LubricatedContact

        Returns
        -------
        list of LubricatedContact
            Contacts that are not converged as they are.
        """
        places: dict[Spectral | FiniteVolume, list[int]] = {}
        for place, contact in enumerate(contacts):
            places.setdefault(self._finer_than(contact), []).append(place)
        corrected = list(contacts)
        for solver, own in places.items():
            for place, contact in zip(own, solver.correct(problem, [contacts[k] for k in own]), strict=True):
                corrected[place] = contact
        return corrected

    def _finer_than(self, contact: LubricatedContact) -> Spectral | FiniteVolume:
        if contact.solver != "spectral":
            return self.finite_volume
        return self.spectral if contact.breaks.step < self.spectral.order else self.spectral.refined()

    def refined(self) -> Auto:
        """The same on finer grids, whose difference estimates the error."""
        return Auto(self.spectral.refined(), self.finite_volume.refined())


def _beyond_spectral(problem: Problem) -> bool:
    return problem.lubricant.cavitation == "mass_conserving" or isinstance(problem.body, MeshedBody)
