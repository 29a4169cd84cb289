"""Friction of a solved contact (equations 3-31 to 3-38), on the moving wall, over the whole domain.

The wall shear stress of the fluid is σ_f = ηv/u + (u/2) dp_f/dx (equation 3-36): Couette and Poiseuille part. In the
cavitated zone dp_f/dx = 0 and the film counts as full. The solid part is σ1 A/A0 (equation 3-32); since
nothing else depends on the shear strength σ1, only the real contact width ∫ A/A0 dx is computed here and σ1 is applied
by whoever knows it: μ_solid = σ1 · width / W.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from softlub.lubrication.result import LubricatedContact
from softlub.protocols import ContactLaw


class Friction(NamedTuple):
    """Integrals of one contact that friction is made of."""

    couette: float
    """∫ ηv/u dx / W."""
    poiseuille: float
    """∫ (u/2) dp_f/dx dx / W."""
    real_contact_width: float
    """∫ A/A0 dx [m]."""
    contact_area_ratio_max: float
    """Largest A/A0."""
    load_share_solid: float
    """∫ p_s dx / W."""

    @property
    def fluid(self) -> float:
        """μ_fluid, both parts together."""
        return self.couette + self.poiseuille


def friction(contact: LubricatedContact, law: ContactLaw, viscosity: float) -> Friction:
    """Integrate the friction of a solved contact.

    Parameters
    ----------
    contact : LubricatedContact
    law : ContactLaw
        The law that the contact was solved with; its area is used.
    viscosity : float
        η [Pa s].

    Returns
    -------
    Friction
    """
    weights, load = contact.weights, contact.load
    area_ratio = law.area_ratio(contact.solid_pressure)
    return Friction(
        couette=float(weights @ (viscosity * contact.speed / contact.separation)) / load,
        poiseuille=float(weights @ (0.5 * contact.separation * contact.fluid_pressure_gradient)) / load,
        real_contact_width=float(weights @ area_ratio),
        contact_area_ratio_max=float(np.max(area_ratio)),
        load_share_solid=float(weights @ contact.solid_pressure) / load,
    )
