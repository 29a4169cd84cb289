"""Static condensation: Schur identities, closed forms, invariance, refusals."""

import felupe
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import sparse

from softlub.solid.dissection import nested_dissection
from softlub.solid.reduction import SingularInteriorError, condense


def dense_schur(matrix, kept):
    inner = np.setdiff1d(np.arange(matrix.shape[0]), kept)
    dense = matrix.toarray()
    response = np.linalg.solve(dense[np.ix_(inner, inner)], dense[np.ix_(inner, kept)])
    return dense[np.ix_(kept, kept)] - dense[np.ix_(kept, inner)] @ response


def grid_matrix(rows, columns, generator, skew=0.0):
    """Diagonally dominant matrix on a nine-point grid with two variables a node."""
    one = sparse.diags_array([1.0, 1.0, 1.0], offsets=[-1, 0, 1], shape=(rows, rows))
    other = sparse.diags_array([1.0, 1.0, 1.0], offsets=[-1, 0, 1], shape=(columns, columns))
    pattern = sparse.csr_array(sparse.kron(sparse.kron(one, other), np.ones((2, 2))))
    matrix = pattern.copy()
    matrix.data = generator.standard_normal(matrix.nnz)
    matrix = 0.5 * (matrix + matrix.T) + skew * matrix
    return sparse.csr_array(matrix + sparse.diags_array(1 + np.abs(matrix).sum(axis=1)))


def plane_strain_matrix(columns, rows, width, height, shear_modulus, bulk_modulus):
    mesh = felupe.Rectangle(b=(width, height), n=(columns, rows))
    field = felupe.FieldContainer([felupe.FieldPlaneStrain(felupe.RegionQuad(mesh), dim=2)])
    solid = felupe.SolidBodyNearlyIncompressible(felupe.NeoHooke(mu=shear_modulus), field, bulk=bulk_modulus)
    return sparse.csr_array(solid.assemble.matrix()), mesh.points


@pytest.mark.parametrize("shape", [(3, 4), (2, 301), (17, 31), (28, 28)])
@pytest.mark.parametrize("skew", [0.0, 0.4])
def test_schur_complement_of_a_grid(shape, skew):
    generator = np.random.default_rng(1)
    matrix = grid_matrix(*shape, generator, skew)
    kept = generator.choice(matrix.shape[0], 11, replace=False)
    expected = dense_schur(matrix, kept)
    np.testing.assert_allclose(condense(matrix, kept), expected, atol=1e-13 * np.abs(expected).max())


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 60), st.floats(0.0, 0.5), st.integers(0, 2**31), st.booleans())
def test_schur_complement_of_any_pattern(size, density, seed, symmetric):
    """Also graphs in pieces, rows that meet nothing, patterns that are not symmetric, nothing or everything kept."""
    generator = np.random.default_rng(seed)
    matrix = sparse.random_array((size, size), density=density, rng=generator)
    matrix = matrix + matrix.T if symmetric else matrix
    matrix = sparse.csr_array(matrix + sparse.eye_array(size) * (1 + np.abs(matrix).sum(axis=1).max()))
    kept = generator.permutation(size)[: generator.integers(0, size + 1)]
    expected = dense_schur(matrix, kept)
    assert expected.shape == (kept.size, kept.size)
    np.testing.assert_allclose(
        condense(matrix, kept), expected, rtol=0, atol=1e-12 * np.abs(matrix.diagonal()).max()
    )


def test_inverse_is_the_block_of_the_inverse():
    matrix = grid_matrix(9, 23, np.random.default_rng(2), skew=0.2)
    kept = np.arange(5, 40, 3)
    block = np.linalg.inv(matrix.toarray())[np.ix_(kept, kept)]
    np.testing.assert_allclose(np.linalg.inv(condense(matrix, kept)), block, atol=1e-13 * np.abs(block).max())


def test_condensing_twice_is_condensing_once():
    matrix = grid_matrix(8, 40, np.random.default_rng(3))
    outer, inner = np.arange(0, 200, 2), np.array([4, 17, 80])
    once = condense(matrix, outer[inner])
    twice = condense(sparse.csr_array(condense(matrix, outer)), inner)
    np.testing.assert_allclose(twice, once, atol=1e-13 * np.abs(once).max())


def test_numbering_of_the_interior_does_not_matter():
    generator = np.random.default_rng(4)
    matrix = grid_matrix(12, 50, generator, skew=0.3)
    kept = np.arange(0, 100, 4)
    order = generator.permutation(matrix.shape[0])
    place = np.argsort(order)
    shuffled = sparse.csr_array(matrix[order][:, order])
    expected = condense(matrix, kept)
    np.testing.assert_allclose(condense(shuffled, place[kept]), expected, atol=1e-13 * np.abs(expected).max())
    np.testing.assert_allclose(
        condense(matrix, kept[::-1]), expected[::-1, ::-1], atol=1e-13 * np.abs(expected).max()
    )


