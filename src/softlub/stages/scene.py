"""From the canonical scene of a node's spec to the objects that the physics works with."""

from __future__ import annotations

import copy
from typing import Any

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.contact.laws.tabulated import TabulatedLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.protocols import ContactLaw
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.solid.shapes.cylinder import Cylinder
from softlub.stages.tabulated import SweptSurface
from softlub.study.specimens import height_scale, without_specimen
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


def rms_roughness(scene: Scene, swept: SweptSurface | None = None) -> float:
    """h_rms [m]: of the spectrum, or of the surface that was swept.

    Parameters
    ----------
    scene : dict
    swept : SweptSurface, optional
        Of a scene whose law is tabulated.

    Returns
    -------
    float
    """
    if swept is not None:
        return swept.rms_roughness * height_scale(scene["surface"])
    return _surface(scene).rms_roughness


def problem(scene: Scene, load: float, speed: float, swept: SweptSurface | None = None) -> Problem:
    """The lubricated contact of a scene.

    Parameters
    ----------
    scene : dict
        Canonical scene, SI.
    load, speed : float
        W [N/m], v [m/s].
    swept : SweptSurface, optional
        The rough contact that a tabulated law comes from.

    Returns
    -------
    Problem
    """
    shape = _build(SHAPES, scene["body"]["shape"])
    return Problem(
        body=HalfSpaceCylinder(radius=shape.radius, modulus=material(scene).plane_strain_modulus),
        law=_law(scene, swept),
        lubricant=Lubricant(**scene["lubricant"]),
        load=load,
        speed=speed,
        rms_roughness=rms_roughness(scene, swept),
        half_domain=scene.get("half_domain"),
    )


def _law(scene: Scene, swept: SweptSurface | None) -> ContactLaw:
    options = scene["contact_law"]
    modulus = material(scene).plane_strain_modulus
    settings = {key: value for key, value in options.items() if key not in ("name", "label")}
    if options["name"] == "none":
        return NoContact()
    if swept is not None:
        height = height_scale(scene["surface"])
        return TabulatedLaw(
            swept.curve,
            swept.closing,
            swept.rms_roughness * height,
            swept.rms_slope * height,
            modulus,
            **settings,
        )
    return LAWS[options["name"]](_surface(scene), modulus, **settings)


def _surface(scene: Scene) -> SelfAffine | Smooth:
    surface: SelfAffine | Smooth = _build(SURFACES, without_specimen(scene["surface"]))
    return surface


def _build(classes: dict[str, Any], block: dict[str, Any]) -> Any:
    return classes[block["kind"]](**{key: value for key, value in block.items() if key != "kind"})
