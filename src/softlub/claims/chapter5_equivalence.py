"""Checks of chapter 5: the hyperelastic body that stands for a viscoelastic one (5.6.3)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.chapter5_materials import L_H
from softlub.claims.reading import AGREEMENT
from softlub.claims.reading_solid import percent
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge
from softlub.solid.equivalence import shape_difference

SOURCE_C10 = 0.8898e6
SOURCE_ALPHA = 1.5
SOURCE_BOUND = 2e-4
"""Of equation 5-16, printed without a unit; lengths in the source's model are mm."""


@check("eq_5_16")
def unit_of_difference(datasets: Datasets) -> Verdict:
    """Power of the length by which the shape difference grows when everything is scaled."""
    one, other = np.array([[0.0, 0.0], [1.0, 2.0]]), np.array([[0.5, 0.0], [1.0, 1.0]])
    power = float(np.log10(shape_difference(10 * one, 10 * other) / shape_difference(one, other)))
    return judge(
        abs(power) < 1e-9,
        f"m^{power:.0f}",
        "how it grows when all lengths do; the source prints no unit. Ours is in m² and, besides, divided by the mean "
        "squared displacement",
    )


@check("eq_5_18")
def softer_volume(datasets: Datasets) -> Verdict:
    """Bulk and shear modulus of the equivalent body over those of L_H."""
    made = L_H.scaled(SOURCE_ALPHA)
    shear, bulk = made.shear_modulus / L_H.shear_modulus, made.bulk_modulus / L_H.bulk_modulus
    return judge(
        bulk >= 1,
        f"alpha = {SOURCE_ALPHA:g}: shear modulus {shear:.2f} times, bulk modulus {bulk:.2f} times",
        "a stiffer body needs D1 divided by alpha; followed as printed, which matters little in a body this "
        "incompressible",
    )


@check("eq_5_alpha")
def not_two_times(datasets: Datasets) -> Verdict:
    """The printed constants over each other."""
    ratio = SOURCE_C10 / L_H.c10
    return judge(abs(ratio - 2) < 0.05, f"0.8898/0.5932 = {ratio:.3f}", "the text calls it two times")


def _model(dataset: xr.Dataset, model: str) -> xr.Dataset:
    labels = [str(label) for label in dataset["model"].values] if "model" in dataset.dims else []
    if model not in labels:
        raise NotComputed(f"study ch5-equivalence holds no model {model}")
    return dataset.isel(model=labels.index(model))


def _by_steps(dataset: xr.Dataset, model: str, variable: str) -> list[tuple[str, float]]:
    """A number of one model by the steps' label, the slowest steps first, of the heaviest load.

    Raises
    ------
    NotComputed
        If the slowest is not known.
    """
    one = _model(dataset, model)[variable]
    one = one.isel({name: -1 if name == "load" else 0 for name in one.dims if name != "steps"})
    pairs = (
        [(str(label), float(value)) for label, value in zip(one["steps"].values, one.values, strict=True)]
        if "steps" in one.dims
        else [("the only steps", float(one))]
    )
    if not np.isfinite(pairs[0][1]):
        raise NotComputed(f"no {variable} of {model} is known for steps of {pairs[0][0]}")
    return pairs


def _listed(pairs: list[tuple[str, float]], digits: int = 3) -> str:
    return ", ".join(f"{value:.{digits}g} ({label})" for label, value in pairs).replace(" us)", " µs)")


GIVEN = f"alpha={SOURCE_ALPHA:g}"
DURATIONS = "by the duration of each step, which the source does not print; its series is not printed either"


@check("claim_5_20")
def source_coefficient(datasets: Datasets) -> Verdict:
    """Root of the normalised shape difference with α = 1.5, and the fitted α."""
    dataset = datasets("ch5-equivalence")
    off = [
        (label, float(np.sqrt(value)))
        for label, value in _by_steps(dataset, GIVEN, "shape_difference_normalised")
    ]
    fitted = _by_steps(dataset, "fitted", "coefficient")
    return judge(
        off[0][1] <= AGREEMENT,
        f"alpha = {SOURCE_ALPHA:g} is off by {_listed(off, 2)} of the rms displacement; fitted alpha {_listed(fitted)}",
        f"{DURATIONS}; judged by the first, the same shape within {percent(AGREEMENT)}",
    )


@check("claim_5_21")
def bound_of_difference(datasets: Datasets) -> Verdict:
    """Equation 5-16 in mm² of α = 1.5, of the fit and of a body that does not deform."""
    dataset = datasets("ch5-equivalence")
    given, fitted = (_by_steps(dataset, model, "shape_difference")[0][1] * 1e6 for model in (GIVEN, "fitted"))
    rigid = dataset["shape_difference_rigid"]
    rigid_value = float(rigid.values.ravel()[0]) * 1e6
    return Verdict(
        f"alpha = {SOURCE_ALPHA:g} {given:.2g} mm², fitted {fitted:.1g} mm², a body that does not deform "
        f"{rigid_value:.3g} mm²",
        "not decidable",
        f"the bound of {SOURCE_BOUND:g} has no unit, and in mm² it tells hardly more than that the body deforms",
    )


@check("claim_5_22")
def equivalent_exists(datasets: Datasets) -> Verdict:
    """Root of the normalised shape difference of the fit."""
    pairs = _by_steps(datasets("ch5-equivalence"), "fitted", "shape_difference_normalised")
    off = [(label, float(np.sqrt(value))) for label, value in pairs]
    return Verdict(
        f"the best one is off by {_listed(off, 2)} of the rms displacement",
        "not decidable",
        "where the sliding is steady the body has relaxed, and is trivially its own equivalent; short steps leave a "
        "difference, and the source prints neither its steps nor its series. Material L alone",
    )


@check("claim_5_23")
def stiffening(datasets: Datasets) -> Verdict:
    """The fitted α."""
    pairs = _by_steps(datasets("ch5-equivalence"), "fitted", "coefficient")
    return judge(
        pairs[0][1] > 1 + AGREEMENT,
        f"alpha = {_listed(pairs)}",
        f"{DURATIONS}; judged by the first, stiffer by more than {percent(AGREEMENT)}. On a smooth plate the body "
        "rests in its own frame, and viscoelasticity acts through the history of the load alone",
    )


@check("claim_5_25")
def reduced_of_equivalent(datasets: Datasets) -> Verdict:
    """Difference of the reduced stiffness of both equivalents from the viscoelastic body."""
    dataset = datasets("ch5-equivalence")
    fitted, given = (_by_steps(dataset, model, "displacement_reduced_error") for model in ("fitted", GIVEN))
    return judge(
        given[0][1] <= AGREEMENT,
        f"with alpha = {SOURCE_ALPHA:g} {percent(given[0][1])} of the largest displacement, with the fitted alpha "
        f"{percent(fitted[0][1])}",
        f"steps of {fitted[0][0]}; good agreement: within {percent(AGREEMENT)}. The coefficient is what does not fit; "
        "the reduced stiffness of a body that does is as good as that of an elastic one",
    )