def test_bar_of_springs():
    """n equal springs in a row are one of k/n."""
    count, stiffness = 1000, 3e6
    matrix = sparse.lil_array((count + 1, count + 1))
    matrix.setdiag(np.r_[stiffness, np.full(count - 1, 2 * stiffness), stiffness])
    matrix.setdiag(-stiffness, 1)
    matrix.setdiag(-stiffness, -1)
    found = condense(matrix, [0, count])
    np.testing.assert_allclose(found, stiffness / count * np.array([[1, -1], [-1, 1]]), rtol=1e-11)


def test_confined_column():
    """A column that cannot widen has the stiffness M w/L, M = K + 4G/3, however fine its mesh."""
    width, height, shear, bulk = 2e-3, 5e-3, 1.2e6, 8e7
    matrix, points = plane_strain_matrix(3, 40, width, height, shear, bulk)
    vertical = np.flatnonzero(points[:, 1] < height) * 2 + 1
    column = sparse.csr_array(matrix[vertical][:, vertical])
    bottom = np.flatnonzero(points[vertical // 2, 1] == 0.0)
    reduced = condense(column, bottom)
    assert reduced.sum() == pytest.approx((bulk + 4 * shear / 3) * width / height, rel=1e-10)


def test_reduced_body_moves_freely_as_a_rigid_one():
    """Unheld, with one edge kept: no force under two translations and a turn, positive energy under the rest."""
    matrix, points = plane_strain_matrix(21, 15, 3e-3, 1e-3, 1e6, 1e9)
    edge = np.flatnonzero(points[:, 1] == 0.0)
    kept = np.stack([2 * edge, 2 * edge + 1], axis=1).ravel()
    reduced = condense(matrix, kept)
    along, zero = points[edge, 0] / 1e-3, np.zeros(edge.size)
    rigid = [
        np.stack(motion, axis=1).ravel() for motion in ((zero + 1, zero), (zero, zero + 1), (zero, along))
    ]
    scale = np.abs(reduced).max()
    for motion in rigid:
        assert np.abs(reduced @ motion).max() < 1e-10 * scale
    np.testing.assert_allclose(reduced, reduced.T, atol=1e-11 * scale)
    eigenvalues = np.linalg.eigvalsh(reduced)
    assert np.sum(np.abs(eigenvalues) < 1e-9 * scale) == 3
    assert np.all(eigenvalues[3:] > 1e-4 * scale)


def test_dissection_orders_every_variable_once_and_parents_last():
    matrix = grid_matrix(30, 70, np.random.default_rng(5))
    fronts = nested_dissection(matrix, leaf_size=50)
    found = np.concatenate([front.variables for front in fronts])
    np.testing.assert_array_equal(np.sort(found), np.arange(matrix.shape[0]))
    for number, front in enumerate(fronts):
        assert all(child < number for child in front.children)
    children = [child for front in fronts for child in front.children]
    assert len(set(children)) == len(children)
    assert len(fronts) > 30
    assert max(front.variables.size for front in fronts) <= 140


@pytest.mark.parametrize(
    ("kept", "words"),
    [
        ([0, 12], "12 lies outside.*0 to 11"),
        ([-1, 3], "-1 lies outside"),
        ([3, 5, 3], "3 is given more than once"),
        ([0.5, 1.0], "whole numbers"),
        ([[0, 1]], "shape"),
    ],
)
def test_refuses_kept_indices(kept, words):
    with pytest.raises(ValueError, match=words):
        condense(grid_matrix(2, 3, np.random.default_rng(0)), kept)


def test_refuses_matrices():
    with pytest.raises(ValueError, match="square"):
        condense(sparse.csr_array((3, 4)), [0])
    broken = grid_matrix(2, 3, np.random.default_rng(0))
    broken.data[4] = np.nan
    with pytest.raises(ValueError, match="NaN"):
        condense(broken, [0])


def test_refuses_an_interior_that_can_move():
    """A body that hangs on nothing, beside the one that is kept."""
    matrix, points = plane_strain_matrix(9, 7, 1e-3, 1e-3, 1e6, 1e8)
    two = sparse.csr_array(sparse.block_diag([matrix, matrix]))
    edge = np.flatnonzero(points[:, 1] == 0.0)
    with pytest.raises(SingularInteriorError, match=r"singular.*hold it"):
        condense(two, 2 * edge)
    with pytest.raises(SingularInteriorError, match="at degree of freedom 3"):
        condense(sparse.diags_array([1.0, 2.0, 3.0, 0.0]), [0])
