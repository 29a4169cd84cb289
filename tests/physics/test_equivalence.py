"""The equivalence coefficient: the measure of difference, the fit against brute force, and on real bodies."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from softlub.solid.body import Body
from softlub.solid.equivalence import (
    final_shape,
    fit_coefficient,
    normalised_shape_difference,
    shape_difference,
)
from softlub.solid.history import Failure, History
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.plate import PlateContact
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.solid.steps import InContact, Loading, Sliding, run

MATERIAL = NeoHookean(c10=0.5932e6, d1=1e-9)
PLACES = np.linspace(-1, 1, 41)
BUMP = 1e-5 * np.stack([0.3 * PLACES, np.exp(-(PLACES**2))], axis=1)
LATERAL = 1e-5 * np.stack([np.cos(PLACES), 0.1 * PLACES], axis=1)


def test_a_shift_scores_its_square():
    moved = BUMP + np.array([3e-6, -4e-6])
    assert shape_difference(moved, BUMP) == pytest.approx(25e-12)
    assert shape_difference(BUMP, moved) == shape_difference(moved, BUMP)
    assert shape_difference(BUMP, BUMP) == 0


def test_a_rigid_body_scores_one():
    assert normalised_shape_difference(0 * BUMP, BUMP) == 1
    assert normalised_shape_difference(BUMP, BUMP) == 0
    assert normalised_shape_difference(1.1 * BUMP, BUMP) == pytest.approx(0.01)
    assert normalised_shape_difference(7.7 * BUMP, 7 * BUMP) == pytest.approx(0.01)


def softening(coefficient):
    """Falls with the coefficient at two rates, so that no multiple is another's shape."""
    return BUMP / coefficient + LATERAL / coefficient**0.6 + 0.1 * LATERAL / (1 + coefficient**2)


@settings(max_examples=30, deadline=None)
@given(st.floats(0.55, 4.9), st.floats(-0.2, 0.2))
@example(4.0, -0.1875)  # the minimum lies beyond the upper bound
@example(4.8125, 0.19140625)  # far from the start, and no shape comes near
def test_finds_the_minimum_of_brute_force(coefficient, distortion):
    """Also where no coefficient gives the reference."""
    reference = softening(coefficient) + distortion * LATERAL
    found = fit_coefficient(reference, softening)
    expected = minimize_scalar(
        lambda a: shape_difference(softening(a), reference),
        bounds=(0.5, 5.0),
        method="bounded",
        options={"xatol": 1e-9},
    )
    assert found.converged
    assert found.runs <= 9
    assert found.coefficient == pytest.approx(expected.x, rel=1e-3)
    assert found.shape_difference <= expected.fun + 1e-5 * shape_difference(reference, 0 * reference)
    assert found.normalised == normalised_shape_difference(softening(found.coefficient), reference)


def test_few_runs_are_enough():
    found = fit_coefficient(softening(2.3), softening)
    assert found.coefficient == pytest.approx(2.3, rel=1e-4)
    assert found.runs <= 6
    assert found.at_bound is None
    np.testing.assert_array_equal(
        found.differences, [shape_difference(softening(a), softening(2.3)) for a in found.coefficients]
    )
    assert found.shape_difference == found.differences.min()


@pytest.mark.parametrize(("coefficient", "bound"), [(3.0, "upper"), (0.6, "lower")])
def test_says_when_a_bound_stopped_it(coefficient, bound):
    found = fit_coefficient(softening(coefficient), softening, bounds=(0.9, 2.0))
    assert found.at_bound == bound
    assert found.coefficient == pytest.approx({"upper": 2.0, "lower": 0.9}[bound], rel=3e-4)
    assert found.coefficients.min() >= 0.9
    assert found.coefficients.max() <= 2.0


def test_says_when_the_runs_did_not_suffice():
    found = fit_coefficient(softening(3.0), softening, most_runs=2)
    assert found.runs == 2
    assert not found.converged


def test_refuses_what_has_no_equivalent():
    with pytest.raises(ValueError, match="must lie within bounds"):
        fit_coefficient(BUMP, softening, bounds=(2.0, 3.0))
    with pytest.raises(ValueError, match="does not deform"):
        fit_coefficient(0 * BUMP, softening)
    with pytest.raises(ValueError, match="same nodes"):
        fit_coefficient(BUMP[:-1], softening)
    with pytest.raises(ValueError, match="no finite shape"):
        fit_coefficient(BUMP, lambda coefficient: np.full_like(BUMP, np.nan))
    stopped = History((), (), Failure("sliding", 4, 0.3, "the body folds"), 5, 20)
    with pytest.raises(ValueError, match=r"sliding stopped at 30 %.*folds"):
        final_shape(stopped)


def slid(material, duration, start=()):
    mesh = TriangularSpecimen().mesh(MeshDensity(edge_nodes=65, rows=6, flank_columns=8))
    steps = [InContact(2e-6, duration), Loading(17.0, duration), *start, Sliding(0.4, duration)]
    return final_shape(run(Body(mesh, material), PlateContact(), steps))


def test_finds_a_known_coefficient_of_a_sliding_body():
    found = fit_coefficient(slid(MATERIAL.scaled(1.3), 1.0), lambda a: slid(MATERIAL.scaled(a), 1.0))
    assert found.coefficient == pytest.approx(1.3, rel=2e-4)
    assert found.normalised < 1e-6
    assert found.runs <= 6


def test_a_viscoelastic_body_is_the_stiffer_the_faster():
    """With one relaxation time of 1 ms, whose arm is as stiff as the rest: α from 1 at rest to 2 in the glass."""
    viscoelastic = Viscoelastic(MATERIAL, PronySeries((1e-3,), (1.0,), "long_term"))
    coefficients = [
        fit_coefficient(slid(viscoelastic, duration), lambda a: slid(MATERIAL.scaled(a), 1.0)).coefficient
        for duration in (1.0, 1e-3, 1e-6)
    ]
    assert coefficients[0] == pytest.approx(1.0, abs=2e-3)
    assert 1.1 < coefficients[1] < 1.9
    assert coefficients[2] == pytest.approx(2.0, abs=2e-2)


def test_friction_that_starts_at_once_relaxes_longer_than_one_that_grows():
    """How it starts is no part of the source's account, and decides the coefficient of short steps."""
    viscoelastic = Viscoelastic(MATERIAL, PronySeries((1e-3,), (1.0,), "long_term"))
    grown, at_once = (
        fit_coefficient(slid(viscoelastic, 1e-3, start), lambda a: slid(MATERIAL.scaled(a), 1.0)).coefficient
        for start in ((), (Sliding(0.4, 0.0),))
    )
    assert at_once < 0.97 * grown
