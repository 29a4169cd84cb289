"""Checks of chapter 5: constants, strain energies, series and moduli (5.5.1, 5.6.1, 5.6.2)."""

from __future__ import annotations

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from softlub.claims.reading_solid import percent
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge
from softlub.solid.materials.moduli import relaxation_modulus
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.materials.wlf import WilliamsLandelFerry

L_H = NeoHookean(0.5932e6, 0.001e-6)
Y_H = NeoHookean(0.5767e6, 0.001e-6)
"""Table 5-1, read in MPa and 1/MPa."""
LONG_TERM = (3e6, 4e6)
"""Modulus of both materials below 1e3 1/s that 5.6.2 states [Pa]."""
FLAT = 0.05
"""Change of the storage modulus up to which it counts as constant."""
BUILT_IN = "the source prints no Prony terms; our synthetic series was made to have this"


def _constants(material: NeoHookean) -> Verdict:
    modulus = material.young_modulus
    return judge(
        LONG_TERM[0] <= modulus <= LONG_TERM[1],
        f"E0 = 9KG/(3K + G) = {modulus / 1e6:.4f} MPa",
        "the source prints no units; in MPa and 1/MPa E0 lies in the 3 to 4 MPa that 5.6.2 states",
    )


@check("table_5_1_row_1")
def constants_of_l(datasets: Datasets) -> Verdict:
    """E0 of L_H."""
    return _constants(L_H)


@check("table_5_1_row_2")
def constants_of_y(datasets: Datasets) -> Verdict:
    """E0 of Y_H."""
    return _constants(Y_H)


def _stretched(stretch: float, deviatoric: bool) -> float:
    """Equation 5-5 of L_H stretched alike in all directions [J/m³]."""
    volume = stretch**3
    invariant = 3 * stretch**2 * (volume ** (-2 / 3) if deviatoric else 1.0)
    return L_H.c10 * (invariant - 3) + (volume - 1) ** 2 / L_H.d1


@check("eq_5_4")
def polynomial_energy(datasets: Datasets) -> Verdict:
    """Stress that the energy leaves in the undeformed body, dW/dJ, with plain and with deviatoric invariants."""
    step = 1e-6
    plain, deviatoric = (
        (_stretched(1 + step, kind) - _stretched(1 - step, kind)) / (6 * step) for kind in (False, True)
    )
    return judge(
        abs(plain) < 1e-6 * L_H.shear_modulus,
        f"with the plain invariants as printed the undeformed body carries {plain / 1e6:.3g} MPa, with deviatoric ones "
        f"{abs(deviatoric) / 1e6:.0g}",
        "constants of L_H; moreover the sum's index must be i + j = 1, not i + j - 1",
    )


@check("eq_5_6")
def initial_moduli(datasets: Datasets) -> Verdict:
    """Slopes of our element's stress at the undeformed state over 2 C10, and E0 over the formula of both moduli."""
    small = 1e-6
    shear = _stress(L_H, (1.0, 1.0, 1.0), shear=small)[0, 1] / small / (2 * L_H.c10)
    bulk = np.trace(_stress(L_H, (1 + small,) * 3)) / 3 / (3 * small) / (2 / L_H.d1)
    across = brentq(
        lambda lateral: _stress(L_H, (1 + small, lateral, lateral))[1, 1], 1 - small, 1.0, xtol=1e-16
    )
    tension = _stress(L_H, (1 + small, across, across))[0, 0] / small / L_H.young_modulus
    return judge(
        max(abs(ratio - 1) for ratio in (shear, bulk, tension)) < 1e-4,
        f"shear {shear:.5f} times 2 C10, volume {bulk:.5f} times 2/D1, tension {tension:.5f} times 9 K0 G0/(3 K0 + G0)",
        "stress of our element at strains of 1e-6",
    )


def _stress(material: NeoHookean, stretches: tuple[float, float, float], shear: float = 0.0) -> np.ndarray:
    """First Piola–Kirchhoff stress as the elements have it, isochoric part and volume [Pa], shape (3, 3)."""
    gradient = np.diag(stretches)
    gradient[0, 1] = shear
    isochoric = material.element_material().gradient([gradient[:, :, None, None], np.zeros((0, 1, 1))])[0]
    volume = float(np.linalg.det(gradient))
    pressure = material.bulk_modulus * (volume - 1)
    return np.asarray(isochoric[:, :, 0, 0] + pressure * volume * np.linalg.inv(gradient).T)


