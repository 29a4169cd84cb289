"""Persson's law against nested quadrature of the printed integral in q and p', and against its asymptotes."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import erf, exp1

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.contact.laws.persson import PerssonLaw
from softlub.contact.laws.persson_integral import scaled_curve
from softlub.pressure_table import evaluate
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 10e6 / (1 - 0.4999**2)
TABLE_3_1 = SelfAffine(1e-6, 0.8, 1e4, 0.78e10)
SURFACES = {
    "table 3-1": TABLE_3_1,
    "plateau": SelfAffine(0.68e-6, 0.8, 2e5, 3e7, long_cutoff=9.3e4),
    "hurst 1": SelfAffine(2e-6, 1.0, 1e5, 1e8),
    "hurst 0.3": SelfAffine(1e-6, 0.3, 5e4, 5e6, long_cutoff=5e3),
}


def spectrum(surface, q):
    return surface.level * min(1.0, (q / surface.rolloff) ** (-2 - 2 * surface.hurst))


def sharpness(surface, distance):
    """w = (π ∫_{q_L}^q q'³ C dq')^(-1/2) at q = q_L + distance (equation 4-21), without cancellation near q_L."""
    start, bend, exponent = surface.plateau_start, surface.rolloff, 2 - 2 * surface.hurst
    within = min(distance, bend - start)
    moment = within * (2 * start + within) * ((start + within) ** 2 + start**2) / 4
    if distance > bend - start:
        logarithm = np.log1p((distance - (bend - start)) / bend)
        moment += bend**4 * (logarithm if exponent == 0 else np.expm1(exponent * logarithm) / exponent)
    return 1 / np.sqrt(np.pi * surface.level * moment)


def over_the_spectrum(surface, inner):
    """√π ∫ q² C w inner(w) dq by adaptive quadrature in ln(q - q_L), cut where C has its kink."""

    def integrand(logarithm):
        distance = np.exp(logarithm)
        q = surface.plateau_start + distance
        w = sharpness(surface, distance)
        return distance * q**2 * spectrum(surface, q) * w * inner(w)

    start = surface.plateau_start
    stops = [np.log(start) + shift for shift in (-50, -20, -10, -5, -2, 0, 3, 6, 9, 12)]
    if surface.long_cutoff is not None:
        stops.append(np.log(surface.rolloff - start))
    end = np.log(surface.cutoff - start)
    stops = [*sorted(stop for stop in stops if stop < end), end]
    tolerance = {"epsabs": 1e-17 * surface.rms_roughness, "epsrel": 1e-9, "limit": 200}
    return np.sqrt(np.pi) * sum(quad(integrand, low, high, **tolerance)[0] for low, high in pairwise(stops))


def separation_by_quadrature(surface, gamma, pressure):
    """Equation 4-22 as corrected, u = √π ∫ q² C w ∫_p^∞ [γ + 3(1 - γ) erf²(wp'/E*)] exp(-(wp'/E*)²) dp'/p' dq."""

    def kernel(logarithm):
        y = np.exp(logarithm)
        return (gamma + 3 * (1 - gamma) * erf(y) ** 2) * np.exp(-(y**2))

    def inner(w):
        argument = w * pressure / MODULUS
        if gamma == 1:
            return exp1(argument**2) / 2
        stop = np.log(max(argument, 1) * 7)
        return quad(kernel, np.log(argument), stop, epsabs=1e-16, epsrel=1e-10)[0]

    return over_the_spectrum(surface, inner)


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("gamma", [1.0, 0.45])
def test_table_is_the_integral(name, gamma):
    surface = SURFACES[name]
    table = PerssonLaw(surface, MODULUS, gamma).table
    for ratio in (2e-5, 1e-3, 0.05, 1.0, 6.0) if gamma == 1 else (0.05, 3.0):
        separation = ratio * surface.rms_roughness
        pressure, slope = evaluate(table, separation)
        found = separation_by_quadrature(surface, gamma, float(pressure))
        # du = dp / slope: what the table is off by, as a relative change of its pressure
        assert (found - separation) * slope / pressure == pytest.approx(0.0, abs=2e-7)


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("gamma", [1.0, 0.45])
def test_tail_decays_over_the_length_of_the_theory(name, gamma):
    """u₀ = γ √π ∫ q² C w dq, since w p/E* is small in every mode that counts; p ~ exp(-u/u₀)."""
    surface = SURFACES[name]
    length = gamma * over_the_spectrum(surface, lambda w: 1.0)
    pressure, slope = evaluate(PerssonLaw(surface, MODULUS, gamma).table, 30 * surface.rms_roughness)
    assert -pressure / slope == pytest.approx(length, rel=1e-6)


def test_tail_is_the_source_s_exponential_law():
    """Equation 3-11 (β₁ = 1, 0.375) is the tail rounded: same decay within 7 %, prefactor in the same decade."""
    table = PerssonLaw(TABLE_3_1, MODULUS).table
    pressure, slope = evaluate(table, np.array([5e-6, 10e-6]))
    np.testing.assert_allclose(-pressure / slope, 1e-6, rtol=0.1)
    tail, _ = evaluate(ExponentialLaw(TABLE_3_1, MODULUS).table, np.array([5e-6, 10e-6]))
    assert np.all((pressure / tail > 0.5) & (pressure / tail < 2.5))


def test_exponential_law_cannot_carry_the_hertz_pressure():
    """It reaches 5.0e4 Pa at u = 0, where the dry contact of Table 3-1 has 2.06e5 Pa; Persson's integral goes on."""
    largest, _ = evaluate(ExponentialLaw(TABLE_3_1, MODULUS).table, 0.0)
    assert largest == pytest.approx(0.375 * MODULUS * 1e4 * 1e-6, rel=1e-7)
    assert largest == pytest.approx(5.0e4, rel=2e-3)
    persson, _ = evaluate(PerssonLaw(TABLE_3_1, MODULUS).table, 0.05e-6)
    assert persson > 1.5e5


