"""The piecewise cubic of ln p over ln u and its two continuations."""

import numpy as np
import pytest

from softlub.contact.laws.none import NoContact
from softlub.pressure_table import EMPTY_TABLE, evaluate, tabulate


def exponential(separation):
    pressure = 5e4 * np.exp(-separation / 1e-6)
    return pressure, -pressure / 1e-6


@pytest.fixture(scope="module")
def table():
    knots = np.geomspace(1e-8, 1e-5, 60)
    return tabulate(knots, *exponential(knots))


def test_knots_are_reproduced(table):
    knots = np.geomspace(1e-8, 1e-5, 60)
    pressure, slope = evaluate(table, knots)
    expected, expected_slope = exponential(knots)
    np.testing.assert_allclose(pressure, expected, rtol=1e-12)
    np.testing.assert_allclose(slope, expected_slope, rtol=1e-11)


def test_interpolation_converges_at_fourth_order_and_its_slope_at_third():
    separation = np.geomspace(2e-8, 0.9e-5, 997)
    expected, expected_slope = exponential(separation)
    errors, slope_errors = [], []
    counts = np.array([40, 80, 160, 320])
    for count in counts:
        knots = np.geomspace(1e-8, 1e-5, count + 1)
        pressure, slope = evaluate(tabulate(knots, *exponential(knots)), separation)
        errors.append(np.max(np.abs(pressure / expected - 1)))
        slope_errors.append(np.max(np.abs(slope / expected_slope - 1)))
    assert -np.polyfit(np.log(counts), np.log(errors), 1)[0] > 3.8
    assert -np.polyfit(np.log(counts), np.log(slope_errors), 1)[0] > 2.8


def test_power_law_is_exact_and_scales_free():
    knots = np.geomspace(1e-9, 1e-4, 7)
    table = tabulate(knots, 3e-3 / knots, -3e-3 / knots**2)
    separation = np.geomspace(1.1e-9, 0.9e-4, 50)
    pressure, slope = evaluate(table, separation)
    np.testing.assert_allclose(pressure, 3e-3 / separation, rtol=1e-11)
    np.testing.assert_allclose(slope, -3e-3 / separation**2, rtol=1e-11)


def test_pressure_goes_on_linearly_below_the_first_knot(table):
    first, slope = exponential(1e-8)
    separation = np.array([0.9e-8, 0.0, -1e-6])
    pressure, slopes = evaluate(table, separation)
    np.testing.assert_allclose(pressure, first + slope * (separation - 1e-8), rtol=1e-12)
    np.testing.assert_allclose(slopes, slope, rtol=1e-12)


def test_pressure_decays_exponentially_beyond_the_last_knot(table):
    separation = np.array([1.0001e-5, 2e-5, 1e-4])
    pressure, slope = evaluate(table, separation)
    expected, expected_slope = exponential(separation)
    np.testing.assert_allclose(pressure, expected, rtol=1e-9)
    np.testing.assert_allclose(slope, expected_slope, rtol=1e-9)


@pytest.mark.parametrize("edge", [1e-8, 1e-5])
def test_value_and_slope_are_continuous_at_both_ends(table, edge):
    pressure, slope = evaluate(table, edge * np.array([1 - 1e-9, 1 + 1e-9]))
    np.testing.assert_allclose(pressure[0], pressure[1], rtol=1e-7)
    np.testing.assert_allclose(slope[0], slope[1], rtol=1e-6)


def test_extreme_separations_are_harmless(table):
    pressure, slope = evaluate(table, [np.inf, 1e300, np.nan])
    np.testing.assert_array_equal(pressure[:2], 0.0)
    np.testing.assert_array_equal(slope[:2], 0.0)
    assert np.isnan(pressure[2])


def test_shape_follows_the_argument(table):
    assert evaluate(table, 1e-6)[0].shape == ()
    assert evaluate(table, np.full((2, 3), 1e-6))[1].shape == (2, 3)


def test_empty_table_carries_nothing():
    assert NoContact().table is EMPTY_TABLE
    pressure, slope = evaluate(EMPTY_TABLE, [-1.0, 0.0, 1e-6, np.inf])
    assert not pressure.any()
    assert not slope.any()
    assert not NoContact().area_ratio(np.array([0.0, 1e5])).any()


def test_uneven_knots_are_refused():
    knots = np.linspace(1e-7, 1e-6, 5)
    with pytest.raises(ValueError, match="evenly spaced"):
        tabulate(knots, *exponential(knots))


@pytest.mark.parametrize("wrong", [0.0, -1.0, np.nan, np.inf])
def test_pressures_that_have_no_logarithm_are_refused(wrong):
    knots = np.geomspace(1e-7, 1e-6, 5)
    pressure, slope = exponential(knots)
    pressure[2] = wrong
    with pytest.raises(ValueError, match="positive and finite"):
        tabulate(knots, pressure, slope)