@check("eq_5_10")
def instantaneous_series(datasets: Datasets) -> Verdict:
    """The printed series against our relaxation modulus of the same material."""
    times, terms = (1e-6, 1e-3), (3.0, 1.0)
    material = Viscoelastic(L_H, PronySeries(times, terms, "long_term"))
    glassy = material.shear_modulus * (1 + sum(terms))
    at = np.array([0.0, 1e-7, 1e-6, 1e-4, 1e-2])
    shares = np.array(terms) / (1 + sum(terms))
    printed = glassy * (1 - (1 - np.exp(-np.divide.outer(at, np.array(times)))) @ shares)
    off = float(np.abs(printed / relaxation_modulus(material, at) - 1).max())
    return judge(
        off < 1e-12,
        f"{off:.0e} from the series relative to the long-term modulus with g = r/(1 + sum r)",
        "two terms, five times",
    )


@check("eq_5_11")
def bulk_series(datasets: Datasets) -> Verdict:
    """Nothing of it is printed."""
    return Verdict(
        "", "not decidable", "the source prints no bulk terms; ours are 0, the bulk modulus is elastic"
    )


@check("eq_5_maxwell")
def maxwell_and_kelvin(datasets: Datasets) -> Verdict:
    """What each model does with a step of stress and of strain, after ten times its time."""
    late = 10.0
    # Over spring and dashpot of one modulus E and time η/E, in units of both.
    creep = {"Maxwell": 1 + late, "Kelvin-Voigt": 1 - np.exp(-late)}
    relaxation = {"Maxwell": np.exp(-late), "Kelvin-Voigt": 1.0}
    bounded, relaxes = creep["Maxwell"] < 2, relaxation["Kelvin-Voigt"] < 0.5
    return judge(
        bool(bounded and relaxes),
        f"under constant stress Maxwell's strain reaches {creep['Maxwell']:.0f} times that of its spring and goes on, "
        f"Kelvin-Voigt's {creep['Kelvin-Voigt']:.2f}; at constant strain Kelvin-Voigt's stress stays, Maxwell's falls "
        f"to {relaxation['Maxwell']:.0e}",
        "after ten relaxation times: Maxwell describes relaxation and Kelvin-Voigt creep",
    )


def _moduli(datasets: Datasets, material: str) -> xr.Dataset:
    dataset = datasets("ch5-moduli")
    labels = [str(label) for label in dataset["material"].values] if "material" in dataset.dims else []
    if material not in labels:
        raise NotComputed(f"study ch5-moduli holds no material {material}")
    one = dataset.isel(material=labels.index(material))
    return one.isel(temperature=0) if "temperature" in one.dims else one


def _at(one: xr.Dataset, name: str, frequency: float) -> float:
    known = one["frequency"].values
    if not known.min() <= frequency <= known.max():
        raise NotComputed(f"study ch5-moduli does not reach {frequency:g} rad/s")
    return float(np.interp(np.log(frequency), np.log(known), one[name].values))


@check("eq_5_E0")
def two_meanings(datasets: Datasets) -> Verdict:
    """The glassy modulus over the initial one of a slow test."""
    one = _moduli(datasets, "L")
    if "instantaneous_modulus" in one:
        glassy = float(one["instantaneous_modulus"])
    else:
        glassy = float(one["storage_modulus"].max())
    slow = float(one["long_term_modulus"])
    return judge(
        abs(glassy / slow - 1) < 0.01,
        f"{glassy / 1e6:.4g} MPa in 5.6.1 and {slow / 1e6:.3g} MPa in 5.5: {glassy / slow:.0f} times apart",
        "one symbol names the glassy modulus and the initial tangent of a slow test; the constants of table 5-1 are "
        "taken as long-term ones; stand-in for L",
    )


