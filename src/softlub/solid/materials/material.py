"""What the finite-element body asks of a material, and the small-strain moduli that follow from two of them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Protocol, Self


class SolidMaterial(Protocol):
    """A material that a finite-element body can be made of.

    The element adds the volumetric energy K (J - 1)²/2 with `bulk_modulus`; `element_material` gives what is left,
    the isochoric response.
    """

    @property
    def shear_modulus(self) -> float:
        """G of the unloaded material at rest [Pa]."""
        ...

    @property
    def bulk_modulus(self) -> float:
        """K [Pa]."""
        ...

    @property
    def young_modulus(self) -> float:
        """E = 9KG/(3K + G) [Pa]."""
        ...

    @property
    def plane_strain_modulus(self) -> float:
        """E/(1 - ν²) of small strains [Pa]: the reduced modulus of the one elastic body."""
        ...

    @property
    def long_term_modulus(self) -> float:
        """The modulus that a shear strength given in parts of E refers to [Pa]."""
        ...

    def element_material(self) -> Any:
        """A new felupe material of the isochoric response: gradient and hessian over [F, state variables]."""
        ...


class RateIndependent(SolidMaterial, Protocol):
    """A material without memory, whose shear stiffness can be set to that of some rate or frequency."""

    def stiffened(self, factor: float) -> RateIndependent:
        """The material with its shear stresses multiplied by a factor and the same bulk modulus."""
        ...


def young_modulus(shear_modulus: float, bulk_modulus: float) -> float:
    """E = 9KG/(3K + G) [Pa]."""
    return 9 * bulk_modulus * shear_modulus / (3 * bulk_modulus + shear_modulus)


def poisson_ratio(shear_modulus: float, bulk_modulus: float) -> float:
    """ν = (3K - 2G)/(6K + 2G)."""
    return (3 * bulk_modulus - 2 * shear_modulus) / (6 * bulk_modulus + 2 * shear_modulus)


class Hyperelastic(ABC):
    """Base of the hyperelastic materials: what follows from initial shear and bulk modulus."""

    @property
    @abstractmethod
    def shear_modulus(self) -> float:
        """G0 [Pa]."""

    @property
    @abstractmethod
    def bulk_modulus(self) -> float:
        """K0 = 2/D1 (equation 5-7) [Pa]."""

    @abstractmethod
    def stiffened(self, factor: float) -> Self:
        """The material with its shear stresses multiplied by a factor and the same bulk modulus.

        Parameters
        ----------
        factor : float
            Above 0.
        """

    @abstractmethod
    def element_material(self) -> Any:
        """A new felupe material of the isochoric response: gradient and hessian over [F, state variables]."""

    @property
    def young_modulus(self) -> float:
        """E0 = 9 K0 G0/(3 K0 + G0), the initial tensile modulus [Pa]."""
        return young_modulus(self.shear_modulus, self.bulk_modulus)

    @property
    def poisson_ratio(self) -> float:
        """ν0 of small strains."""
        return poisson_ratio(self.shear_modulus, self.bulk_modulus)

    @property
    def plane_strain_modulus(self) -> float:
        """E0/(1 - ν0²) of small strains [Pa]."""
        return self.young_modulus / (1 - self.poisson_ratio**2)

    @property
    def long_term_modulus(self) -> float:
        """E0 [Pa]: the modulus that a shear strength given in parts of E refers to."""
        return self.young_modulus
