"""Checks of the printed equations of the deterministic solver of 4.5."""

from __future__ import annotations

import numpy as np
import xarray as xr
from scipy.integrate import quad

from softlub.claims.reading_contact import numbers
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge
from softlub.contact.polonsky_keer import SOURCE_CHANGE, solve_polonsky_keer
from softlub.contact.solver.kernels import love_rectangle
from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthesis import synthesize
from softlub.surfaces.topography import Topography


@check("eq_4_24")
def deflection_factor(datasets: Datasets) -> Verdict:
    """The printed deflection in the middle of Hertz's pressure against a²/R, in units of both."""
    # p = p0 √(1 − r²) with p0 = 2 E* a/(π R): w(0) = prefactor ∫ p/r dA.
    integral = quad(lambda r: 2 * np.pi * np.sqrt(1 - r**2), 0, 1)[0]
    ratio = 2 / np.pi * 2 / np.pi * integral
    return judge(
        abs(ratio - 1) < 1e-6,
        f"the printed deflection is {ratio:.4g} times a²/R",
        "in the middle of Hertz's pressure on one elastic body with E* = E/(1 - nu²), as 4-15 defines it: 1/(pi E*)",
    )


@check("eq_4_26")
def influence_of_rectangle(datasets: Datasets) -> Verdict:
    """The printed influence against Love's rectangle, on the loaded cell itself and two cells beside."""

    def reach(along: float, across: float) -> float:
        return along + float(np.hypot(along, across))

    def printed(x: float, y: float) -> float:
        east, west, north, south = x + 0.5, x - 0.5, y + 0.5, y - 0.5
        return (
            abs(east) * np.log(reach(north, east) / reach(south, east))
            + abs(west) * np.log(reach(south, west) / reach(north, west))
            + abs(north) * np.log(reach(east, north) / reach(west, north))
            + abs(south) * np.log(reach(west, south) / reach(east, south))
        )

    places = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0))
    right = [2 * np.pi * float(love_rectangle(np.array(x), np.array(y))) for x, y in places]
    ratios = [printed(x, y) / value for (x, y), value in zip(places, right, strict=True)]
    return judge(
        max(abs(ratio - 1) for ratio in ratios) < 1e-6,
        f"printed over right: {numbers(ratios)} on the loaded cell, 2 cells beside it and 2 along, 1 across",
        "the leading factors are signed",
    )


@check("eq_4_29")
def cyclic_index(datasets: Datasets) -> Verdict:
    """The printed sum, with nothing below index 0, against the product of transforms."""
    random = np.random.default_rng(1)
    kernel, signal = random.normal(size=(2, 16))
    cyclic = np.fft.irfft(np.fft.rfft(kernel) * np.fft.rfft(signal), 16)
    printed = np.convolve(kernel, signal)[:16]
    difference = float(np.abs(printed - cyclic).max() / np.abs(cyclic).max())
    return judge(
        difference < 1e-9,
        f"off by {100 * difference:.0f} % of the largest value",
        "16 random numbers; the index is to be taken modulo N",
    )


@check("eq_4_30")
def gap_in_contact(datasets: Datasets) -> Verdict:
    """Gap where pressure acts, over the mean gap, in the maps of figure 4-10."""
    dataset = datasets("ch4-maps")
    maps = maps_of(dataset)
    ratios = []
    for step in range(maps.sizes["load_step"]):
        one = maps.isel(load_step=step)
        inside = one["contact_pressure"].values > 0
        gap = one["gap"].values
        if inside.any() and not inside.all():
            ratios.append(float(np.sqrt(np.mean(gap[inside] ** 2)) / gap[~inside].mean()))
    if not ratios:
        raise NotComputed("no load of study ch4-maps is in partial contact")
    return judge(
        min(ratios) > 1e-3,
        f"gap in contact over mean gap outside: {max(ratios):.0e} at most",
        "the bodies touch where pressure acts: the gap there is 0, to within the solver's tolerance",
    )


