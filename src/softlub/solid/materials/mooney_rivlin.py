"""The Mooney–Rivlin material, a special case of the source's polynomial form (equation 5-4)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from softlub.solid.materials.material import Hyperelastic
from softlub.units import Unit, check

if TYPE_CHECKING:
    from softlub.solid.materials.isochoric import IsochoricEnergy


@dataclass(frozen=True)
class MooneyRivlin(Hyperelastic):
    """W = C10 (Ī1 - 3) + C01 (Ī2 - 3) + (J - 1)²/D1.

    Parameters
    ----------
    c10, c01 : float
        C10 and C01 [Pa]; not negative, or the material would soften in some state, and one above 0.
    d1 : float
        D1 [1/Pa].

    Raises
    ------
    ValueError
        If a constant is negative, D1 is 0, or both C10 and C01 are 0.
    """

    c10: Annotated[float, Unit("Pa", at_least=0)]
    c01: Annotated[float, Unit("Pa", at_least=0)]
    d1: Annotated[float, Unit("1/Pa", above=0)]

    def __post_init__(self) -> None:
        check(self)
        if self.c10 + self.c01 == 0:
            raise ValueError("MooneyRivlin: c10 and c01 are both 0; one must be above 0 Pa")

    @property
    def shear_modulus(self) -> float:
        """G0 = 2 (C10 + C01) [Pa]."""
        return 2 * (self.c10 + self.c01)

    @property
    def bulk_modulus(self) -> float:
        """K0 = 2/D1 (equation 5-7) [Pa]."""
        return 2 / self.d1

    def stiffened(self, factor: float) -> MooneyRivlin:
        """The material with C10 and C01 multiplied by a factor above 0 and the same bulk modulus."""
        return MooneyRivlin(factor * self.c10, factor * self.c01, self.d1)

    def element_material(self) -> IsochoricEnergy:
        """A new felupe material of the isochoric response, differentiated by tensortrax."""
        from felupe.constitution.tensortrax.models.hyperelastic import mooney_rivlin

        from softlub.solid.materials.isochoric import IsochoricEnergy

        return IsochoricEnergy(mooney_rivlin, C10=self.c10, C01=self.c01)
