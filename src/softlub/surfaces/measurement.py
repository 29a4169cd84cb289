"""A measured surface or line as a study names it: the file, and what is done to it before anything touches.

Only names and numbers: nothing here reads a file, so that whoever reads studies need not load what does.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from softlub.units import Length, Unit

Form = Literal["mean", "tilt", "curvature"]
Missing = Literal["refuse", "fill"]


@dataclass(frozen=True)
class MeasuredLine:
    """A measured line and its way to roughness.

    Parameters
    ----------
    file : str
        The instrument's file.
    channel : str or int, optional
        Channel by name or number; the first one with heights otherwise.
    unit : str, optional
        Unit of lengths where the file states none.
    missing : {"refuse", "fill"}
        What to do with points that were not measured.
    form : {"mean", "tilt", "curvature"}
        What is taken off first, in the sense of least squares.
    waviness_wavelength : float, optional
        Cut-off of the Gaussian filter that takes the waviness off [m]; none without it.
    """

    file: str
    channel: str | int | None = None
    unit: str | None = None
    missing: Missing = "refuse"
    form: Form = "tilt"
    waviness_wavelength: Length | None = None


@dataclass(frozen=True)
class Measured(MeasuredLine):
    """A measured area and its way to roughness.

    Parameters
    ----------
    file, channel, unit, missing, form, waviness_wavelength
        As in `MeasuredLine`.
    tapered_fraction : float, optional
        Share of the sides over which the heights fade to their mean, so that the surface may be continued
        periodically; without it the surface stays as finite as it was measured.
    """

    tapered_fraction: Annotated[float, Unit("1", above=0, at_most=1)] | None = None
