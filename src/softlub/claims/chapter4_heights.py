"""Checks of how Gaussian the heights of the surfaces are (4.6.2)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.printed_surfaces import find, rows
from softlub.claims.reading_contact import numbers
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge
from softlub.datasets.contact_curves import inputs, surfaces

GAUSSIAN = 0.1
"""Deviation up to which heights count as Gaussian."""


def deviation(surface: xr.Dataset) -> float:
    """√(S² + (K − 3)²/4) of skewness S and kurtosis K, as rms over the realisations: 0 for Gaussian heights."""
    skewness, excess = (surface[name].values.astype(float) for name in ("skewness", "kurtosis"))
    return float(np.sqrt(np.nanmean(skewness**2 + (excess - 3) ** 2 / 4)))


def _plateaus(datasets: Datasets) -> dict[float, float]:
    """Deviation by λ_L/λ_r, for L = 2 λ_L."""
    dataset = datasets("ch4-thermodynamic")
    found = {
        printed.longest / printed.rolloff: deviation(surface)
        for printed in rows("table_4_3")
        if (surface := find(dataset, printed)) is not None
    }
    if len(found) < 2:
        raise NotComputed("fewer than two surfaces of table 4-3 were run")
    return found


@check("claim_4_20")
def wider_plateau(datasets: Datasets) -> Verdict:
    """Deviation over the width of the plateau."""
    found = _plateaus(datasets)
    values = list(found.values())
    return judge(
        values[-1] <= 0.5 * values[0],
        f"deviation {numbers(values, 2)} at lambda_L/lambda_r = {numbers(list(found))}",
        "root of skewness² + (kurtosis - 3)²/4; more Gaussian means at most half of it from first to last",
    )


@check("claim_4_34")
def wide_plateau(datasets: Datasets) -> Verdict:
    """Deviation of the widest plateau that was run."""
    found = _plateaus(datasets)
    widest = max(found)
    return judge(
        found[widest] <= GAUSSIAN,
        f"deviation {found[widest]:.2g} at q_r/q_L = {widest:g}",
        f"root of skewness² + (kurtosis - 3)²/4; Gaussian means up to {GAUSSIAN:g}",
    )


@check("claim_4_21")
def larger_surface(datasets: Datasets) -> Verdict:
    """Deviation over the size of surfaces without a plateau."""
    found = {}
    for surface in surfaces(datasets("ch4-thermodynamic")):
        known = inputs(surface)
        if abs(known["long_cutoff"] / known["rolloff"] - 1) < 1e-3:
            found[known["size"] * known["long_cutoff"] / (2 * np.pi)] = deviation(surface)
    if len(found) < 2:
        raise NotComputed("fewer than two sizes without a plateau were run")
    values = [found[size] for size in sorted(found)]
    return judge(
        values[-1] > 0.5 * values[0],
        f"deviation {numbers(values, 2)} at L/lambda_L = {numbers(sorted(found))}",
        "root of skewness² + (kurtosis - 3)²/4; the statement holds if the largest surface keeps more than half of "
        "the smallest one's. By the central limit more long waves make heights more Gaussian, whether a plateau or "
        "the size brings them",
    )
