"""Options of finite-element bodies that a study file may set; what is left out is set by the study's `accuracy`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from softlub.units import Length, Unit

Duration = Annotated[float, Unit("s", above=0)]


@dataclass(frozen=True)
class MeshOptions:
    """How fine a body is meshed.

    Parameters
    ----------
    edge_nodes : int, optional
        Nodes of the contact edge, evenly spaced along x.
    rows : int, optional
        Cells from the contact edge up to the holder.
    first_height : float, optional
        Height of the cells at the contact edge [m]; as high as wide where it is left out.
    flank_columns : int, optional
        Cells from either end of the contact edge to the side of the body.
    """

    edge_nodes: Annotated[int, Unit("1", at_least=3, at_most=4097)] | None = None
    rows: Annotated[int, Unit("1", at_least=2, at_most=400)] | None = None
    first_height: Length | None = None
    flank_columns: Annotated[int, Unit("1", at_least=1, at_most=400)] | None = None


@dataclass(frozen=True)
class HardContactOptions:
    """Hard contact with a smooth plate.

    Parameters
    ----------
    penalty : float
        Pressure per penetration [Pa/m].
    """

    penalty: Annotated[float, Unit("Pa/m", above=0)] = 1e14


@dataclass(frozen=True)
class StepOptions:
    """The source's three steps: in contact, loading, sliding.

    Parameters
    ----------
    overlap : float
        How far the plate is moved into the apex to establish the contact [m].
    in_contact, loading : float
        Durations [s].
    sliding : float, optional
        Duration of the slide [s]; `sliding_distance` over `sliding_speed` where it is left out.
    sliding_distance, sliding_speed : float
        Of the plate [m], [m/s].
    increments : int
        Least number of increments that a step of a material with memory is cut into: it takes strain as linear in time
        over each. One without memory takes as few as converge.
    """

    overlap: Length = 2e-6
    in_contact: Duration = 1.0
    loading: Duration = 1.0
    sliding: Duration | None = None
    sliding_distance: Length = 0.5e-3
    sliding_speed: Annotated[float, Unit("m/s", above=0)] = 1e-3
    increments: Annotated[int, Unit("1", at_least=1, at_most=1000)] = 10

    @property
    def durations(self) -> dict[str, float]:
        """Duration of every step [s]."""
        slide = self.sliding_distance / self.sliding_speed if self.sliding is None else self.sliding
        return {"in_contact": self.in_contact, "loading": self.loading, "sliding": slide}
