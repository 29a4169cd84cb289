"""The plan of a study: a pure function of what the study says."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from typing import Any

from softlub.study import paths
from softlub.study.accuracy import PRESETS
from softlub.study.drawings import DRAWINGS
from softlub.study.nodes import Node, Plan, digest, make_node
from softlub.study.outputs import SCALARS, left_out
from softlub.study.parsed import Study
from softlub.study.solvers import settings

REVISIONS = {"panel": 1, "study": 1, "figure": 1}
"""Raised when a stage's results change without a change of its spec: all its nodes are then computed anew."""

CHUNK = 512
"""Curves of a sample that one panel solves; a power of two, so that each chunk of a Sobol design is balanced."""


def plan(study: Study) -> Plan:
    """Everything that a study needs.

    Parameters
    ----------
    study : Study

    Returns
    -------
    Plan
        Panels, the study that joins them, its figures.
    """
    panels, labels = _panels(study)
    joined = _study_node(study, panels, labels)
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
                "options": _plain(figure.options),
            },
            [joined],
            f"{study.name}/{figure.name}",
        )
        for figure in study.figures
    ]
    chapters = {} if study.chapter is None else {study.name: study.chapter}
    # Two solvers with different labels may be the same one.
    return Plan(tuple({node.key: node for node in [*panels, joined, *figures]}.values()), chapters)


def needs_fields(study: Study) -> bool:
    """Whether anybody asks for pressures and separation over x."""
    return "fields" in study.outputs or any(DRAWINGS[figure.draw].fields for figure in study.figures)


def _panels(study: Study) -> tuple[list[Node], list[str]]:
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
                        "values": _plain(sweep.values),
                        "labels": list(sweep.labels),
                    }
                    for sweep in study.sweeps
                ],
                "sample": sample,
                "load": list(study.loads),
                "speed": solver.speeds(study.speeds),
                "solver": chosen,
                "fields": needs_fields(study),
            }
            panels.append(make_node("panel", _slug(spec), spec))
            labels.append(label)
    return panels, labels


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
        scene = paths.replaced(scene, sweep.path, _plain(sweep.values[0]))
    for path, bounds in (study.sample.ranges if study.sample else {}).items():
        if path != "load":
            scene = paths.replaced(scene, path, bounds.low)
    return scene


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
    described = _description(study)
    spec = {
        "stage": "study",
        "revision": REVISIONS["study"],
        "study": study.name,
        "title": study.title,
        "shear_strength": _plain(study.shear_strength),
        "solvers": labels,
        "left_out": left_out(outputs),
        "stand_ins": [{"key": entry.key, "reason": entry.reason} for entry in study.stand_ins],
        "definition": described,
        "definition_hash": digest(described),
    }
    return make_node("study", study.name.lower(), spec, panels, study.name)


def _description(study: Study) -> dict[str, Any]:
    """What the dataset tells of its study: everything but the figures."""
    sample = study.sample
    return {
        "scene": _plain(study.scene),
        "shear_strength": _plain(study.shear_strength),
        "load": list(study.loads),
        "speed": list(study.speeds),
        "sweeps": {sweep.path: _plain(sweep.values) for sweep in study.sweeps},
        "sample": sample
        and {
            "points": sample.points,
            "seed": sample.seed,
            "ranges": {path: [r.low, r.high, r.spacing] for path, r in sample.ranges.items()},
        },
        "solvers": [solver.model_dump(by_alias=True) for solver in study.solvers],
        "accuracy": study.accuracy,
    }


def _plain(value: Any) -> Any:
    """A value as JSON knows it."""
    if isinstance(value, Mapping):
        return {str(key): _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(entry) for entry in value]
    return value
