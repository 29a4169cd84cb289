"""From the canonical scene of a node's spec to the objects that the physics works with."""

from __future__ import annotations

import copy
from typing import Any

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.protocols import ContactLaw
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.solid.shapes.cylinder import Cylinder
from softlub.surfaces.spectrum import SelfAffine, Smooth

Scene = dict[str, Any]

SURFACES = {"self_affine": SelfAffine, "smooth": Smooth}
SHAPES = {"cylinder": Cylinder}
MATERIALS = {"linear_elastic": LinearElastic}
LAWS = {"persson": PerssonLaw, "exponential": ExponentialLaw}


def with_value(scene: Scene, path: str, value: Any) -> Scene:
    """A copy of the scene with one field set.

    Parameters
    ----------
    scene : dict
    path : str
        Keys joined by dots, from the scene down: ``"body.material.young_modulus"``.
    value
        Number in SI or canonical sub-dict.

    Returns
    -------
    dict
    """
    changed = copy.deepcopy(scene)
    *parents, last = path.split(".")
    place = changed
    for key in parents:
        place = place[key]
    place[last] = value
    return changed


def material(scene: Scene) -> LinearElastic:
    """The body's material."""
    return _build(MATERIALS, scene["body"]["material"])


def surface(scene: Scene) -> SelfAffine | Smooth:
    """The rough surface, or the smooth one."""
    return _build(SURFACES, scene["surface"])


def problem(scene: Scene, load: float, speed: float) -> Problem:
    """The lubricated contact of a scene.

    Parameters
    ----------
    scene : dict
        Canonical scene, SI.
    load, speed : float
        W [N/m], v [m/s].

    Returns
    -------
    Problem
    """
    modulus = material(scene).plane_strain_modulus
    shape = _build(SHAPES, scene["body"]["shape"])
    rough = surface(scene)
    return Problem(
        body=HalfSpaceCylinder(radius=shape.radius, modulus=modulus),
        law=_law(scene["contact_law"], rough, modulus),
        lubricant=Lubricant(**scene["lubricant"]),
        load=load,
        speed=speed,
        rms_roughness=rough.rms_roughness,
        half_domain=scene.get("half_domain"),
    )


def _law(options: dict[str, Any], rough: SelfAffine | Smooth, modulus: float) -> ContactLaw:
    settings = {key: value for key, value in options.items() if key not in ("name", "label")}
    if options["name"] == "none":
        return NoContact()
    return LAWS[options["name"]](rough, modulus, **settings)


def _build(classes: dict[str, Any], block: dict[str, Any]) -> Any:
    return classes[block["kind"]](**{key: value for key, value in block.items() if key != "kind"})
