"""Checks of chapter 3: the Stribeck curves (3.3.1, 3.6, 3.7) and their inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
import xarray as xr

from softlub.claims.reading import curve, hertz_half_width, hertz_peak_pressure, interpolated, minimum, number
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge, state
from softlub.datasets.minimum import FrictionMinimum
from softlub.datasets.variables import FLAGS

LOWEST = 1e-5
"""Lowest speed of the curves [m/s]."""
MODULI = (1e7, 2e7, 5e7)
ROUGHNESSES = (1e-6, 3e-6, 6e-6)
NEARLY_EQUAL = 0.1
"""Relative difference up to which curves count as nearly the same."""

state(
    "not computed",
    dict.fromkeys((f"fig_3_{n}" for n in range(1, 6)), "a schematic: there is nothing to compute")
    | dict.fromkeys((f"fig_3_{n}" for n in range(6, 9)), "a flow chart: there is nothing to compute"),
)
state(
    "not decidable",
    {"claim_3_34": "the source prints no measured data; our trend is judged in claim_3_31 to claim_3_33"},
)


@check("table_3_1")
def inputs_of_table(datasets: Datasets) -> Verdict:
    """The study uses the printed inputs; what follows from them is printed nowhere."""
    dataset = datasets("ch3-stribeck")
    newton = curve(dataset)
    printed = {
        "radius": 0.01,
        "viscosity": 0.1,
        "rms_roughness": 1e-6,
        "load": 100.0,
        "long_term_modulus": 1e7,
    }
    used = {name: float(newton[name]) for name in printed}
    differing = [name for name, value in printed.items() if not np.isclose(used[name], value)]
    plateau = number(newton.isel(speed=0), "friction_coefficient")
    return judge(
        not differing,
        f"half-width {hertz_half_width(newton) * 1e3:.3f} mm, "
        f"peak pressure {hertz_peak_pressure(newton) / 1e6:.3f} MPa, "
        f"friction coefficient {plateau:.3f} at the lowest speed",
        f"other inputs used: {', '.join(differing)}"
        if differing
        else "by construction: the printed inputs are taken over; the source prints nothing that follows from them",
    )


@check("claim_3_01")
def domain(datasets: Datasets) -> Verdict:
    """Smallest separation at 1 m/s over domains from some Hertz half-widths on."""
    dataset = datasets("ch3-domain")
    if "half_domain" not in dataset.dims:
        raise NotComputed("study ch3-domain was not swept over half_domain")
    reach = dataset["half_domain"].values
    order = np.argsort(reach)
    films = [interpolated(curve(dataset.isel(half_domain=i)), 1.0, "separation_min") for i in order]
    units = reach[order] / hertz_half_width(curve(dataset.isel(half_domain=0)))
    return judge(
        films[0] < 0.95 * films[-1],
        "; ".join(f"{film * 1e6:.1f} µm at ±{unit:.1f} a" for film, unit in zip(films, units, strict=True)),
        "smallest separation at 1 m/s; the source's own domain of ±1 mm (3.2 a) is one of those that are too small",
    )


@check("claim_3_02")
def cavitation(datasets: Datasets) -> Verdict:
    """Friction with either cavitation model."""
    dataset = datasets("ch3-cavitation")
    reynolds = curve(dataset, cavitation="reynolds")["friction_coefficient"].values
    conserving = curve(dataset, cavitation="mass_conserving")["friction_coefficient"].values
    change = np.abs(conserving / reynolds - 1)
    if not np.isfinite(change).any():
        raise NotComputed("no speed converged with both cavitation models")
    largest = float(np.nanmax(change))
    return judge(
        largest <= 0.05,
        f"friction changes by at most {100 * largest:.2g} %",
        f"over the {int(np.isfinite(change).sum())} speeds that converged with both; hardly means up to 5 %; no "
        "evidence but an identity of the model: without reformation of the film both conditions have one solution, and "
        "the cavity's film counts as full in both",
    )


@check("claim_3_22")
def shear_strength(datasets: Datasets) -> Verdict:
    """The strength in parts of the modulus, at every speed."""
    newton = curve(datasets("ch3-stribeck"))
    part = np.atleast_1d(newton["shear_strength"].values / float(newton["long_term_modulus"]))
    return judge(
        bool(np.allclose(part, 0.1)),
        f"{part.min():.3g} E to {part.max():.3g} E",
        "by construction: the strength is an input, taken over from the source",
    )


@check("eq_3_38")
def friction_parts(datasets: Datasets) -> Verdict:
    """Total friction against the sum of its parts, and its solid part against strength times real width."""
    newton = curve(datasets("ch3-stribeck"))
    parts = ("couette", "poiseuille", "solid")
    total = sum(newton[f"friction_coefficient_{part}"] for part in parts)
    difference = float(np.nanmax(np.abs(total - newton["friction_coefficient"])))
    return judge(
        difference < 1e-9,
        f"largest difference {difference:.0e}",
        "by construction: the total is made as the sum of its Couette, Poiseuille and solid parts",
    )


@check("claim_3_23")
def decades(datasets: Datasets) -> Verdict:
    """Decades of speed over which the curve converged, and where its assumptions end."""
    newton = curve(datasets("ch3-stribeck"))
    speed = newton["speed"].values[newton["converged"].values.astype(bool)]
    if speed.size < 2:
        raise NotComputed("fewer than two speeds converged")
    span = float(np.log10(speed.max() / speed.min()))
    outside = newton["speed"].values[(newton["flags"].values.astype(int) & FLAGS["outside_half_space"]) > 0]
    limit = f"; half-space and parabola are left above {outside.min():.2g} m/s" if outside.size else ""
    return judge(
        span > 6, f"{span:.2g} decades", f"converged from {speed.min():.2g} to {speed.max():.2g} m/s{limit}"
    )


@check("claim_3_24")
def share_at_minimum(datasets: Datasets) -> Verdict:
    """Asperity share at the minimum of friction."""
    least = minimum(curve(datasets("ch3-stribeck")))
    return judge(
        abs(least.load_share_solid / 0.003 - 1) <= 0.5,
        f"{100 * least.load_share_solid:.2g} %",
        f"at the minimum, friction coefficient {least.friction_coefficient:.4f}, {least.speed:.3g} m/s; "
        "reproduced if within half of 0.3 %",
    )


@check("claim_3_25")
def film_at_minimum(datasets: Datasets) -> Verdict:
    """How far the separation grows on the way to the minimum of friction."""
    newton = curve(datasets("ch3-stribeck"))
    least, first = minimum(newton), newton.isel(speed=0)
    growth = least.separation_min / number(first, "separation_min")
    drop = number(first, "friction_coefficient") / least.friction_coefficient
    return judge(
        growth > 2 and drop > 2,
        f"separation grows {growth:.2g}-fold while friction drops {drop:.2g}-fold",
        "smallest separation, as the caption of 3-17 has it; the text calls it the central one",
    )


@check("claim_3_26")
def softer_leaves_earlier(datasets: Datasets) -> Verdict:
    """Speed at which half the friction of the lowest speed is left, for each modulus."""
    curves = [curve(datasets("ch3-modulus"), young_modulus=modulus) for modulus in MODULI]
    speeds = [_speed_of_half(one) for one in curves]
    return judge(
        all(softer < stiffer for softer, stiffer in pairwise(speeds)),
        "half the boundary friction is left at " + ", ".join(f"{speed:.2g}" for speed in speeds) + " m/s",
        "for 10, 20 and 50 MPa",
    )


def _speed_of_half(one: xr.Dataset) -> float:
    """First speed where friction has fallen to half of that at the lowest one, interpolated in ln v [m/s]."""
    friction, speed = one["friction_coefficient"].values, np.log(one["speed"].values)
    known = np.isfinite(friction)
    friction, speed = friction[known], speed[known]
    if friction.size == 0 or not (friction < 0.5 * friction[0]).any():
        raise NotComputed("friction never falls to half of that at the lowest speed")
    after = int(np.argmax(friction < 0.5 * friction[0]))
    ends = friction[[after, after - 1]]
    return float(np.exp(np.interp(0.5 * friction[0], ends, speed[[after, after - 1]])))


def _spread(
    datasets: Datasets, study: str, over: Mapping[str, Sequence[float]], variable: str, speed: float
) -> float:
    """Largest over smallest value of a variable across a sweep, less one."""
    ((name, values),) = over.items()
    found = [interpolated(curve(datasets(study), **{name: value}), speed, variable) for value in values]
    return max(found) / min(found) - 1


@check("claim_3_27")
def boundary_friction_of_moduli(datasets: Datasets) -> Verdict:
    """Friction of the three moduli at the lowest speed."""
    spread = _spread(datasets, "ch3-modulus", {"young_modulus": MODULI}, "friction_coefficient", LOWEST)
    return judge(
        spread <= NEARLY_EQUAL,
        f"spread {100 * spread:.2g} % at 1e-5 m/s",
        f"nearly the same means within 10 %: {_margin(spread, NEARLY_EQUAL)}; at rest it is exact, since the solid "
        "friction of a strength in proportion to the modulus does not depend on the modulus",
    )


def _margin(value: float, limit: float) -> str:
    """How far a value stands from its limit, and whether a little less or more would have decided otherwise."""
    points = 100 * (limit - value)
    where = "below" if points >= 0 else "above"
    borderline = ", borderline" if abs(value / limit - 1) < 0.05 else ""
    return f"{abs(points):.2g} percentage points {where} the limit{borderline}"


@check("claim_3_28")
def film_friction_of_moduli(datasets: Datasets) -> Verdict:
    """Fluid friction of the three moduli at 1 m/s."""
    spread = _spread(datasets, "ch3-modulus", {"young_modulus": MODULI}, "friction_coefficient_fluid", 1.0)
    return judge(
        spread <= NEARLY_EQUAL, f"spread {100 * spread:.2g} % at 1 m/s", "nearly the same means within 10 %"
    )


@check("claim_3_29")
def softer_builds_film(datasets: Datasets) -> Verdict:
    """Smallest separation of the three moduli in mixed lubrication."""
    curves = [curve(datasets("ch3-modulus"), young_modulus=modulus) for modulus in MODULI]
    films = [interpolated(one, 1e-2, "separation_min") for one in curves]
    return judge(
        all(softer > stiffer for softer, stiffer in pairwise(films)),
        "separations " + ", ".join(f"{film * 1e6:.2g}" for film in films) + " µm at 0.01 m/s",
        "for 10, 20 and 50 MPa",
    )


@check("claim_3_30")
def full_film_of_roughnesses(datasets: Datasets) -> Verdict:
    """Friction and separation of the three roughnesses at 1 m/s."""
    sweep = {"rms_roughness": ROUGHNESSES}
    friction, film = (
        _spread(datasets, "ch3-roughness", sweep, name, 1.0)
        for name in ("friction_coefficient", "separation_min")
    )
    return judge(
        max(friction, film) <= NEARLY_EQUAL,
        f"spread of friction {100 * friction:.2g} %, of separation {100 * film:.2g} % at 1 m/s",
        "hardly matters means within 10 %",
    )


@check("claim_3_31")
def boundary_friction_of_roughnesses(datasets: Datasets) -> Verdict:
    """Friction of the three roughnesses at the lowest speed."""
    curves = [curve(datasets("ch3-roughness"), rms_roughness=rms) for rms in ROUGHNESSES]
    frictions = [interpolated(one, LOWEST, "friction_coefficient") for one in curves]
    return judge(
        all(rougher < smoother for smoother, rougher in pairwise(frictions)),
        "friction coefficients " + ", ".join(f"{friction:.3g}" for friction in frictions) + " at 1e-5 m/s",
        "for 1, 3 and 6 µm",
    )


def _minima(datasets: Datasets) -> list[FrictionMinimum]:
    return [minimum(curve(datasets("ch3-roughness"), rms_roughness=rms)) for rms in ROUGHNESSES]


def _regime(share: float) -> str:
    if share > 0.5:
        return "a shallow dip in boundary lubrication, not the entry into full film that the source describes"
    return "within mixed lubrication or beyond"


def _sixth_micrometre(datasets: Datasets) -> str:
    six = _minima(datasets)[-1]
    return (
        f"for 1, 3 and 6 µm; at 6 µm asperities still carry {100 * six.load_share_solid:.2g} % of the load at the "
        f"minimum, {_regime(six.load_share_solid)}"
    )


@check("claim_3_32")
def minimum_moves(datasets: Datasets) -> Verdict:
    """Hersey number of the minimum for each roughness."""
    numbers = [least.hersey_number for least in _minima(datasets)]
    return judge(
        all(rougher > smoother for smoother, rougher in pairwise(numbers)),
        "minima at " + ", ".join(f"{value:.3g}" for value in numbers) + " N/m",
        _sixth_micrometre(datasets),
    )


@check("claim_3_33")
def minimum_grows(datasets: Datasets) -> Verdict:
    """Friction at the minimum for each roughness."""
    frictions = [least.friction_coefficient for least in _minima(datasets)]
    return judge(
        all(rougher > smoother for smoother, rougher in pairwise(frictions)),
        "least friction coefficients " + ", ".join(f"{value:.3g}" for value in frictions),
        _sixth_micrometre(datasets),
    )
