"""Continuation in ln λ: predict from the last solutions, correct, halve the step where that fails."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from softlub.lubrication.solvers.finite_volume.equations import State
from softlub.lubrication.solvers.finite_volume.newton import Iterate

Corrector = Callable[[float, State], Iterate]
"""λ and a start -> where Newton's method ended."""

LARGEST_STEP = 1.0
"""In ln λ."""
SMALLEST_STEP = 1e-2
"""In ln λ; below it the point is given up."""
FRONT_MARGIN = 0.25
"""The predicted front is moved out by this part of its predicted motion: a film too long is cut back at once."""
REMEMBERED = 3
"""Solutions that the prediction uses."""


class Track:
    """The solutions found so far on the way along the speed, the last ones first."""

    def __init__(self, known: Sequence[tuple[float, State]]) -> None:
        self.known = list(known)

    def add(self, log_speed: float, state: State) -> None:
        """Remember a solution."""
        self.known = [(log_speed, state), *self.known][:REMEMBERED]

    def predict(self, log_speed: float) -> State:
        """Polynomial through the remembered solutions, in ln λ."""
        places = np.array([place for place, _ in self.known])
        weights = np.array(
            [
                np.prod((log_speed - np.delete(places, i)) / (p - np.delete(places, i)))
                for i, p in enumerate(places)
            ]
        )
        states = [state for _, state in self.known]
        pressure = sum(w * state.pressure for w, state in zip(weights, states, strict=True))
        front = float(weights @ [state.front for state in states])
        ahead = FRONT_MARGIN * (1 + abs(front - states[0].front))
        return State(pressure, float(weights @ [state.approach for state in states]), front + ahead)


def advance(track: Track, correct: Corrector, speed_number: float) -> Iterate:
    """Go from the track's last solution to another λ, in as many steps as it takes.

    Returns
    -------
    Iterate
        That of the wanted λ; not converged if some step became too short.
    """
    goal = float(np.log(speed_number))
    step = LARGEST_STEP
    iterations = 0
    history: tuple[float, ...] = ()
    while True:
        place = track.known[0][0]
        target = goal if abs(goal - place) <= step else place + np.copysign(step, goal - place)
        iterate = correct(float(np.exp(target)), track.predict(target))
        iterations += iterate.iterations
        history += iterate.history
        if iterate.converged:
            track.add(target, iterate.state)
            step = min(2 * step, LARGEST_STEP)
            if target == goal:
                return iterate
        else:
            step = 0.5 * min(step, abs(target - place))
            track.known = track.known[:2]
            if step < SMALLEST_STEP:
                return iterate
