"""Plan of what needs a surface's heights: laws, topographies, and the studies that join them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from softlub.study.accuracy import PRESETS
from softlub.study.combinations import scenes_of
from softlub.study.drawings import DRAWINGS
from softlub.study.kinds import MATERIALS, built
from softlub.study.nodes import Node, make_node
from softlub.study.parsed import Pressures, Study
from softlub.study.specimens import height_scale, realisation, realisations, scaled, specimen
from softlub.study.stamp import REVISIONS, plain, stamp

LIGHTEST, HEAVIEST = 1e-3, 1.0
"""p/(E* h'_rms) between which a law is swept: from A/A0 of 0.2 % to all but full contact."""
TOLERANCE = 1e-6


def default_pressures(count: int) -> Pressures:
    """Pressures of a law, evenly spaced in their logarithm and rounded, so that every machine has the same."""
    ratio = HEAVIEST / LIGHTEST
    between = [LIGHTEST * ratio ** (i / (count - 1)) for i in range(count)]
    return Pressures("slope", tuple(float(f"{value:.12g}") for value in between))


def law_node(
    study: Study,
    surface: Mapping[str, Any],
    solver: Mapping[str, Any] | None = None,
    boundary: str | None = None,
    pressures: Mapping[str, Any] | None = None,
    further: Mapping[str, Any] | None = None,
) -> Node | None:
    """The law of a surface at the study's accuracy.

    Parameters
    ----------
    study : Study
    surface : mapping
        Canonical block.
    solver : mapping, optional
        Name and settings; the default solver's otherwise.
    boundary : {"periodic", "free"}, optional
        As the surface is otherwise.
    pressures : mapping, optional
        ``over`` and ``values`` in the units of the scaled surface; those of the accuracy otherwise.
    further : mapping, optional
        ``maps`` and ``gap_thresholds``, where somebody asks for them.

    Returns
    -------
    Node or None
        None where the surface is too large for the accuracy.
    """
    accuracy = PRESETS[study.accuracy]
    piece = specimen(surface, accuracy, study.files)
    if piece is None:
        return None
    loads = default_pressures(accuracy.contact_loads)
    spec = {
        "stage": "law",
        "revision": REVISIONS["law"],
        "surface": scaled(piece),
        "boundary": boundary,
        "pressures": pressures or {"over": loads.over, "values": list(loads.values)},
        "solver": solver or {"name": "conjugate_gradients", "tolerance": TOLERANCE},
        **(further or {}),
    }
    return make_node("law", _slug(piece), spec, files=_files(study, surface))


def topography_nodes(study: Study, surface: Mapping[str, Any], heights: bool) -> list[Node]:
    """One node for each realisation of a surface; heights are kept of the first."""
    piece = specimen(surface, PRESETS[study.accuracy], study.files)
    if piece is None:
        return []
    nodes = []
    for index in range(realisations(piece)):
        spec = {
            "stage": "topography",
            "revision": REVISIONS["topography"],
            "surface": realisation(piece, index),
            "heights": heights and index == 0,
        }
        nodes.append(make_node("topography", _slug(piece), spec, files=_files(study, surface)))
    return nodes


def _slug(piece: Mapping[str, Any]) -> str:
    points = f"-{piece['points']}" if "points" in piece else ""
    return f"{piece['kind']}{points}".replace("_", "-")


def _files(study: Study, surface: Mapping[str, Any]) -> tuple[str, ...]:
    return (str(study.files[surface["file"]].path),) if "file" in surface else ()


def contact_nodes(study: Study) -> list[Node]:
    """All nodes of a study of surfaces or of rough contacts, but for its figures."""
    scenes = list(scenes_of(study))
    topographies = (
        [_scene_topographies(study, scene) for scene in scenes]
        if study.kind == "surface" or _asks(study, "topographies")
        else []
    )
    laws = (
        [[_study_law(study, scene, solver) for solver in study.solvers] for scene in scenes]
        if study.kind == "rough_contact"
        else []
    )
    needed = [node for row in laws for node in row if node] + [node for row in topographies for node in row]
    nodes = list({node.key: node for node in needed}.values())
    place = {node.key: index for index, node in enumerate(node for node in nodes if node.kind == "law")}
    own = {node.key: index for index, node in enumerate(node for node in nodes if node.kind == "topography")}
    spec = {
        "stage": "contact_study" if study.kind == "rough_contact" else "surface_study",
        "revision": REVISIONS["study"],
        "sweeps": [{"dimension": sweep.dimension, "labels": plain(sweep.labels)} for sweep in study.sweeps],
        "solvers": list(study.solver_labels),
        "surfaces": [_described(study, scene) for scene in scenes],
        "laws": [[place[node.key] if node else None for node in row] for row in laws],
        "topographies": [[own[node.key] for node in row] for row in topographies],
        **stamp(study, _description(study)),
    }
    return [*nodes, make_node("study", study.name.lower(), spec, nodes, study.name)]


def _scene_topographies(study: Study, scene: Mapping[str, Any]) -> list[Node]:
    blocks = [scene[place] for place in ("surface", "line") if scene.get(place)]
    return [node for block in blocks for node in topography_nodes(study, block, needs_heights(study))]


def needs_heights(study: Study) -> bool:
    """Whether anybody asks for the heights of a surface."""
    return "heights" in study.outputs or _asks(study, "heights")


def _asks(study: Study, what: str) -> bool:
    return any(getattr(DRAWINGS[figure.draw], what) for figure in study.figures)


def _study_law(study: Study, scene: Mapping[str, Any], solver: Any) -> Node | None:
    height = height_scale(scene["surface"])
    further: dict[str, Any] = {}
    if "maps" in study.outputs or _asks(study, "maps"):
        further["maps"] = True
    if study.gap_thresholds:
        further["gap_thresholds"] = [threshold / height for threshold in study.gap_thresholds]
    return law_node(
        study,
        scene["surface"],
        {"name": solver.name, **solver.options},
        scene["boundary"],
        _scaled_pressures(study.pressures, modulus(scene), height),
        further,
    )


def modulus(scene: Mapping[str, Any]) -> float | None:
    """E* of the pressed body [Pa]; None where the scene names none."""
    if scene["body"] is None:
        return None
    return float(built(MATERIALS, scene["body"]["material"]).plane_strain_modulus)


def _scaled_pressures(
    pressures: Pressures | None, plane_strain_modulus: float | None, height: float
) -> dict[str, Any] | None:
    if pressures is None:
        return None
    if pressures.over == "slope":
        return {"over": "slope", "values": list(pressures.values)}
    assert plane_strain_modulus is not None
    return {"over": "modulus", "values": [p / (plane_strain_modulus * height) for p in pressures.values]}


def _described(study: Study, scene: Mapping[str, Any]) -> dict[str, Any]:
    """What a study's dataset tells of one of its surfaces, and what turns its law into SI."""
    surface = scene["surface"]
    if surface is None:
        return {"asked": {}, "made": None}
    return {
        "asked": {key: value for key, value in surface.items() if key != "file"},
        "made": specimen(surface, PRESETS[study.accuracy], study.files),
        "height": height_scale(surface),
        "modulus": modulus(scene) if study.kind == "rough_contact" else None,
    }


def _description(study: Study) -> dict[str, Any]:
    return {
        "scene": plain(study.scene),
        "sweeps": {sweep.path: plain(sweep.values) for sweep in study.sweeps},
        "solvers": [solver.model_dump(by_alias=True) for solver in study.solvers],
        "pressures": study.pressures
        and {"over": study.pressures.over, "values": list(study.pressures.values)},
        "gap_thresholds": list(study.gap_thresholds),
        "accuracy": study.accuracy,
    }


def panel_laws(study: Study, scenes: Sequence[Mapping[str, Any]]) -> tuple[list[Node], list[int | None]]:
    """Laws that lubricated contacts read, and which of them each scene reads.

    Parameters
    ----------
    study : Study
    scenes : sequence of mapping
        Canonical scenes of a panel, in its order.

    Returns
    -------
    nodes : list of Node
    index : list of int or None
        None for a scene whose law is made where it is used.
    """
    nodes: dict[str, int] = {}
    found: list[Node] = []
    index: list[int | None] = []
    for scene in scenes:
        if scene["contact_law"]["name"] != "boundary_element":
            index.append(None)
            continue
        node = law_node(study, scene["surface"])
        assert node is not None, "checked when the study was read"
        if node.key not in nodes:
            nodes[node.key] = len(found)
            found.append(node)
        index.append(nodes[node.key])
    return found, index
