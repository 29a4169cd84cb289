"""What a body went through on the plate: every increment, the state at the end of every step, and where it stopped."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softlub.solid.contact_patch import reaches_end

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Increment:
    """One accepted increment.

    Attributes
    ----------
    step : str
        Name of the step.
    time : float
        At its end, from the start of the first step [s].
    load : float
        Normal load W [N/m].
    friction : float
        μ.
    plate_height : float
        d [m].
    edge_displacement : ndarray, shape (k, 2)
        Of the nodes of the contact edge, the holder at rest [m].
    normal, shear : ndarray, shape (k,)
        Nodal forces of the plate on the edge, upwards and along +x [N/m].
    iterations, evaluations : int
        Newton steps (each one assembly and one factorisation) and nodal forces evaluated.
    residual : float
        Largest unbalanced force over the largest nodal force.
    """

    step: str
    time: float
    load: float
    friction: float
    plate_height: float
    edge_displacement: FloatArray
    normal: FloatArray
    shear: FloatArray
    iterations: int
    evaluations: int
    residual: float
    converged: bool = True

    @property
    def reaches_edge_end(self) -> bool:
        """Whether an outermost node carries a thousandth of the largest nodal force: more of the body would touch."""
        return reaches_end(self.normal)


@dataclass(frozen=True, eq=False)
class StepEnd:
    """All nodes at the last increment that a step reached.

    Attributes
    ----------
    step : str
    fraction : float
        How much of the step was done; 1 where it was completed.
    displacement : ndarray, shape (n, 2)
        Of all nodes [m].
    """

    step: str
    fraction: float
    displacement: FloatArray


@dataclass(frozen=True)
class Failure:
    """Why a step was not completed.

    Attributes
    ----------
    step : str
    increment : int
        Number of the increment within the step that could not be made, from 1.
    fraction : float
        How much of the step was done before.
    reason : str
        What the last attempt, at the smallest increment, met with.
    """

    step: str
    increment: int
    fraction: float
    reason: str

    def __str__(self) -> str:
        return (
            f"step {self.step} stopped at {100 * self.fraction:.3g} % of its way: increment {self.increment} found no "
            f"equilibrium however small; {self.reason}"
        )


@dataclass(frozen=True, eq=False)
class History:
    """All of a simulation; whatever was reached is there, also where a step failed.

    Attributes
    ----------
    increments : tuple of Increment
    ends : tuple of StepEnd
        One for every step begun, in order; a step whose first increment failed leaves the state before it.
    failure : Failure or None
        None where all steps were completed.
    rejected : int
        Attempts at increments that were too large.
    wasted_iterations : int
        Newton steps of these attempts.
    """

    increments: tuple[Increment, ...]
    ends: tuple[StepEnd, ...]
    failure: Failure | None
    rejected: int
    wasted_iterations: int

    @property
    def converged(self) -> bool:
        """Whether all steps were completed."""
        return self.failure is None

    @property
    def last(self) -> Increment:
        """The last good increment.

        Raises
        ------
        ValueError
            If not even the first increment was reached, with the reason.
        """
        if not self.increments:
            raise ValueError(f"no increment was reached: {self.failure}")
        return self.increments[-1]

    @property
    def displacement(self) -> FloatArray:
        """Displacement of all nodes at the last good increment [m], shape (n, 2)."""
        return self.ends[-1].displacement

    def of(self, step: str) -> tuple[Increment, ...]:
        """The increments of the steps of one name."""
        return tuple(increment for increment in self.increments if increment.step == step)

    @property
    def iterations(self) -> int:
        """Newton steps in all: so many assemblies and factorisations."""
        return self.wasted_iterations + sum(increment.iterations for increment in self.increments)
