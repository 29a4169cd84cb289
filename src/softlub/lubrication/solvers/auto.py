"""The default: spectral elements, and finite volumes for the points that those leave unsolved or cannot treat."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import compress

from softlub.lubrication.meshed_body import MeshedBody
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.spectral import Spectral


@dataclass(frozen=True)
class Auto:
    """Spectral elements with finite volumes to fall back on.

    Mass-conserving films and meshed bodies go to the latter at once.

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
            A solution nearby.

        Returns
        -------
        LubricatedContact
        """
        if _beyond_spectral(problem):
            return self.finite_volume.solve(problem, start)
        contact = self.spectral.solve(problem, start)
        return contact if contact.converged else self.finite_volume.solve(problem)

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
        unsolved = [i for i, contact in enumerate(contacts) if not contact.converged]
        if unsolved:
            repairs = self.finite_volume.sweep(problem, [speeds[i] for i in unsolved])
            for i, repair in zip(unsolved, repairs, strict=True):
                contacts[i] = repair if repair.converged else contacts[i]
        return contacts

    def correct(self, problem: Problem, contacts: Sequence[LubricatedContact]) -> list[LubricatedContact]:
        """Solve the points of given contacts on these grids, each by the solver that found it.

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
        spectral = [contact.solver == "spectral" for contact in contacts]
        by_elements = iter(self.spectral.correct(problem, list(compress(contacts, spectral))))
        others = [contact for contact, own in zip(contacts, spectral, strict=True) if not own]
        by_volumes = iter(self.finite_volume.correct(problem, others))
        return [next(by_elements if own else by_volumes) for own in spectral]

    def refined(self) -> Auto:
        """The same on finer grids, whose difference estimates the error."""
        return Auto(self.spectral.refined(), self.finite_volume.refined())


def _beyond_spectral(problem: Problem) -> bool:
    return problem.lubricant.cavitation == "mass_conserving" or isinstance(problem.body, MeshedBody)
