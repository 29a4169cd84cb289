"""Materials' parameters: moduli, conversions, and what is refused."""

from dataclasses import fields
from typing import Literal, get_args, get_origin, get_type_hints

import numpy as np
import pytest

from softlub.solid.materials.linear_elastic import INCOMPRESSIBLE_BULK_RATIO, LinearElastic
from softlub.solid.materials.mooney_rivlin import MooneyRivlin
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.materials.wlf import WilliamsLandelFerry
from softlub.solid.materials.yeoh import Yeoh
from softlub.units import Unit

L = NeoHookean(0.5932e6, 1e-9)
ALL = [
    L,
    MooneyRivlin(0.4e6, 0.2e6, 1e-9),
    Yeoh(0.6e6, -0.02e6, 3e3, 1e-9),
    LinearElastic(3.5e6, 0.5),
    LinearElastic(3.5e6, 0.4),
]
SERIES = PronySeries((1e-4, 1e-2, 1.0), (5.0, 0.7, 0.1), "long_term")


@pytest.mark.parametrize(
    "parameters", [NeoHookean, MooneyRivlin, Yeoh, LinearElastic, PronySeries, WilliamsLandelFerry]
)
def test_every_number_of_a_material_has_a_unit(parameters):
    """Also the numbers of a tuple: the study reader builds its checks from the annotations."""
    hints = get_type_hints(parameters, include_extras=True)
    for field in fields(parameters):
        inner = get_args(hints[field.name])
        numbers = [hints[field.name], *inner]
        if get_origin(hints[field.name]) is not Literal:
            assert any(
                isinstance(extra, Unit) for hint in numbers for extra in getattr(hint, "__metadata__", ())
            )


def test_moduli_of_the_source_s_material():
    assert L.shear_modulus == pytest.approx(1.1864e6)
    assert L.bulk_modulus == pytest.approx(2e9)
    assert L.young_modulus == pytest.approx(3.5585e6, rel=1e-4)
    assert L.young_modulus == pytest.approx(6 * L.c10, rel=1e-3)
    assert L.long_term_modulus == L.young_modulus


@pytest.mark.parametrize("material", ALL, ids=repr)
def test_moduli_agree_with_each_other(material):
    """E = 2G(1 + ν) = 3K(1 - 2ν), whichever two the material is given by."""
    shear, bulk = material.shear_modulus, material.bulk_modulus
    ratio = material.poisson_ratio
    assert material.young_modulus == pytest.approx(2 * shear * (1 + ratio), rel=1e-12)
    assert material.plane_strain_modulus == pytest.approx(material.young_modulus / (1 - ratio**2), rel=1e-12)
    if ratio < 0.5:
        assert material.young_modulus == pytest.approx(3 * bulk * (1 - 2 * ratio), rel=1e-9)


def test_an_incompressible_linear_material_has_the_stated_bulk_modulus():
    rubber = LinearElastic(3.5e6, 0.5)
    assert rubber.bulk_modulus == pytest.approx(2e9, rel=1e-12)
    assert LinearElastic(7e6, 0.5).bulk_modulus == pytest.approx(4e9, rel=1e-12)
    assert rubber.bulk_modulus == INCOMPRESSIBLE_BULK_RATIO * rubber.shear_modulus


def test_the_equivalent_material_follows_the_printed_equations():
    stiffer = L.scaled(1.5)
    assert (stiffer.c10, stiffer.d1) == (1.5 * L.c10, 1.5 * L.d1)
    assert stiffer.shear_modulus == pytest.approx(1.5 * L.shear_modulus)
    assert stiffer.bulk_modulus == pytest.approx(L.bulk_modulus / 1.5)
    assert L.scaled(1.0) == L


@pytest.mark.parametrize("material", ALL, ids=repr)
@pytest.mark.parametrize("factor", [0.1, 2.5])
def test_a_stiffened_material_keeps_its_bulk_modulus(material, factor):
    stiffer = material.stiffened(factor)
    assert type(stiffer) is type(material)
    assert stiffer.shear_modulus == pytest.approx(factor * material.shear_modulus, rel=1e-10)
    assert stiffer.bulk_modulus == pytest.approx(material.bulk_modulus, rel=1e-9)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: NeoHookean(-1.0, 1e-9), "NeoHookean: c10 = -1 must be above 0 Pa"),
        (lambda: NeoHookean(1e6, 0.0), "d1 = 0 must be above 0 1/Pa"),
        (lambda: L.scaled(-1.0), "c10 = -593200 must be above 0 Pa"),
        (lambda: NeoHookean(float("nan"), 1e-9), "c10 = nan must be above 0 Pa"),
        (lambda: MooneyRivlin(1e6, -1e5, 1e-9), "c01 = -100000 must be at least 0 Pa"),
        (lambda: MooneyRivlin(0.0, 0.0, 1e-9), "c10 and c01 are both 0"),
        (lambda: Yeoh(0.0, 1e5, 1e5, 1e-9), "c10 = 0 must be above 0 Pa"),
        (lambda: Yeoh(1e6, 0.0, -1.0, 1e-9), "c30 = -1 must be at least 0 Pa"),
        (lambda: Yeoh(1e6, -1e5, 0.0, 1e-9), "c20 = -100000 Pa lets the energy fall"),
        (lambda: Yeoh(1e6, -2e5, 1e4, 1e-9), "above -173205 Pa"),
        (lambda: LinearElastic(-1.0, 0.3), "young_modulus = -1 must be above 0 Pa"),
        (lambda: LinearElastic(1e6, 0.51), "poisson_ratio = 0.51 must be above 0 and at most 0.5"),
        (lambda: WilliamsLandelFerry(0.0, 50.0, 300.0), "first_constant = 0 must be above 0"),
    ],
)
def test_impossible_constants_are_refused(make, words):
    with pytest.raises(ValueError, match=words):
        make()


