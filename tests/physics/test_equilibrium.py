"""Newton's method for displacement and plate: its whole derivative, its balance, its controls and its refusals."""

import numpy as np
import pytest
from solid_meshes import Rubber, rounded_block
from test_plate import LAWS

from softlub.solid.body import Body
from softlub.solid.control import HeightControl, LoadControl
from softlub.solid.equilibrium import EquilibriumSolver, NewtonSettings
from softlub.solid.plate import PlateContact
from softlub.solid.plate_laws import HardContact

MESH = rounded_block()
START = np.zeros_like(MESH.points)
MODERATE = Rubber(bulk_modulus=50e6)
MIRRORED = np.array([-1, 1])


def pressed(solver, contact, height=5e-6):
    result = solver.solve(contact, HeightControl(height), START, 0.0)
    assert result.converged, result.reason
    return result


@pytest.fixture(scope="module")
def solver():
    return EquilibriumSolver(Body(MESH, Rubber()))


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_newtons_whole_derivative_agrees_with_finite_differences(law):
    """The step from a state solves the derivative of all residuals, by displacement and by height, exactly."""
    body = Body(MESH, MODERATE)
    solver = EquilibriumSolver(body)
    contact, control = PlateContact(law, 0.5), LoadControl(40.0)
    displacement = 2e-6 * np.random.default_rng(2).standard_normal(MESH.points.shape)
    displacement[MESH.held] = 0

    def residuals(part):
        at = solver._evaluate(contact, control, displacement + part * change, 6e-6 + part * rise)
        return np.append(at.unbalanced, -at.missing_load)

    change, rise = START, 0.0
    for _ in range(2):  # the lagged pressure is then that of the state itself
        start = solver._evaluate(contact, control, displacement, 6e-6)
    change, rise, _ = solver._direction(control, start)
    before, step = residuals(0.0), 1e-6
    along = (residuals(step) - residuals(-step)) / (2 * step)
    assert np.abs(along + before).max() <= 1e-6 * np.abs(before).max()


@pytest.mark.parametrize("friction", [0.0, 0.4, -0.4])
@pytest.mark.parametrize("law", [HardContact(), LAWS[1]], ids=lambda law: type(law).__name__)
def test_the_holder_carries_what_the_plate_gives(solver, law, friction):
    contact = PlateContact(law, friction)
    first = pressed(solver, contact)
    result = solver.solve(contact, LoadControl(60.0), first.displacement, first.plate_height)
    assert result.converged, result.reason
    forces = solver.body.forces(result.displacement).reshape(-1, 2)
    held = forces[MESH.held].sum(axis=0)
    assert result.contact.load == pytest.approx(60.0, rel=1e-9)
    np.testing.assert_allclose(held, [-friction * 60.0, -60.0], atol=60 * 1e-8)
    np.testing.assert_array_equal(result.contact.shear, friction * result.contact.normal)
    np.testing.assert_array_equal(result.displacement[MESH.held], 0)
    loaded = np.zeros_like(forces)
    loaded[MESH.edge] = result.contact.components().reshape(-1, 2)
    free = np.setdiff1d(np.arange(len(forces)), MESH.held)
    assert np.abs((forces - loaded)[free]).max() <= 2e-9 * np.abs(forces).max()


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_load_control_and_height_control_agree(solver, friction):
    contact = PlateContact(HardContact(), friction)
    by_height = pressed(solver, contact, 12e-6)
    near = pressed(solver, contact, 8e-6)
    by_load = solver.solve(contact, LoadControl(by_height.contact.load), near.displacement, near.plate_height)
    assert by_load.converged
    assert by_load.plate_height == pytest.approx(12e-6, rel=1e-7)
    scale = np.abs(by_height.displacement).max()
    assert np.abs(by_load.displacement - by_height.displacement).max() <= 1e-7 * scale


def test_friction_to_either_side_is_a_mirror_image(solver):
    """Mirrored about x = 0: nodes change sides, x components their sign."""
    right, left = (pressed(solver, PlateContact(HardContact(), mu)) for mu in (0.5, -0.5))
    partner = [int(np.argmin(np.abs(MESH.points - point * MIRRORED).sum(axis=1))) for point in MESH.points]
    scale = np.abs(right.displacement).max()
    np.testing.assert_allclose(left.displacement[partner] * MIRRORED, right.displacement, atol=1e-9 * scale)


def test_newton_ends_quadratically_but_for_the_lagged_pressure(solver):
    result = pressed(solver, PlateContact(HardContact(), 0.4), 12e-6)
    assert result.iterations <= 10
    assert result.history[-1] < 1e-3 * result.history[-2]


def test_load_without_contact_is_refused_in_words(solver):
    result = solver.solve(PlateContact(), LoadControl(10.0), START, -1e-6)
    assert not result.converged
    assert "no node is in contact" in result.reason


def test_too_few_iterations_are_told_and_nothing_is_raised():
    solver = EquilibriumSolver(Body(MESH, Rubber()), NewtonSettings(most_iterations=2))
    result = solver.solve(PlateContact(), HeightControl(2e-5), START, 0.0)
    assert not result.converged
    assert result.iterations == 2
    assert "no convergence in 2 iterations" in result.reason


def test_a_hopeless_height_ends_with_a_reason(solver):
    """The plate above the holder: whatever Newton meets on the way, it comes back."""
    result = solver.solve(PlateContact(), HeightControl(1.2e-3), START, 0.0)
    assert not result.converged
    assert result.reason
    assert np.all(np.isfinite(result.displacement))


def test_a_start_that_is_inside_out_is_told(solver):
    wrong = START.copy()
    wrong[MESH.cells[20, 0]] += 1e-3
    result = solver.solve(PlateContact(), HeightControl(0.0), wrong, 0.0)
    assert not result.converged
    assert "turned inside out" in result.reason


def test_the_longest_step_is_kept():
    settings = NewtonSettings(largest_step=2e-3, most_iterations=1)
    solver = EquilibriumSolver(Body(MESH, Rubber()), settings)
    result = solver.solve(PlateContact(), HeightControl(1e-4), START, 0.0)
    assert np.abs(result.displacement).max() <= 2e-3 * np.ptp(MESH.points[:, 1]) * (1 + 1e-12)
