"""The reduced stiffness against the body it was made of: linear, nonlinear, at rest and loaded, stored."""

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import splu

from softlub.contact.laws.exponential import ExponentialLaw
from softlub.datasets.store import read, write
from softlub.solid.body import Body
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.plate import PlateContact
from softlub.solid.plate_laws import PressureClearance
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.solid.reduction import condense
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.rectangle import Rectangle
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.solid.steps import InContact, Loading, Sliding, run
from softlub.surfaces.spectrum import SelfAffine

MATERIAL = NeoHookean(c10=0.5932e6, d1=1e-9)
LOAD = 17.0
HALF_WIDTH = 30e-6


def contact_forces(mesh, load, friction=0.0, half_width=HALF_WIDTH):
    """Nodal forces of Hertz's pressure about the middle, with friction."""
    shape = np.sqrt(np.maximum(1 - (mesh.edge_positions / half_width) ** 2, 0)) * mesh.edge_widths
    normal = load * shape / shape.sum()
    return np.stack([friction * normal, normal], axis=1)


def in_balance(body, edge_forces, start=None):
    """Displacement of all nodes under forces on the edge, by Newton's method."""
    mesh, free = body.mesh, body.mesh.free_dofs
    wanted = np.zeros(2 * len(mesh.points))
    wanted[mesh.edge_dofs] = edge_forces.ravel()
    displacement = np.zeros_like(mesh.points) if start is None else start.copy()
    for _ in range(25):
        missing = (wanted - body.forces(displacement))[free]
        step = np.zeros(wanted.size)
        step[free] = splu(sparse.csc_array(body.tangent()[free][:, free])).solve(missing)
        displacement += step.reshape(-1, 2)
        if np.abs(step).max() < 1e-10 * np.abs(displacement).max():
            return displacement
    raise AssertionError(f"no balance: {np.abs(missing).max()}")


def solved_accurately(matrix, right):
    """Refined with residuals in extended precision: one plain solution is itself off by 7e-10 with 513 nodes."""
    factors = splu(sparse.csc_array(matrix))
    solution = factors.solve(right).astype(np.longdouble)
    for _ in range(3):
        products = matrix.data.astype(np.longdouble) * solution[matrix.indices]
        residual = right - np.add.reduceat(products, matrix.indptr[:-1])
        solution += factors.solve(residual.astype(float))
    return solution.astype(float)


@pytest.fixture(scope="module")
def specimen():
    return Body(TriangularSpecimen().mesh(MeshDensity(edge_nodes=129, rows=11, flank_columns=12)), MATERIAL)


@pytest.fixture(scope="module")
def loaded(specimen):
    forces = contact_forces(specimen.mesh, LOAD, friction=0.4)
    displacement = in_balance(specimen, 0.5 * forces)
    return forces, in_balance(specimen, forces, displacement)


@pytest.mark.parametrize(("friction", "lateral_bound"), [(0.0, 0.12), (0.4, 0.02)])
def test_stays_near_nonlinear_finite_elements_at_the_working_load(friction, lateral_bound):
    """Within 2 % of the longest displacement; without friction that hides a tenth of the small lateral one."""
    body = Body(TriangularSpecimen().mesh(MeshDensity(edge_nodes=513, rows=11, flank_columns=30)), MATERIAL)
    reduced = ReducedStiffness.of(body)
    last = run(body, PlateContact(), [InContact(), Loading(LOAD), Sliding(friction)]).last
    assert last.load == pytest.approx(LOAD, rel=1e-8)
    full = last.edge_displacement
    difference = np.abs(reduced.displacement(np.column_stack([last.shear, last.normal])) - full)
    assert np.hypot(*difference.T).max() <= 0.02 * np.hypot(*full.T).max()
    assert difference[:, 0].max() <= lateral_bound * np.abs(full[:, 0]).max()
    assert difference[:, 1].max() <= 0.02 * np.abs(full[:, 1]).max()


@pytest.mark.parametrize(("edge_nodes", "bound"), [(129, 1e-9), (513, 1e-9), (1025, 1e-8)])
def test_agrees_with_linear_finite_elements(edge_nodes, bound):
    density = MeshDensity(edge_nodes=edge_nodes, rows=11, flank_columns=30)
    body = Body(TriangularSpecimen().mesh(density), MATERIAL)
    mesh, free = body.mesh, body.mesh.free_dofs
    forces = contact_forces(mesh, LOAD, friction=0.4)
    everywhere = np.zeros(2 * len(mesh.points))
    everywhere[mesh.edge_dofs] = forces.ravel()
    linear = np.zeros(everywhere.size)
    linear[free] = solved_accurately(sparse.csr_array(body.tangent()[free][:, free]), everywhere[free])
    expected = linear[mesh.edge_dofs].reshape(-1, 2)
    found = ReducedStiffness.of(body).displacement(forces)
    assert np.abs(found - expected).max() < bound * np.abs(expected).max()


