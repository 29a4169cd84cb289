"""Isotropic linear elasticity in plane strain."""

from __future__ import annotations

from dataclasses import dataclass

from softlub.units import PoissonRatio, Pressure


@dataclass(frozen=True)
class LinearElastic:
    """Linear elastic material.

    Parameters
    ----------
    young_modulus : float
        E [Pa].
    poisson_ratio : float
        ν in (0, 0.5].
    """

    young_modulus: Pressure
    poisson_ratio: PoissonRatio

    @property
    def plane_strain_modulus(self) -> float:
        """E* = E/(1 - ν²) [Pa]: the reduced modulus of the one elastic body."""
        return self.young_modulus / (1 - self.poisson_ratio**2)

    @property
    def long_term_modulus(self) -> float:
        """E [Pa]: the modulus that a shear strength given in parts of E refers to."""
        return self.young_modulus
