"""The half cylinder of the source's chapter 3, wide against its contact: a parabola on a half-space."""

from __future__ import annotations

from dataclasses import dataclass

from softlub.units import Length


@dataclass(frozen=True)
class Cylinder:
    """Cylinder lying on the plate, gap x²/(2R) near the contact (equation 3-13).

    Parameters
    ----------
    radius : float
        R [m].
    """

    radius: Length
