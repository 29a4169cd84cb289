"""Prony series of relaxation times (equation 5-10)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from softlub.units import Unit

FloatArray = NDArray[np.float64]

Normalised = Literal["long_term", "instantaneous"]
NORMALISED: tuple[Normalised, ...] = ("long_term", "instantaneous")
Time = Annotated[float, Unit("s", above=0)]
Term = Annotated[float, Unit("1", at_least=0)]


@dataclass(frozen=True)
class PronySeries:
    """Relaxation of the shear modulus.

    Relative to the long-term modulus G(t) = G∞ (1 + Σ r_i exp(-t/τ_i)); relative to the instantaneous modulus
    G(t) = G0 (1 - Σ g_i (1 - exp(-t/τ_i))), as in equation 5-10. The two are the same material for
    g_i = r_i/(1 + Σr) and G0 = (1 + Σr) G∞.

    Parameters
    ----------
    times : tuple of float
        Relaxation times τ_i [s].
    terms : tuple of float
        As many r_i or g_i, not negative.
    normalised : {"long_term", "instantaneous"}
        Which modulus the terms are relative to.

    Raises
    ------
    ValueError
        If there is no term, numbers of times and terms differ, a time is not positive, a term is negative or NaN,
        or terms relative to the instantaneous modulus add up to 1 or more.
    """

    times: tuple[Time, ...]
    terms: tuple[Term, ...]
    normalised: Normalised

    def __post_init__(self) -> None:
        if self.normalised not in NORMALISED:
            raise ValueError(
                f"PronySeries: normalised = {self.normalised!r} is unknown; allowed: {', '.join(NORMALISED)}"
            )
        if len(self.times) != len(self.terms) or len(self.times) == 0:
            raise ValueError(
                f"PronySeries: {len(self.times)} times and {len(self.terms)} terms; "
                "give every term its relaxation time, one at least"
            )
        _check_each("times", self.times, Unit("s", above=0))
        _check_each("terms", self.terms, Unit("1", at_least=0))
        total = sum(self.terms)
        if self.normalised == "instantaneous" and total >= 1:
            raise ValueError(
                f"PronySeries: the terms add up to {total:g}; relative to the instantaneous modulus they must stay "
                "below 1, or nothing is left of it in the long term. Are they relative to the long-term modulus? "
                "Then say normalised: long_term"
            )

    @property
    def term_sum(self) -> float:
        """Σ r_i: the instantaneous over the long-term modulus, less 1."""
        return float(self.long_term_terms.sum())

    @cached_property
    def relaxation_times(self) -> FloatArray:
        """τ_i [s], shape (terms,)."""
        return np.array(self.times, dtype=np.float64)

    @cached_property
    def long_term_terms(self) -> FloatArray:
        """r_i, relative to the long-term modulus, shape (terms,)."""
        terms = np.array(self.terms, dtype=np.float64)
        return terms if self.normalised == "long_term" else terms / (1 - terms.sum())

    @cached_property
    def instantaneous_terms(self) -> FloatArray:
        """g_i, relative to the instantaneous modulus, shape (terms,)."""
        terms = np.array(self.terms, dtype=np.float64)
        return terms if self.normalised == "instantaneous" else terms / (1 + terms.sum())

    def relative_to(self, normalised: Normalised) -> PronySeries:
        """The same series with terms relative to the long-term or to the instantaneous modulus."""
        terms = self.long_term_terms if normalised == "long_term" else self.instantaneous_terms
        return PronySeries(self.times, tuple(terms.tolist()), normalised)

    def slowed(self, factor: float) -> PronySeries:
        """The series with all relaxation times multiplied by a factor above 0, such as the WLF shift factor."""
        return PronySeries(tuple(factor * time for time in self.times), self.terms, self.normalised)


def _check_each(name: str, values: tuple[float, ...], unit: Unit) -> None:
    for index, value in enumerate(values):
        if not unit.allows(value):
            raise ValueError(f"PronySeries: {name}[{index}] = {value:g} must be {unit.allowed()}")
