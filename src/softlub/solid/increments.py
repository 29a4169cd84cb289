"""How large an increment of a step is tried, after what the last ones met with."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from softlub.units import Unit, check

Part = Annotated[float, Unit("1", above=0, at_most=1)]


@dataclass(frozen=True)
class Stepping:
    """Sizes of increments, in parts of a step.

    Parameters
    ----------
    first : float, optional
        Tried first in every step.
    largest : float, optional
        Never exceeded; a material that remembers takes its strain as linear in time over an increment, so that it
        needs several.
    smallest : float, optional
        Tried last before a step is given up.
    growth, cutback : float, optional
        An increment that converged is followed by one this much larger; one that did not is divided by this.

    Raises
    ------
    ValueError
        If a part of a step is not in (0, 1] or a factor not above 1.
    """

    first: Part = 1.0
    largest: Part = 1.0
    smallest: Part = 1e-3
    growth: Annotated[float, Unit("1", above=1)] = 1.5
    cutback: Annotated[float, Unit("1", above=1)] = 3.0

    def __post_init__(self) -> None:
        check(self)

    def begin(self) -> float:
        """Size of a step's first increment."""
        return min(self.first, self.largest)

    def larger(self, size: float) -> float:
        """Size after one that converged."""
        return min(self.growth * size, self.largest)

    def smaller(self, size: float) -> float | None:
        """Size after one that did not converge; None where it was the smallest."""
        # The size may be the difference of two parts of a step, which rounding leaves above the smallest.
        return max(size / self.cutback, self.smallest) if size > self.smallest * (1 + 1e-6) else None

    def reach(self, done: float, size: float) -> float:
        """Where the increment ends: no sliver is left at the end of the step.

        Parameters
        ----------
        done : float
            Part of the step that is done.
        size : float
            Of the increment.
        """
        return 1.0 if done + size > 1.0 - 1e-3 * size else done + size
