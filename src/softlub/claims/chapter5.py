"""Checks of chapter 5: the reduced stiffness against finite elements (5.2 to 5.5)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.reading import AGREEMENT
from softlub.claims.reading_solid import (
    Differences,
    differences,
    displacement,
    largest,
    percent,
    scene,
    sweep,
)
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge, state
from softlub.protocols import FloatArray

SPOILED = 5.0
"""How many times larger a difference must be to count as spoiled by the constraint."""
SAME = f"equal if both components are within {percent(AGREEMENT)} of their largest value"

state(
    "not computed",
    {
        **dict.fromkeys(("fig_5_2", "fig_5_6", "fig_5_11"), "a schematic: there is nothing to compute"),
        "fig_5_3": "a sketch of the model; the mesh of ours is drawn beside figures 5-4 and 5-5",
    },
)


def equal(found: Differences) -> bool:
    """Whether a figure would show no difference in either direction."""
    return max(found.lateral, found.vertical) <= AGREEMENT


@check("claim_5_01")
def half_space_falls_short(datasets: Datasets) -> Verdict:
    """Deflection of the half-space over that by finite elements, for every datum, at the heaviest load reached."""
    body = heaviest(datasets("ch5-half-cylinder"))
    if "displacement_half_space" not in body:
        raise NotComputed("study ch5-half-cylinder does not compare with the half-space")
    middle = int(np.argmin(np.abs(body["x"].values)))
    full = displacement(body)[:, 1]
    theory = body["displacement_half_space"].sel(component="y").transpose("datum", "node").values
    ratios = theory[:, middle] / full[middle]
    beyond = [float(one[middle] - (one[0] + one[-1]) / 2) for one in (full, theory[0])]
    each = ", ".join(
        f"{ratio:.2f} (datum {datum:g} m)" for ratio, datum in zip(ratios, body["datum"].values, strict=True)
    )
    value = (
        f"half-space over finite elements in the middle: {each}, which moves by {1e3 * full[middle]:.2g} mm"
    )
    reason = (
        f"the source states no datum of the logarithm, and it decides; beyond the ends of the edge, which no datum "
        f"changes, the middle moves {beyond[1] / beyond[0]:.2f} times as far in the half-space"
    )
    if ratios.min() < 1 < ratios.max():
        return Verdict(value, "not decidable", reason)
    return judge(bool(ratios.max() < 1), value, reason)


def heaviest(dataset: xr.Dataset) -> xr.Dataset:
    """The body under the heaviest load that it reached.

    Raises
    ------
    NotComputed
        If it reached none.
    """
    loads = dataset["load"].values
    for load in loads[::-1]:
        try:
            return scene(dataset, {"load": float(load)})
        except NotComputed:
            continue
    raise NotComputed("the body reached the end of its steps under no load")


@check("claim_5_03")
def linear_static(datasets: Datasets) -> Verdict:
    """Largest difference without friction."""
    found = differences(scene(datasets("ch5-linear"), {"friction": 0.0}))
    return judge(
        equal(found),
        f"{found}",
        f"largest difference over the largest displacement; {SAME}. Without friction the lateral displacement is "
        "small, so that the largest vector hides what it is off by",
    )


@check("claim_5_04")
def friction_does_not_matter(datasets: Datasets) -> Verdict:
    """Largest difference with and without friction."""
    dataset = datasets("ch5-linear")
    bodies = [scene(dataset, {"friction": value}) for value in (0.0, 0.4)]
    without, with_friction = (differences(body) for body in bodies)
    lengths = [
        found.whole * largest(displacement(body))
        for found, body in zip((without, with_friction), bodies, strict=True)
    ]
    return judge(
        max(without.whole, with_friction.whole) <= AGREEMENT,
        f"mu = 0: {without}, {1e6 * lengths[0]:.2g} µm; mu = 0.4: {with_friction}, {1e6 * lengths[1]:.2g} µm",
        f"the same quality if both are within {percent(AGREEMENT)} of the largest displacement; as lengths they differ "
        "little, as parts of the lateral displacement much, since friction makes that one large",
    )


@check("claim_5_05")
def linear_sliding(datasets: Datasets) -> Verdict:
    """Largest difference at a friction of 0.4."""
    found = differences(scene(datasets("ch5-linear"), {"friction": 0.4}))
    return judge(equal(found), f"{found}", f"largest difference over the largest displacement; {SAME}")


@check("claim_5_06")
def hyperelastic_sliding(datasets: Datasets) -> Verdict:
    """Largest difference of L_H."""
    found = differences(scene(datasets("ch5-hyperelastic")))
    return judge(equal(found), f"{found}", f"largest difference over the largest displacement; {SAME}")


@check("claim_5_07")
def hyperelastic_is_nearly_linear(datasets: Datasets) -> Verdict:
    """Displacement of L_H against that of a body with E0, once turning with the body and once strictly linear."""
    dataset = datasets("ch5-hyperelastic")
    sweep(dataset, "material")
    first, second = (scene(dataset, {"material": str(name)}) for name in dataset["material"].values[:2])
    full = displacement(first)
    turning, strict = (
        largest(displacement(second, method) - full) / largest(full) for method in ("full", "reduced")
    )
    return judge(
        max(turning, strict) <= AGREEMENT,
        f"{percent(turning)} of the largest displacement; {percent(strict)} for small displacements",
        f"alike within {percent(AGREEMENT)}. Our linear body is free of stress when it turns, and so neo-Hookean with "
        f"G = E/3; its reduced stiffness is the strictly linear one",
    )


@check("claim_5_08")
def better_than_half_space(datasets: Datasets) -> Verdict:
    """Difference of the reduced stiffness and of the half-space with the best datum."""
    body = scene(datasets("ch5-hyperelastic"))
    if "displacement_half_space" not in body:
        raise NotComputed("study ch5-hyperelastic does not compare with the half-space")
    reduced = differences(body).whole
    best = best_half_space(body)
    return judge(
        reduced < best,
        f"{percent(reduced)} by the reduced stiffness, {percent(best)} by the half-space",
        "largest difference over the largest displacement, under the same nodal forces; of the half-space, whose "
        "displacements are known up to a constant each, with the constants that fit best",
    )


def best_half_space(body: xr.Dataset) -> float:
    """Least over all shifts along x and y of the largest difference, over the largest displacement.

    Bounded from below by half of the range of the larger component's difference.
    """
    full = displacement(body)
    theory = body["displacement_half_space"].isel(datum=0).transpose("node", "component").values
    off: FloatArray = theory - full
    return float(np.ptp(off, axis=0).max() / 2) / largest(full)


@check("claim_5_13")
def constraint_spoils(datasets: Datasets) -> Verdict:
    """Difference with and without the contact constraint."""
    body = scene(datasets("ch5-constraint"))
    without, kept = differences(body), differences(body, "constrained")
    return judge(
        kept.whole >= SPOILED * without.whole,
        f"kept: {kept}; released: {without}",
        f"spoiled if {SPOILED:g} times larger; unloaded the apex alone touches, and the penalty holds it",
    )
