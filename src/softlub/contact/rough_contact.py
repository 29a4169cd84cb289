"""Contact of a rough surface with an elastic half-space at given loads."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from softlub.contact.rough_surface import check_pressure, check_tolerance, scaled_heights, scales
from softlub.contact.solution import ContactSolution
from softlub.contact.solver.gradients import Progress
from softlub.contact.solver.minimisation import Minimisation
from softlub.surfaces.topography import Topography

ITERATIONS = 500
"""Iterations after which a load is given back as not converged."""


class RoughContact:
    """One surface and modulus, ready for any number of loads; keeps its transforms and arrays between them.

    Parameters
    ----------
    topography : Topography
    modulus : float
        E* = E / (1 - ν²) [Pa].
    tolerance : float
        Root mean square gap over the contact at convergence, over h_rms.
    iterations : int
        Iterations a load at most.

    Raises
    ------
    ValueError
        If modulus or tolerance make no sense, or the surface is constant.
    MemoryError
        If the grid will not fit; before anything is allocated.
    """

    def __init__(
        self, topography: Topography, modulus: float, tolerance: float = 1e-6, iterations: int = ITERATIONS
    ) -> None:
        check_tolerance(tolerance)
        self.topography = topography
        self._scales = scales(topography, modulus)
        self._tolerance = tolerance
        self._iterations = iterations
        self._minimisation = Minimisation(
            scaled_heights(topography, self._scales.height), topography.periodic
        )
        self._highest = float(self._minimisation.heights.max())

    def solve(self, pressure: float, start: NDArray[np.floating] | None = None) -> ContactSolution:
        """Contact at a nominal pressure.

        Parameters
        ----------
        pressure : float
            Mean pressure over the whole surface [Pa].
        start : ndarray, shape (nx, ny), optional
            Pressure map to begin with, in any unit: it is scaled to the load.

        Returns
        -------
        ContactSolution

        Raises
        ------
        ValueError
            If the pressure is negative or not finite, or the start has another shape.
        """
        check_pressure(pressure)
        if pressure == 0:
            return self._untouched()
        before = self._minimisation.convolutions
        load = pressure / self._scales.pressure * self.topography.heights.size
        full = self._minimisation.full_contact(load)
        progress = Progress() if full else self._minimise(load, start)
        return self._solution(pressure, full, progress, self._minimisation.convolutions - before)

    def _minimise(self, load: float, start: NDArray[np.floating] | None) -> Progress:
        found = self._minimisation
        if start is None:
            return found.solve(found.first_pressure(load), load, self._tolerance, self._iterations)
        return found.solve(self._given(start, load), load, self._tolerance, self._iterations)

    def _given(self, start: NDArray[np.floating], load: float) -> NDArray[np.float32]:
        if start.shape != self.topography.heights.shape:
            raise ValueError(
                f"start of shape {start.shape} on a surface of shape {self.topography.heights.shape}: "
                "give the pressure of a solution on the same grid"
            )
        total = float(start.sum(dtype=float, where=start > 0))
        if not 0 < total < np.inf:
            raise ValueError("start carries no load: give a pressure map with positive values")
        return np.maximum(start * (load / total), 0).astype(np.float32)

    def _solution(
        self, pressure: float, full: bool, progress: Progress, convolutions: int
    ) -> ContactSolution:
        found = self._minimisation
        residual = found.residual
        pressures, gap = found.take()
        pressures *= self._scales.pressure  # in place: large grids have no room for other arrays
        gap *= self._scales.height
        return ContactSolution(
            pressure=pressures,
            gap=gap,
            nominal_pressure=pressure,
            rigid_approach=(self._highest + found.level) * self._scales.height,
            periodic=self.topography.periodic,
            full_contact=full,
            converged=residual <= self._tolerance,
            iterations=progress.iterations,
            convolutions=convolutions,
            residual=residual,
            residuals=tuple(progress.residuals) or (residual,),
        )

    def _untouched(self) -> ContactSolution:
        heights = self.topography.heights
        return ContactSolution(
            pressure=np.zeros(heights.shape),
            gap=np.asarray(heights.max() - heights),
            nominal_pressure=0.0,
            rigid_approach=0.0,
            periodic=self.topography.periodic,
            full_contact=False,
            converged=True,
            iterations=0,
            convolutions=0,
            residual=0.0,
            residuals=(0.0,),
        )


def solve(
    topography: Topography,
    modulus: float,
    pressure: float,
    tolerance: float = 1e-6,
    start: ContactSolution | None = None,
) -> ContactSolution:
    """Contact of a rough surface with an elastic half-space at one nominal pressure.

    Solves the source's equations 4-30 to 4-34 (gap zero and pressure positive in contact, the reverse elsewhere,
    the load balanced). Periodic surfaces use the half-space's compliance 2 / (E* |q|) wave by wave, others Love's
    rectangles on an unloaded surrounding.

    Parameters
    ----------
    topography : Topography
        Rigid rough surface, or the sum of both bodies' roughness.
    modulus : float
        E* = E / (1 - ν²) of the elastic body [Pa]; of two bodies 1/E* is the sum.
    pressure : float
        Mean pressure over the whole surface [Pa]. Beyond full contact the solution says `full_contact`.
    tolerance : float
        Root mean square gap over the contact at convergence, over h_rms.
    start : ContactSolution, optional
        Contact of the same grid at another load to begin with.

    Returns
    -------
    ContactSolution
        Flagged where it did not converge.

    Raises
    ------
    ValueError
        If pressure, modulus or tolerance make no sense, or the surface is constant.
    MemoryError
        If the grid will not fit, with an estimate.
    """
    check_pressure(pressure)
    contact = RoughContact(topography, modulus, tolerance)
    return contact.solve(pressure, None if start is None else start.pressure)
