"""What is given of the plate under a body: its height, or the load that it carries."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from softlub.solid.free_system import SingularStiffness


class Control(Protocol):
    """What is given of the plate: its height or its load."""

    def height(self, present: float) -> float:
        """Where the plate starts [m], from where it is at present."""
        ...

    def imbalance(self, load: float) -> float:
        """What is missing in the load [N/m]."""
        ...

    def rise(self, missing: float, gain: float) -> float:
        """How far the plate moves up [m] to make up a missing load [N/m] at a gain [N/m²]."""
        ...


@dataclass(frozen=True)
class HeightControl:
    """The plate stands at a given height [m]; the load follows."""

    value: float

    def height(self, present: float) -> float:
        """The given height."""
        return self.value

    def imbalance(self, load: float) -> float:
        """Nothing: every load is right."""
        return 0.0

    def rise(self, missing: float, gain: float) -> float:
        """The plate does not move."""
        return 0.0


@dataclass(frozen=True)
class LoadControl:
    """The plate carries a given load [N/m]; its height follows."""

    value: float

    def height(self, present: float) -> float:
        """Where it is."""
        return present

    def imbalance(self, load: float) -> float:
        """The given load less the present one."""
        return self.value - load

    def rise(self, missing: float, gain: float) -> float:
        """Missing load over gain."""
        if gain == 0:
            raise SingularStiffness("no node is in contact, so that no height of the plate changes its load")
        return missing / gain