def test_initial_state_of_the_specimen(specimen):
    reduced = ReducedStiffness.of(specimen)
    mesh = specimen.mesh
    np.testing.assert_array_equal(reduced.positions, mesh.edge_positions)
    np.testing.assert_array_equal(reduced.widths, mesh.edge_widths)
    np.testing.assert_array_equal(reduced.base_gap, mesh.base_gap)
    assert not reduced.base_force.any()
    assert not reduced.base_displacement.any()
    scale = np.abs(reduced.stiffness).max()
    np.testing.assert_allclose(reduced.stiffness, reduced.stiffness.T, atol=1e-10 * scale)
    assert np.linalg.eigvalsh(reduced.stiffness).min() > 0


def test_pushing_a_node_harder_needs_work():
    """A stiffer material moves in proportion less, wherever it is pushed."""
    mesh = Rectangle(2e-3, 1e-3).mesh(MeshDensity(edge_nodes=33, rows=8))
    forces = contact_forces(mesh, LOAD, friction=0.3, half_width=3e-4)
    soft, stiff = (
        ReducedStiffness.of(Body(mesh, NeoHookean(factor * 0.5e6, 1e-8 / factor))).displacement(forces)
        for factor in (1.0, 2.5)
    )
    np.testing.assert_allclose(2.5 * stiff, soft, rtol=1e-9, atol=1e-12 * np.abs(soft).max())


def test_error_of_the_initial_state_grows_with_the_load(specimen):
    """A tangent at rest: right in the limit of no load, off by the square of a small load."""
    reduced = ReducedStiffness.of(specimen)
    errors = []
    for load in (0.01, 0.1):
        forces = contact_forces(specimen.mesh, load, friction=0.4)
        exact = in_balance(specimen, forces)[specimen.mesh.edge]
        errors.append(np.abs(reduced.displacement(forces) - exact).max() / np.abs(exact).max())
    assert errors[0] < 1e-3
    assert 8 < errors[1] / errors[0] < 12


def test_error_of_the_loaded_state_is_in_proportion_to_the_step(specimen, loaded):
    forces, displacement = loaded
    reduced = ReducedStiffness.of(specimen, displacement)
    mesh = specimen.mesh
    np.testing.assert_allclose(reduced.base_force, forces, atol=1e-9 * np.abs(forces).max())
    np.testing.assert_array_equal(reduced.base_displacement, displacement[mesh.edge])
    assert np.abs(reduced.displacement(forces)).max() < 1e-9 * np.abs(displacement).max()
    initial = ReducedStiffness.of(specimen)
    errors, errors_at_rest = [], []
    for step in (1e-3, 1e-2, 1e-1):
        moved = (in_balance(specimen, (1 + step) * forces, displacement) - displacement)[mesh.edge]
        found = reduced.displacement((1 + step) * forces)
        at_rest = initial.displacement(step * forces)
        errors.append(np.abs(found - moved).max() / np.abs(moved).max())
        errors_at_rest.append(np.abs(at_rest - moved).max() / np.abs(moved).max())
    orders = np.diff(np.log10(errors))
    assert np.all(np.abs(orders - 1) < 0.1)
    assert errors[0] < 1e-3
    assert errors_at_rest[0] > 10 * errors[0]


def test_asking_leaves_the_body_as_it_was(specimen, loaded):
    displacement = loaded[1]
    specimen.forces(displacement)
    before = specimen.tangent()
    ReducedStiffness.of(specimen, 0.0 * displacement)
    assert (specimen.tangent() != before).nnz == 0


def test_a_kept_constraint_holds_the_edge(specimen):
    """With the contact's tangent added, the apex carries a spring; without it the body alone answers."""
    free = ReducedStiffness.of(specimen)
    place, spring = int(np.argmin(free.base_gap)), 1e9
    springs, forces = np.zeros(free.positions.size), np.zeros((free.positions.size, 2))
    springs[place], forces[place, 1] = spring, 1.0
    alone = free.displacement(forces)[place, 1]
    together = free.with_contact(springs).displacement(forces)[place, 1]
    assert 1 / together == pytest.approx(1 / alone + spring, rel=1e-8)


