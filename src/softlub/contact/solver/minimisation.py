"""From a first pressure to a converged one: single precision as far as it carries, double for what counts.

Float32 halves the memory of an iteration and nearly its time, and its rounding stays below the usual tolerance: the
gap rebuilt in float64 at the end agrees, and where it does not, the iteration goes on from there. The result is
always judged in float64.
"""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver import free_set
from softlub.contact.solver.compliance import FreeCompliance, PeriodicCompliance
from softlub.contact.solver.gradients import FreeSetGradients, Progress
from softlub.contact.solver.projection import project_onto_load
from softlub.contact.solver.transforms import QUICK

FloatArray = NDArray[np.float64]

SINGLE_LIMIT = 5e-7
"""Residual below which rounding in single precision soon no longer lets the iteration fall."""
MARGIN = 0.9
"""How far below the tolerance single precision aims, for its own rounding."""
FULL_CONTACT_DOUBT = 1e-4
"""Relative doubt of single precision about the load of full contact."""
CASCADE_POINTS = 1024 * 1024
"""Points from which on a coarser grid is solved first."""
CASCADE_AREA = 0.8
"""Share of the points in contact above which the clipped pressure of full contact is the better start."""
COARSE_TOLERANCE = 3e-3
COARSE_ITERATIONS = 60
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
    effort : str, optional
        On planning the transforms in single precision, see `transforms`.

    Attributes
    ----------
    pressure, gap : ndarray, shape (nx, ny)
        The solution, dimensionless, in double precision; the gap includes the contact `level`.
    level : float
        Mean of the gap over the points under pressure.
    residual : float
        Root mean square of gap less level over the free set.
    """

    def __init__(self, heights: FloatArray, periodic: bool, effort: str | None = None) -> None:
        self.heights = heights
        self.periodic = periodic
        self._single = self._compliance(np.float32, effort)
        self._minimisers: dict[str, FreeSetGradients] = {}
        self._coarse_convolutions = 0.0
        self._taken = False
        self._holds_stiffness = False
        self.pressure: FloatArray = np.empty(0)
        self.gap: FloatArray = np.empty(0)
        self.level = self.residual = self._deepest = np.nan

    def _compliance(
        self, dtype: type[np.floating], effort: str | None = None
    ) -> PeriodicCompliance | FreeCompliance:
        kind = PeriodicCompliance if self.periodic else FreeCompliance
        return kind((self.heights.shape[0], self.heights.shape[1]), dtype, effort)

    @cached_property
    def _double(self) -> PeriodicCompliance | FreeCompliance:
        # not before it is needed: a coarse grid finds its first pressure without
        return self._compliance(np.float64)

    @property
    def convolutions(self) -> int:
        """Pairs of transforms so far; those of a coarser grid count by its share of the points."""
        double = self._double.count if "_double" in self.__dict__ else 0
        return self._single.count + double + math.ceil(self._coarse_convolutions)

    def full_contact(self, load: float) -> bool:
        """Try full contact: whether its pressure is nowhere negative; then it is the solution.

        In full contact every wave of the heights needs the pressure |θ| times its amplitude, exactly.
        """
        if not self.periodic:
            return False
        mean = load / self.heights.size
        if np.isnan(self._deepest):
            self._stiffness_of_heights()
        if mean < (1 - FULL_CONTACT_DOUBT) * self._deepest:
            return False
        double = self._fresh_double()
        double.source[:] = self.heights
        double.stiffness_of_source()
        if float(double.result.min()) + mean < 0:
            return False
        np.add(double.result, mean, out=double.source)
        self._judge(load)
        return True

    def first_pressure(self, load: float) -> NDArray[np.float32]:
        """Pressure to begin with.

        That of full contact, clipped where it pulls, and shifted to the load; on large grids and away from full
        contact, that of a grid of half as many points a side.
        """
        if not self._holds_stiffness:  # a trial of full contact has left it there
            self._stiffness_of_heights()
        pressure = np.empty(self.heights.shape, np.float32)
        project_onto_load(self._single.result, load, pressure)
        nx, ny = self.heights.shape
        coarsens = nx % 2 == 0 and ny % 2 == 0 and nx * ny >= CASCADE_POINTS
        if coarsens and np.count_nonzero(pressure) < CASCADE_AREA * pressure.size:
            self._coarse_pressure(load, pressure)
        return pressure

    def _stiffness_of_heights(self) -> None:
        self._single.source[:] = self.heights if self.periodic else self.heights - self.heights.min()
        self._single.stiffness_of_source()
        self._holds_stiffness = True
        self._deepest = -float(self._single.result.min())

    def _coarse_pressure(self, load: float, pressure: NDArray[np.float32]) -> None:
        """Fill `pressure` with what the means of 2 by 2 points carry; dimensionless pressure goes with the spacing."""
        heights = self.heights
        means = 0.25 * (heights[::2, ::2] + heights[1::2, ::2] + heights[::2, 1::2] + heights[1::2, 1::2])
        coarse = Minimisation(means, self.periodic, QUICK)  # too few iterations for more
        found = coarse.estimate(coarse.first_pressure(load / 2), load / 2)
        self._coarse_convolutions += coarse.convolutions / 4
        for offset in ((0, 0), (0, 1), (1, 0), (1, 1)):
            pressure[offset[0] :: 2, offset[1] :: 2] = found
        pressure *= np.float32(load / pressure.sum(dtype=float))

    def estimate(self, pressure: NDArray[np.floating], load: float) -> NDArray[np.float32]:
        """Pressure to `COARSE_TOLERANCE`, in single precision and not judged in double."""
        minimiser = self._begin(pressure, load)
        minimiser.minimise(COARSE_TOLERANCE, COARSE_ITERATIONS, Progress())
        return minimiser.pressure

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
        minimiser = self._begin(pressure, load)
        del pressure  # a large grid needs its memory
        for _ in range(SINGLE_ATTEMPTS):
            reached = minimiser.minimise(max(MARGIN * tolerance, SINGLE_LIMIT), limit, progress)
            self._rebuild(minimiser)
            if not reached or self.residual <= max(tolerance, SINGLE_LIMIT / MARGIN):
                break
            minimiser.pressure[:] = self.pressure
            np.subtract(self.gap, self.level, out=minimiser.gap, casting="same_kind")
        if self.residual > tolerance:
            minimiser = self._minimiser("double", load)
            minimiser.pressure[:] = self.pressure
            minimiser.gap[:] = self.gap
            minimiser.minimise(MARGIN * tolerance, limit, progress)
            self._rebuild(minimiser)
        progress.residuals.append(self.residual)
        return progress

    def _begin(self, pressure: NDArray[np.floating], load: float) -> FreeSetGradients:
        """The minimiser in single precision, at a given pressure and its gap."""
        minimiser = self._minimiser("single", load)
        minimiser.pressure[:] = pressure
        self._single.source[:] = pressure
        self._holds_stiffness = False
        self._single.apply()
        np.subtract(self._single.result, self.heights, out=minimiser.gap, casting="same_kind")
        return minimiser

    def _minimiser(self, precision: str, load: float) -> FreeSetGradients:
        if precision not in self._minimisers:
            compliance = self._single if precision == "single" else self._double
            self._minimisers[precision] = FreeSetGradients(compliance, self.periodic)
        self._minimisers[precision].load = load
        return self._minimisers[precision]

    def _rebuild(self, minimiser: FreeSetGradients) -> None:
        """Judge a minimiser's pressure in double precision, less what points about to leave still carry."""
        double = self._fresh_double()
        number = minimiser.pressure.dtype.type
        free_set.keep_carrying(minimiser.pressure, minimiser.gap, number(minimiser.level), double.source)
        self._judge(minimiser.load)

    def _judge(self, load: float) -> None:
        """Scale the pressure in the double precision's source to the load; compute its gap, level and residual."""
        double = self._fresh_double()
        double.source *= load / double.source.sum()
        double.apply()
        self.pressure = double.source
        self.gap = np.subtract(double.result, self.heights, out=double.result)
        carrying, gaps = free_set.carried(self.pressure, self.gap)
        self.level = gaps / carrying
        count, square = free_set.residual_squares(self.pressure, self.gap, self.level)
        self.residual = float(np.sqrt(square / count))

    def _fresh_double(self) -> PeriodicCompliance | FreeCompliance:
        if self._taken:
            self._double.renew()
            self._taken = False
        return self._double

    def take(self) -> tuple[FloatArray, FloatArray]:
        """Pressure and gap above the contact level, for the caller to keep: the next load is given other arrays."""
        self._taken = True
        self.gap -= self.level
        return self.pressure, self.gap
