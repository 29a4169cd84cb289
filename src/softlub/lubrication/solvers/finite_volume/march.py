"""Many speeds of one contact: along the speed on the coarsest grid, then grid by grid."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from softlub.lubrication.solvers.finite_volume.continuation import Track, advance
from softlub.lubrication.solvers.finite_volume.equations import State
from softlub.lubrication.solvers.finite_volume.level import Level, refine
from softlub.lubrication.solvers.finite_volume.newton import Iterate
from softlub.lubrication.solvers.finite_volume.start import rigid_start, starting_speed_number

STARTS = (1.0, 3.0, 10.0)
"""Multiples of the starting speed that are tried."""


def march(level: Level, speed_numbers: Sequence[float]) -> list[Iterate]:
    """Solve at every λ on one grid, both ways from a thick film.

    Parameters
    ----------
    level : Level
    speed_numbers : sequence of float
        λ, ascending.

    Returns
    -------
    list of Iterate
        One a speed; those that were not reached hold the last iterate on the way to them.
    """
    begin, first = _thick_film(level)
    if not first.converged:
        return [first] * len(speed_numbers)
    found: dict[float, Iterate] = {}
    slower = [value for value in reversed(speed_numbers) if value <= begin]
    faster = [value for value in speed_numbers if value > begin]
    for way in (slower, faster):
        track = Track([(float(np.log(begin)), first.state)])
        for value in way:
            found[value] = advance(track, level.correct, value)
    return [found[value] for value in speed_numbers]


def _thick_film(level: Level) -> tuple[float, Iterate]:
    """The first λ that yields to Martin's pressure, and its solution."""
    for factor in STARTS:
        begin = factor * starting_speed_number(level.contact)
        iterate = level.correct(begin, rigid_start(level.contact, begin))
        if iterate.converged:
            break
    return begin, iterate


def march_refined(level: Level, speed_numbers: Sequence[float], coarse: Sequence[Iterate]) -> list[Iterate]:
    """Solve at every λ on a grid of 2n - 1 nodes from the solutions on n nodes.

    The start at each speed is the coarse solution plus the difference that the last speed showed between the grids.
    Speeds that fail so, or failed on the coarse grid, are reached by continuation from the last one that did not.

    Parameters
    ----------
    level : Level
    speed_numbers : sequence of float
        λ, ascending.
    coarse : sequence of Iterate
        One a speed.

    Returns
    -------
    list of Iterate
    """
    found: list[Iterate] = []
    difference: State | None = None
    track = Track([])
    for value, below in zip(reversed(speed_numbers), reversed(coarse), strict=True):
        start = _refined(below.state)
        iterate = level.correct(value, start if difference is None else _sum(start, difference, 1.0))
        if iterate.converged:
            track.add(float(np.log(value)), iterate.state)
        else:
            if not track.known:
                begin, first = _thick_film(level)
                track.add(float(np.log(begin)), first.state)
            iterate = advance(track, level.correct, value)
        if iterate.converged:
            difference = _sum(iterate.state, start, -1.0)
        found.append(iterate)
    return found[::-1]


def _refined(state: State) -> State:
    """A state on n nodes taken to 2n - 1."""
    return State(refine(state.pressure), state.approach, 2 * state.front + 0.5)


def _sum(state: State, other: State, factor: float) -> State:
    """state + factor · other."""
    return State(
        state.pressure + factor * other.pressure,
        state.approach + factor * other.approach,
        state.front + factor * other.front,
    )