@check("claim_5_14")
def rubber_to_glass(datasets: Datasets) -> Verdict:
    """Both ends and the peak between, of every material."""
    dataset = datasets("ch5-moduli")
    found, holds = [], []
    for name in map(str, dataset["material"].values if "material" in dataset.dims else ()):
        one = _moduli(datasets, name)
        storage, factor = one["storage_modulus"].values, one["loss_factor"].values
        peak = int(np.argmax(factor))
        holds.append(
            abs(storage[0] / float(one["long_term_modulus"]) - 1) < FLAT
            and storage[-1] > 10 * storage[0]
            and factor[0] < 0.1 * factor[peak]
            and 0 < peak < factor.size - 1
            and factor[-1] < 0.1 * factor[peak]
        )
        found.append(
            f"{name}: E' rises {storage[-1] / storage[0]:.0f} times, tan phi {factor[peak]:.2g} at most"
        )
    if not holds:
        raise NotComputed("study ch5-moduli compares no materials")
    return judge(
        all(holds),
        "; ".join(found),
        f"flat within {percent(FLAT)} at the lowest frequency, ten times stiffer at the highest, and a peak of tan phi "
        "of ten times its ends between; any Prony series has both ends",
    )


@check("claim_5_15")
def warming(datasets: Datasets) -> Verdict:
    """The printed shift factor ten degrees above and below the reference."""
    law = WilliamsLandelFerry(17.44, 51.6, 293.15)
    warm, cold = (law.shift_factor(293.15 + change) for change in (10.0, -10.0))
    return judge(
        warm < 1 < cold,
        f"times are multiplied by {warm:.2g} ten degrees above the reference, by {cold:.2g} below",
        "the direction follows for any positive K1 and K2; the source prints neither; here the usual 17.44 and 51.6 K",
    )


@check("claim_5_16")
def ten_decades(datasets: Datasets) -> Verdict:
    """Decades between the ends of the transition."""
    found = []
    for name in ("L", "Y"):
        one = _moduli(datasets, name)
        frequency, storage = one["frequency"].values, one["storage_modulus"].values
        between = (storage > (1 + FLAT) * storage[0]) & (storage < (1 - FLAT) * storage[-1])
        found.append(f"{name} {np.log10(frequency[between][-1] / frequency[between][0]):.1f}")
    return Verdict(
        f"{', '.join(found)} decades more than {percent(FLAT)} from both ends", "not decidable", BUILT_IN
    )


@check("claim_5_17")
def stiffening(datasets: Datasets) -> Verdict:
    """Stiffness at 1e7 and loss factor at 1e4 rad/s."""
    found = []
    for name in ("L", "Y"):
        one = _moduli(datasets, name)
        ratio = _at(one, "storage_modulus", 1e7) / float(one["long_term_modulus"])
        found.append(
            f"{name}: E' {ratio:.1f} times its long-term value at 1e7 rad/s, tan phi "
            f"{_at(one, 'loss_factor', 1e4):.2g} at 1e4 rad/s"
        )
    return Verdict("; ".join(found), "not decidable", BUILT_IN)


@check("claim_5_18")
def long_term(datasets: Datasets) -> Verdict:
    """Storage modulus at 1e3 rad/s."""
    found = [
        f"{name} {_at(_moduli(datasets, name), 'storage_modulus', 1e3) / 1e6:.2f} MPa" for name in ("L", "Y")
    ]
    return Verdict(
        f"{', '.join(found)} at 1e3 rad/s",
        "not decidable",
        f"{BUILT_IN}: its long-term modulus is that of table 5-1, about 6 C10",
    )


FOLLOWS = 0.05
"""By how much entries may differ from proportion to the storage modulus."""


@check("claim_5_19")
def condensed_at_a_frequency(datasets: Datasets) -> Verdict:
    """Vertical entries of the condensed matrix beside the storage modulus, over their values at rest."""
    one = _moduli(datasets, "L")
    if "stiffness_diagonal" not in one:
        raise NotComputed("study ch5-moduli condenses no stiffness")
    entries = one["stiffness_diagonal"].sel(component="y").max("node").values
    storage, asked = one["stiffness_storage_modulus"].values, one["stiffness_frequency"].values
    if asked[0] != 0 or asked.size < 2:
        raise NotComputed("study ch5-moduli compares no frequency with rest")
    stiffer, expected = entries / entries[0], storage / storage[0]
    each = ", ".join(
        f"{value:.2f} where E' is {by:.2f} ({frequency:g} rad/s)"
        for value, by, frequency in zip(stiffer[1:], expected[1:], asked[1:], strict=True)
    )
    return judge(
        bool(np.all(np.abs(stiffer / expected - 1) <= FOLLOWS)),
        f"vertical entries over those at rest: {each}",
        f"the storage modulus alone enters; reproduced if the entries follow it within {percent(FOLLOWS)}. They fall "
        "behind where it nears the bulk modulus, which stays elastic",
    )
