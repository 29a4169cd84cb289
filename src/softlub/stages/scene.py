"""From the canonical scene of a node's spec to the objects that the physics works with."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.contact.laws.none import NoContact
from softlub.contact.laws.persson import PerssonLaw
from softlub.contact.laws.tabulated import TabulatedLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.meshed_body import MeshedBody
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.protocols import Compliance, ContactLaw
from softlub.solid.materials.viscoelastic import at_rest
from softlub.stages.tabulated import SweptSurface
from softlub.study import kinds
from softlub.study.specimens import height_scale, without_specimen
from softlub.surfaces.spectrum import SelfAffine, Smooth

Scene = dict[str, Any]

SURFACES = {"self_affine": SelfAffine, "smooth": Smooth}
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


def material(scene: Scene) -> Any:
    """The body's material; of one with a memory that at rest, since a film is steady in the frame of the body."""
    return at_rest(kinds.built(kinds.MATERIALS, scene["body"]["material"]))


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


def problem(
    scene: Scene,
    load: float,
    speed: float,
    swept: SweptSurface | None = None,
    compliance: Compliance | None = None,
) -> Problem:
    """The lubricated contact of a scene.

    Parameters
    ----------
    scene : dict
        Canonical scene, SI.
    load, speed : float
        W [N/m], v [m/s].
    swept : SweptSurface, optional
        The rough contact that a tabulated law comes from.
    compliance : Compliance, optional
        Of a body of finite elements.

    Returns
    -------
    Problem
    """
    return Problem(
        body=_body(scene, compliance),
        law=_law(scene, swept),
        lubricant=Lubricant(**scene["lubricant"]),
        load=load,
        speed=speed,
        rms_roughness=rms_roughness(scene, swept),
        half_domain=scene.get("half_domain"),
    )


def _body(scene: Scene, compliance: Compliance | None) -> HalfSpaceCylinder | MeshedBody:
    modulus = material(scene).plane_strain_modulus
    if compliance is None:
        return HalfSpaceCylinder(
            radius=kinds.built(kinds.SHAPES, scene["body"]["shape"]).radius, modulus=modulus
        )
    return MeshedBody(compliance, _tip_radius(scene, compliance), modulus)


def _tip_radius(scene: Scene, compliance: Compliance) -> float:
    """R of the shape where it has one, and otherwise of the parabola through the lowest quarter of its gap [m].

    It makes units and first guesses alone.
    """
    shape = scene["body"]["shape"]
    if shape["kind"] != "profile":
        return float(kinds.built(kinds.MESHED_SHAPES, shape).tip_radius)
    x, gap = compliance.positions, compliance.base_gap - compliance.base_gap.min()
    low = gap <= gap.max() / 4
    curvature = 2 * float(np.polyfit(x[low], gap[low], 2)[0]) if low.sum() > 2 else 0.0
    return min(1 / curvature, float(np.ptp(x))) if curvature > 0 else float(np.ptp(x))


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
    surface: SelfAffine | Smooth = kinds.built(SURFACES, without_specimen(scene["surface"]))
    return surface
