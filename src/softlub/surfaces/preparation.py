"""From an instrument's file to roughness, as a study describes the way."""

from __future__ import annotations

from typing import NamedTuple

from softlub.surfaces.filtering import separate_form, separate_waviness, taper
from softlub.surfaces.measured import read, read_profile
from softlub.surfaces.measurement import Form, Measured, MeasuredLine
from softlub.surfaces.profile import Profile
from softlub.surfaces.topography import Topography

__all__ = ["Measured", "PreparedLine", "prepare", "prepare_line", "separate_line"]


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


class PreparedLine(NamedTuple):
    """A line on its way to roughness (figure 4-1)."""

    raw: Profile
    """As it was measured."""
    form: Profile
    """What was taken off first."""
    waviness: Profile | None
    """What was taken off then; None where nothing was."""
    roughness: Profile
    """What is left."""


def prepare_line(measured: MeasuredLine) -> PreparedLine:
    """Read a measured line and take off what does not belong to its roughness.

    Raises
    ------
    ValueError
        As `read_profile`, `separate_form` and `separate_waviness` do.
    """
    raw = read_profile(measured.file, measured.channel, measured.unit, measured.missing)
    return separate_line(raw, measured.form, measured.waviness_wavelength)


def separate_line(raw: Profile, form: Form, waviness_wavelength: float | None) -> PreparedLine:
    """Take form and waviness off a line.

    Parameters
    ----------
    raw : Profile
    form : {"mean", "tilt", "curvature"}
    waviness_wavelength : float or None
        Cut-off of the Gaussian filter [m].
    """
    without_form = separate_form(raw, form)
    if waviness_wavelength is None:
        return PreparedLine(raw, without_form.removed, None, without_form.kept)
    separated = separate_waviness(without_form.kept, waviness_wavelength)
    return PreparedLine(raw, without_form.removed, separated.removed, separated.kept)
