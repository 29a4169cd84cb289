"""The tabulated law: Persson's own curves come back from a sweep of them, monotone, with physical tails."""

from __future__ import annotations

import numpy as np
import pytest

from softlub.contact.laws.monotone import monotone_spline
from softlub.contact.laws.persson import PerssonLaw
from softlub.contact.laws.persson_curve import separation_at, spectrum_curve, waves_curve
from softlub.contact.laws.tabulated import TabulatedLaw, averaged
from softlub.contact.real_area import persson_area_ratio
from softlub.pressure_table import evaluate
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1e7
SPECTRA = {
    "table 3-1": SelfAffine(1e-6, 0.8, 1e4, 7.8e9),
    "plateau": SelfAffine(0.68e-6, 0.8, 2e5, 3e7, 9.3e4),
    "hurst 0.3": SelfAffine(1e-6, 0.3, 5e4, 5e6),
}
LOADS = np.geomspace(1e-3, 1, 20)


def persson_sweep(spectrum, loads=LOADS):
    """What a sweep would find if Persson's theory were exact."""
    return separation_at(spectrum_curve(spectrum), loads), persson_area_ratio(loads, 1.0, 1.0)


def law_of(spectrum, modulus=MODULUS, **options):
    separation, area = persson_sweep(spectrum)
    curve = averaged(LOADS, separation[None], area[None])
    return TabulatedLaw(
        curve, spectrum_curve(spectrum), spectrum.rms_roughness, spectrum.rms_slope, modulus, **options
    )


@pytest.fixture(params=SPECTRA.values(), ids=SPECTRA)
def spectrum(request):
    return request.param


def test_persson_comes_back_from_a_sweep_of_persson(spectrum):
    law, theory = law_of(spectrum), PerssonLaw(spectrum, MODULUS)
    low, high = law.separation_range
    separation = np.geomspace(low, high, 400)
    pressure, slope = evaluate(law.table, separation)
    expected, expected_slope = evaluate(theory.table, separation)
    np.testing.assert_allclose(pressure, expected, rtol=2e-4)
    np.testing.assert_allclose(slope, expected_slope, rtol=5e-3)


def test_where_the_gap_closes_perssons_curve_goes_on(spectrum):
    law, theory = law_of(spectrum), PerssonLaw(spectrum, MODULUS)
    separation = np.geomspace(1.05e-5 * spectrum.rms_roughness, law.separation_range[0], 100)
    expected = evaluate(theory.table, separation)[0]
    np.testing.assert_allclose(evaluate(law.table, separation)[0], expected, rtol=1e-3)


def test_a_sweep_off_persson_is_joined_without_a_step(spectrum):
    separation, area = persson_sweep(spectrum)
    curve = averaged(LOADS, 0.8 * separation[None], area[None])
    law = TabulatedLaw(curve, spectrum_curve(spectrum), spectrum.rms_roughness, spectrum.rms_slope, MODULUS)
    at = law.separation_range[0]
    below, above = evaluate(law.table, np.array([at * (1 - 1e-6), at * (1 + 1e-6)]))[0]
    assert below == pytest.approx(above, rel=1e-4)


def test_pressure_falls_and_area_rises_everywhere(spectrum):
    law = law_of(spectrum)
    separation = np.geomspace(1e-9, 30, 5000) * spectrum.rms_roughness
    pressure, slope = evaluate(law.table, separation)
    assert np.all(pressure > 0)
    assert np.all(np.diff(pressure) < 0)
    assert np.all(slope < 0)
    loads = np.geomspace(1e-12, 3, 500) * MODULUS * spectrum.rms_slope
    area = law.area_ratio(loads)
    assert np.all(np.diff(area) > 0)
    assert np.all(area <= 1)


def test_the_tail_is_exponential_in_the_separation(spectrum):
    law = law_of(spectrum)
    end = law.separation_range[1]
    separation = end + np.linspace(0.5, 8, 40) * spectrum.rms_roughness
    rate = evaluate(law.table, separation)[1] / evaluate(law.table, separation)[0]
    np.testing.assert_allclose(rate, rate[0], rtol=1e-3)
    assert -rate[0] * spectrum.rms_roughness == pytest.approx(1.0, rel=0.25)


def test_area_is_perssons_in_proportion_to_light_loads_and_full_under_heavy_ones(spectrum):
    law = law_of(spectrum)
    loads = np.geomspace(1e-9, 10, 300) * MODULUS * spectrum.rms_slope
    np.testing.assert_allclose(
        law.area_ratio(loads), persson_area_ratio(loads, MODULUS, spectrum.rms_slope), rtol=1e-9
    )
    light = loads[:50]
    np.testing.assert_allclose(
        law.area_ratio(light) / light, law.area_ratio(light[:1])[0] / light[0], rtol=1e-6
    )
    assert law.area_ratio(np.array([0.0, 1e12])).tolist() == [0.0, 1.0]