@pytest.mark.parametrize("gamma", [1.0, 0.45])
def test_work_of_squeezing_is_the_elastic_energy_of_full_contact(gamma):
    """∫ p du from full contact to infinity is E* (π/2) ∫ q² C dq (equation 4-18 at P = 1), for any γ."""
    surface = SURFACES["plateau"]
    curve = scaled_curve(
        surface.hurst, surface.cutoff / surface.rolloff, surface.plateau_start / surface.rolloff, gamma
    )
    # ∫ p du = ∫ p (-du/d ln p) d ln p
    logarithm = np.log(curve.pressure)
    integrand = curve.pressure * curve.rate
    work = abs(np.sum((integrand[1:] + integrand[:-1]) / 2 * np.diff(logarithm)))
    scale = MODULUS * surface.rolloff * surface.rms_roughness**2
    assert work * scale == pytest.approx(MODULUS * np.pi / 2 * surface.moment(2), rel=1e-4)


def test_area_is_linear_at_light_loads_and_full_in_the_end():
    law = PerssonLaw(TABLE_3_1, MODULUS)
    light = np.array([1e-4]) * MODULUS * TABLE_3_1.rms_slope
    kappa = law.area_ratio(light) / 1e-4
    assert kappa == pytest.approx(np.sqrt(8 / np.pi), rel=1e-6)
    assert law.area_ratio(np.array([10 * MODULUS]))[0] == 1.0
    assert law.area_ratio(np.array([0.0]))[0] == 0.0


@pytest.mark.parametrize("name", SURFACES)
def test_law_goes_on_without_a_jump_below_its_range(name):
    law = PerssonLaw(SURFACES[name], MODULUS)
    deepest = law.separation_range[0]
    assert deepest == pytest.approx(1e-5 * SURFACES[name].rms_roughness)
    pressure, slope = evaluate(law.table, deepest * np.array([0.1, 1 - 1e-6, 1 + 1e-6]))
    assert pressure[1] == pytest.approx(pressure[2], rel=1e-5)
    assert slope[1] == pytest.approx(slope[2], rel=1e-3)
    # the hyperbola through pressure and slope at the deepest separation
    exponent = -slope[1] * deepest / pressure[1]
    assert pressure[0] == pytest.approx(pressure[1] * (1 + 9 * exponent), rel=1e-5)


def test_any_load_finds_a_positive_separation():
    """A hundred times the pressure of the deepest separation is met above u = 0, below where the law ends."""
    law = PerssonLaw(TABLE_3_1, MODULUS)
    deepest, _ = evaluate(law.table, law.separation_range[0])
    heaviest, _ = evaluate(law.table, 1e-5 * law.separation_range[0])
    assert heaviest > 100 * deepest


def test_softer_variant_moves_pressure_and_keeps_area_over_separation():
    separation = np.geomspace(1e-8, 1e-5, 50)
    plain = PerssonLaw(TABLE_3_1, MODULUS)
    softer = PerssonLaw(TABLE_3_1, MODULUS, pressure_factor=1 / np.pi)
    pressure, _ = evaluate(plain.table, separation)
    soft_pressure, _ = evaluate(softer.table, separation)
    np.testing.assert_allclose(soft_pressure, pressure / np.pi, rtol=1e-12)
    np.testing.assert_allclose(softer.area_ratio(soft_pressure), plain.area_ratio(pressure), rtol=1e-12)


@pytest.mark.parametrize("gamma", [0.0, -0.1, 1.1, np.nan])
def test_gamma_outside_its_interval_is_refused(gamma):
    with pytest.raises(ValueError, match="gamma"):
        PerssonLaw(TABLE_3_1, MODULUS, gamma)
