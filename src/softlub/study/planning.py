"""The plan of a study: a pure function of what the study says."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from typing import Any

from softlub.study import paths
from softlub.study.accuracy import PRESETS
from softlub.study.combinations import scenes_of
from softlub.study.contact_planning import contact_nodes, modulus, panel_laws
from softlub.study.drawings import DRAWINGS
from softlub.study.nodes import Node, Plan, make_node
from softlub.study.outputs import SCALARS, left_out
from softlub.study.parsed import Study, Sweep
from softlub.study.solid_nodes import settled_mesh
from softlub.study.solid_planning import equivalence_nodes, film_stiffnesses, material_nodes, solid_nodes
from softlub.study.solvers import settings
from softlub.study.specimens import without_specimen
from softlub.study.stamp import REVISIONS, plain, stamp

CHUNK = 1024
"""Curves of a sample that one panel solves; a power of two, so that each chunk of a Sobol design is balanced."""


def plan(study: Study) -> Plan:
    """Everything that a study needs.

    Parameters
    ----------
    study : Study

    Returns
    -------
    Plan
        Laws and panels, or topographies, the study that joins them, its figures.
    """
    nodes = NODES[study.kind](study)
    joined = nodes[-1]
    figures = [
        make_node(
            "figure",
            f"{study.name}-{figure.name}".lower(),
            {
                "stage": "figure",
                "revision": REVISIONS["figure"],
                "study": study.name,
                "figure": figure.name,
                "draw": figure.draw,
                "options": plain(figure.options),
            },
            [joined],
            f"{study.name}/{figure.name}",
        )
        for figure in study.figures
    ]
    chapters = {} if study.chapter is None else {study.name: study.chapter}
    # Two solvers with different labels may be the same one.
    return Plan(tuple({node.key: node for node in [*nodes, *figures]}.values()), chapters)


def needs_fields(study: Study) -> bool:
    """Whether anybody asks for pressures and separation over x."""
    return "fields" in study.outputs or any(DRAWINGS[figure.draw].fields for figure in study.figures)


def _lubricated_nodes(study: Study) -> list[Node]:
    """Laws, panels and the study itself."""
    scenes = list(scenes_of(study))
    laws, law_index = panel_laws(study, scenes)
    stiffnesses, stiffness_index = film_stiffnesses(study, scenes)
    read = {
        **({"laws": law_index} if laws else {}),
        **({"stiffnesses": stiffness_index} if stiffnesses else {}),
    }
    panels, labels = _panels(study, [*laws, *stiffnesses], read)
    return [*laws, *stiffnesses, *panels, _study_node(study, panels, labels)]


def _deflection_nodes(study: Study) -> list[Node]:
    """The study itself, whose job is too small to be cut."""
    body = study.scene["body"]
    spec = {
        "stage": "deflection_study",
        "revision": REVISIONS["study"],
        "radius": body["shape"]["radius"],
        "modulus": modulus(study.scene),
        **study.deflection,
        **stamp(study, {"scene": plain(study.scene), **study.deflection}),
    }
    return [make_node("study", study.name.lower(), spec, name=study.name)]


NODES = {
    "stribeck": _lubricated_nodes,
    "rough_contact": contact_nodes,
    "surface": contact_nodes,
    "deflection": _deflection_nodes,
    "solid": solid_nodes,
    "equivalence": equivalence_nodes,
    "material": material_nodes,
}
"""What plans each kind of study; its last node is the study itself."""


def _panels(
    study: Study, inputs: list[Node], read: Mapping[str, list[int | None]]
) -> tuple[list[Node], list[str]]:
    accuracy = PRESETS[study.accuracy]
    panels: list[Node] = []
    labels: list[str] = []
    for solver, label in zip(study.solvers, study.solver_labels, strict=True):
        chosen = settings(solver, accuracy)
        for sample in _chunks(study):
            spec = {
                "stage": "panel",
                "revision": REVISIONS["panel"],
                "scene": base_scene(study, solver.half_domain),
                "sweeps": [
                    {
                        "dimension": sweep.dimension,
                        "path": sweep.path,
                        "values": _solved_values(sweep),
                        "labels": list(sweep.labels),
                    }
                    for sweep in study.sweeps
                ],
                **read,
                "sample": sample,
                "load": list(study.loads),
                "speed": solver.speeds(study.speeds),
                "solver": chosen,
                "fields": needs_fields(study),
            }
            panels.append(make_node("panel", _slug(spec), spec, inputs))
            labels.append(label)
    return panels, labels


def _solved_values(sweep: Sweep) -> list[Any]:
    """Values of a swept field as a panel knows them: a surface by its spectrum."""
    values: list[Any] = plain(sweep.values)
    if sweep.path == "surface":
        return [without_specimen(value) for value in values]
    if sweep.path == "body.shape":
        return [_without_file(value) for value in values]
    return values


def base_scene(study: Study, half_domain: float | None = None) -> dict[str, Any]:
    """The scene that a panel starts from: what is varied holds its first value.

    Parameters
    ----------
    study : Study
    half_domain : float, optional
        The solver's own domain, which goes before the scene's, and that before the accuracy's [m].

    Returns
    -------
    dict
    """
    scene: dict[str, Any] = copy.deepcopy(dict(study.scene))
    scene["half_domain"] = half_domain or scene["half_domain"] or PRESETS[study.accuracy].half_domain
    for sweep in study.sweeps:
        scene = paths.replaced(scene, sweep.path, plain(sweep.values[0]))
    for path, bounds in (study.sample.ranges if study.sample else {}).items():
        if path != "load":
            scene = paths.replaced(scene, path, bounds.low)
    if scene["body"]["stiffness"] != "half_space":
        # Its film reaches as far as its contact edge.
        scene["half_domain"] = None
        scene["body"]["mesh"] = settled_mesh(study.accuracy, scene["body"]["mesh"])
        scene["body"]["shape"] = _without_file(scene["body"]["shape"])
    # Where a measured surface lies is no part of the key: what is in it stands in the law's.
    surface = without_specimen(scene["surface"])
    scene["surface"] = {"kind": "measured"} if surface["kind"] == "measured" else surface
    return scene


def _without_file(shape: Mapping[str, Any]) -> dict[str, Any]:
    """A shape without the place of a measured edge, what is in which stands in the stiffness's key."""
    return {key: value for key, value in shape.items() if key != "file"}


