"""The influence matrix of a meshed body: equation 6-7, reciprocity, half-space and strip limits, loaded base state."""

import numpy as np
import pytest
from test_reduced_stiffness import MATERIAL, contact_forces, in_balance

from softlub.lubrication.half_space import influence_matrix
from softlub.solid.body import Body
from softlub.solid.compliance import MeshedCompliance
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.rectangle import Rectangle
from softlub.solid.shapes.triangle import TriangularSpecimen


@pytest.fixture(scope="module")
def specimen():
    return Body(TriangularSpecimen().mesh(MeshDensity(edge_nodes=129, rows=11, flank_columns=12)), MATERIAL)


def parabolic_pressure(positions, half_width):
    return 1e5 * np.maximum(1 - (positions / half_width) ** 2, 0)


def test_pressure_acts_along_the_normal(specimen):
    """Equation 6-7 against 6-1: forces Δs p n on the nodes, with Δs and n of the chord over the node."""
    reduced = ReducedStiffness.of(specimen)
    compliance = MeshedCompliance.of(reduced)
    x, y = reduced.positions, reduced.base_gap
    pressure = parabolic_pressure(x, 3e-4)
    length = np.hypot(x[2:] - x[:-2], y[2:] - y[:-2]) / 2
    angle = np.arctan2(x[2:] - x[:-2], -(y[2:] - y[:-2]))
    forces = np.zeros((x.size, 2))
    forces[1:-1] = (length * pressure[1:-1])[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    expected = reduced.displacement(forces)[:, 1]
    found = compliance.deflection(pressure)
    np.testing.assert_allclose(found, expected, atol=1e-9 * np.abs(expected).max())
    assert compliance.widths @ pressure == pytest.approx(forces[:, 1].sum(), rel=1e-12)
    np.testing.assert_array_equal(compliance.matrix() @ pressure, found)


def test_an_upright_force_alone_would_miss_part_of_it(specimen):
    """The lateral part of the normal counts on the flanks, by some per cent."""
    reduced = ReducedStiffness.of(specimen)
    pressure = parabolic_pressure(reduced.positions, 3e-4)
    upright = np.stack([np.zeros_like(pressure), pressure * reduced.widths], axis=1)
    along_normal = MeshedCompliance.of(reduced).deflection(pressure)
    difference = np.abs(reduced.displacement(upright)[:, 1] - along_normal).max() / along_normal.max()
    assert 0.01 < difference < 0.2


def test_reciprocity():
    """On a flat edge the gap at i by the force at j is the gap at j by the force at i."""
    mesh = Rectangle(2e-3, 1e-3).mesh(MeshDensity(edge_nodes=65, rows=12))
    compliance = MeshedCompliance.of(ReducedStiffness.of(Body(mesh, MATERIAL)))
    by_force = compliance.influence / compliance.widths
    np.testing.assert_allclose(by_force, by_force.T, atol=1e-9 * np.abs(by_force).max())


def half_space_error(width, nodes, rows):
    """Deviation of the deflection under a parabola of 0.2 mm half-width within it, the rigid approach taken out."""
    material = NeoHookean(c10=0.5e6, d1=1e-9)
    mesh = Rectangle(width, 0.5 * width).mesh(MeshDensity(edge_nodes=nodes, rows=rows))
    compliance = MeshedCompliance.of(ReducedStiffness.of(Body(mesh, material)))
    x = compliance.positions
    pressure = parabolic_pressure(x, 2e-4)
    inside = np.abs(x) < 2e-4
    found = compliance.deflection(pressure)[inside]
    expected = (influence_matrix(x, material.plane_strain_modulus) @ pressure)[inside]
    difference = found - expected
    return np.ptp(difference) / np.ptp(expected)


def test_a_large_block_is_a_half_space():
    """The shape's error falls with the square of the body's size, until the mesh is too coarse to tell."""
    errors = [half_space_error(width, nodes, 16) for width, nodes in ((2e-3, 101), (4e-3, 201), (8e-3, 401))]
    assert errors[1] < 0.4 * errors[0]
    assert errors[2] < 0.6 * errors[1]
    assert errors[2] < 0.02


def test_a_thin_strip_is_a_winkler_foundation():
    """Far from its ends a strip of height h under even pressure opens by p h/(K + 4G/3)."""
    material = NeoHookean(c10=0.5e6, d1=1e-6)
    height = 1e-4
    mesh = Rectangle(4e-3, height).mesh(MeshDensity(edge_nodes=81, rows=4))
    compliance = MeshedCompliance.of(ReducedStiffness.of(Body(mesh, material)))
    opening = compliance.deflection(np.full(81, 1e4))
    modulus = material.bulk_modulus + 4 * material.shear_modulus / 3
    assert opening[40] == pytest.approx(1e4 * height / modulus, rel=1e-6)


def test_loaded_base_state_keeps_its_own_gap(specimen):
    """Under the base state's own pressure the gap is the base state's; under more it opens as the body does."""
    mesh = specimen.mesh
    forces = contact_forces(mesh, 17.0)
    displacement = in_balance(specimen, forces)
    reduced = ReducedStiffness.of(specimen, displacement)
    compliance = MeshedCompliance.of(reduced)
    np.testing.assert_array_equal(compliance.positions, mesh.edge_positions + displacement[mesh.edge, 0])
    pressure = reduced.base_force[:, 1] / compliance.widths
    gap = compliance.base_gap + compliance.deflection(pressure)
    np.testing.assert_allclose(gap, reduced.base_gap, atol=1e-9 * np.abs(displacement).max())
    assert compliance.widths @ pressure == pytest.approx(17.0, rel=1e-8)


def test_refuses_an_overhanging_edge():
    x = np.array([0.0, 2e-6, 1e-6, 3e-6])
    reduced = ReducedStiffness(x, np.ones(4), np.eye(8), np.zeros(4), np.zeros((4, 2)), np.zeros((4, 2)))
    with pytest.raises(ValueError, match=r"overhangs .* node 1 .*narrower"):
        MeshedCompliance.of(reduced)
