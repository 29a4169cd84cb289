"""Conjugate gradients on the free set, with a projected step: one convolution an iteration.

Minimised is ½ Σ p (K p) - Σ p h over p >= 0 with a given sum; its gradient is the gap g up to the contact level.
Every iteration

1. measures the gap on the free set F = {p > 0 or g < 0}; its root mean square is the residual;
2. preconditions it: stencil (`stencil`) plus coarse correction (`coarse`);
3. turns it into a Polak–Ribière⁺ direction;
4. projects the trial point onto p >= 0 and restores its load along φ, the pressure that moves all contacts alike,
   block by block so that no long wave of pressure is added;
5. convolves the step to the projected trial, and takes the exact factor along it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.contact.solver import free_set, steps
from softlub.contact.solver.coarse import BLOCK, CoarseCorrection
from softlub.contact.solver.compliance import Compliance
from softlub.contact.solver.projection import project_onto_load
from softlub.contact.solver.stencil import stencil_taps

CLIPPED_SHARE = 0.01
"""Share of the load that a projection must clip for its full step to be preferred to the exact factor.

Nor is the next direction conjugate to such a step.
"""
LIFTED_SHARE = 1e-4
"""Share of the load that a projection must clip for what it adds to be undone block by block, not all over."""
LEAST_FULL_FACTOR = 0.7
"""Exact factor above which it may be; a full step lowers the energy wherever the factor exceeds one half."""
LEAST_FACTOR = 0.1
"""Exact factor below which the next direction is the steepest."""
STEP_CHANGE = 1.4
"""By what the length of the trial may grow or shrink from one iteration to the next."""
MOST_STEP = 1.0
"""Longest trial, as a factor of the direction; where S is the true stiffness, 1 is exact."""
RELEASE = float(free_set.RELEASE)
RELEASE_GROWTH = 4.0
"""By what the release is raised where the step leads uphill or nowhere; it falls back by as much a step."""
MOST_RELEASE = 2.0
"""Largest release, near the stiffness of a single point, π / √2."""
STEEPEST_STEP = 1.0
"""Pressure per gap of a step of the steepest descent; the compliance of the shortest waves is 1 / (π √2)."""
LOAD_SLACK = 1e-3
"""Relative error of the load above which a projected trial is scaled back to it."""
PATIENCE = 12
"""Iterations without progress after which the search starts again from the steepest direction."""
PROGRESS = 0.9
"""What the residual has to be multiplied with within `PATIENCE` iterations."""
RESTARTS = 3
"""Restarts in a row without progress after which the search gives up."""


@dataclass
class Progress:
    """Residuals of the iterations so far, over all precisions."""

    residuals: list[float] = field(default_factory=list)
    iterations: int = 0


class FreeSetGradients:
    """Minimiser for one grid, precision and compliance.

    Parameters
    ----------
    compliance : Compliance
        Convolution; its arrays serve as direction and displacement.
    periodic : bool

    Attributes
    ----------
    load : float
        Sum of the pressure over the grid, dimensionless.
    pressure, gap : ndarray, shape (nx, ny)
        Where to begin, and where the minimisation ended.
    """

    def __init__(self, compliance: Compliance, periodic: bool) -> None:
        self._compliance = compliance
        self.load = 0.0
        shape, dtype = compliance.source.shape, compliance.source.dtype
        self.pressure: NDArray[Any] = np.zeros(shape, dtype)
        self.gap: NDArray[Any] = np.zeros(shape, dtype)
        self._weight: NDArray[Any] = np.zeros(shape, dtype)
        self._preconditioned: NDArray[Any] = np.zeros(shape, dtype)
        self._coarse = CoarseCorrection((shape[0], shape[1]), periodic, dtype)
        self._added: NDArray[Any] = np.zeros_like(self._coarse.sums[0])
        self._number = dtype.type
        self._wrap = self._number(1 if periodic else 0)
        self._taps = stencil_taps().astype(dtype)
        self.level = 0.0

    def minimise(self, tolerance: float, limit: int, progress: Progress) -> bool:
        """Iterate from the present pressure and gap until the residual reaches the tolerance.

        Parameters
        ----------
        tolerance : float
            Root mean square gap over the free set [h_rms].
        limit : int
            Largest number of iterations in `progress`.
        progress : Progress
            Extended by what is done here.

        Returns
        -------
        bool
            Whether the tolerance was reached.
        """
        self.level = float(self.gap.mean(dtype=float, where=self.pressure > 0))
        self._compliance.source[:] = 0  # it holds the direction between iterations
        self._rest = 0.0
        self._steepest()
        best, since, restarts = np.inf, 0, 0
        while True:
            residual, product, product_last = self._weigh()
            progress.residuals.append(residual)
            if residual <= tolerance:
                return True
            if residual < PROGRESS * best:
                best, since, restarts = residual, 0, 0
            elif since >= PATIENCE:
                since, restarts = 0, restarts + 1
                self._steepest()
            if restarts > RESTARTS or progress.iterations >= limit:
                return False
            since += 1
            self._iterate(product, product_last)
            progress.iterations += 1

    def _steepest(self) -> None:
        self._momentum_scale = 0.0
        self._step = MOST_STEP
        self._last_product = 0.0
        self._release = RELEASE

    def _weigh(self) -> tuple[float, float, float]:
        """Residual, and the products of the gap with the stencil's share of z and with the last z."""
        count, square, product, product_last = free_set.weigh(
            self.pressure,
            self.gap,
            self._compliance.source,
            self._number(self._rest),
            self._number(self.level),
            self._number(self._release),
            self._taps,
            self._wrap,
            BLOCK,
            self._weight,
            self._preconditioned,
            self._coarse.sums,
        )
        return float(np.sqrt(square / max(count, 1.0))), product, product_last

    def _iterate(self, product: float, product_last: float) -> None:
        coarse, shift, coarse_product = self._coarse.correction()
        product += coarse_product
        momentum = 0.0
        if self._momentum_scale > 0 and self._last_product > 0:
            momentum = max(0.0, (product - product_last) / self._last_product) * self._momentum_scale
        self._last_product = product
        slope, clipped = self._project(coarse, momentum, shift)
        if slope >= 0:  # points about to leave the contact lead uphill
            release = self._release
            self._steepest()
            if release < MOST_RELEASE:
                self._release = min(RELEASE_GROWTH * release, MOST_RELEASE)
                return
            slope, clipped = self._descend(), 1.0
        energy = self._compliance.apply()
        factor = self._factor(-slope / energy if energy > 0 else 0.0, clipped)
        carrying, gaps = steps.advance(
            self.pressure, self.gap, self._compliance.source, self._compliance.result, self._number(factor)
        )
        self.level = gaps / carrying
        self._rest = 1 - factor

    def _project(self, coarse: NDArray[Any], momentum: float, shift: float) -> tuple[float, float]:
        """Write the step to the projected trial into the compliance's source; return its slope and clipped share."""
        number, move = self._number, self._compliance.source
        total, weight, clipped = steps.search(
            self.pressure,
            self._weight,
            coarse,
            BLOCK,
            self._preconditioned,
            move,
            number(momentum),
            number(self._step),
            self._added,
        )
        lifts, load = np.zeros_like(self._added), 0.0
        if clipped > LIFTED_SHARE * self.load:
            lifts, load = self._coarse.lift(self._added)
        lifts += number((self.load - total - load) / weight)
        level = number(self.level + shift)
        slope, total = steps.project(
            self.pressure, self.gap, self._weight, move, number(self._step), lifts, BLOCK, level
        )
        if abs(total - self.load) > LOAD_SLACK * self.load:
            slope = steps.rescale(self.pressure, self.gap, move, number(self.load / total), level)
        return slope, clipped / self.load

    def _descend(self) -> float:
        """Write the step of the projected steepest descent into the compliance's source; return its slope.

        Projecting a preconditioned direction may lead uphill, where many points are about to leave the contact. The
        plain gradient, projected in the plain metric, never does.
        """
        number, move = self._number, self._compliance.source
        np.subtract(self.pressure, STEEPEST_STEP * (self.gap - number(self.level)), out=move)
        project_onto_load(move, self.load, self._preconditioned)
        np.subtract(self._preconditioned, self.pressure, out=move)
        return float(np.vdot(move, self.gap - number(self.level)))

    def _factor(self, exact: float, clipped: float) -> float:
        """Factor of the step that is taken, and the state for the next direction."""
        if clipped > CLIPPED_SHARE and exact > LEAST_FULL_FACTOR:
            taken = 1.0
        elif exact > 1:
            taken = 1.0 if clipped > 0 else min(exact, steps.room(self.pressure, self._compliance.source))
        else:
            taken = max(exact, 0.0)
        self._momentum_scale = 0.0 if clipped > CLIPPED_SHARE else 1 / self._step
        self._release = max(self._release / RELEASE_GROWTH, RELEASE)
        if exact < LEAST_FACTOR:
            self._momentum_scale = 0.0
            self._release = min(RELEASE_GROWTH**2 * self._release, MOST_RELEASE)
        self._step = min(MOST_STEP, self._step * min(STEP_CHANGE, max(1 / STEP_CHANGE, exact)))
        return taken
