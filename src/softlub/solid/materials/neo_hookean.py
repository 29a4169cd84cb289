"""The neo-Hookean material in the source's form (equations 5-5 to 5-7)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from softlub.solid.materials.material import Hyperelastic
from softlub.units import Pressure, Unit, check

if TYPE_CHECKING:
    from softlub.solid.materials.isochoric import IsochoricNeoHooke


@dataclass(frozen=True)
class NeoHookean(Hyperelastic):
    """W = C10 (Ī1 - 3) + (J - 1)²/D1 (equation 5-5), with Ī1 = J^(-2/3) tr C.

    Parameters
    ----------
    c10 : float
        C10 [Pa].
    d1 : float
        D1 [1/Pa].

    Raises
    ------
    ValueError
        If a constant is not above 0.
    """

    c10: Pressure
    d1: Annotated[float, Unit("1/Pa", above=0)]

    def __post_init__(self) -> None:
        check(self)

    @property
    def shear_modulus(self) -> float:
        """G0 = 2 C10 (equation 5-6) [Pa]."""
        return 2 * self.c10

    @property
    def bulk_modulus(self) -> float:
        """K0 = 2/D1 (equation 5-7) [Pa]."""
        return 2 / self.d1

    def scaled(self, coefficient: float) -> NeoHookean:
        """The equivalent hyperelastic material of equations 5-17 and 5-18.

        Both constants are multiplied, as printed. Since K0 = 2/D1, that lowers the bulk modulus by the factor by
        which it raises the shear modulus: G0 becomes α G0, K0 becomes K0/α.

        Parameters
        ----------
        coefficient : float
            Equivalence coefficient α, above 0.
        """
        return NeoHookean(coefficient * self.c10, coefficient * self.d1)

    def stiffened(self, factor: float) -> NeoHookean:
        """The material with C10 multiplied by a factor above 0 and the same bulk modulus."""
        return NeoHookean(factor * self.c10, self.d1)

    def element_material(self) -> IsochoricNeoHooke:
        """A new felupe material of the isochoric response."""
        from softlub.solid.materials.isochoric import IsochoricNeoHooke

        return IsochoricNeoHooke(self.shear_modulus)
