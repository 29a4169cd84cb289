"""Steps of a test on the plate: into contact, loading, sliding, each with the time it takes, and going through them.

A step is made in increments, each an equilibrium. One that is not found is tried again with a smaller increment, from
the last good state; the next one is larger again. Where even the smallest fails, the simulation ends there and says so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Annotated, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from softlub.solid.control import Control, HeightControl, LoadControl
from softlub.solid.equilibrium import Equilibrium, EquilibriumSolver, NewtonSettings
from softlub.solid.history import Failure, History, Increment, StepEnd
from softlub.solid.increments import Stepping
from softlub.solid.plate import PlateContact
from softlub.units import Length, LineLoad, Unit, check

if TYPE_CHECKING:
    from softlub.solid.body import Body

FloatArray = NDArray[np.float64]

Duration = Annotated[float, Unit("s", at_least=0)]


@dataclass(frozen=True)
class Situation:
    """What is imposed on the body at one moment, and where the plate then stands.

    Parameters
    ----------
    control : Control
        Height or load of the plate.
    friction : float
        μ.
    load : float
        Of the plate [N/m].
    lowest : float
        y of the lowest edge node, where a plate from below touches [m].
    """

    control: Control
    friction: float
    load: float
    lowest: float


class Step(Protocol):
    """A way from one situation to another."""

    name: ClassVar[str]

    @property
    def duration(self) -> float:
        """What it takes [s]."""
        ...

    def imposed(self, begin: Situation, fraction: float) -> tuple[Control, float]:
        """Control and friction after a fraction of the way from where the step began."""
        ...


@dataclass(frozen=True)
class InContact:
    """The plate rises beyond touching, never to touching alone: no node would carry a load then.

    Parameters
    ----------
    overlap : float, optional
        How far it rises from where it first touches [m].
    duration : float, optional
        [s].
    """

    name: ClassVar[str] = "in-contact"
    overlap: Length = 4e-6
    duration: Duration = 1.0

    def __post_init__(self) -> None:
        check(self)

    def imposed(self, begin: Situation, fraction: float) -> tuple[Control, float]:
        """The plate's height."""
        return HeightControl(begin.lowest + fraction * self.overlap), begin.friction


@dataclass(frozen=True)
class Loading:
    """The load goes evenly from what the plate carries to a given one; friction stays.

    Parameters
    ----------
    load : float
        W [N/m].
    duration : float, optional
        [s].
    """

    name: ClassVar[str] = "loading"
    load: LineLoad
    duration: Duration = 1.0

    def __post_init__(self) -> None:
        check(self)

    def imposed(self, begin: Situation, fraction: float) -> tuple[Control, float]:
        """The load."""
        return LoadControl(begin.load + fraction * (self.load - begin.load)), begin.friction


@dataclass(frozen=True)
class Sliding:
    """Friction goes evenly from what it is to a given one, while load or height of the plate stay as they are.

    Parameters
    ----------
    friction : float
        μ; the plate moves in +x.
    duration : float, optional
        Sliding distance over speed [s].
    """

    name: ClassVar[str] = "sliding"
    friction: Annotated[float, Unit("1")]
    duration: Duration = 1.0

    def __post_init__(self) -> None:
        check(self)

    def imposed(self, begin: Situation, fraction: float) -> tuple[Control, float]:
        """The friction."""
        return begin.control, begin.friction + fraction * (self.friction - begin.friction)


def run(
    body: Body,
    contact: PlateContact,
    steps: Sequence[Step],
    stepping: Stepping | None = None,
    newton: NewtonSettings | None = None,
) -> History:
    """Take a body through steps on the plate.

    Parameters
    ----------
    body : Body
        Undeformed; afterwards in the last good state.
    contact : PlateContact
        Its friction is that of the first steps, until one changes it.
    steps : sequence of Step
        In order; the first one should be `InContact`.
    stepping : Stepping, optional
        Sizes of the increments.
    newton : NewtonSettings, optional

    Returns
    -------
    History
        With a failure where a step could not be completed; nothing is raised on a hard problem.
    """
    walk = _Walk(EquilibriumSolver(body, newton), contact, stepping or Stepping())
    failure = None
    for step in steps:
        failure = walk.through(step)
        if failure is not None:
            break
    return History(tuple(walk.increments), tuple(walk.ends), failure, walk.rejected, walk.wasted)


@dataclass
class _Walk:
    """The last good state, and the record of how it was reached."""

    solver: EquilibriumSolver
    contact: PlateContact
    stepping: Stepping
    increments: list[Increment] = field(default_factory=list)
    ends: list[StepEnd] = field(default_factory=list)
    rejected: int = 0
    wasted: int = 0
    time: float = 0.0

    def __post_init__(self) -> None:
        mesh = self.solver.body.mesh
        lowest = float(mesh.points[mesh.edge, 1].min())
        self.displacement = np.zeros_like(mesh.points)
        self.height = lowest
        self.situation = Situation(HeightControl(lowest), self.contact.friction, 0.0, lowest)

    def through(self, step: Step) -> Failure | None:
        """Go through one step; why not, where it cannot be completed."""
        begin, done, size = self.situation, 0.0, self.stepping.begin()
        trend: _Trend | None = None
        count, failure = 1, None
        while done < 1.0 and failure is None:
            reached = self.stepping.reach(done, size)
            found = self._attempt(step, begin, done, reached, trend)
            if found.converged:
                trend = _Trend(found.displacement - self.displacement, found.plate_height - self.height)
                trend = trend.per(reached - done)
                self._take(step, begin, reached, found, (reached - done) * step.duration)
                done, size, count = reached, self.stepping.larger(size), count + 1
                continue
            self.rejected += 1
            self.wasted += found.iterations
            trend = None
            smaller = self.stepping.smaller(reached - done)
            if smaller is None:
                failure = Failure(step.name, count, done, found.reason)
            size = smaller or size
        self.ends.append(StepEnd(step.name, done, self.displacement))
        return failure

    def _attempt(
        self, step: Step, begin: Situation, done: float, reached: float, trend: _Trend | None
    ) -> Equilibrium:
        """Try an increment; the body keeps it if it converged and goes back if it did not."""
        body = self.solver.body
        control, friction = step.imposed(begin, reached)
        before = body.checkpoint()
        body.begin_increment((reached - done) * step.duration)
        displacement, height = self.displacement, self.height
        if trend is not None:
            displacement = displacement + (reached - done) * trend.displacement
            height += (reached - done) * trend.height
        contact = replace(self.contact, friction=friction)
        found = self.solver.solve(contact, control, displacement, height)
        if found.converged:
            body.accept()
        else:
            body.restore(before)
        return found

    def _take(
        self, step: Step, begin: Situation, reached: float, found: Equilibrium, duration: float
    ) -> None:
        mesh = self.solver.body.mesh
        self.time += duration
        self.displacement, self.height = found.displacement, found.plate_height
        edge = found.displacement[mesh.edge]
        control, friction = step.imposed(begin, reached)
        lowest = float((mesh.points[mesh.edge, 1] + edge[:, 1]).min())
        self.situation = Situation(control, friction, found.contact.load, lowest)
        self.increments.append(
            Increment(
                step.name,
                self.time,
                found.contact.load,
                friction,
                found.plate_height,
                edge,
                found.contact.normal,
                found.contact.shear,
                found.iterations,
                found.evaluations,
                found.residual,
            )
        )


@dataclass(frozen=True, eq=False)
class _Trend:
    """Change of displacement and plate height, from which the next increment starts."""

    displacement: FloatArray
    height: float

    def per(self, size: float) -> _Trend:
        return _Trend(self.displacement / size, self.height / size)
