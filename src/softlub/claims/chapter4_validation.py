"""Checks of what the solver of 4.5 finds and costs: deflections, maps, and a second solver."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import xarray as xr

from softlub.claims.chapter4_solver import maps_of
from softlub.claims.reading_contact import numbers
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge
from softlub.datasets.contact_curves import contact_curve, contacts

AGREEMENT = 0.02
"""Largest difference of the separation, in parts of h_rms, and of the area, in parts of A0, that counts as none."""


@check("claim_4_08")
def transforms_are_faster(datasets: Datasets) -> Verdict:
    """CPU times of both ways."""
    direct, transform = (_method(datasets, name) for name in ("direct", "dc_fft"))
    slow, fast = float(direct["seconds"]), float(transform["seconds"])
    return judge(
        slow >= 5 * fast,
        f"{fast:.2g} s against {slow:.2g} s: {slow / fast:.0f} times",
        f"one deflection on {direct['deflection'].size} points along the line; ten times means "
        f"five at least, since the ratio grows with the grid. The source's own times, 0.06 and 7.1 s, are "
        f"{7.1 / 0.06:.0f} times apart, not 10",
    )


def _method(datasets: Datasets, name: str) -> xr.Dataset:
    dataset = datasets("ch4-dcfft")
    labels = [str(label) for label in dataset["method"].values] if "method" in dataset.dims else []
    if name not in labels:
        raise NotComputed(f"study ch4-dcfft holds no method {name}")
    return dataset.isel(method=labels.index(name))


def _deflections(datasets: Datasets) -> tuple[float, float]:
    """Largest difference of both deflections, and of DC-FFT and Hertz's closed form, over the largest deflection."""
    direct, transform = (_method(datasets, name)["deflection"].values for name in ("direct", "dc_fft"))
    exact = datasets("ch4-dcfft")["deflection_hertz"].values
    scale = np.abs(exact).max()
    return float(np.abs(direct - transform).max() / scale), float(np.abs(transform - exact).max() / scale)


@check("claim_4_09")
def same_deflection(datasets: Datasets) -> Verdict:
    """Both deflections against each other and the closed form."""
    difference, error = _deflections(datasets)
    return judge(
        difference < 1e-9,
        f"largest difference {difference:.0e} of the largest deflection",
        f"both are {error:.1e} of it off Hertz's closed form",
    )


@check("claim_4_11")
def padding(datasets: Datasets) -> Verdict:
    """DC-FFT against the closed form of a body without end."""
    difference, error = _deflections(datasets)
    return judge(
        max(difference, error) < 0.01,
        f"padded transforms are {error:.1e} of the largest deflection off that of a body without end",
        f"and {difference:.0e} off the direct sum, which knows no period",
    )


@check("claim_4_10")
def iterations(datasets: Datasets) -> Verdict:
    """Iterations of the source's algorithm to its own rule, and of ours to its tolerance."""
    dataset = datasets("ch4-benchmarks")
    keer, ours = (_contact(dataset, name) for name in ("polonsky_keer", "conjugate_gradients"))
    steps = np.asarray(keer["iterations"].values, dtype=float)
    return judge(
        bool(np.nanmax(steps) <= 200),
        f"{numbers([float(step) for step in steps.ravel()], 4)} iterations",
        f"Polonsky-Keer to the rule 4-47 on {int(keer['points'])}² points at p/(E* h'rms) = "
        f"{numbers([float(load) for load in _loads(keer)])}; ours takes {int(np.nanmax(ours['iterations'].values))} at "
        "most to a residual of 1e-6",
    )


def _loads(contact: xr.Dataset) -> np.ndarray:
    return np.ravel(contact["reduced_pressure"].values / float(contact["rms_slope_spectral"]))


def _contact(dataset: xr.Dataset, solver: str, boundary: str = "") -> xr.Dataset:
    """The contact that a solver made, of the boundary where two are compared.

    Raises
    ------
    NotComputed
        If there is none.
    """
    for labels, contact in contacts(dataset):
        if labels.get("solver", solver).startswith(solver) and labels.get("boundary", boundary) == boundary:
            return contact
    raise NotComputed(f"the dataset holds no {boundary} contact by {solver}".replace("  ", " "))


