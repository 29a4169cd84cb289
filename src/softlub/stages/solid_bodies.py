"""From the blocks of a node's spec to bodies of finite elements, what they meet and the steps they go through."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.contact.laws.persson import PerssonLaw
from softlub.contact.laws.tabulated import TabulatedLaw
from softlub.protocols import ContactLaw
from softlub.solid.body import Body
from softlub.solid.increments import Stepping
from softlub.solid.materials.viscoelastic import at_rest
from softlub.solid.mesh import BodyMesh
from softlub.solid.plate_laws import HardContact, NormalLaw, PressureClearance
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.steps import InContact, Loading, Sliding, Step
from softlub.stages.tabulated import read_law
from softlub.study import kinds
from softlub.surfaces.spectrum import SelfAffine

Block = Mapping[str, Any]

STEPS: dict[str, Any] = {"in_contact": InContact, "loading": Loading, "sliding": Sliding}
LAWS: dict[str, Any] = {"persson": PerssonLaw, "exponential": ExponentialLaw}


def make_material(block: Block) -> Any:
    """The material of a canonical block."""
    return kinds.built(kinds.MATERIALS, block)


def make_mesh(body: Block, files: Sequence[Path] = ()) -> BodyMesh:
    """The mesh of a body's shape.

    Parameters
    ----------
    body : mapping
        ``shape`` and ``mesh``.
    files : sequence of Path
        The file of a measured shape, whose block holds the hash of it.

    Returns
    -------
    BodyMesh
    """
    shape = dict(body["shape"])
    if files:
        shape["file"] = str(files[0])
    mesh: BodyMesh = kinds.built(kinds.MESHED_SHAPES, shape).mesh(MeshDensity(**body["mesh"]))
    return mesh


def make_body(body: Block, files: Sequence[Path] = (), material: Any = None) -> Body:
    """A body, undeformed.

    Parameters
    ----------
    body : mapping
        ``shape``, ``material``, ``element`` and ``mesh``.
    files : sequence of Path
        The file of a measured shape.
    material : optional
        In place of the block's.

    Returns
    -------
    Body
    """
    made = make_material(body["material"]) if material is None else material
    return Body(make_mesh(body, files), made, body["element"])


def make_steps(steps: Sequence[Block]) -> list[Step]:
    """Steps of a job; those of a material without memory have no duration of their own."""
    apart = ("name", "increments")
    return [
        STEPS[step["name"]](**{name: value for name, value in step.items() if name not in apart})
        for step in steps
    ]


def make_stepping(steps: Sequence[Block]) -> Stepping:
    """Sizes of the increments of a job's steps."""
    part = 1 / max(int(step.get("increments", 1)) for step in steps)
    return Stepping(first=part, largest=part)


def make_law(contact: Block, laws: Sequence[Path]) -> NormalLaw:
    """What the contact edge meets.

    Parameters
    ----------
    contact : mapping
        ``name`` of the law and its settings; for asperities ``material``, and ``surface`` or ``height``.
    laws : sequence of Path
        Swept rough contact, where the law comes from one.

    Returns
    -------
    NormalLaw
    """
    settings = {
        name: value
        for name, value in contact.items()
        if name not in ("name", "surface", "material", "height")
    }
    if contact["name"] == "hard":
        return HardContact(**settings)
    modulus = at_rest(make_material(contact["material"])).plane_strain_modulus
    law: ContactLaw
    if laws:
        swept, height = read_law(laws[0]), contact["height"]
        roughness, slope = swept.rms_roughness * height, swept.rms_slope * height
        law = TabulatedLaw(swept.curve, swept.closing, roughness, slope, modulus, **settings)
    else:
        spectrum = {name: value for name, value in contact["surface"].items() if name != "kind"}
        law = LAWS[contact["name"]](SelfAffine(**spectrum), modulus, **settings)
    return PressureClearance(law.table)
