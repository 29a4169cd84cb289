"""Specimens: the pieces of a surface that jobs make or read, as nodes of the plan name them.

A contact scales with the height of its surface: twice the heights at twice the pressure touch in the same places with
twice the gap. So a law is computed for heights in units of the surface's own h_rms and is the same node for every
roughness and modulus; a measured surface stays as it is.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from softlub.study.accuracy import Accuracy
from softlub.study.kinds import field_names
from softlub.study.measured_files import MeasuredFile
from softlub.surfaces.spectrum import SelfAffine

Surface = Mapping[str, Any]

SPECTRUM = tuple(field_names(SelfAffine))
REALISATIONS = 3
"""Pieces that are averaged over where neither study nor size say otherwise, as in the source."""


def without_specimen(surface: Surface) -> dict[str, Any]:
    """A canonical surface without what concerns pieces of it: all that its spectrum's theory needs."""
    if surface["kind"] != "self_affine":
        return dict(surface)
    return {key: value for key, value in surface.items() if key == "kind" or key in SPECTRUM}


def specimen(
    surface: Surface, accuracy: Accuracy, files: Mapping[str, MeasuredFile]
) -> dict[str, Any] | None:
    """What is made of a surface at some accuracy.

    Parameters
    ----------
    surface : mapping
        Canonical block of a rough surface or a line.
    accuracy : Accuracy
    files : mapping
        Instruments' files by the name that the study gives them.

    Returns
    -------
    dict or None
        The block with points, cut-off and number of realisations settled, or with the hash of its file in place of
        the path; None where the surface is too large for the accuracy.
    """
    if "file" in surface:
        settled = {key: value for key, value in surface.items() if key != "file"}
        return {**settled, "sha256": files[surface["file"]].digest}
    if surface["kind"] != "self_affine":
        return dict(surface)
    points, cutoff = surface["points"], surface["cutoff"]
    if points > accuracy.surface_points:
        if not accuracy.coarsened:
            return None
        points = accuracy.surface_points
        cutoff = min(cutoff, math.pi * points / surface["size"])
        if cutoff <= surface["rolloff"]:
            return None
    default = REALISATIONS if points <= accuracy.averaged_points else 1
    return {
        **surface,
        "points": points,
        "cutoff": cutoff,
        "realisations": surface["realisations"] or default,
    }


def height_scale(surface: Surface) -> float:
    """Height that a specimen's law counts in [m]: h_rms, and 1 m where only the measurement knows it."""
    return float(surface.get("rms_roughness", 1.0))


def scaled(surface: Surface) -> dict[str, Any]:
    """A specimen with heights in units of `height_scale`: what its law depends on."""
    return {**surface, "rms_roughness": 1.0} if "rms_roughness" in surface else dict(surface)


def realisations(surface: Surface) -> int:
    """Number of pieces of a specimen."""
    return int(surface.get("realisations", 1))


def realisation(surface: Surface, index: int) -> dict[str, Any]:
    """One piece of a specimen."""
    if "realisations" not in surface:
        return dict(surface)
    own = {key: value for key, value in surface.items() if key != "realisations"}
    return {**own, "seed": surface["seed"] + index}
