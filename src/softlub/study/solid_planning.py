"""Plan of finite-element bodies: states under load, reduced stiffnesses, equivalent bodies, and the studies of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from softlub.study import parts
from softlub.study.accuracy import PRESETS
from softlub.study.combinations import scenes_of
from softlub.study.contact_planning import law_node
from softlub.study.drawings import DRAWINGS
from softlub.study.nodes import Node, make_node
from softlub.study.parsed import Study
from softlub.study.quantities import rounded
from softlub.study.specimens import height_scale, without_specimen
from softlub.study.stamp import REVISIONS, plain, stamp

REMEMBERING = ("viscoelastic",)
"""Kinds of materials to which the durations of the steps matter."""
COEFFICIENTS = (0.5, 5.0)
"""Bounds between which the equivalence coefficient is sought."""

Scene = Mapping[str, Any]


def body_spec(study: Study, body: Mapping[str, Any]) -> dict[str, Any]:
    """A body as a job makes it, its mesh settled at the study's accuracy.

    Parameters
    ----------
    study : Study
    body : mapping
        Canonical block.

    Returns
    -------
    dict
        ``shape``, ``material``, ``element`` and ``mesh``; of a measured shape the hash of its file in place of the
        path.
    """
    shape = plain(body["shape"])
    if "file" in shape:
        shape["sha256"] = study.files[shape.pop("file")].digest
    return {
        "shape": shape,
        "material": plain(body["material"]),
        "element": body["element"],
        "mesh": settled_mesh(study.accuracy, body["mesh"]),
    }


def settled_mesh(accuracy: str, mesh: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers of a mesh: those of the study, and where it names none those of the accuracy."""
    preset = PRESETS[accuracy]
    numbers = {
        "edge_nodes": preset.edge_nodes,
        "rows": preset.mesh_rows,
        "flank_columns": preset.flank_columns,
    }
    # A swept number comes as a float.
    settled: dict[str, Any] = {name: int(mesh[name] or default) for name, default in numbers.items()}
    return {**settled, "first_height": mesh["first_height"]}


def body_files(study: Study, body: Mapping[str, Any]) -> tuple[str, ...]:
    """The file of a measured shape, as a job's input."""
    return (str(study.files[body["shape"]["file"]].path),) if "file" in body["shape"] else ()


def at_rest(material: Mapping[str, Any]) -> dict[str, Any]:
    """The material that a body's stiffness at rest depends on: of a viscoelastic one that without its memory.

    One whose constants describe the response at once stays as it is, and the job that reads it takes it apart.
    """
    if material["kind"] in REMEMBERING and material["constants"] == "long_term":
        return dict(material["hyperelastic"])
    return dict(material)


def equivalent(material: Mapping[str, Any], coefficient: float) -> dict[str, Any]:
    """The hyperelastic material of a coefficient (equations 5-17 and 5-18)."""
    rest = parts.built(parts.MATERIALS, material).at_rest.scaled(coefficient)
    # Rounded, so that a coefficient of 1 is the material itself on every machine.
    return {"kind": "neo_hookean", "c10": rounded(rest.c10, 12), "d1": rounded(rest.d1, 12)}


def steps_spec(material: Mapping[str, Any], scene: Scene, load: float) -> list[dict[str, Any]]:
    """The steps of a job: in contact, loading, sliding; durations only where the material remembers them."""
    options = parts.model_of(parts.STEPS).model_validate(dict(scene["steps"])).build()
    steps: list[dict[str, Any]] = [
        {"name": "in_contact", "overlap": options.overlap},
        {"name": "loading", "load": load},
        {"name": "sliding", "friction": scene["friction"]},
    ]
    if material["kind"] in REMEMBERING:
        timed = {"increments": options.increments}
        return [{**step, "duration": options.durations[step["name"]], **timed} for step in steps]
    return steps if scene["friction"] else steps[:2]


def contact_spec(study: Study, scene: Scene) -> tuple[dict[str, Any], list[Node]]:
    """What a body meets, and the law that a job reads for it where there is one."""
    law = dict(scene["contact_law"])
    surface = scene["surface"]
    if law["name"] == "hard":
        return law, []
    if law["name"] != "boundary_element":
        return {**law, "surface": without_specimen(surface)}, []
    node = law_node(study, surface)
    assert node is not None, "checked when the study was read"
    return {**law, "height": height_scale(surface)}, [node]


def state_node(
    study: Study, scene: Scene, load: float, material: Mapping[str, Any] | None = None
) -> list[Node]:
    """The body of a scene under a load, after what it reads.

    Parameters
    ----------
    study : Study
    scene : mapping
        Canonical scene.
    load : float
        [N/m]
    material : mapping, optional
        In place of the scene's.

    Returns
    -------
    list of Node
        The last one is the state.
    """
    body = body_spec(study, scene["body"])
    # Asperities are those of the scene's own material, whatever its body is compared with.
    contact, laws = contact_spec(study, scene)
    if contact["name"] != "hard":
        contact["material"] = at_rest(body["material"])
    if material is not None:
        body["material"] = plain(material)
    spec = {
        "stage": "solid_state",
        "revision": REVISIONS["state"],
        "body": body,
        "contact": contact,
        "steps": steps_spec(body["material"], scene, load),
    }
    return [*laws, _body_node(study, scene["body"], "state", spec, laws)]


def stiffness_node(
    study: Study, body: Mapping[str, Any], frequency: float = 0.0, fit: Node | None = None
) -> Node:
    """The reduced stiffness of a body at its initial state.

    Parameters
    ----------
    study : Study
    body : mapping
        Canonical block.
    frequency : float
        ω [rad/s] of the storage modulus; 0 for the body at rest.
    fit : Node, optional
        Equivalent body, whose coefficient the material at rest is scaled with.

    Returns
    -------
    Node
    """
    made = body_spec(study, body)
    if not frequency:
        made["material"] = at_rest(made["material"])
    spec = {
        "stage": "reduced_stiffness",
        "revision": REVISIONS["stiffness"],
        "body": made,
        **({"frequency": frequency} if frequency else {}),
    }
    return _body_node(study, body, "stiffness", spec, [] if fit is None else [fit])


def _body_node(
    study: Study, body: Mapping[str, Any], kind: str, spec: Mapping[str, Any], inputs: Sequence[Node]
) -> Node:
    made = spec["body"]
    words = [made["shape"]["kind"], made["material"]["kind"], str(made["mesh"]["edge_nodes"])]
    return make_node(kind, "-".join(words).replace("_", "-"), spec, inputs, files=body_files(study, body))


def fit_node(study: Study, scene: Scene, load: float, state: Node) -> Node:
    """The search for the hyperelastic body that takes a viscoelastic one's shape."""
    body = body_spec(study, scene["body"])
    contact, laws = contact_spec(study, scene)
    if contact["name"] != "hard":
        contact["material"] = at_rest(body["material"])
    rest = equivalent(body["material"], 1.0)
    spec = {
        "stage": "equivalence_fit",
        "revision": REVISIONS["equivalence"],
        "body": {**body, "material": rest},
        "contact": contact,
        "steps": steps_spec(rest, scene, load),
        "bounds": list(COEFFICIENTS),
    }
    return _body_node(study, scene["body"], "equivalence", spec, [state, *laws])


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
