"""Curves of a rough contact over its load: one a surface, averaged over realisations, and their κ.

The real area of a light contact grows in proportion to the load, A/A0 = κ p/(E* h'_rms) (equation 4-15). κ is no
constant: it falls as the load rises, and it depends on how the area is counted and on which h'_rms normalises the
load, so that both are said wherever a κ is given. Here h'_rms is always the spectral one.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

DESCRIBED_BY = "rms_slope_spectral"
"""A variable of every surface: its dimensions but `realisation` name the surfaces."""
INPUTS = (
    "hurst",
    "rolloff",
    "cutoff",
    "long_cutoff",
    "size",
    "points",
    "rms_roughness",
    "rms_slope_spectral",
    "rms_slope_forward",
    "rms_slope_central",
    "skewness",
    "kurtosis",
    "nayak_parameter",
)
WINDOW = 0.2
"""Largest A/A0 of the load window of κ, as in the source's figures 4-12 to 4-16."""


def surfaces(dataset: xr.Dataset) -> Iterator[xr.Dataset]:
    """The parts of a dataset that belong to one surface each, realisations together.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of surfaces or of rough contacts.

    Yields
    ------
    xarray.Dataset
        Without the swept dimensions, in their order; surfaces that were not run are left out.
    """
    swept = [str(name) for name in dataset[DESCRIBED_BY].dims if name != "realisation"]
    for choice in itertools.product(*(range(dataset.sizes[name]) for name in swept)):
        one = dataset.isel(dict(zip(swept, choice, strict=True)))
        if np.isfinite(one[DESCRIBED_BY].values).any():
            yield one


def contacts(dataset: xr.Dataset) -> Iterator[tuple[dict[str, str], xr.Dataset]]:
    """The parts of a dataset that one solver made of one surface.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of rough contact.

    Yields
    ------
    choice : dict of str to str
        Value of each swept dimension.
    contact : xarray.Dataset
    """
    swept = [str(name) for name in dataset["converged"].dims if name not in ("realisation", "load_step")]
    for choice in itertools.product(*(range(dataset.sizes[name]) for name in swept)):
        picked = dict(zip(swept, choice, strict=True))
        labels = {name: str(dataset[name].values[i]) for name, i in picked.items() if name in dataset.coords}
        yield labels, dataset.isel(picked)


def inputs(surface: xr.Dataset) -> dict[str, float]:
    """What is known of a surface, realisations averaged.

    Parameters
    ----------
    surface : xarray.Dataset

    Returns
    -------
    dict of str to float
        Those of `INPUTS` that the dataset holds; `long_cutoff` is the roll-off where there is no plateau.
    """
    known = {}
    for name in INPUTS:
        if name in surface.variables and np.isfinite(surface[name].values.astype(float)).any():
            known[name] = float(np.nanmean(surface[name].values.astype(float)))
    if "rolloff" in known:
        known.setdefault("long_cutoff", known["rolloff"])
    return known


@dataclass(frozen=True, eq=False)
class ContactCurve:
    """One surface's contact over its load, the mean of all realisations that converged.

    Attributes
    ----------
    inputs : dict of str to float
        See `inputs`.
    load : ndarray, shape (loads,)
        p/(E* h'_rms) with the spectral h'_rms, ascending.
    reduced_pressure : ndarray, shape (loads,)
        p/E*.
    mean, low, high : dict of str to ndarray, shape (loads,)
        Mean, least and greatest over the realisations of each variable; NaN where none converged.
    failed : ndarray of bool, shape (loads,)
        Whether a realisation did not converge.
    realisations : int
    """

    inputs: dict[str, float]
    load: FloatArray
    reduced_pressure: FloatArray
    mean: dict[str, FloatArray]
    low: dict[str, FloatArray]
    high: dict[str, FloatArray]
    failed: NDArray[np.bool_]
    realisations: int

    def relative_separation(self, name: str = "mean_separation") -> FloatArray:
        """u/h_rms, shape (loads,)."""
        return self.mean[name] / self.inputs["rms_roughness"]


CURVE_VARIABLES = (
    "contact_area_ratio",
    "contact_area_ratio_pixel",
    "mean_separation",
    "contact_area_ratio_persson",
    "mean_separation_persson",
    "mean_separation_persson_gamma",
    "pressure_exponential",
)


