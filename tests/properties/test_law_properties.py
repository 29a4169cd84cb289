"""What every contact law must do for every surface: positive, falling, scaling with modulus and roughness."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.contact.laws.persson import PerssonLaw
from softlub.pressure_table import evaluate
from softlub.surfaces.spectrum import SelfAffine

RELATIVE = np.concatenate([-np.geomspace(1e-1, 1e-6, 6), [0.0], np.geomspace(1e-9, 100, 400)])
"""u/h_rms, from below zero to where only the tail's continuation is left."""


def decades(low, high):
    return st.floats(low, high).map(lambda exponent: 10.0**exponent)


@st.composite
def surfaces(draw):
    rolloff = draw(decades(3, 6))
    plateau = draw(st.one_of(st.none(), st.floats(0.01, 1.0)))
    return SelfAffine(
        rms_roughness=draw(decades(-8, -4.5)),
        hurst=draw(st.one_of(st.just(1.0), st.floats(0.05, 1.0))),
        rolloff=rolloff,
        cutoff=rolloff * draw(decades(0.3, 6)),
        long_cutoff=None if plateau is None else plateau * rolloff,
    )


@st.composite
def laws(draw):
    surface, modulus = draw(surfaces()), draw(decades(4, 11))
    factor = draw(st.sampled_from([1.0, 1 / np.pi, 0.25]))
    if draw(st.booleans()):
        return ExponentialLaw(surface, modulus, factor)
    gamma = draw(st.one_of(st.just(1.0), st.floats(0.1, 1.0)))
    return PerssonLaw(surface, modulus, gamma, factor)


def relative_pressure(law):
    pressure, slope = evaluate(law.table, RELATIVE * law.spectrum.rms_roughness)
    return pressure / law.modulus, slope * law.spectrum.rms_roughness / law.modulus


@settings(deadline=None, max_examples=60)
@given(laws())
def test_pressure_is_positive_finite_and_falls(law):
    pressure, slope = relative_pressure(law)
    assert np.all(np.isfinite(pressure))
    alive = pressure > 1e-250
    assert np.all(pressure >= 0)
    assert np.all(slope[alive] < 0)
    assert np.all(np.diff(pressure[alive]) < 0)


@settings(deadline=None, max_examples=60)
@given(laws())
def test_area_is_a_share_that_grows_with_pressure(law):
    pressure = np.geomspace(1e-8, 1e3, 200) * law.modulus * law.spectrum.rms_slope
    area = law.area_ratio(pressure)
    assert np.all((area > 0) & (area <= 1))
    assert np.all(np.diff(area) >= 0)


@settings(deadline=None, max_examples=40)
@given(laws(), decades(-3, 3))
def test_pressure_scales_with_the_modulus(law, factor):
    other = type(law)(**{**vars_of(law), "modulus": law.modulus * factor})
    np.testing.assert_allclose(relative_pressure(other)[0], relative_pressure(law)[0], rtol=1e-10)


@settings(deadline=None, max_examples=40)
@given(laws(), decades(-1, 1))
def test_pressure_over_relative_separation_scales_with_the_roughness(law, factor):
    """Heights times k at the same wavevectors: pressure times k at k times the separation, and slopes times k."""
    surface = law.spectrum
    rougher = SelfAffine(
        surface.rms_roughness * factor, surface.hurst, surface.rolloff, surface.cutoff, surface.long_cutoff
    )
    other = type(law)(**{**vars_of(law), "spectrum": rougher})
    pressure, _ = relative_pressure(law)
    shown = (pressure > 1e-200) & (RELATIVE > 0)
    np.testing.assert_allclose(relative_pressure(other)[0][shown], factor * pressure[shown], rtol=1e-9)
    load = np.array([0.01, 0.3]) * law.modulus * surface.rms_slope
    np.testing.assert_allclose(other.area_ratio(factor * load), law.area_ratio(load), rtol=1e-10)


@settings(deadline=None, max_examples=40)
@given(laws(), decades(-1, 1))
def test_similar_surfaces_press_alike(law, factor):
    """Heights times k, wavevectors over k: the same slopes, the same pressure at the same relative separation."""
    surface = law.spectrum
    long_cutoff = None if surface.long_cutoff is None else surface.long_cutoff / factor
    similar = SelfAffine(
        surface.rms_roughness * factor,
        surface.hurst,
        surface.rolloff / factor,
        surface.cutoff / factor,
        long_cutoff,
    )
    other = type(law)(**{**vars_of(law), "spectrum": similar})
    pressure, _ = relative_pressure(law)
    shown = (pressure > 1e-200) & (RELATIVE > 0)
    np.testing.assert_allclose(relative_pressure(other)[0][shown], pressure[shown], rtol=1e-8)


@settings(deadline=None, max_examples=60)
@given(laws(), st.floats(-13, 4.4))
def test_slope_is_the_derivative_of_the_table(law, logarithm):
    separation = np.exp(logarithm) * law.spectrum.rms_roughness
    step = 1e-4 * separation * min(1.0, np.exp(-logarithm))
    # Within one cubic: knots are some 0.035 apart, and the third derivative jumps at them.
    (before, _, after), (_, slope, _) = evaluate(law.table, separation + step * np.array([-1, 0, 1]))
    assert (after - before) / (2 * step) == pytest.approx(slope, rel=1e-4, abs=1e-280)


@settings(deadline=None, max_examples=25)
@given(surfaces(), st.floats(0.1, 0.9))
def test_smaller_gamma_is_softer_in_the_tail(surface, gamma):
    """γ < 1 shortens the tail by γ, so that far away less pressure is left."""
    separation = np.array([20.0, 40.0]) * surface.rms_roughness
    plain, plain_slope = evaluate(PerssonLaw(surface, 1e7).table, separation)
    reduced, reduced_slope = evaluate(PerssonLaw(surface, 1e7, gamma).table, separation)
    assert np.all(reduced < plain)
    rates = reduced_slope[1] / reduced[1] * plain[1] / plain_slope[1]
    assert rates == pytest.approx(1 / gamma, rel=1e-4)


def vars_of(law):
    """Parameters of a law, without what it has cached."""
    return {name: getattr(law, name) for name in law.__dataclass_fields__}
