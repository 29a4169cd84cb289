"""What only the whole study shows about the surfaces that it presses: too large, too many, or pressed for nothing."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import Any

from softlub.contact.memory import estimated_bytes
from softlub.study.accuracy import PRESETS
from softlub.study.combinations import scenes_of
from softlub.study.messages import Problem
from softlub.study.parsed import Study
from softlub.study.specimens import SPECTRUM, specimen

Surface = Mapping[str, Any]


def contact_problems(study: Study) -> Iterator[Problem]:
    """What is wrong with a study of surfaces or of rough contacts."""
    scenes = list(scenes_of(study))
    surfaces = [scene["surface"] for scene in scenes if scene["surface"] is not None]
    made = [specimen(surface, PRESETS[study.accuracy], study.files) for surface in surfaces]
    if surfaces and not any(made):
        yield _too_large(study, scenes[0]["surface"])
    if study.kind != "rough_contact":
        return
    if study.pressures is not None and study.pressures.over == "pascal" and study.scene["body"] is None:
        yield Problem(
            "grid.pressure",
            "needs the modulus; give scene.body.material, or grid.normalised_pressure instead",
        )
    for label in study.solver_labels:
        if study.solver_labels.count(label) > 1:
            yield Problem("grid.solver", f"has {label} twice; drop one, or give each a label")
    for scene, piece in zip(scenes, made, strict=True):
        yield from _memory_problems(piece, scene["boundary"] != "free")


def law_problems(study: Study) -> Iterator[Problem]:
    """What is wrong with the tabulated laws of a study of lubricated contacts."""
    ranges = study.sample.ranges if study.sample else {}
    scenes = list(scenes_of(study))
    tabulated = [scene for scene in scenes if scene["contact_law"]["name"] == "boundary_element"]
    varied = [sweep.path for sweep in study.sweeps]
    for path in [*varied, *ranges]:
        name = path.removeprefix("surface.")
        if path.startswith("surface.") and name not in SPECTRUM and not tabulated:
            yield Problem(
                f"grid.scene.{path}",
                "varies the pieces of the surface that are made, and no contact_law of the study makes any; "
                "take contact_law: boundary_element",
            )
    if not tabulated:
        return
    for path in ranges:
        if path.startswith("surface.") and path != "surface.rms_roughness":
            yield Problem(
                f"grid.sample.ranges.scene.{path}",
                "would need a rough contact for every point of the sample; "
                "allowed with boundary_element: scene.surface.rms_roughness, or sweep the field in steps",
            )
    yield from tabulated_problems(study)


def tabulated_problems(study: Study) -> Iterator[Problem]:
    """Surfaces that a study has pressed for their law, and that are too large."""
    for scene in scenes_of(study):
        if scene.get("contact_law", {}).get("name") != "boundary_element":
            continue
        piece = specimen(scene["surface"], PRESETS[study.accuracy], study.files)
        if piece is None:
            yield _too_large(study, scene["surface"])
        yield from _memory_problems(piece, periodic=True)


def _too_large(study: Study, surface: Surface) -> Problem:
    most = PRESETS[study.accuracy].surface_points
    return Problem(
        "scene.surface.points",
        f"is more than the accuracy {study.accuracy} makes; allowed: {most} at most, or accuracy: source",
        str(surface.get("points", "")),
    )


def _memory_problems(piece: Surface | None, periodic: bool) -> Iterator[Problem]:
    if piece is None or "points" not in piece:
        return
    points = piece["points"]
    needed = estimated_bytes((points, points), periodic)
    there = machine_memory()
    if needed > there:
        yield Problem(
            "scene.surface.points",
            f"needs about {needed / 1e9:.1f} GB, and this machine has {there / 1e9:.1f} GB; take fewer points",
            str(points),
        )


def machine_memory() -> float:
    """All that the machine has [bytes]: what is free is another amount when the job runs, which looks again."""
    return float(os.sysconf("SC_PHYS_PAGES")) * float(os.sysconf("SC_PAGE_SIZE"))
