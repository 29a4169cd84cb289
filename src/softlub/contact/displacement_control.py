"""Contact at a given separation or approach: the load is found that brings the bodies there.

The mean gap falls, and the rigid approach rises, with the load; both change nearly like its logarithm where few
asperities touch, so the search is a secant in log p, held within the bracket that the loads so far leave.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from softlub.contact.load_sweep import foretell
from softlub.contact.rough_contact import RoughContact
from softlub.contact.solution import ContactSolution
from softlub.surfaces.topography import Topography

LOADS = 40
"""Loads tried at most."""
FIRST_STEP = 0.5
"""First change of log p, before two loads give a slope."""
LONGEST_STEP = 4.0
"""Largest change of log p at once."""


@dataclass
class Search:
    """A quantity that rises with the logarithm of the load, and the value it must take.

    Parameters
    ----------
    quantity : callable
        Of a solution [m].
    target : float
        Value to reach [m].
    slack : float
        Error that is accepted [m].
    """

    quantity: Callable[[ContactSolution], float]
    target: float
    slack: float


def solve_at_mean_gap(
    topography: Topography, modulus: float, mean_gap: float, tolerance: float = 1e-6
) -> ContactSolution:
    """Contact of a rough surface at a given mean gap.

    Parameters
    ----------
    topography : Topography
    modulus : float
        E* [Pa].
    mean_gap : float
        Mean of the gap over the whole surface [m], between 0 and the mean gap at first touch.
    tolerance : float
        As in `solve`; the mean gap is met to ten times this, relative to h_rms.

    Returns
    -------
    ContactSolution
        Flagged as not converged where no load brings the gap there.

    Raises
    ------
    ValueError
        If the gap is not above 0 and below that at first touch, or as `solve` does.
    """
    heights = topography.heights
    first_touch = float(heights.max() - heights.mean())
    if not 0 < mean_gap < first_touch:
        raise ValueError(
            f"mean gap {mean_gap:g} m must lie above 0 and below {first_touch:g} m, where the surface first touches"
        )
    contact = RoughContact(topography, modulus, tolerance)
    slack = 10 * tolerance * float(heights.std())
    return _search(contact, modulus, Search(lambda found: -found.mean_gap, -mean_gap, slack))


def solve_at_approach(
    topography: Topography, modulus: float, approach: float, tolerance: float = 1e-6
) -> ContactSolution:
    """Contact of a rough surface at a given rigid approach since first touch.

    Parameters
    ----------
    topography : Topography
    modulus : float
        E* [Pa].
    approach : float
        `ContactSolution.rigid_approach` to reach [m], above 0.
    tolerance : float
        As in `solve`; the approach is met to ten times this, relative to h_rms.

    Returns
    -------
    ContactSolution
        Flagged as not converged where no load brings the bodies there: with a periodic surface the approach ends
        at the height of the summit above the mean plane.

    Raises
    ------
    ValueError
        If the approach is not positive and finite, or as `solve` does.
    """
    if not 0 < approach < np.inf:
        raise ValueError(f"approach {approach:g} m must be above 0 and finite")
    contact = RoughContact(topography, modulus, tolerance)
    slack = 10 * tolerance * float(topography.heights.std())
    return _search(contact, modulus, Search(lambda found: found.rigid_approach, approach, slack))


def _search(contact: RoughContact, modulus: float, search: Search) -> ContactSolution:
    """Secant with a bracket over log p, each contact starting from what the last two foretell."""
    heights, spacing = contact.topography.heights, contact.topography.spacing
    squares = [float(np.mean(np.diff(heights, axis=axis) ** 2)) for axis in (0, 1)]
    slope = np.sqrt(sum(squares)) / spacing
    tried: list[tuple[float, float]] = []
    low, high = -np.inf, np.inf
    at = float(np.log(0.05 * modulus * slope))
    last: ContactSolution | None = None
    before: ContactSolution | None = None
    for _ in range(LOADS):
        pressure = float(np.exp(at))
        start = None if last is None else foretell(pressure, last, before)
        before, last = last, contact.solve(pressure, start)
        excess = search.quantity(last) - search.target
        if abs(excess) <= search.slack:
            return last
        tried.append((at, excess))
        low, high = (at, high) if excess < 0 else (low, at)
        at = _next(tried, low, high)
        if high - low < 1e-12:
            break
    assert last is not None
    return last.failed()


def _next(tried: list[tuple[float, float]], low: float, high: float) -> float:
    """The secant's guess where it lies within the bracket and near, else a bounded step or the bracket's middle."""
    at, excess = tried[-1]
    guess = at - np.sign(excess) * FIRST_STEP
    if len(tried) > 1 and tried[-1][1] != tried[-2][1]:
        old, old_excess = tried[-2]
        guess = at - excess * (at - old) / (excess - old_excess)
    guess = min(max(guess, at - LONGEST_STEP), at + LONGEST_STEP)
    if low < guess < high:
        return float(guess)
    if np.isfinite(low) and np.isfinite(high):
        return 0.5 * (low + high)
    return float(at - np.sign(excess) * LONGEST_STEP)
