"""Reading a designed sample of scenes: its inputs, and the two numbers that scale each of its contacts."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures.quantities import FloatArray

DERIVED = (
    "plane_strain_modulus",
    "long_term_modulus",
    "hertz_half_width",
    "shear_strength",
    "half_domain",
)
"""Variables over the sample that follow from inputs."""


def inputs(dataset: xr.Dataset) -> dict[str, FloatArray]:
    """Everything that was drawn for the sample, by name, shape (samples,)."""
    found = {}
    for name, variable in dataset.variables.items():
        if variable.dims == ("sample",) and name not in ("sample", *DERIVED):
            values = np.asarray(variable.values, dtype=float)
            if np.ptp(values) > 0:
                found[str(name)] = values
    return found


def speed_number(dataset: xr.Dataset) -> xr.DataArray:
    """λ = 6ηvR²/(a³p0) of every point, with Hertz's a and p0 = 2W/(πa)."""
    half_width = _half_width(dataset)
    peak = 2 * dataset["load"] / (np.pi * half_width)
    speed = 6 * dataset["viscosity"] * dataset["speed"] * dataset["radius"] ** 2
    return speed / (half_width**3 * peak)


def roughness_number(dataset: xr.Dataset) -> xr.DataArray:
    """h_rms R/a²: roughness in units of the Hertz contact's indentation."""
    return dataset["rms_roughness"] * dataset["radius"] / _half_width(dataset) ** 2


def _half_width(dataset: xr.Dataset) -> xr.DataArray:
    """a = √(4WR/(πE*)) [m]."""
    return (4 * dataset["load"] * dataset["radius"] / (np.pi * dataset["plane_strain_modulus"])) ** 0.5


def first_order_index(cause: FloatArray, effect: FloatArray, bins: int) -> float:
    """Share of the effect's variance that one input explains by itself: Var(E[Y|X])/Var(Y).

    The input is cut into bins of equally many points; the variance of the bins' means is corrected for what
    chance alone puts there (ε² of the one-way analysis of variance), so that an idle input gives zero on average.

    Parameters
    ----------
    cause, effect : ndarray, shape (n,)
        Points with a NaN effect are left out.
    bins : int
        At most n/2.

    Returns
    -------
    float
        NaN where the effect does not vary or too few points are left.
    """
    known = np.isfinite(effect)
    cause, effect = cause[known], effect[known]
    if effect.size < 4 * bins or np.ptp(effect) == 0:
        return float("nan")
    groups = np.array_split(effect[np.argsort(cause, kind="stable")], bins)
    between = sum(group.size * (group.mean() - effect.mean()) ** 2 for group in groups)
    within = sum(((group - group.mean()) ** 2).sum() for group in groups)
    chance = (bins - 1) * within / (effect.size - bins)
    return float((between - chance) / (between + within))
