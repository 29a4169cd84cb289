"""What only the whole study shows about its finite-element bodies: meshes that cannot be made, surfaces too large."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from softlub.solid.materials.moduli import material_at_frequency
from softlub.solid.shapes.density import MeshDensity
from softlub.study import kinds
from softlub.study.combinations import scenes_of
from softlub.study.contact_checks import tabulated_problems
from softlub.study.messages import Problem
from softlub.study.parsed import Study
from softlub.study.solid_nodes import settled_mesh


def body_problems(study: Study) -> Iterator[Problem]:
    """What is wrong with the finite-element bodies of a study, film or not."""
    for scene in scenes_of(study):
        body = scene["body"]
        if "mesh" in body:
            shape = dict(body["shape"])
            if "file" in shape:
                shape["file"] = str(study.files[shape["file"]].path)
            yield from _mesh_problems(shape, settled_mesh(study.accuracy, body["mesh"]))


def solid_problems(study: Study) -> Iterator[Problem]:
    """What is wrong with a study of finite-element bodies."""
    yield from body_problems(study)
    yield from tabulated_problems(study)
    yield from _temperature_problems(study)
    yield from _frequency_problems(study)
    if "constrained" in study.solid.get("compare", ()):
        yield from _constraint_problems(study)


def _constraint_problems(study: Study) -> Iterator[Problem]:
    laws = {scene["contact_law"]["name"] for scene in scenes_of(study)} - {"hard"}
    if laws:
        yield Problem(
            "compare",
            f"constrained keeps the penalty of a hard contact, and contact_law is {', '.join(sorted(laws))}; leave it "
            "out, or take a smooth surface",
        )


def _mesh_problems(shape: Mapping[str, Any], mesh: Mapping[str, Any]) -> Iterator[Problem]:
    complaint = _complaint(json.dumps(shape, sort_keys=True), json.dumps(mesh, sort_keys=True))
    if complaint:
        yield Problem("scene.body.mesh", complaint)


@lru_cache(maxsize=256)
def _complaint(shape: str, mesh: str) -> str:
    """What is wrong with a mesh; empty where it can be used. A run reads its studies twice, the mesh is made once."""
    try:
        kinds.built(kinds.MESHED_SHAPES, json.loads(shape)).mesh(MeshDensity(**json.loads(mesh)))
    except ValueError as error:
        return str(error)
    return ""


def _temperature_problems(study: Study) -> Iterator[Problem]:
    for scene in scenes_of(study):
        shift = scene.get("time_temperature") or {}
        for temperature in study.solid.get("temperature", ()):
            try:
                kinds.TIME_TEMPERATURE(**shift).shift_factor(temperature)
            except ValueError as error:
                yield Problem("grid.temperature", str(error), f"{temperature:g}")


def _frequency_problems(study: Study) -> Iterator[Problem]:
    """Frequencies at which a stiffness is asked for and a linear elastic material would stiffen beyond its volume."""
    for frequency in study.solid.get("stiffness_frequency", ()):
        for scene in scenes_of(study):
            material = kinds.built(kinds.MATERIALS, scene["body"]["material"])
            try:
                material_at_frequency(material, frequency)
            except ValueError as error:
                yield Problem("grid.stiffness_frequency", str(error), f"{frequency:g}")
