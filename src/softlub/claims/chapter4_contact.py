"""Checks of κ and separation over the grid and over the width of the plateau (4.6.1, 4.6.2)."""

from __future__ import annotations

import numpy as np

from softlub.claims.chapter4 import SURFACE
from softlub.claims.kappas import BUSH, PERSSON, Kappa, about, beside, listed, spread, table_kappas
from softlub.claims.reading_contact import (
    GAP,
    MEDIUM,
    at,
    largest_gap_difference,
    normalised,
    numbers,
    points_of,
    relative_separation,
    table_curves,
)
from softlub.claims.verdict import Datasets, Verdict, check, judge
from softlub.datasets.contact_curves import ContactCurve


@check("claim_4_05")
def between_theories(datasets: Datasets) -> Verdict:
    """κ of all grids of table 4-2 against both theories."""
    kappas = table_kappas(datasets, "table_4_2", 1)
    every = [value for k in kappas for value in (k.corrected, k.pixel)]
    return judge(min(every) > PERSSON and max(every) < BUSH, listed(kappas), beside(kappas))


def _near_source(kappas: list[Kappa]) -> Verdict:
    """Whether κ is about 2.1 by the area itself, and what counting pixels would say."""
    corrected, pixels = ([getattr(k, name) for k in kappas] for name in ("corrected", "pixel"))
    said = "agrees with" if about(pixels, 2.1) else "does not agree with"
    return judge(
        about(corrected, 2.1),
        listed(kappas),
        f"about means within 5 % of 2.1 by the corrected area; the count of pixels, as the source has it, {said} 2.1. "
        + beside(kappas),
    )


@check("claim_4_16")
def kappa_of_grids(datasets: Datasets) -> Verdict:
    """κ over the grid."""
    return _near_source(table_kappas(datasets, "table_4_2", 1))


@check("claim_4_22")
def kappa_of_plateaus(datasets: Datasets) -> Verdict:
    """κ over the width of the plateau."""
    return _near_source(table_kappas(datasets, "table_4_3"))


@check("claim_4_17", "claim_8_05")
def area_over_grid(datasets: Datasets) -> Verdict:
    """Area at one load on each grid, of the realisation that all grids share."""
    found = table_curves(datasets, "table_4_2", common=True)
    pixels, corrected = (
        [at(row.curve.load, row.curve.mean[name], MEDIUM) for row in found]
        for name in ("contact_area_ratio_pixel", "contact_area_ratio")
    )
    return judge(
        spread(pixels) <= 0.02,
        f"A/A0 by pixels {numbers(pixels)}, corrected for the edge {numbers(corrected)}",
        f"N = {points_of(found)} at p/(E* h'rms) = {MEDIUM:g}; pixels differ by {100 * spread(pixels):.2g} %, the "
        f"corrected areas by {100 * spread(corrected):.2g} %; hardly means up to 2 % of the source's count of pixels",
    )


@check("claim_4_18")
def coarsest_grid(datasets: Datasets) -> Verdict:
    """Pixels on the coarsest grid against the corrected area on the finest one."""
    found = table_curves(datasets, "table_4_2", common=True)
    coarse = at(found[0].curve.load, found[0].curve.mean["contact_area_ratio_pixel"], MEDIUM)
    fine = at(found[-1].curve.load, found[-1].curve.mean["contact_area_ratio"], MEDIUM)
    own = at(found[0].curve.load, found[0].curve.mean["contact_area_ratio"], MEDIUM)
    return judge(
        abs(coarse / fine - 1) <= 0.05,
        f"pixels at two points a wave count {100 * (coarse / fine - 1):+.0f} % of area, corrected for the edge "
        f"{100 * (own / fine - 1):+.1f} %",
        f"against the corrected area at N = {found[-1].printed.points}, p/(E* h'rms) = {MEDIUM:g}; enough means within "
        "5 %",
    )


@check("claim_4_19")
def gap_over_grid(datasets: Datasets) -> Verdict:
    """Gap of the realisation that all grids share."""
    found = table_curves(datasets, "table_4_2", common=True)
    difference, load = largest_gap_difference([row.curve for row in found], normalised)
    return judge(
        difference <= 0.02,
        f"gaps differ by at most {difference:.2g} h_rms, at p/(E* h'rms) = {load:.2g}",
        f"N = {points_of(found)}; no effect means up to 0.02 h_rms",
    )


@check("claim_4_23")
def gap_over_plateau(datasets: Datasets) -> Verdict:
    """Gap at light and heavy loads over the width of the plateau."""
    curves = [row.curve for row in table_curves(datasets, "table_4_3")]
    light = max(float(curve.reduced_pressure[0]) for curve in curves) * 1.001
    middle = 0.1 * SURFACE.rms_slope
    gaps = [[relative_separation(curve, p) for curve in curves] for p in (light, middle)]
    return judge(
        np.ptp(gaps[0]) > GAP,
        f"u/h_rms {numbers(gaps[0])} at p/E* = {light:.1e}, {numbers(gaps[1])} at {middle:.1e}",
        f"plateaus 1 to {max(2 * np.pi / curve.inputs['long_cutoff'] for curve in curves) / 1e-4:g} roll-off "
        f"wavelengths; strongly means by more than {GAP:g} h_rms",
    )


@check("claim_4_24")
def logarithmic_law(datasets: Datasets) -> Verdict:
    """Slope of the gap over ln p at the lightest loads, over that where the gap is h_rms."""
    curves = [row.curve for row in table_curves(datasets, "table_4_3")]
    ratios = [_straightness(curve) for curve in curves]
    return judge(
        ratios[0] < 0.9 and ratios[-1] > ratios[0],
        f"slope at the lightest loads over that at u = h_rms: {numbers(ratios)}",
        "from no plateau to the widest; 1 is the logarithmic law",
    )


def _straightness(curve: ContactCurve) -> float:
    gap, logarithm = curve.relative_separation(), np.log(curve.reduced_pressure)
    known = np.isfinite(gap)
    slope = -np.gradient(gap[known], logarithm[known])
    middle = float(np.interp(-1.0, -gap[known], slope))
    return float(slope[0] / middle)
