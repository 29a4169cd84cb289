"""A measured surface as a study names it: the file and what is done to it before anything touches."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from softlub.surfaces.filtering import Form, separate_form, separate_waviness, taper
from softlub.surfaces.measured import Missing, read
from softlub.surfaces.topography import Topography
from softlub.units import Length, Unit


@dataclass(frozen=True)
class Measured:
    """A measured area and its way to roughness.

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
    tapered_fraction : float, optional
        Share of the sides over which the heights fade to their mean, so that the surface may be continued
        periodically; without it the surface stays as finite as it was measured.
    """

    file: str
    channel: str | int | None = None
    unit: str | None = None
    missing: Missing = "refuse"
    form: Form = "tilt"
    waviness_wavelength: Length | None = None
    tapered_fraction: Annotated[float, Unit("1", above=0, at_most=1)] | None = None


def prepare(measured: Measured) -> Topography:
    """Read a measured surface and take off what does not belong to its roughness.

    Raises
    ------
    ValueError
        As `read`, `separate_form`, `separate_waviness` and `taper` do.
    """
    surface = read(measured.file, measured.channel, measured.unit, measured.missing)
    surface = separate_form(surface, measured.form).kept
    if measured.waviness_wavelength is not None:
        surface = separate_waviness(surface, measured.waviness_wavelength).kept
    return surface if measured.tapered_fraction is None else taper(surface, measured.tapered_fraction)
