"""Isotropic linear elasticity in plane strain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from softlub.solid.materials import material
from softlub.units import PoissonRatio, Pressure, check

if TYPE_CHECKING:
    from softlub.solid.materials.isochoric import IsochoricNeoHooke

INCOMPRESSIBLE_BULK_RATIO = 12000 / 7
"""K/G that stands for a Poisson ratio of 0.5: 2000 MPa over the 3.5/3 MPa of the source's specimen.

The source's materials L and Y, with K0 = 2000 MPa from D1 = 0.001 1/MPa, are as nearly incompressible.
"""


@dataclass(frozen=True)
class LinearElastic:
    """Linear elastic material.

    In a finite-element body it is the neo-Hookean material of its small-strain moduli: linear under small strains, and
    free of stress under rotations of any size.

    Parameters
    ----------
    young_modulus : float
        E [Pa].
    poisson_ratio : float
        ν in (0, 0.5].

    Raises
    ------
    ValueError
        If a number lies outside its bounds.
    """

    young_modulus: Pressure
    poisson_ratio: PoissonRatio

    def __post_init__(self) -> None:
        check(self)

    @property
    def shear_modulus(self) -> float:
        """G = E/(2 (1 + ν)) (equation 5-12) [Pa]."""
        return self.young_modulus / (2 * (1 + self.poisson_ratio))

    @property
    def bulk_modulus(self) -> float:
        """K = E/(3 (1 - 2ν)) (equation 5-13) [Pa]; `INCOMPRESSIBLE_BULK_RATIO` G for ν = 0.5."""
        if self.poisson_ratio == 0.5:
            return INCOMPRESSIBLE_BULK_RATIO * self.shear_modulus
        return self.young_modulus / (3 * (1 - 2 * self.poisson_ratio))

    @property
    def plane_strain_modulus(self) -> float:
        """E* = E/(1 - ν²) [Pa]: the reduced modulus of the one elastic body."""
        return self.young_modulus / (1 - self.poisson_ratio**2)

    @property
    def long_term_modulus(self) -> float:
        """E [Pa]: the modulus that a shear strength given in parts of E refers to."""
        return self.young_modulus

    def stiffened(self, factor: float) -> LinearElastic:
        """The material with its shear modulus multiplied by a factor above 0 and the same bulk modulus.

        Raises
        ------
        ValueError
            If Poisson's ratio would not stay above 0: the shear modulus reaches 3/2 of the bulk modulus.
        """
        shear, bulk = factor * self.shear_modulus, self.bulk_modulus
        ratio = material.poisson_ratio(shear, bulk)
        if not ratio > 0:
            raise ValueError(
                f"a shear modulus of {shear:g} Pa beside a bulk modulus of {bulk:g} Pa makes Poisson's ratio "
                f"{ratio:g}; it must stay above 0: take a ratio closer to 0.5, or smaller Prony terms"
            )
        return LinearElastic(material.young_modulus(shear, bulk), ratio)

    def element_material(self) -> IsochoricNeoHooke:
        """A new felupe material of the isochoric response."""
        from softlub.solid.materials.isochoric import IsochoricNeoHooke

        return IsochoricNeoHooke(self.shear_modulus)
