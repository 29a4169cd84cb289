"""Nodes of finite-element bodies: states under load, reduced stiffnesses, searches for an equivalent body."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from softlub.study import kinds, parts
from softlub.study.accuracy import PRESETS
from softlub.study.contact_planning import law_node
from softlub.study.nodes import Node, make_node
from softlub.study.parsed import Study
from softlub.study.quantities import rounded
from softlub.study.specimens import height_scale, without_specimen
from softlub.study.stamp import REVISIONS, plain

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
    rest = kinds.built(kinds.MATERIALS, material).at_rest.scaled(coefficient)
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
