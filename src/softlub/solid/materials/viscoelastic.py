"""Finite linear viscoelasticity: a material without memory and a Prony series of its isochoric stress.

J. C. Simo, T. J. R. Hughes, Computational Inelasticity (1998), chapter 10; the form that ABAQUS uses.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from softlub.solid.materials.material import RateIndependent
from softlub.solid.materials.prony import Normalised, PronySeries

if TYPE_CHECKING:
    from softlub.solid.materials.viscoelastic_response import ViscoelasticResponse


@dataclass(frozen=True)
class Viscoelastic:
    """A material whose shear stress relaxes while its bulk modulus stays elastic.

    Parameters
    ----------
    hyperelastic : RateIndependent
        Material without memory: neo-Hookean, Mooney–Rivlin, Yeoh or linear elastic.
    prony : PronySeries
        Relaxation of its isochoric stress.
    constants : {"long_term", "instantaneous"}, optional
        Response that the constants of `hyperelastic` describe: at rest for long, or at once.
    """

    hyperelastic: RateIndependent
    prony: PronySeries
    constants: Normalised = "long_term"

    @cached_property
    def at_rest(self) -> RateIndependent:
        """The material after infinitely long relaxation."""
        if self.constants == "long_term":
            return self.hyperelastic
        return self.hyperelastic.stiffened(1 / (1 + self.prony.term_sum))

    @property
    def shear_modulus(self) -> float:
        """G∞ [Pa]."""
        return self.at_rest.shear_modulus

    @property
    def instantaneous_shear_modulus(self) -> float:
        """G0 = (1 + Σr) G∞ [Pa]."""
        return (1 + self.prony.term_sum) * self.shear_modulus

    @property
    def bulk_modulus(self) -> float:
        """K, elastic [Pa]."""
        return self.at_rest.bulk_modulus

    @property
    def young_modulus(self) -> float:
        """9 K G∞/(3 K + G∞) [Pa]."""
        return self.at_rest.young_modulus

    @property
    def plane_strain_modulus(self) -> float:
        """E/(1 - ν²) of small strains at rest [Pa]."""
        return self.at_rest.plane_strain_modulus

    @property
    def long_term_modulus(self) -> float:
        """The modulus that a shear strength given in parts of E refers to: that at rest [Pa]."""
        return self.at_rest.long_term_modulus

    def element_material(self) -> ViscoelasticResponse:
        """A new felupe material of the isochoric response, with a history of its own that begins at rest."""
        from softlub.solid.materials.viscoelastic_response import ViscoelasticResponse

        return ViscoelasticResponse(self.at_rest.element_material(), self.prony)


def at_rest(material: RateIndependent | Viscoelastic) -> RateIndependent:
    """The material without its memory: itself where it has none."""
    return material.at_rest if isinstance(material, Viscoelastic) else material
