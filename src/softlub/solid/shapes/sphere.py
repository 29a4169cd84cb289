"""The half sphere of the source's figure 4-9, a paraboloid on a half-space."""

from __future__ import annotations

from dataclasses import dataclass

from softlub.units import Length


@dataclass(frozen=True)
class Sphere:
    """Sphere on a plate.

    Parameters
    ----------
    radius : float
        R [m].
    """

    radius: Length