def _differences(first: xr.Dataset, second: xr.Dataset) -> tuple[float, float, float]:
    """Largest difference of u/h_rms and of A/A0 over the loads, and of u/h_rms at the heaviest one."""
    one, other = contact_curve(first), contact_curve(second)
    if not np.allclose(one.reduced_pressure, other.reduced_pressure):
        raise NotComputed("the contacts were not solved at the same loads")
    gap = np.abs(one.relative_separation() - other.relative_separation())
    area = np.abs(one.mean["contact_area_ratio_pixel"] - other.mean["contact_area_ratio_pixel"])
    if not np.isfinite(gap).any():
        raise NotComputed("no load converged with both")
    return float(np.nanmax(gap)), float(np.nanmax(area)), float(gap[np.isfinite(gap)][-1])


@check("claim_4_12")
def periodicity(datasets: Datasets) -> Verdict:
    """Periodic against finite contact of one surface."""
    dataset = datasets("ch4-patch")
    periodic, finite = (_contact(dataset, "conjugate_gradients", name) for name in ("periodic", "free"))
    gap, area, _ = _differences(periodic, finite)
    return judge(
        max(gap, area) <= AGREEMENT,
        f"mean separations differ by up to {gap:.2g} h_rms, areas by up to {area:.2g} A0",
        f"negligible means up to {AGREEMENT:g} of either; a finite patch bulges out at its edges, so it needs a higher "
        "load to close",
    )


@check("claim_4_13")
def closing(datasets: Datasets) -> Verdict:
    """Mean gap and area over the loads of figure 4-10."""
    maps = maps_of(datasets("ch4-maps"))
    order = np.argsort(maps["pressure"].values)
    axes = tuple(n for n in maps["gap"].dims if n != "load_step")
    gaps = [float(value) for value in maps["gap"].mean(axes).values[order]]
    areas = [float(value) for value in (maps["contact_pressure"] > 0).mean(axes).values[order]]
    return judge(
        all(a > b or a < 1e-12 for a, b in pairwise(gaps)) and all(a <= b for a, b in pairwise(areas)),
        f"mean gap {', '.join(f'{gap * 1e9:.0f}' for gap in gaps)} nm, contact {numbers(areas, 2)} of the points",
        "at 0.03, 0.23, 0.6 and 1.6 MPa; full contact stays full",
    )


@check("claim_4_14")
def other_solver(datasets: Datasets) -> Verdict:
    """Our solver against our Polonsky–Keer, since the source prints nothing of the other solver."""
    dataset = datasets("ch4-validation")
    ours, keer = (_contact(dataset, name, "free") for name in ("conjugate_gradients", "polonsky_keer"))
    gap, area, heavy = _differences(ours, keer)
    return Verdict(
        f"our two solvers differ by up to {gap:.0e} h_rms and {area:.0e} A0, by {heavy:.0e} h_rms at the heaviest load",
        "not decidable",
        "the source prints no data of the other solver; our own Polonsky-Keer with DC-FFT stands in for it",
    )


@check("claim_4_15")
def thresholds(datasets: Datasets) -> Verdict:
    """Area by pressure and by two thresholds of the gap."""
    contact = _contact(datasets("ch4-validation"), "conjugate_gradients", "free")
    if "contact_area_ratio_gap" not in contact:
        raise NotComputed("study ch4-validation counted no area by the gap")
    counted = contact["contact_area_ratio_gap"]
    true = contact["contact_area_ratio_pixel"]
    partial = (true.values > 0) & (true.values < 0.99)
    deviations = {}
    for i in range(contact.sizes["threshold"]):
        ratio = (counted.isel(threshold=i).transpose(*true.dims) / true).values[partial]
        deviations[float(contact["threshold"].values[i])] = (float(ratio.min()), float(ratio.max()))
    spread = max(high for _, high in deviations.values()) / min(low for low, _ in deviations.values()) - 1
    return judge(
        spread <= 0.05,
        "; ".join(
            f"gap < {t:g} m counts {low:.2f} to {high:.2f} of the area"
            for t, (low, high) in deviations.items()
        ),
        "over the points that carry pressure, in partial contact; small means within 5 %. Contact is where pressure "
        "acts: the gap there is the solver's tolerance, and no threshold below that counts anything but rounding",
    )