def _chunks(study: Study) -> Iterator[dict[str, Any] | None]:
    sample = study.sample
    if sample is None:
        yield None
        return
    ranges = {
        path: {"from": bounds.low, "to": bounds.high, "spacing": bounds.spacing}
        for path, bounds in sample.ranges.items()
    }
    for first in range(0, sample.points, CHUNK):
        yield {
            "seed": sample.seed,
            "first": first,
            "size": min(CHUNK, sample.points - first),
            "ranges": ranges,
        }


def _slug(spec: Mapping[str, Any]) -> str:
    scene = spec["scene"]
    shape, law = scene["body"]["shape"]["kind"], scene["contact_law"]["name"]
    contact = "smooth" if law == "none" else law
    return f"{shape}-{contact}-{spec['solver']['name']}".replace("_", "-")


def _study_node(study: Study, panels: list[Node], labels: list[str]) -> Node:
    # Figures read the scalars, whichever groups the file names besides.
    outputs = {
        *study.outputs,
        *(SCALARS if study.figures else ()),
        *(["fields"] if needs_fields(study) else []),
    }
    spec = {
        "stage": "study",
        "revision": REVISIONS["study"],
        "shear_strength": plain(study.shear_strength),
        "solvers": labels,
        "left_out": left_out(outputs),
        **stamp(study, _description(study)),
    }
    return make_node("study", study.name.lower(), spec, panels, study.name)


def _description(study: Study) -> dict[str, Any]:
    """What the dataset tells of its study: everything but the figures."""
    sample = study.sample
    return {
        "scene": plain(study.scene),
        "shear_strength": plain(study.shear_strength),
        "load": list(study.loads),
        "speed": list(study.speeds),
        "sweeps": {sweep.path: plain(sweep.values) for sweep in study.sweeps},
        "sample": sample
        and {
            "points": sample.points,
            "seed": sample.seed,
            "ranges": {path: [r.low, r.high, r.spacing] for path, r in sample.ranges.items()},
        },
        "solvers": [solver.model_dump(by_alias=True) for solver in study.solvers],
        "accuracy": study.accuracy,
    }