def maps_of(dataset: xr.Dataset) -> xr.Dataset:
    """Maps of pressure and gap over the loads, of the first of whatever else was swept.

    Raises
    ------
    NotComputed
        If the dataset keeps none.
    """
    if not {"contact_pressure", "gap"} <= set(dataset.variables):
        raise NotComputed("study ch4-maps keeps no maps of pressure and gap")
    others = [n for n in dataset["contact_pressure"].dims if n not in ("load_step", "x", "y")]
    return dataset.isel(dict.fromkeys(others, 0))


@check("eq_4_34")
def load_balance(datasets: Datasets) -> Verdict:
    """Mean pressure by the right and by the printed sum, over the load."""
    maps = maps_of(datasets("ch4-maps"))
    if "y" not in maps["contact_pressure"].dims:
        raise NotComputed("study ch4-maps keeps central lines only, which do not hold the load")
    heaviest = maps.isel(load_step=int(np.argmax(maps["pressure"].values)))
    pressure, load = heaviest["contact_pressure"].values, float(heaviest["pressure"])
    right = float(pressure.mean() / load)
    printed = float(pressure[0, 0] / load)
    return judge(
        abs(printed - 1) < 1e-6,
        f"sum of p_kl gives {right:.6f} of the load, sum of p_ij at the first point {printed:.3g}",
        "the term must carry the index that is summed over",
    )


@check("eq_4_35")
def gap_update(datasets: Datasets) -> Verdict:
    """Gap after two updates at one pressure, which must be that after one."""
    height, deflection = np.array([0.3, -0.1, 0.2]), np.array([0.05, 0.1, 0.02])
    printed = height.copy()
    for _ in range(2):
        printed = deflection + printed
    difference = float(np.abs(printed - (deflection + height)).max() / deflection.max())
    return judge(
        difference < 1e-9,
        f"two updates at one pressure differ by {difference:.0f} times the deflection",
        "what the deflection is added to is the height of the surface, not the last gap",
    )


@check("eq_4_46")
def load_scaling(datasets: Datasets) -> Verdict:
    """Load after the printed scaling, from pressures that carry twice too much."""
    wanted, pressure = 1.0, np.array([0.5, 1.5])
    scaled = pressure * (pressure.sum() / wanted)
    return judge(
        abs(scaled.sum() / wanted - 1) < 1e-9,
        f"the load becomes {scaled.sum() / wanted:.0f} times the wanted one from {pressure.sum():.0f} times",
        "the factor is wanted over found load",
    )


@check("eq_4_47")
def stopping_rule(datasets: Datasets) -> Verdict:
    """Residual that the rule leaves, and iterations it takes, on the surface of table 4-1 at 64² points."""
    spacing = 4e-4 / 64
    spectrum = SelfAffine(9.58e-7, 0.8, 2 * np.pi / 1e-4, np.pi / spacing, 2 * np.pi / 2e-4)
    surface = Topography(synthesize(spectrum, 4e-4, 64, 1).heights, spacing, periodic=False)
    found = [
        (
            solve_polonsky_keer(surface, 1.0, load * spectrum.rms_slope, 0.0, SOURCE_CHANGE, 2000),
            solve_polonsky_keer(surface, 1.0, load * spectrum.rms_slope, 1e-6, 0.0, 2000),
        )
        for load in (0.05, 0.5)
    ]
    worst = max(by_change.residual for by_change, _ in found)
    return judge(
        worst <= 1e-6,
        f"rms gap in contact {worst:.0e} h_rms where the rule stops",
        "Polonsky-Keer with DC-FFT at p/(E* h'rms) = 0.05 and 0.5: "
        + ", ".join(f"{first.iterations} iterations" for first, _ in found)
        + ", against "
        + " and ".join(str(second.iterations) for _, second in found)
        + " to a residual of 1e-6. The rule bounds a step, no error; ours stops at the residual",
    )
