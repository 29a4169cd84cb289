"""Moduli of a viscoelastic material over frequency and time (section 5.6.1).

A strain ε exp(iωt) draws the stress E*(ω) ε exp(iωt) with E* = E' + iE'' (equation 5-14). The series gives the
shear modulus, G* = G∞ (1 + Σ r_i iωτ_i/(1 + iωτ_i)); the bulk modulus is elastic, so E* = 9KG*/(3K + G*).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from softlub.solid.materials.material import RateIndependent
from softlub.solid.materials.viscoelastic import Viscoelastic

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class DynamicModulus:
    """Complex modulus over angular frequency.

    Parameters
    ----------
    angular_frequency : ndarray, shape (n,)
        ω [rad/s].
    storage, loss : ndarray, shape (n,)
        Real and imaginary part [Pa].
    """

    angular_frequency: FloatArray
    storage: FloatArray
    loss: FloatArray

    @property
    def loss_factor(self) -> FloatArray:
        """tan φ = E''/E' (equation 5-15)."""
        return self.loss / self.storage

    @property
    def magnitude(self) -> FloatArray:
        """|E*| = √(E'² + E''²) (equation 5-15) [Pa]."""
        return np.hypot(self.storage, self.loss)


def shear_dynamics(material: Viscoelastic, angular_frequency: ArrayLike) -> DynamicModulus:
    """Storage and loss modulus of shear.

    Parameters
    ----------
    material : Viscoelastic
    angular_frequency : array_like, shape (n,)
        ω [rad/s], not negative.

    Returns
    -------
    DynamicModulus

    Raises
    ------
    ValueError
        If a frequency is negative or not finite.
    """
    frequency = _checked("angular frequency", "rad/s", angular_frequency)
    complex_modulus = _complex_shear_modulus(material, frequency)
    return DynamicModulus(frequency, complex_modulus.real, complex_modulus.imag)


def tensile_dynamics(material: Viscoelastic, angular_frequency: ArrayLike) -> DynamicModulus:
    """Storage and loss modulus of tension, as figures 5-12 to 5-14 show them; parameters as in `shear_dynamics`.

    E* = 9KG*/(3K + G*) with the elastic bulk modulus K. Where the material is glassy and G* no longer small
    against K, 3G* would be too high.
    """
    frequency = _checked("angular frequency", "rad/s", angular_frequency)
    shear = _complex_shear_modulus(material, frequency)
    tensile = 9 * material.bulk_modulus * shear / (3 * material.bulk_modulus + shear)
    return DynamicModulus(frequency, tensile.real, tensile.imag)


def relaxation_modulus(material: Viscoelastic, time: ArrayLike) -> FloatArray:
    """Shear modulus G(t) = G∞ (1 + Σ r_i exp(-t/τ_i)) after a step in strain (equation 5-10).

    Parameters
    ----------
    material : Viscoelastic
    time : array_like, shape (n,)
        t since the step [s], not negative.

    Returns
    -------
    ndarray, shape (n,)
        In Pa.

    Raises
    ------
    ValueError
        If a time is negative or not finite.
    """
    elapsed = _checked("time", "s", time)
    decay = np.exp(-np.divide.outer(elapsed, material.prony.relaxation_times))
    return material.shear_modulus * (1 + decay @ material.prony.long_term_terms)


def material_at_frequency(material: Viscoelastic, angular_frequency: float) -> RateIndependent:
    """The material without memory that has the storage modulus at one frequency.

    For a reduced stiffness at a given frequency: only the real part of the stiffness enters (section 5.6.3).

    Parameters
    ----------
    material : Viscoelastic
    angular_frequency : float
        ω [rad/s]; 0 for the material at rest.

    Returns
    -------
    RateIndependent
        Of the kind of `material.hyperelastic`, its shear modulus G'(ω), its bulk modulus unchanged.
    """
    storage = float(shear_dynamics(material, [angular_frequency]).storage[0])
    return material.at_rest.stiffened(storage / material.shear_modulus)


def _complex_shear_modulus(material: Viscoelastic, frequency: FloatArray) -> ComplexArray:
    phase = 1j * np.multiply.outer(frequency, material.prony.relaxation_times)
    return material.shear_modulus * (1 + (phase / (1 + phase)) @ material.prony.long_term_terms)


def _checked(what: str, unit: str, values: ArrayLike) -> FloatArray:
    array = np.atleast_1d(np.asarray(values, dtype=np.float64))
    bad = array[~((array >= 0) & (array < np.inf))]
    if bad.size:
        raise ValueError(f"{what} {bad[0]:g} {unit} must be finite and at least 0 {unit}")
    return array