def test_modulus_and_pressure_factor_scale_the_pressure_and_leave_the_area(spectrum):
    law, softer = law_of(spectrum), law_of(spectrum, pressure_factor=0.25)
    stiff = law_of(spectrum, modulus=4 * MODULUS)
    separation = np.geomspace(1e-3, 5, 50) * spectrum.rms_roughness
    pressure = evaluate(law.table, separation)[0]
    np.testing.assert_allclose(evaluate(softer.table, separation)[0], pressure / 4, rtol=1e-12)
    np.testing.assert_allclose(evaluate(stiff.table, separation)[0], pressure * 4, rtol=1e-12)
    np.testing.assert_allclose(softer.area_ratio(pressure / 4), law.area_ratio(pressure), rtol=1e-12)


def test_realisations_are_averaged_and_their_spread_is_kept():
    separation, area = persson_sweep(SPECTRA["plateau"])
    several = np.array([0.9, 1.0, 1.1])[:, None]
    curve = averaged(LOADS[::-1], (several * separation)[:, ::-1], np.repeat(area[None], 3, axis=0)[:, ::-1])
    np.testing.assert_allclose(curve.pressure, LOADS)
    np.testing.assert_allclose(curve.separation, separation)
    np.testing.assert_allclose(curve.separation_spread, separation * np.std([0.9, 1, 1.1]))
    np.testing.assert_allclose(curve.area_spread, 0, atol=1e-15)


def test_a_load_that_failed_once_is_left_out():
    separation, area = persson_sweep(SPECTRA["plateau"])
    two = np.repeat(separation[None], 2, axis=0)
    two[1, 7] = np.nan
    assert averaged(LOADS, two, np.repeat(area[None], 2, axis=0)).pressure.size == LOADS.size - 1
    two[1, 3:] = np.nan
    with pytest.raises(ValueError, match="only 3 loads have converged"):
        averaged(LOADS, two, np.repeat(area[None], 2, axis=0))


def test_a_sweep_that_is_not_monotone_is_refused():
    separation, area = persson_sweep(SPECTRA["plateau"])
    separation[5] *= 1.5
    with pytest.raises(ValueError, match="not monotone"):
        averaged(LOADS, separation[None], area[None])


def test_a_sweep_that_leaves_no_gap_open_is_refused():
    spectrum = SPECTRA["plateau"]
    loads = np.geomspace(1.5, 3, 6)
    separation, area = persson_sweep(spectrum, loads)
    with pytest.raises(ValueError, match="leave the gap open"):
        TabulatedLaw(
            averaged(loads, separation[None], area[None]), spectrum_curve(spectrum), 1e-6, 0.5, MODULUS
        )


@pytest.mark.parametrize("gamma", [1.0, 0.45])
def test_measured_waves_give_the_curve_of_their_spectrum(gamma):
    spectrum = SPECTRA["plateau"]
    q = np.geomspace(spectrum.plateau_start, spectrum.cutoff, 2001)
    middles, steps = np.sqrt(q[1:] * q[:-1]), np.diff(q)
    curve = waves_curve(middles, 2 * np.pi * middles * spectrum.density(middles) * steps, gamma)
    expected = separation_at(spectrum_curve(spectrum, gamma), LOADS)
    np.testing.assert_allclose(separation_at(curve, LOADS), expected, rtol=2e-3, atol=1e-5)


def test_measured_waves_of_one_length_are_refused():
    with pytest.raises(ValueError, match="2 lengths"):
        waves_curve([1e5, 2e5], [1e-12, 0.0])


def test_separation_goes_on_at_both_ends_of_the_curve():
    curve = spectrum_curve(SPECTRA["plateau"])
    lightest = curve.pressure[-1]
    tail = separation_at(curve, np.array([lightest, lightest / np.e, lightest / np.e**2]))
    np.testing.assert_allclose(np.diff(tail), curve.rate[-1], rtol=1e-9)
    assert separation_at(curve, np.array([100.0])) == 0


def test_monotone_spline_is_of_fourth_order_where_the_points_are_smooth():
    errors = []
    for count in (11, 21, 41):
        x = np.linspace(0, 2, count)
        fine = np.linspace(0, 2, 1001)
        errors.append(np.abs(monotone_spline(x, np.exp(x))(fine) - np.exp(fine)).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 3.5)


def test_monotone_spline_never_overshoots():
    x = np.arange(7.0)
    y = np.array([0, 1e-3, 2e-3, 1, 1.001, 1.002, 5])
    fine = monotone_spline(x, y)(np.linspace(0, 6, 2001))
    assert np.all(np.diff(fine) > 0)
    with pytest.raises(ValueError, match="strictly monotone"):
        monotone_spline(x, np.zeros(7))
