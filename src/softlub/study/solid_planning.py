"""Plan of finite-element studies: which bodies each needs, and which of them its dataset and its panels read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from softlub.study.combinations import scenes_of
from softlub.study.drawings import DRAWINGS
from softlub.study.nodes import Node, make_node
from softlub.study.parsed import Study
from softlub.study.solid_nodes import Scene, equivalent, fit_node, state_node, stiffness_node
from softlub.study.stamp import REVISIONS, plain, stamp


@dataclass
class Inputs:
    """Nodes that a study reads, each once, and the places of those that it asks for among those of their kind."""

    nodes: dict[str, Node] = field(default_factory=dict)

    def place(self, nodes: Iterable[Node]) -> int:
        """Add nodes, and say at which place among its kind the last of them stands."""
        last = None
        for last in nodes:
            self.nodes.setdefault(last.key, last)
        assert last is not None
        return [key for key, node in self.nodes.items() if node.kind == last.kind].index(last.key)

    def read(self, *kinds: str) -> list[Node]:
        """Those of some kinds."""
        return [node for node in self.nodes.values() if node.kind in kinds]


def solid_nodes(study: Study) -> list[Node]:
    """All nodes of a study of a body under load, but for its figures."""
    inputs, scenes = Inputs(), list(scenes_of(study))
    states = [[inputs.place(state_node(study, scene, load)) for load in study.loads] for scene in scenes]
    compare = study.solid["compare"]
    reduced = [
        inputs.place([stiffness_node(study, scene["body"])])
        if {"reduced", "constrained"} & {*compare}
        else None
        for scene in scenes
    ]
    spec = {
        "stage": "solid_study",
        "compare": list(compare),
        "datum": list(study.solid["datum"]),
        "states": states,
        "stiffnesses": reduced,
        "penalties": [scene["contact_law"].get("penalty") for scene in scenes],
        "materials": [plain(scene["body"]["material"]) for scene in scenes],
        **_shared(study),
    }
    return _joined(study, spec, inputs, ("state", "stiffness"))


def equivalence_nodes(study: Study) -> list[Node]:
    """All nodes of a study of equivalent bodies, but for its figures."""
    inputs, scenes = Inputs(), list(scenes_of(study))
    rows = []
    for scene in scenes:
        rows.append([_equivalents(study, scene, load, inputs) for load in study.loads])
    spec = {
        "stage": "equivalence_study",
        "coefficients": list(study.solid["coefficient"]),
        "rows": rows,
        **_shared(study),
    }
    return _joined(study, spec, inputs, ("state", "equivalence", "stiffness"))


def _equivalents(study: Study, scene: Scene, load: float, inputs: Inputs) -> dict[str, Any]:
    body = scene["body"]
    relaxing = state_node(study, scene, load)
    fit = fit_node(study, scene, load, relaxing[-1])
    given = [equivalent(body["material"], value) for value in study.solid["coefficient"]]
    return {
        "viscoelastic": inputs.place(relaxing),
        "fitted": inputs.place([fit]),
        "given": [inputs.place(state_node(study, scene, load, material)) for material in given],
        "stiffness_fitted": inputs.place([stiffness_node(study, body, fit=fit)]),
        "stiffness_given": [
            inputs.place([stiffness_node(study, {**body, "material": material})]) for material in given
        ],
    }


def material_nodes(study: Study) -> list[Node]:
    """All nodes of a study of materials, but for its figures."""
    inputs, scenes = Inputs(), list(scenes_of(study))
    frequencies = study.solid["stiffness_frequency"]
    stiffnesses = [
        [inputs.place([stiffness_node(study, scene["body"], frequency)]) for frequency in frequencies]
        for scene in scenes
    ]
    spec = {
        "stage": "material_study",
        "materials": [plain(scene["body"]["material"]) for scene in scenes],
        "time_temperature": [plain(scene["time_temperature"]) for scene in scenes],
        "frequency": list(study.solid["frequency"]),
        "temperature": list(study.solid["temperature"]),
        "stiffness_frequency": list(frequencies),
        "stiffnesses": stiffnesses,
        **_shared(study),
    }
    return _joined(study, spec, inputs, ("stiffness",))


def film_stiffnesses(study: Study, scenes: Sequence[Scene]) -> tuple[list[Node], list[int | None]]:
    """Reduced stiffnesses that lubricated contacts read, and which of them each scene reads.

    Parameters
    ----------
    study : Study
    scenes : sequence of mapping
        Canonical scenes of a panel, in its order.

    Returns
    -------
    nodes : list of Node
    index : list of int or None
        None for a half-space, which is made where it is used.
    """
    inputs = Inputs()
    index = [
        None
        if scene["body"]["stiffness"] == "half_space"
        else inputs.place([stiffness_node(study, scene["body"])])
        for scene in scenes
    ]
    return inputs.read("stiffness"), index


def _shared(study: Study) -> dict[str, Any]:
    keep = {
        *study.outputs,
        *(["mesh"] if any(DRAWINGS[figure.draw].mesh for figure in study.figures) else []),
    }
    return {
        "revision": REVISIONS["study"],
        "sweeps": [{"dimension": sweep.dimension, "labels": plain(sweep.labels)} for sweep in study.sweeps],
        "load": list(study.loads),
        "keep": sorted(keep),
    }


def _joined(study: Study, spec: Mapping[str, Any], inputs: Inputs, kinds: tuple[str, ...]) -> list[Node]:
    description = {
        "scene": plain(study.scene),
        "sweeps": {sweep.path: plain(sweep.values) for sweep in study.sweeps},
        "load": list(study.loads),
        "solid": plain(study.solid),
        "accuracy": study.accuracy,
    }
    read = inputs.read(*kinds)
    whole = {**spec, **stamp(study, description)}
    return [*inputs.nodes.values(), make_node("study", study.name.lower(), whole, read, study.name)]
