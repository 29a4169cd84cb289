"""The loop that repeats a module's sweep, accelerated and guarded, until its residual or its budget is used up."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from softlub.lubrication.solvers.modules.anderson import Anderson
from softlub.lubrication.solvers.modules.contact import Fields
from softlub.protocols import FloatArray

LARGEST_LOG_CHANGE = 0.5
"""Largest change of ln H at any node that an accelerated step may make."""
DIVERGENCE = 30.0
"""Growth of the residual over the best one that sends the accelerated iteration back to it, with half the steps."""
SMALLEST_MIXING = 1e-2
"""Share of a sweep's change below which repeated returns do not shrink it."""
SHORTEST_MEMORY = 4
"""Memory below which repeated returns do not shrink it."""
SMALLEST_GAP = 1e-9
"""Floor of H: no iterate may close the gap."""


@dataclass
class Budget:
    """Sweeps and CPU time that one point may take, and the record of what it did.

    Parameters
    ----------
    max_sweeps : int
    seconds : float
        CPU time of the process [s].
    """

    max_sweeps: int
    seconds: float
    sweeps: int = 0
    history: list[float] = field(default_factory=list)
    began: float = field(default_factory=time.process_time)

    @property
    def used_seconds(self) -> float:
        """CPU time since the start [s]."""
        return time.process_time() - self.began

    @property
    def is_spent(self) -> bool:
        """Whether the point has to be given up."""
        return self.sweeps >= self.max_sweeps or self.used_seconds > self.seconds


Layout = tuple[str, ...]
"""The members of `Fields` that one sweep hands to the next; the others follow from them."""


def pack(fields: Fields, layout: Layout) -> FloatArray:
    """The handed-on fields as one vector: pressures by p0, ln H, H_c."""
    parts = [np.log(fields.gap) if name == "gap" else np.atleast_1d(getattr(fields, name)) for name in layout]
    return np.concatenate(parts)


def unpack(vector: FloatArray, layout: Layout, fields: Fields) -> Fields:
    """The fields of a vector; members outside the layout are those of `fields`. Pressures are clipped at zero."""
    members: dict[str, Any] = {}
    first = 0
    for name in layout:
        size = np.size(getattr(fields, name))
        part = vector[first : first + size]
        first += size
        if name == "approach":
            members[name] = float(part[0])
        else:
            members[name] = np.exp(part) if name == "gap" else np.maximum(part, 0.0)
    return fields._replace(**members)


def iterate(
    sweep: Callable[[Fields], Fields],
    start: Fields,
    layout: Layout,
    memory: int,
    measure: Callable[[Fields, FloatArray], float],
    target: float,
    budget: Budget,
    check_every: int = 1,
) -> tuple[Fields, float]:
    """Repeat a sweep until a measure of its result falls to a target.

    Parameters
    ----------
    sweep : callable
        One sweep of a module, relaxation included.
    start : Fields
    layout : tuple of str
        What one sweep hands to the next.
    memory : int
        Anderson's memory; 0 for plain relaxation.
    measure : callable
        Residual of the swept fields, given them and the packed change of the sweep.
    target : float
        Residual to stop at.
    budget : Budget
        Counts the sweeps, and stops them when it is spent.
    check_every : int
        Sweeps between two looks at the residual.

    Returns
    -------
    fields : Fields
        As the last sweep left them; the start where the budget was spent before.
    residual : float
        Their measure; infinite where no sweep was made.
    """
    fields = start
    accelerator = Anderson(memory, pack(start, layout).size)
    best = _Best(float("inf"), start)
    mixing = 1.0
    if budget.is_spent:
        return start, float("inf")
    while True:
        swept = sweep(fields)
        budget.sweeps += 1
        state = pack(fields, layout)
        change = pack(swept, layout) - state
        if (budget.sweeps - 1) % check_every == 0 or budget.is_spent:
            residual = measure(swept, change)
            if residual <= target or budget.is_spent:
                return swept, residual
            if residual < best.residual:
                best = _Best(residual, fields)
            elif not residual < DIVERGENCE * best.residual and memory > 0:
                mixing = max(0.5 * mixing, SMALLEST_MIXING)
                accelerator = Anderson(max(accelerator.memory // 2, SHORTEST_MEMORY), state.size)
                fields = best.fields
                continue
        following = accelerator.next(state, mixing * change)
        fields = unpack(_guarded(state, following, layout, swept), layout, swept)


class _Best(NamedTuple):
    """The fields before the best sweep so far."""

    residual: float
    fields: Fields


def _guarded(state: FloatArray, following: FloatArray, layout: Layout, fields: Fields) -> FloatArray:
    """The step shortened where it would change some gap too much."""
    first = sum(np.size(getattr(fields, name)) for name in layout[: layout.index("gap")])
    largest = np.max(
        np.abs(following[first : first + fields.gap.size] - state[first : first + fields.gap.size])
    )
    return state + min(1.0, LARGEST_LOG_CHANGE / max(largest, LARGEST_LOG_CHANGE)) * (following - state)
