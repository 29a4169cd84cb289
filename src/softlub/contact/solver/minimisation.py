"""From a first pressure to a converged one: single precision as far as it carries, double for what counts.

Float32 halves the memory of an iteration and nearly its time, and its rounding stays below the usual tolerance: the
gap rebuilt in float64 at the end agrees, and where it does not, the iteration goes on from there. The result is
always judged in float64.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver import free_set
from softlub.contact.solver.compliance import FreeCompliance, PeriodicCompliance
from softlub.contact.solver.gradients import FreeSetGradients, Progress
from softlub.contact.solver.projection import project_onto_load

FloatArray = NDArray[np.float64]

SINGLE_LIMIT = 3e-7
"""Residual below which rounding in single precision no longer lets the iteration fall."""
MARGIN = 0.9
"""How far below the tolerance single precision aims, for its own rounding."""
FULL_CONTACT_DOUBT = 1e-4
"""Relative doubt of single precision about the load of full contact."""
SINGLE_ATTEMPTS = 3
"""Rebuilds after which double precision takes over."""


class Minimisation:
    """Contact of one dimensionless surface, for any number of loads.

    Parameters
    ----------
    heights : ndarray, shape (nx, ny)
        Heights over h_rms, of mean zero.
    periodic : bool
        Whether the surface repeats itself; else it is surrounded by an unloaded half-space.

    Attributes
    ----------
    pressure, gap : ndarray, shape (nx, ny)
        The solution, dimensionless, in double precision; the gap includes the contact `level`.
    level : float
        Mean of the gap over the points under pressure.
    residual : float
        Root mean square of gap less level over the free set.
    """

    def __init__(self, heights: FloatArray, periodic: bool) -> None:
        self.heights = heights
        self.periodic = periodic
        kind = PeriodicCompliance if periodic else FreeCompliance
        shape = (heights.shape[0], heights.shape[1])
        self._single = kind(shape, np.float32)
        self._double = kind(shape, np.float64)
        self._minimisers: dict[str, FreeSetGradients] = {}
        self.pressure: FloatArray = np.empty(0)
        self.gap: FloatArray = np.empty(0)
        self.level = self.residual = self._deepest = np.nan

    @property
    def convolutions(self) -> int:
        """Pairs of transforms of the whole grid so far."""
        return self._single.count + self._double.count

    def full_contact(self, load: float) -> bool:
        """Try full contact: whether its pressure is nowhere negative; then it is the solution.

        In full contact every wave of the heights needs the pressure |θ| times its amplitude, exactly.
        """
        if not self.periodic:
            return False
        mean = load / self.heights.size
        if np.isnan(self._deepest):
            self._single.source[:] = self.heights
            self._single.stiffness_of_source()
            self._deepest = -float(self._single.result.min())
        if mean < (1 - FULL_CONTACT_DOUBT) * self._deepest:
            return False
        self._double.source[:] = self.heights
        self._double.stiffness_of_source()
        if float(self._double.result.min()) + mean < 0:
            return False
        self._rebuild(self._double.result + mean, load)
        return True

    def first_pressure(self, load: float) -> NDArray[np.float32]:
        """Pressure to begin with: that of full contact, clipped where it pulls, and shifted to the load."""
        self._single.source[:] = self.heights if self.periodic else self.heights - self.heights.min()
        self._single.stiffness_of_source()
        pressure = np.empty(self.heights.shape, np.float32)
        project_onto_load(self._single.result, load, pressure)
        return pressure

    def solve(self, pressure: NDArray[np.floating], load: float, tolerance: float, limit: int) -> Progress:
        """Minimise from a first pressure that carries the load.

        Parameters
        ----------
        pressure : ndarray, shape (nx, ny)
        load : float
            Sum of the pressure.
        tolerance : float
            Residual to reach.
        limit : int
            Largest number of iterations.

        Returns
        -------
        Progress
            `residual` tells whether the tolerance was reached.
        """
        progress = Progress()
        if tolerance >= SINGLE_LIMIT:
            minimiser = self._minimiser("single", load)
            minimiser.pressure[:] = pressure
            self._single.source[:] = pressure
            self._single.apply()
            np.subtract(self._single.result, self.heights, out=minimiser.gap, casting="same_kind")
            for _ in range(SINGLE_ATTEMPTS):
                reached = minimiser.minimise(MARGIN * tolerance, limit, progress)
                self._rebuild(minimiser.pressure, load, minimiser)
                if not reached or self.residual <= tolerance:
                    break
                minimiser.pressure[:] = self.pressure
                np.subtract(self.gap, self.level, out=minimiser.gap, casting="same_kind")
        else:
            self._rebuild(pressure, load)
        if self.residual > tolerance:
            minimiser = self._minimiser("double", load)
            minimiser.pressure[:] = self.pressure
            minimiser.gap[:] = self.gap
            minimiser.minimise(MARGIN * tolerance, limit, progress)
            self._rebuild(minimiser.pressure, load, minimiser)
        progress.residuals.append(self.residual)
        return progress

    def _minimiser(self, precision: str, load: float) -> FreeSetGradients:
        if precision not in self._minimisers:
            compliance = self._single if precision == "single" else self._double
            self._minimisers[precision] = FreeSetGradients(compliance, self.periodic)
        self._minimisers[precision].load = load
        return self._minimisers[precision]

    def _rebuild(
        self, pressure: NDArray[np.floating], load: float, minimiser: FreeSetGradients | None = None
    ) -> None:
        """Scale a pressure to the load and compute its gap, level and residual, all in double precision."""
        source = self._double.source
        source[:] = pressure
        if minimiser is not None:
            source[minimiser.pressure <= free_set.RELEASE * (minimiser.gap - minimiser.level)] = 0
        source *= load / source.sum()
        self._double.apply()
        self.pressure = source
        self.gap = np.subtract(self._double.result, self.heights, out=self._double.result)
        carrying = source > 0
        self.level = float(self.gap.mean(where=carrying))
        count, square = free_set.residual_squares(source, self.gap, self.level)
        self.residual = float(np.sqrt(square / count))
