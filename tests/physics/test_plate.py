"""Contact with the plate: laws of the pressure, the friction cone, and the derivative of the nodal forces."""

import numpy as np
import pytest
from solid_meshes import rounded_block

from softlub.pressure_table import tabulate
from softlub.solid.plate import PlateContact
from softlub.solid.plate_laws import HardContact, PressureClearance

MESH = rounded_block()
SEPARATION = np.geomspace(1e-8, 2e-5, 200)
SCALE = 2e-6
TABLE = tabulate(SEPARATION, 1e6 * np.exp(-SEPARATION / SCALE), -1e6 / SCALE * np.exp(-SEPARATION / SCALE))
LAWS = [HardContact(1e12), PressureClearance(TABLE)]


def some_displacement():
    return 3e-6 * np.random.default_rng(5).standard_normal(MESH.points.shape)


def test_hard_contact_pushes_only_what_penetrates():
    pressure, stiffness = HardContact(2e12).pressure_and_stiffness(np.array([-1e-6, 0.0, 1e-6]))
    np.testing.assert_allclose(pressure, [2e6, 0, 0])
    np.testing.assert_allclose(stiffness, [2e12, 0, 0])


def test_tabulated_contact_is_the_table_and_goes_on_linearly_below_zero():
    gap = np.array([1e-6, 5e-6, -1e-6, -2e-6, -3e-6])
    pressure, stiffness = PressureClearance(TABLE).pressure_and_stiffness(gap)
    np.testing.assert_allclose(pressure[:2], 1e6 * np.exp(-gap[:2] / SCALE), rtol=1e-6)
    np.testing.assert_allclose(np.diff(pressure[2:]), 1e-6 * stiffness[2], rtol=1e-12)
    assert np.all(stiffness > 0)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_derivative_agrees_with_finite_differences(law):
    contact = PlateContact(law, 0.4)
    displacement, height, step = some_displacement(), 4e-6, 1e-11
    middle = contact.forces(MESH, displacement, height)
    ahead, behind = (contact.forces(MESH, displacement, height + sign * step) for sign in (1, -1))
    scale = middle.stiffness.max()
    assert np.abs((ahead.normal - behind.normal) / (2 * step) - middle.stiffness).max() <= 1e-6 * scale
    assert np.abs((ahead.shear - behind.shear) / (2 * step) - 0.4 * middle.stiffness).max() <= 1e-6 * scale
    lifted = displacement + np.array([0, step])
    np.testing.assert_allclose(
        contact.forces(MESH, lifted, height).normal, behind.normal, rtol=1e-6, atol=1e-12
    )
    aside = displacement + np.array([1e-4, 0])
    np.testing.assert_array_equal(contact.forces(MESH, aside, height).normal, middle.normal)


@pytest.mark.parametrize("friction", [-0.3, 0.0, 0.7])
def test_every_node_lies_on_the_friction_cone(friction):
    forces = PlateContact(HardContact(), friction).forces(MESH, some_displacement(), 4e-6)
    assert np.any(forces.normal > 0)
    np.testing.assert_array_equal(forces.shear, friction * forces.normal)


def test_pressure_stands_on_the_reference_length():
    forces = PlateContact(HardContact()).forces(MESH, np.zeros_like(MESH.points), 1e-5)
    np.testing.assert_allclose(forces.normal, forces.pressure * MESH.edge_widths)
    assert forces.load == pytest.approx(1e14 * MESH.edge_widths @ np.maximum(1e-5 - MESH.base_gap, 0))
    np.testing.assert_array_equal(forces.components()[1::2], forces.normal)
    np.testing.assert_array_equal(forces.components()[::2], forces.shear)


def test_a_friction_coefficient_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="friction = nan must be a finite number"):
        PlateContact(HardContact(), float("nan"))
