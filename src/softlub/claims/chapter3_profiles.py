"""Checks of chapter 3: pressures and separation over x (3.5)."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import xarray as xr

from softlub.claims.reading import (
    AGREEMENT,
    at_speed,
    curve,
    field,
    hertz_half_width,
    law,
    number,
    profile_difference,
)
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge

LOWEST, MIDDLE, HIGHEST = 1e-5, 1.5e-3, 0.12
"""Speeds of figures 3-9 to 3-11 [m/s]."""
FIELDS = ("fluid_pressure", "solid_pressure", "separation")
NEARLY_EQUAL = 0.1
"""Relative difference up to which profiles count as nearly the same."""
STAND_IN = (
    "the full integral with gamma = 0.45 stands in for reference 2, and that gamma was chosen because its asperity "
    "pressure at 0.12 m/s would call for the factor 1e5"
)


@check("claim_3_12")
def near_reference(datasets: Datasets) -> Verdict:
    """The stand-in for reference 2 (γ = 0.45) against the exponential law; no data of reference 2 is printed."""
    dataset = datasets("ch3-profiles")
    differences = [
        max(profile_difference(*_both_laws(dataset, speed), name) for name in FIELDS[:2])
        for speed in (LOWEST, MIDDLE, HIGHEST)
    ]
    return Verdict(
        "pressures differ by " + ", ".join(f"{100 * difference:.2g} %" for difference in differences),
        "not decidable",
        f"the source prints no data of reference 2; {STAND_IN}; differences are parts of the peak pressure at 1e-5, "
        "1.5e-3 and 0.12 m/s",
    )


def _both_laws(dataset: xr.Dataset, speed: float) -> tuple[xr.Dataset, xr.Dataset]:
    full = curve(law(dataset, "persson", 0.45))
    return at_speed(full, speed), at_speed(curve(law(dataset, "exponential")), speed)


@check("claim_3_13")
def boundary_profile(datasets: Datasets) -> Verdict:
    """Share and width of the contact at the lowest speed."""
    dataset = datasets("ch3-profiles")
    point = at_speed(curve(law(dataset, "persson")), LOWEST)
    share, width = number(point, "load_share_solid"), _relative_width(point)
    approximate = number(at_speed(curve(law(dataset, "exponential")), LOWEST), "load_share_solid")
    return judge(
        share > 0.5 and 1.0 < width < 1.25,
        f"asperity share {share:.3f}, pressure {width:.3f} times as wide at a tenth of its height as Hertz's",
        "with the full Persson integral; "
        f"with the source's own law 3-11 the share is {approximate:.2f}, since that law cannot carry the load at rest",
    )


def _relative_width(point: xr.Dataset) -> float:
    """Width of the total pressure at a tenth of its maximum, where roughness widens a contact, over that of Hertz's."""
    x, fluid = field(point, "fluid_pressure")
    total = fluid + field(point, "solid_pressure")[1]
    top = int(np.argmax(total))
    level = 0.1 * total[top]
    left = np.interp(level, total[: top + 1], x[: top + 1])
    right = np.interp(-level, -total[top:], x[top:])
    return float((right - left) / (2 * np.sqrt(1 - 0.1**2) * hertz_half_width(point)))


@check("claim_3_14")
def fluid_gains(datasets: Datasets) -> Verdict:
    """The asperity share falls from speed to speed."""
    profiles = curve(law(datasets("ch3-profiles"), "persson"))
    shares = [number(at_speed(profiles, v), "load_share_solid") for v in (LOWEST, MIDDLE, HIGHEST)]
    return judge(
        all(later < earlier for earlier, later in pairwise(shares)),
        "asperity shares " + ", ".join(f"{share:.3g}" for share in shares),
        "at 1e-5, 1.5e-3 and 0.12 m/s",
    )


@check("claim_3_15")
def law_explains_difference(datasets: Datasets) -> Verdict:
    """What changes when only the asperity law changes, at the two lower speeds."""
    dataset = datasets("ch3-profiles")
    pairs = (_both_laws(dataset, speed) for speed in (LOWEST, MIDDLE))
    differences = [profile_difference(*pair, "solid_pressure") for pair in pairs]
    return judge(
        max(differences) <= NEARLY_EQUAL,
        "asperity pressures differ by " + ", ".join(f"{100 * part:.2g} %" for part in differences),
        f"of the peak pressure at 1e-5 and 1.5e-3 m/s (full integral, gamma = 0.45, against law 3-11); "
        f"small means up to {100 * NEARLY_EQUAL:g} %; {STAND_IN}",
    )


@check("claim_3_16")
def laws_agree_in_full_film(datasets: Datasets) -> Verdict:
    """Fluid pressure and separation with either law at the highest speed."""
    pair = _both_laws(datasets("ch3-profiles"), HIGHEST)
    differences = [profile_difference(*pair, name) for name in ("fluid_pressure", "separation")]
    return judge(
        max(differences) <= AGREEMENT,
        f"fluid pressures differ by {100 * differences[0]:.2g} %, separations by {100 * differences[1]:.2g} %",
        f"full integral with gamma = 0.45 against law 3-11 at 0.12 m/s; equal means within 2 %; {STAND_IN}",
    )


@check("claim_3_17")
def amplified_pressure(datasets: Datasets) -> Verdict:
    """Order of the asperity share at the highest speed, for both values of γ; one of them was chosen to fit this."""
    dataset = datasets("ch3-profiles")
    plain, fitted = (
        number(at_speed(curve(law(dataset, "persson", gamma)), HIGHEST), "load_share_solid")
        for gamma in (1.0, 0.45)
    )
    return Verdict(
        f"asperity share {fitted:.1e} with gamma = 0.45, {plain:.1e} with gamma = 1",
        "not decidable",
        f"the source prints no data of reference 2; {STAND_IN}, so that its agreement proves nothing; with gamma = 1 "
        "no such factor would be called for",
    )


@check("eq_gumbel")
def rupture_condition(datasets: Datasets) -> Verdict:
    """Power of the distance from the rupture with which the fluid pressure rises: 2 for Reynolds, 1 for Gümbel."""
    point = at_speed(curve(law(datasets("ch3-profiles"), "persson")), HIGHEST)
    x, pressure = field(point, "fluid_pressure")
    distance = number(point, "rupture_position") - x
    near = (distance > 0) & (pressure > 1e-6 * pressure.max()) & (pressure < 0.05 * pressure.max()) & (x > 0)
    if near.sum() < 2:
        raise NotComputed("too few nodes lie beside the rupture")
    power = float(np.polyfit(np.log(distance[near]), np.log(pressure[near]), 1)[0])
    return Verdict(
        f"pressure rises with the power {power:.2f} of the distance from the rupture",
        "differs" if power > 1.5 else "reproduced",
        "pressure and slope vanish together: that is Reynolds' (Swift and Stieber's) condition; Gümbel's cuts off "
        "a solution that has negative pressures and would leave a slope",
    )
