"""Properties that hold for any surface: invariances, complementarity, monotone area."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from softlub import contact
from softlub.surfaces.topography import Topography

MODULUS = 1e7
TOLERANCE = 1e-8


@st.composite
def surfaces(draw: st.DrawFn) -> Topography:
    shape = (draw(st.integers(2, 40)), draw(st.integers(2, 40)))
    heights = np.random.default_rng(draw(st.integers(0, 2**32 - 1))).standard_normal(shape)
    for _ in range(draw(st.integers(0, 3))):  # smoother ones too
        heights = (heights + np.roll(heights, 1, 0) + np.roll(heights, 1, 1)) / 3
    return Topography(1e-7 * heights, 1e-6, draw(st.booleans()))


loads = st.floats(-4, 1).map(lambda exponent: float(MODULUS * 0.1 * 10**exponent))
few = settings(max_examples=25, deadline=None, derandomize=True)


def solve(topography: Topography, pressure: float, modulus: float = MODULUS) -> contact.ContactSolution:
    found = contact.solve(topography, modulus, pressure, tolerance=TOLERANCE)
    assert found.converged
    return found


def moved(topography: Topography, heights: np.ndarray) -> Topography:
    return Topography(np.ascontiguousarray(heights), topography.spacing, topography.periodic)


def assert_same(one: contact.ContactSolution, two: contact.ContactSolution, undo, height: float) -> None:
    assert np.abs(undo(two.pressure) - one.pressure).max() < 1e-5 * one.pressure.max()
    assert np.abs(undo(two.gap) - one.gap).max() < 1e-6 * height


@few
@given(surfaces(), loads)
def test_complementarity(topography: Topography, pressure: float) -> None:
    found = solve(topography, pressure)
    height = topography.heights.std()
    assert found.pressure.min() >= 0
    assert found.gap.min() > -100 * TOLERANCE * height
    carrying = found.pressure > 0
    assert np.sqrt(np.mean(found.gap[carrying] ** 2)) < 2 * TOLERANCE * height
    assert abs(found.load_error) < 1e-12
    assert 0 < found.contact_area_ratio_pixel <= 1


@few
@given(surfaces(), loads, st.integers(0, 39), st.integers(0, 39))
def test_translation(topography: Topography, pressure: float, along: int, across: int) -> None:
    topography = Topography(topography.heights, topography.spacing, periodic=True)
    there = solve(moved(topography, np.roll(topography.heights, (along, across), (0, 1))), pressure)
    here = solve(topography, pressure)
    assert_same(
        here, there, lambda field: np.roll(field, (-along, -across), (0, 1)), topography.heights.std()
    )


@few
@given(surfaces(), loads)
def test_mirror_and_transposition(topography: Topography, pressure: float) -> None:
    here, height = solve(topography, pressure), topography.heights.std()
    assert_same(here, solve(moved(topography, topography.heights[::-1]), pressure), lambda f: f[::-1], height)
    assert_same(
        here, solve(moved(topography, topography.heights[:, ::-1]), pressure), lambda f: f[:, ::-1], height
    )
    assert_same(here, solve(moved(topography, topography.heights.T), pressure), lambda f: f.T, height)


@few
@given(surfaces(), loads, st.floats(1e-3, 1e3))
def test_pressure_scales_with_the_modulus(topography: Topography, pressure: float, factor: float) -> None:
    here = solve(topography, pressure)
    there = solve(topography, factor * pressure, factor * MODULUS)
    assert np.abs(there.pressure / factor - here.pressure).max() < 1e-5 * here.pressure.max()
    assert np.abs(there.gap - here.gap).max() < 1e-6 * topography.heights.std()


@few
@given(surfaces(), loads, st.floats(-1e-3, 1e-3))
def test_gap_does_not_depend_on_the_height_datum(
    topography: Topography, pressure: float, datum: float
) -> None:
    here = solve(topography, pressure)
    there = solve(moved(topography, topography.heights + datum), pressure)
    assert np.abs(there.gap - here.gap).max() < 1e-6 * topography.heights.std() + 1e-12 * abs(datum)


@few
@given(surfaces(), loads, st.floats(1.1, 10))
def test_more_load_more_contact(topography: Topography, pressure: float, factor: float) -> None:
    light, heavy = solve(topography, pressure), solve(topography, factor * pressure)
    assert heavy.contact_area_ratio_pixel >= light.contact_area_ratio_pixel
    assert heavy.mean_gap <= light.mean_gap + 1e-6 * topography.heights.std()
    assert heavy.rigid_approach >= light.rigid_approach - 1e-6 * topography.heights.std()
    # every point's pressure grows with the load: the half-space presses on no other surface the less
    assert np.all(heavy.pressure >= light.pressure - 1e-4 * heavy.pressure.max())
