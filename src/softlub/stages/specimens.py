"""From the surface in a node's spec to its heights."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from softlub.study.specimens import SPECTRUM
from softlub.surfaces.measurement import Measured, MeasuredLine
from softlub.surfaces.preparation import PreparedLine, prepare, prepare_line, separate_line
from softlub.surfaces.profile import Profile
from softlub.surfaces.profile_synthesis import synthesize_profile
from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthesis import synthesize, synthesize_exponential
from softlub.surfaces.topography import Topography

Surface = Mapping[str, Any]


def spectrum(surface: Surface) -> SelfAffine | None:
    """The spectrum that a surface is made from; None where it is measured."""
    if "hurst" not in surface:
        return None
    return SelfAffine(**{name: surface[name] for name in SPECTRUM})


def make(surface: Surface, files: Sequence[Path]) -> Topography:
    """One piece of a surface.

    Parameters
    ----------
    surface : mapping
        Of the kind ``self_affine``, with the seed of the piece, or ``measured``.
    files : sequence of Path
        The instrument's file of a measured one.

    Returns
    -------
    Topography
    """
    asked = spectrum(surface)
    if asked is None:
        return prepare(Measured(**_measurement(surface, files, Measured)))
    maker = synthesize_exponential if surface["wavevectors"] == "exponential" else synthesize
    return maker(asked, surface["size"], surface["points"], surface["seed"], target=surface["target"])


def make_line(surface: Surface, files: Sequence[Path]) -> PreparedLine:
    """A line at every stage of its preparation.

    Parameters
    ----------
    surface : mapping
        Of the kind ``self_affine_line`` or ``measured_line``.
    files : sequence of Path
        The instrument's file of a measured one.

    Returns
    -------
    PreparedLine
    """
    asked = spectrum(surface)
    if asked is None:
        return prepare_line(MeasuredLine(**_measurement(surface, files, MeasuredLine)))
    points = surface["points"]
    # One half of a periodic line: the ends of a scan do not meet.
    twice = synthesize_profile(asked, 2 * surface["length"], 2 * points, surface["seed"])
    line = Profile(twice.heights[:points], twice.spacing, periodic=False)
    along = line.positions / line.positions[-1]
    form = surface["rise"] * along - 4 * surface["sag"] * along * (1 - along)
    raw = replace(line, heights=line.heights + form)
    return separate_line(raw, surface["form"], surface["waviness_wavelength"])


def _measurement(surface: Surface, files: Sequence[Path], part: type) -> dict[str, Any]:
    names = {field.name for field in fields(part)}
    return {"file": str(files[0]), **{name: value for name, value in surface.items() if name in names}}
