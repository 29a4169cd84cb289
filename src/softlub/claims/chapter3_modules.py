"""Checks of chapter 3: the source's three modules (3.4, 3.5)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.reading import (
    AGREEMENT,
    at_speed,
    attempted,
    curve,
    field,
    number,
    profile_difference,
    solver,
)
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge, state

MODULES = ("bml", "mehl", "ehl")

state(
    "not computed",
    {
        "claim_3_04": "no study varies the relaxation of the inner loop",
        "claim_3_05": "no study varies the relaxation factors of BML",
        "claim_3_08": "the datasets keep the last residual of every point, not the history of its load",
    },
)
state("not decidable", {"claim_3_10": "the source contradicts itself: text and table print different ranges"})


def _sweeps(datasets: Datasets) -> tuple[xr.Dataset, xr.Dataset]:
    """MEHL by Gauss–Seidel and by Newton–Raphson sweep, each over speed."""
    dataset = datasets("ch3-sweeps")
    return (
        curve(solver(dataset, "mehl", without="newton_raphson")),
        curve(solver(dataset, "mehl", option="newton_raphson")),
    )


@check("claim_3_06")
def cost_of_sweeps(datasets: Datasets) -> Verdict:
    """Sweeps and CPU time of both at 0.03 m/s."""
    points = [at_speed(one, 0.03) for one in _sweeps(datasets)]
    sweeps = [number(point, "iterations") for point in points]
    seconds = [number(point, "solver_seconds") for point in points]
    return judge(
        sweeps[1] < sweeps[0] and seconds[1] < seconds[0],
        f"Newton–Raphson {sweeps[1]:.0f} sweeps and {seconds[1]:.2g} s, "
        f"Gauss–Seidel {sweeps[0]:.0f} sweeps and {seconds[0]:.2g} s",
        "at 0.03 m/s",
    )


@check("claim_3_07")
def newton_sweep_fails(datasets: Datasets) -> Verdict:
    """Where each sweep fails."""
    seidel, newton = _sweeps(datasets)
    both = attempted(seidel) & attempted(newton)
    if not both.any():
        raise NotComputed("no speed was attempted with both sweeps")
    failed = [~one["converged"].values.astype(bool)[both] for one in (seidel, newton)]
    lowest = int(np.argmin(seidel["speed"].values[both]))
    return judge(
        bool(failed[1][lowest]),
        f"Newton–Raphson fails at {failed[1].sum()} of {both.sum()} speeds, Gauss–Seidel at {failed[0].sum()}",
        "reproduced if Newton–Raphson fails at the lowest speed, where the separation is smallest",
    )


@check("claim_3_09")
def many_iterations(datasets: Datasets) -> Verdict:
    """Most sweeps that a point of MEHL took."""
    both = _sweeps(datasets)
    most = max(int(one["iterations"].values.max()) for one in both)
    converged = [one["iterations"].values[one["converged"].values.astype(bool)] for one in both]
    slowest = max((int(counts.max()) for counts in converged if counts.size), default=0)
    return judge(
        most > 10_000,
        f"up to {most} sweeps; {slowest} for the slowest point that converged",
        "over all speeds attempted",
    )


@check("claim_3_18")
def sweeps_agree(datasets: Datasets) -> Verdict:
    """Fields of both sweeps at 0.03 m/s, and how steeply the fluid pressure ends."""
    seidel, newton = (at_speed(one, 0.03) for one in _sweeps(datasets))
    _all_converged({"Gauss–Seidel": seidel, "Newton–Raphson": newton})
    difference = profile_difference(seidel, newton, "fluid_pressure")
    slopes = [_slope_at_rupture(point) for point in (seidel, newton)]
    return judge(
        difference <= AGREEMENT and slopes[1] > 2 * slopes[0],
        f"fluid pressures differ by {100 * difference:.2g} %; slope where the film ends {slopes[0]:.1e} (Gauss–Seidel) "
        f"and {slopes[1]:.1e} (Newton–Raphson) of the steepest",
        "at 0.03 m/s; reproduced if they agree within 2 % and Newton–Raphson ends at least twice as steeply",
    )


def _slope_at_rupture(point: xr.Dataset) -> float:
    x, pressure = field(point, "fluid_pressure")
    slope = np.abs(np.gradient(pressure, x))
    return float(slope[np.flatnonzero(pressure > 1e-6 * pressure.max())[-1]] / slope.max())


def _all_converged(points: dict[str, xr.Dataset]) -> None:
    failed = [
        f"{name} did not converge (residual {float(point['residual']):.1e} after {int(point['iterations'])} sweeps)"
        for name, point in points.items()
        if not bool(point["converged"])
    ]
    if failed:
        raise NotComputed("; ".join(failed) + ", so the statement cannot be judged")


def _agreement(datasets: Datasets, names: tuple[str, str], speed: float, fields: tuple[str, ...]) -> Verdict:
    """Whether two modules agree at one speed; a module that did not converge decides nothing."""
    dataset = datasets("ch3-modules")
    points = {name.upper(): at_speed(curve(solver(dataset, name)), speed) for name in names}
    first, second = points.values()
    differences = {name: profile_difference(first, second, name) for name in fields}
    value = ", ".join(f"{name.replace('_', ' ')} {100 * part:.2g} %" for name, part in differences.items())
    try:
        _all_converged(points)
    except NotComputed as failure:
        return Verdict(f"last iterates differ: {value}", "not computed", str(failure))
    return judge(
        max(differences.values()) <= AGREEMENT, f"differences: {value}", "agreement means within 2 %"
    )


@check("claim_3_19")
def bml_and_mehl(datasets: Datasets) -> Verdict:
    """BML against MEHL at 1.5e-3 m/s."""
    return _agreement(datasets, ("bml", "mehl"), 1.5e-3, ("fluid_pressure", "solid_pressure", "separation"))


@check("claim_3_20")
def mehl_and_ehl(datasets: Datasets) -> Verdict:
    """MEHL against EHL at 0.12 m/s."""
    return _agreement(datasets, ("mehl", "ehl"), 0.12, ("fluid_pressure", "separation"))


@check("claim_3_21")
def negligible_asperities(datasets: Datasets) -> Verdict:
    """Asperity share of the Newton solution at 0.12 m/s."""
    share = number(at_speed(curve(datasets("ch3-modules")), 0.12), "load_share_solid")
    return judge(
        share < 0.01, f"asperity share {100 * share:.2g} %", "negligible means below 1 % of the load"
    )


@check("claim_3_11")
def modules_in_turn(datasets: Datasets) -> Verdict:
    """How many of each module's points converge along the curve."""
    dataset = datasets("ch3-stribeck")
    counts, failures = [], 0
    for name in MODULES:
        one = curve(solver(dataset, name))
        asked = attempted(one)
        converged = int((one["converged"].values.astype(bool) & asked).sum())
        counts.append(f"{name.upper()} {converged} of {int(asked.sum())}")
        failures += int(asked.sum()) - converged
    return judge(
        failures == 0, "converged: " + ", ".join(counts), "speeds at which each module was asked for"
    )
