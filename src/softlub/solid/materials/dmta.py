"""Prony series from dynamic mechanical (thermal) analysis: storage and loss modulus over frequency (section 5.6.1.4).

For given relaxation times the moduli are linear in the long-term modulus and the terms,

    G' = G∞ + Σ G_i x_i²/(1 + x_i²),   G'' = Σ G_i x_i/(1 + x_i²),   x_i = ωτ_i,

so that the best terms that are not negative come from one least-squares problem, here of relative residuals.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from softlub.solid.materials.columns import ANGULAR_FREQUENCIES, PRESSURES, read_columns
from softlub.solid.materials.moduli import DynamicModulus
from softlub.solid.materials.prony import PronySeries

FloatArray = NDArray[np.float64]

COLUMNS = {
    "frequency": ANGULAR_FREQUENCIES,
    "storage_modulus": PRESSURES,
    "loss_modulus": PRESSURES,
}
FEWEST_FREQUENCIES = 4
NEGLIGIBLE = 1e-6
"""Terms that add less than this to every measured modulus are left out."""


@dataclass(frozen=True, eq=False)
class PronyFit:
    """A series fitted to measured moduli.

    Parameters
    ----------
    series : PronySeries
        Relative to the long-term modulus, without negligible terms.
    long_term_shear_modulus : float
        G∞ [Pa].
    storage_residual, loss_residual : ndarray, shape (n,)
        Fitted over measured shear modulus, less 1, at each frequency in ascending order.
    """

    series: PronySeries
    long_term_shear_modulus: float
    storage_residual: FloatArray
    loss_residual: FloatArray

    @property
    def rms_residual(self) -> float:
        """Root mean square of all relative residuals."""
        return float(np.sqrt(np.mean(np.concatenate([self.storage_residual, self.loss_residual]) ** 2)))

    @property
    def largest_residual(self) -> float:
        """Largest relative residual."""
        return float(np.abs(np.concatenate([self.storage_residual, self.loss_residual])).max())


def read_dmta(path: str | Path) -> DynamicModulus:
    """Read measured tensile moduli.

    Parameters
    ----------
    path : str or Path
        CSV file with the columns ``frequency [rad/s]`` (or Hz), ``storage_modulus [Pa]`` and ``loss_modulus [Pa]`` (or
        MPa).

    Returns
    -------
    DynamicModulus
        In ascending order of frequency.

    Raises
    ------
    ValueError
        If the file is not of this form, has fewer than 4 frequencies or one twice, or a number that is not above 0.
        The message names the file.
    FileNotFoundError
        If there is no such file.
    """
    columns = read_columns(path, COLUMNS).columns
    for name, values in columns.items():
        if np.any(values <= 0):
            raise ValueError(
                f"{path}: {name} = {values.min():g} in row {values.argmin() + 1} must be above 0"
            )
    order = np.argsort(columns["frequency"])
    frequency, storage, loss = (columns[name][order] for name in COLUMNS)
    if frequency.size < FEWEST_FREQUENCIES or np.any(np.diff(frequency) == 0):
        raise ValueError(
            f"{path}: {frequency.size} frequencies, {np.unique(frequency).size} of them different; "
            f"a fit needs at least {FEWEST_FREQUENCIES}, each once"
        )
    return DynamicModulus(frequency, storage, loss)


def fit_prony(
    measured: DynamicModulus,
    bulk_modulus: float = np.inf,
    times_per_decade: float = 10.0,
    decades_beyond: float = 1.0,
) -> PronyFit:
    """Fit a Prony series to measured tensile moduli.

    Parameters
    ----------
    measured : DynamicModulus
        Tensile moduli, positive.
    bulk_modulus : float, optional
        Elastic K [Pa], by which tension turns into shear: G* = 3KE*/(9K - E*). Without it the material is
        incompressible, G* = E*/3.
    times_per_decade : float, optional
        Relaxation times on offer per decade of frequency; the fit takes few of them. A material with one relaxation
        time between two of those on offer is met within 0.5 % with 10 a decade, and within some 10 % with 2.
    decades_beyond : float, optional
        Decades by which they go beyond the measured band on either side.

    Returns
    -------
    PronyFit

    Raises
    ------
    ValueError
        If there are fewer than 4 frequencies, a number is not finite and above 0, the storage modulus reaches 9K,
        which no shear modulus gives, or the fit finds no long-term modulus or no relaxation.
    """
    _check_measured(measured)
    shear = _shear_modulus(measured, bulk_modulus)
    frequency = measured.angular_frequency
    first, last = (
        np.log10(1 / frequency.max()) - decades_beyond,
        np.log10(1 / frequency.min()) + decades_beyond,
    )
    times = np.logspace(first, last, max(2, round((last - first) * times_per_decade) + 1))
    storage, loss = _columns(frequency, times)
    system = np.concatenate([storage / shear.real[:, None], loss / shear.imag[:, None]])
    moduli, _ = nnls(system, np.ones(2 * frequency.size))
    long_term = float(moduli[0])
    moduli[np.max(system * moduli, axis=0) < NEGLIGIBLE] = 0
    used = np.flatnonzero(moduli[1:])
    if long_term == 0 or used.size == 0:
        what = "a liquid: no long-term modulus" if long_term == 0 else "elastic: no relaxation"
        raise ValueError(f"the moduli fit to {what}; measure over more frequencies")
    series = PronySeries(
        tuple(times[used].tolist()), tuple((moduli[1:][used] / long_term).tolist()), "long_term"
    )
    residual = (system @ moduli - 1).reshape(2, -1)
    return PronyFit(series, long_term, residual[0], residual[1])


def _check_measured(measured: DynamicModulus) -> None:
    if measured.angular_frequency.size < FEWEST_FREQUENCIES:
        raise ValueError(
            f"{measured.angular_frequency.size} frequencies: a fit needs at least {FEWEST_FREQUENCIES}"
        )
    for name in ("angular_frequency", "storage", "loss"):
        values = getattr(measured, name)
        bad = np.flatnonzero(~((values > 0) & (values < np.inf)))
        if bad.size:
            raise ValueError(f"{name}[{bad[0]}] = {values[bad[0]]:g} must be finite and above 0")


def _shear_modulus(measured: DynamicModulus, bulk_modulus: float) -> NDArray[np.complex128]:
    tensile: NDArray[np.complex128] = measured.storage + 1j * measured.loss
    if np.isinf(bulk_modulus):
        return tensile * (1 / 3)
    if np.any(measured.storage >= 9 * bulk_modulus):
        raise ValueError(
            f"a storage modulus of {measured.storage.max():g} Pa cannot go with a bulk modulus of {bulk_modulus:g} Pa: "
            "it must stay below nine times that; check the units"
        )
    shear: NDArray[np.complex128] = 3 * bulk_modulus * tensile / (9 * bulk_modulus - tensile)
    return shear


def _columns(frequency: FloatArray, times: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Storage and loss modulus per unit of the long-term modulus and of each term, shapes (n, 1 + terms)."""
    phase = 1j * np.multiply.outer(frequency, times)
    response = phase / (1 + phase)
    still = np.ones((frequency.size, 1))
    return np.hstack([still, response.real]), np.hstack([0 * still, response.imag])