def contact_curve(surface: xr.Dataset) -> ContactCurve:
    """The curve of one surface.

    Parameters
    ----------
    surface : xarray.Dataset
        One of `surfaces`, of a study of rough contact, with `reduced_pressure` p/E*.

    Returns
    -------
    ContactCurve
    """
    if "realisation" in surface[DESCRIBED_BY].dims:
        # Surfaces made less often than others are filled up with NaN.
        surface = surface.isel(realisation=np.flatnonzero(np.isfinite(surface[DESCRIBED_BY].values)))
    converged = np.asarray(_over_loads(surface["converged"]), dtype=bool)
    reduced = np.broadcast_to(_over_loads(surface["reduced_pressure"]), converged.shape)
    slope = surface["rms_slope_spectral"]
    load = reduced / _over_loads(slope.expand_dims(load_step=1) if "load_step" not in slope.dims else slope)
    order = np.argsort(load.mean(axis=0))
    values = {
        name: np.where(converged, _over_loads(surface[name]), np.nan)[:, order]
        for name in CURVE_VARIABLES
        if name in surface
    }
    known = np.any(converged, axis=0)[order]
    return ContactCurve(
        inputs=inputs(surface),
        load=load.mean(axis=0)[order],
        reduced_pressure=reduced.mean(axis=0)[order],
        mean={name: _reduced(np.nanmean, each, known) for name, each in values.items()},
        low={name: _reduced(np.nanmin, each, known) for name, each in values.items()},
        high={name: _reduced(np.nanmax, each, known) for name, each in values.items()},
        failed=~np.all(converged, axis=0)[order],
        realisations=converged.shape[0],
    )


def _over_loads(variable: xr.DataArray) -> np.ndarray:
    """Values as (realisations, loads)."""
    if "realisation" not in variable.dims:
        variable = variable.expand_dims("realisation")
    return np.asarray(variable.transpose("realisation", "load_step").values)


def _reduced(
    operation: Callable[..., FloatArray], values: FloatArray, known: NDArray[np.bool_]
) -> FloatArray:
    result = np.full(known.shape, np.nan)
    result[known] = operation(values[:, known], axis=0)
    return result


def secant_kappa(load: FloatArray, area: FloatArray) -> FloatArray:
    """κ = A/A0 · E* h'_rms/p of every load, shape (loads,)."""
    return np.asarray(area / load)


def local_kappa(load: FloatArray, area: FloatArray) -> FloatArray:
    """Local slope d(A/A0)/d(p/(E* h'_rms)), taken in logarithms; NaN beside a failed load.

    Parameters
    ----------
    load, area : ndarray, shape (loads,)
        Load ascending.

    Returns
    -------
    ndarray, shape (loads,)
    """
    known = np.isfinite(area) & (area > 0)
    slope = np.full(load.shape, np.nan)
    if np.count_nonzero(known) >= 3:
        exponent = np.gradient(np.log(area[known]), np.log(load[known]), edge_order=2)
        slope[known] = exponent * area[known] / load[known]
    return slope


def window_kappa(load: FloatArray, area: FloatArray, limit: float = WINDOW) -> float:
    """κ of the straight line through the origin that fits the area up to a limit best, ∫Ax dx/∫x² dx.

    The integrals run over the load, not over the points, so that κ does not depend on how the loads were chosen.

    Parameters
    ----------
    load, area : ndarray, shape (loads,)
        Load ascending; failed loads are NaN in `area`.
    limit : float
        Largest A/A0.

    Returns
    -------
    float
        NaN where fewer than three loads lie in the window.
    """
    known = np.isfinite(area) & (area > 0)
    if np.count_nonzero(known & (area <= limit)) < 3:
        return float("nan")
    log_load, log_area = np.log(load[known]), np.log(area[known])
    end = float(np.interp(np.log(limit), log_area, log_load))
    x = np.linspace(0.0, np.exp(end), 2001)[1:]
    # Below the lightest load the area is as good as in proportion to it.
    inside = np.exp(np.interp(np.log(x), log_load, log_area)) * np.minimum(x / load[known][0], 1.0)
    return float(np.sum(inside * x) / np.sum(x**2))
