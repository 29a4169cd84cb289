"""Checks of chapter 4: surfaces, their spectra and how they are made (4.2, 4.3)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge, state
from softlub.datasets.contact_curves import inputs
from softlub.surfaces.line_spectrum import line_factor
from softlub.surfaces.spectrum import SelfAffine

SURFACE = SelfAffine(
    rms_roughness=9.58e-7,
    hurst=0.8,
    rolloff=2 * np.pi / 1e-4,
    cutoff=2 * np.pi / 7.81e-7,
    long_cutoff=2 * np.pi / 2e-4,
)
"""The surface of table 4-1."""

state(
    "not decidable",
    {
        "fig_4_1": "the source prints neither the profile's data nor its cut-off; ours is a synthetic line",
        "fig_4_3": "a sketch without numbers; ours is drawn from equation 4-5",
        "fig_4_4": "the source prints no topography; ours is a synthetic surface, its spectra are judged in eq_4_6",
    },
)
state(
    "not computed",
    dict.fromkeys(("fig_4_6", "fig_4_7"), "a schematic by others: there is nothing to compute"),
)


@check("eq_4_4_unit")
def spectrum_unit(datasets: Datasets) -> Verdict:
    """Power of the length by which C(q) grows when the whole surface is scaled."""
    scaled = SelfAffine(
        2 * SURFACE.rms_roughness,
        SURFACE.hurst,
        SURFACE.rolloff / 2,
        SURFACE.cutoff / 2,
        SURFACE.plateau_start / 2,
    )
    power = float(np.log2(scaled.density(scaled.rolloff) / SURFACE.density(SURFACE.rolloff)))
    return judge(
        abs(power + 4) < 1e-6,
        f"m^{power:.0f}",
        "how C(q) grows when height and wavelengths are doubled together",
    )


@check("eq_4_5")
def prefactor(datasets: Datasets) -> Verdict:
    """h_rms of the printed spectrum with the plateau of table 4-1."""
    hurst, q_r = SURFACE.hurst, SURFACE.rolloff
    level = hurst / np.pi * SURFACE.rms_roughness**2 / q_r**2
    branch = (1 - (SURFACE.cutoff / q_r) ** (-2 * hurst)) / (2 * hurst)
    plateau = (1 - (SURFACE.plateau_start / q_r) ** 2) / 2
    ratio = float(np.sqrt(2 * np.pi * level * q_r**2 * (branch + plateau)) / SURFACE.rms_roughness)
    return judge(
        abs(ratio - 1) < 0.02,
        f"the printed spectrum has {ratio:.3f} times the h_rms it is given",
        "plateau of table 4-1, lambda_L = 2 lambda_r; without a plateau the prefactor holds; ours is normalised to the "
        "whole h_rms",
    )


@check("eq_4_6")
def spectrum_of_lines(datasets: Datasets) -> Verdict:
    """Factor between C1D+ and q C at H = 0.8, and where it is π."""
    factor = line_factor(SURFACE.hurst)
    return judge(
        abs(factor / np.pi - 1) < 0.01,
        f"{factor:.4g} at H = {SURFACE.hurst:g}",
        f"2 sqrt(pi) Gamma(H + 1/2)/Gamma(H + 1), which is {line_factor(1.0):.4g} at H = 1 only",
    )


@check("eq_4_7")
def phases(datasets: Datasets) -> Verdict:
    """rms of the real part of a sum with independent phases, over that of the asked spectrum."""
    points = 2**15
    random = np.random.default_rng(1)
    half = points // 2 - 1
    waves = np.zeros(points, dtype=complex)
    phase = random.uniform(0, 2 * np.pi, points)
    waves[1 : half + 1], waves[-half:] = np.exp(1j * phase[:half]), np.exp(1j * phase[half : 2 * half])
    independent = float(np.std(np.fft.ifft(waves, norm="forward").real) / np.sqrt(2 * half))
    return judge(
        abs(independent - 1) < 0.05,
        f"the real part has {independent:.3f} times the h_rms asked for",
        f"{2 * half} waves with phases drawn for q and -q alike; phi(-q) = -phi(q) gives 1",
    )


@check("eq_4_zeta")
def magnification(datasets: Datasets) -> Verdict:
    """The printed magnification where the shortest waves are resolved."""
    printed = SURFACE.rolloff / SURFACE.cutoff
    return judge(
        printed > 1,
        f"{printed:.2g} at the shortest wave of table 4-1",
        "magnification must grow as shorter waves are resolved: lambda_r over lambda",
    )


@check("claim_4_01")
def gaussian_rubber(datasets: Datasets) -> Verdict:
    """Skewness and kurtosis of the stand-in."""
    dataset = datasets("ch4-topography")
    if not {"skewness", "kurtosis"} <= set(dataset.variables):
        raise NotComputed("study ch4-topography holds no skewness and kurtosis")
    return Verdict(
        f"skewness {_mean(dataset, 'skewness'):.2f}, kurtosis {_mean(dataset, 'kurtosis'):.2f}",
        "not decidable",
        "the source prints no topography; these are our synthetic stand-in's (Gauss: 0 and 3)",
    )


def _mean(dataset: xr.Dataset, name: str) -> float:
    return float(np.nanmean(dataset[name].values))


SPLIT = 2.0
"""Waves of up to this many roll-off wavevectors count as long."""


def _spectrum(datasets: Datasets, wavevectors: str) -> tuple[np.ndarray, np.ndarray, SelfAffine]:
    """Wavevectors, density and the asked spectrum of one way to space wavevectors."""
    dataset = datasets("ch4-synthesis")
    for dimension in dataset["power_spectrum"].dims:
        labels = [str(label) for label in dataset[dimension].values] if dimension in dataset.coords else []
        if wavevectors in labels:
            one = dataset.isel({dimension: labels.index(wavevectors)})
            break
    else:
        raise NotComputed(f"study ch4-synthesis holds no surface of {wavevectors} wavevectors")
    if "realisation" in one.dims:
        one = one.isel(realisation=0)
    q, density = (np.asarray(one[name].values, dtype=float) for name in ("wavevector", "power_spectrum"))
    known = inputs(one)
    plateau = known["long_cutoff"] < known["rolloff"] * (1 - 1e-9)
    asked = SelfAffine(
        known["rms_roughness"],
        known["hurst"],
        known["rolloff"],
        known["cutoff"],
        known["long_cutoff"] if plateau else None,
    )
    kept = np.isfinite(q) & np.isfinite(density)
    return q[kept], density[kept], asked


def _shares(q: np.ndarray, density: np.ndarray, asked: SelfAffine) -> tuple[float, float]:
    """Variance of the long and of the short waves over that of the asked spectrum at the same wavevectors."""
    weight = q * np.gradient(q)
    long = q <= SPLIT * asked.rolloff
    wanted = asked.density(q)
    # Rings at a cut-off hold part of their waves only.
    inside = wanted > 0
    return tuple(  # type: ignore[return-value]
        float(np.sum((weight * density)[part & inside]) / np.sum((weight * wanted)[part & inside]))
        for part in (long, ~long)
    )


@check("claim_4_02")
def exponential_wavevectors(datasets: Datasets) -> Verdict:
    """Variance of long and short waves of exponential wavevectors over that asked for."""
    long, short = _shares(*_spectrum(datasets, "exponential"))
    return judge(
        long > 1.05 and short < 0.95,
        f"long waves have {long:.2f} times, short ones {short:.2f} times the variance asked for",
        f"long: up to {SPLIT:g} q_r; both surfaces have the h_rms asked for",
    )


@check("claim_4_03")
def linear_wavevectors(datasets: Datasets) -> Verdict:
    """The same for linear wavevectors."""
    long, short = _shares(*_spectrum(datasets, "linear"))
    return judge(
        max(abs(long - 1), abs(short - 1)) < 0.05,
        f"long waves have {long:.3f} times, short ones {short:.3f} times the variance asked for",
        f"long: up to {SPLIT:g} q_r; reproduced if both are within 5 %",
    )


@check("claim_8_03")
def better_spacing(datasets: Datasets) -> Verdict:
    """Whether exponential wavevectors come closer to the asked spectrum than linear ones."""
    errors = {
        name: max(abs(share - 1) for share in _shares(*_spectrum(datasets, name)))
        for name in ("linear", "exponential")
    }
    return judge(
        errors["exponential"] < errors["linear"],
        ", ".join(f"{name} wavevectors are off by {100 * error:.2g} %" for name, error in errors.items()),
        "larger error of the variances of long and short waves; 4.3 itself finds that linear ones are right",
    )
