"""The Yeoh material, a special case of the source's polynomial form (equation 5-4)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from softlub.solid.materials.material import Hyperelastic
from softlub.units import Pressure, Unit, check

if TYPE_CHECKING:
    from softlub.solid.materials.isochoric import IsochoricEnergy


@dataclass(frozen=True)
class Yeoh(Hyperelastic):
    """W = C10 (Ī1 - 3) + C20 (Ī1 - 3)² + C30 (Ī1 - 3)³ + (J - 1)²/D1.

    Parameters
    ----------
    c10, c20, c30 : float
        C10, C20 and C30 [Pa]. C20 may be negative, as fits to the softening of filled rubber give it, as long as
        the energy grows with Ī1 everywhere: C20² < 3 C10 C30.
    d1 : float
        D1 [1/Pa].

    Raises
    ------
    ValueError
        If C10 or D1 is not above 0, C30 is negative, or the energy falls with Ī1 somewhere.
    """

    c10: Pressure
    c20: Annotated[float, Unit("Pa")]
    c30: Annotated[float, Unit("Pa", at_least=0)]
    d1: Annotated[float, Unit("1/Pa", above=0)]

    def __post_init__(self) -> None:
        check(self)
        # dW/dĪ1 = C10 + 2 C20 x + 3 C30 x² must have no root at x = Ī1 - 3 > 0.
        if self.c20 < 0 and self.c20**2 >= 3 * self.c10 * self.c30:
            raise ValueError(
                f"Yeoh: c20 = {self.c20:g} Pa lets the energy fall under large strain; it must be at least 0 Pa, "
                f"or above {-((3 * self.c10 * self.c30) ** 0.5):g} Pa = -√(3 c10 c30)"
            )

    @property
    def shear_modulus(self) -> float:
        """G0 = 2 C10 (equation 5-6) [Pa]."""
        return 2 * self.c10

    @property
    def bulk_modulus(self) -> float:
        """K0 = 2/D1 (equation 5-7) [Pa]."""
        return 2 / self.d1

    def stiffened(self, factor: float) -> Yeoh:
        """The material with C10, C20 and C30 multiplied by a factor above 0 and the same bulk modulus."""
        return Yeoh(factor * self.c10, factor * self.c20, factor * self.c30, self.d1)

    def element_material(self) -> IsochoricEnergy:
        """A new felupe material of the isochoric response, differentiated by tensortrax."""
        from felupe.constitution.tensortrax.models.hyperelastic import yeoh

        from softlub.solid.materials.isochoric import IsochoricEnergy

        return IsochoricEnergy(yeoh, C10=self.c10, C20=self.c20, C30=self.c30)