def test_a_linear_material_cannot_get_stiffer_in_shear_than_in_volume():
    with pytest.raises(ValueError, match=r"makes Poisson's ratio -0\.93.*; it must stay above 0"):
        LinearElastic(3.5e6, 0.4).stiffened(300.0)
    assert LinearElastic(3.5e6, 0.5).stiffened(300.0).poisson_ratio == pytest.approx(0.418, abs=1e-3)


def test_a_yeoh_material_may_soften_as_long_as_its_energy_grows():
    material = Yeoh(1e6, -1.7e5, 1e4, 1e-9)
    excess = np.linspace(0, 100, 10_001)
    assert np.all(material.c10 + 2 * material.c20 * excess + 3 * material.c30 * excess**2 > 0)


def test_a_series_is_the_same_material_in_both_normalisations():
    total = sum(SERIES.terms)
    other = SERIES.relative_to("instantaneous")
    assert other.terms == pytest.approx([term / (1 + total) for term in SERIES.terms])
    assert other.normalised == "instantaneous"
    np.testing.assert_allclose(other.long_term_terms, SERIES.long_term_terms, rtol=1e-12)
    assert other.relative_to("long_term").terms == pytest.approx(SERIES.terms)
    assert SERIES.relative_to("long_term") == SERIES
    assert other.term_sum == pytest.approx(total)


@pytest.mark.parametrize(
    ("times", "terms", "normalised", "words"),
    [
        ((), (), "long_term", "0 times and 0 terms"),
        ((1.0, 2.0), (0.1,), "long_term", "2 times and 1 terms"),
        ((1.0, 0.0), (0.1, 0.1), "long_term", r"times\[1\] = 0 must be above 0 s"),
        ((-1.0,), (0.1,), "long_term", r"times\[0\] = -1 must be above 0 s"),
        ((1.0,), (-0.1,), "long_term", r"terms\[0\] = -0.1 must be at least 0"),
        ((1.0,), (float("nan"),), "long_term", r"terms\[0\] = nan must be at least 0"),
        ((float("nan"),), (0.1,), "long_term", r"times\[0\] = nan must be above 0 s"),
        ((float("inf"),), (0.1,), "long_term", r"times\[0\] = inf must be above 0 s"),
        ((1.0, 2.0), (0.5, 0.5), "instantaneous", "add up to 1; .* normalised: long_term"),
        ((1.0,), (0.5,), "initial", "'initial' is unknown; allowed: long_term, instantaneous"),
    ],
)
def test_impossible_series_are_refused(times, terms, normalised, words):
    with pytest.raises(ValueError, match=words):
        PronySeries(times, terms, normalised)


def test_terms_relative_to_the_long_term_modulus_have_no_limit():
    assert PronySeries((1.0,), (500.0,), "long_term").instantaneous_terms[0] == pytest.approx(500 / 501)


def test_constants_of_either_response_describe_the_same_material():
    slow = Viscoelastic(L, SERIES)
    fast = Viscoelastic(L.stiffened(1 + SERIES.term_sum), SERIES, constants="instantaneous")
    assert fast.shear_modulus == pytest.approx(slow.shear_modulus, rel=1e-12)
    assert fast.instantaneous_shear_modulus == pytest.approx(6.8 * L.shear_modulus, rel=1e-12)
    assert (fast.bulk_modulus, slow.long_term_modulus) == (L.bulk_modulus, L.young_modulus)


def test_the_shift_factor_s_sign_and_size():
    """lg a_T = -17.44 · 50/(51.6 + 50): universal constants, 50 K above the glass transition."""
    shift = WilliamsLandelFerry(17.44, 51.6, 200.0)
    assert shift.shift_factor(200.0) == 1
    assert np.log10(shift.shift_factor(250.0)) == pytest.approx(-8.5827, abs=1e-4)
    assert shift.at_temperature(SERIES, 210.0).times[0] < SERIES.times[0]
    assert shift.at_temperature(SERIES, 190.0).times[0] > SERIES.times[0]
    assert shift.at_temperature(SERIES, 190.0).terms == SERIES.terms


@pytest.mark.parametrize("temperature", [148.4, 100.0, float("nan"), float("inf")])
def test_temperatures_without_a_shift_are_refused(temperature):
    with pytest.raises(ValueError, match=r"must be finite and above 148.4 K = T_ref - K2"):
        WilliamsLandelFerry(17.44, 51.6, 200.0).shift_factor(temperature)