def test_a_constraint_added_after_condensing_is_one_added_before(specimen):
    mesh, free = specimen.mesh, specimen.mesh.free_dofs
    reduced = ReducedStiffness.of(specimen)
    springs = 1e9 * np.random.default_rng(3).random(mesh.edge.size)
    whole = sparse.lil_array(specimen.tangent_at(0.0 * mesh.points))
    whole[2 * mesh.edge + 1, 2 * mesh.edge + 1] += springs
    whole[2 * mesh.edge, 2 * mesh.edge + 1] += 0.4 * springs
    before = condense(sparse.csr_array(whole)[free][:, free], np.searchsorted(free, mesh.edge_dofs))
    after = reduced.with_contact(springs, friction=0.4).stiffness
    np.testing.assert_allclose(after, before, rtol=0, atol=1e-9 * np.abs(before).max())


def test_stiffness_of_the_contact_is_the_derivative_of_its_forces(specimen):
    mesh, reduced = specimen.mesh, ReducedStiffness.of(specimen)
    law = ExponentialLaw(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=1e9), 4.7e6)
    contact = PlateContact(PressureClearance(law.table), friction=0.4)
    state, generator = 1e-6 * np.random.default_rng(1).random(mesh.points.shape), np.random.default_rng(2)
    plate = contact.forces(mesh, state, -1e-6)
    added = reduced.with_contact(plate.stiffness, plate.friction).stiffness - reduced.stiffness
    direction = generator.standard_normal(mesh.points.shape)
    step = 1e-10
    ahead, behind = (
        contact.forces(mesh, state + sign * step * direction, -1e-6).components() for sign in (1, -1)
    )
    found = -added @ direction[mesh.edge].ravel()
    np.testing.assert_allclose(found, (ahead - behind) / (2 * step), atol=1e-6 * np.abs(found).max())


def test_with_the_plate_kept_the_edge_hardly_moves(specimen):
    """Figure 5-10: a plate that touches the apex alone is enough to hold the body up."""
    mesh = specimen.mesh
    touching = PlateContact().forces(mesh, 0 * mesh.points, 1e-12)
    assert np.count_nonzero(touching.stiffness) == 1
    apex = int(np.argmin(mesh.base_gap))
    forces = contact_forces(mesh, LOAD)
    released = ReducedStiffness.of(specimen).displacement(forces)
    kept = ReducedStiffness.of(specimen).with_contact(touching.stiffness).displacement(forces)
    assert abs(kept[apex, 1]) < 1e-2 * abs(released[apex, 1])
    assert np.abs(kept - released).max() > 0.5 * np.abs(released).max()


def test_stored_and_read_again(specimen, loaded, tmp_path):
    reduced = ReducedStiffness.of(specimen, loaded[1])
    write(reduced.dataset(), tmp_path / "stiffness.nc")
    stored = read(tmp_path / "stiffness.nc")
    assert all(stored[name].attrs["units"] for name in ("stiffness", "x", "base_gap", "nodal_force"))
    again = ReducedStiffness.from_dataset(stored)
    for name in ("positions", "widths", "stiffness", "base_gap", "base_force", "base_displacement"):
        np.testing.assert_array_equal(getattr(again, name), getattr(reduced, name))
    push = stored["stiffness"].sel(component="y", component_pushed="x").isel(node=3, node_pushed=5)
    assert push == reduced.stiffness[7, 10]


def test_refuses_states(specimen, loaded):
    with pytest.raises(ValueError, match="does not fit"):
        ReducedStiffness.of(specimen, np.zeros((3, 2)))
    stretched = loaded[1] + 1e-6 * np.sin(specimen.mesh.points[:, :1] * 1e4)
    with pytest.raises(ValueError, match=r"out of balance.*converged"):
        ReducedStiffness.of(specimen, stretched)
    with pytest.raises(ValueError, match=r"base_gap of shape \(4,\) must be \(3,\)"):
        ReducedStiffness(np.arange(3.0), np.ones(3), np.eye(6), np.ones(4), np.ones((3, 2)), np.ones((3, 2)))


def test_forces_of_another_shape_are_refused(specimen):
    reduced = ReducedStiffness.of(specimen)
    with pytest.raises(
        ValueError, match=r"shape \(258,\) do not fit 129 edge nodes: give them as \(129, 2\)"
    ):
        reduced.displacement(np.zeros(258))
