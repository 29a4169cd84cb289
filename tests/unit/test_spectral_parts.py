"""The parts of the spectral solver, each against an independent computation."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.polynomial import polynomial
from scipy.integrate import quad

from softlub.lubrication.solvers.spectral.basis import lobatto_basis
from softlub.lubrication.solvers.spectral.breaks import element_breaks
from softlub.lubrication.solvers.spectral.grid import make_grid, transfer
from softlub.lubrication.solvers.spectral.kernel import log_kernel
from softlub.lubrication.solvers.spectral.linear import factorise, substitute
from softlub.lubrication.solvers.spectral.martin import rigid_film
from softlub.lubrication.solvers.spectral.resolution import is_film

orders = st.integers(2, 14)


@st.composite
def polynomials(draw):
    order = draw(orders)
    return order, np.array(
        draw(st.lists(st.floats(-3, 3, allow_subnormal=False), min_size=order + 1, max_size=order + 1))
    )


@settings(max_examples=40, deadline=None)
@given(polynomials())
def test_operators_are_exact_on_polynomials(case):
    order, coefficients = case
    basis = lobatto_basis(order)
    values = polynomial.polyval(basis.nodes, coefficients)
    primitive = polynomial.polyint(coefficients)
    integral = polynomial.polyval(basis.nodes, primitive) - polynomial.polyval(-1.0, primitive)
    slope = polynomial.polyval(basis.nodes, polynomial.polyder(coefficients))
    np.testing.assert_allclose(basis.integration @ values, integral, atol=1e-12)
    np.testing.assert_allclose(basis.differentiation @ values, slope, atol=1e-10 * order**2)
    np.testing.assert_allclose(basis.integration[-1], basis.weights, atol=1e-14)


@settings(max_examples=30, deadline=None)
@given(orders)
def test_weights_are_exact_to_twice_the_order(order):
    basis = lobatto_basis(order)
    for degree in range(2 * order):
        exact = 2 / (degree + 1) if degree % 2 == 0 else 0.0
        assert basis.weights @ basis.nodes**degree == pytest.approx(exact, abs=1e-13)


def test_an_order_below_two_is_refused():
    with pytest.raises(ValueError, match="order 1"):
        lobatto_basis(1)


@pytest.mark.parametrize("order", [3, 8, 13])
def test_kernel_against_quadrature(order):
    """∫ ln|y - s| f(s) ds for f = s^order, at targets inside, on a break, beside it, near and far."""
    basis = lobatto_basis(order)
    breaks = np.array([-2.0, -0.7, 0.1, 0.13, 1.5])
    grid = make_grid(breaks, 3, basis)
    targets = np.array([-2.0, -1.3, -0.7, 0.1, 0.100001, 0.117, 1.5, 1.51, 3.0, -40.0])
    kernel = log_kernel(targets, breaks, basis.legendre_weights)
    for target, row in zip(targets, kernel, strict=True):
        inside = [target] if -2 < target < 1.5 else []
        expected, _ = quad(
            lambda s, y=target: np.log(max(abs(y - s), 1e-300)) * s**order,
            -2,
            1.5,
            points=inside or None,
            epsabs=1e-11,
            epsrel=1e-11,
            limit=400,
        )
        assert row @ grid.nodes**order == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_kernel_keeps_its_digits_far_away():
    """Far away the potential of any load follows from its moments."""
    basis = lobatto_basis(20)
    breaks = np.array([-1.0, 0.2, 1.0])
    grid = make_grid(breaks, 1, basis)
    load = 1 + grid.nodes
    total, first, second = (grid.weights @ (load * grid.nodes**k) for k in range(3))
    target = 1e5
    potential = log_kernel(np.array([target]), breaks, basis.legendre_weights)[0] @ load
    assert potential == pytest.approx(
        total * np.log(target) - first / target - second / (2 * target**2), rel=1e-14
    )


@pytest.mark.parametrize("size", [1, 7, 8, 9, 40, 107])
def test_factors_solve_what_numpy_solves(size):
    rng = np.random.default_rng(size)
    matrix = rng.normal(size=(size, size)) * np.exp(rng.uniform(-8, 8, size))[:, None]
    right = rng.normal(size=size)
    expected = np.linalg.solve(matrix, right)
    pivots = np.empty(size, np.int64)
    assert factorise(matrix, pivots)
    substitute(matrix, pivots, right)
    np.testing.assert_allclose(right, expected, rtol=1e-8, atol=1e-9 * np.abs(expected).max())


def test_a_singular_matrix_is_reported():
    assert not factorise(np.zeros((9, 9)), np.empty(9, np.int64))


@settings(max_examples=200, deadline=None)
@given(
    rupture=st.floats(0.1, 30),
    approach=st.floats(-0.6, 1e3),
    log_film=st.floats(-16, 6),
    log_speed=st.floats(-25, 20),
    log_roughness=st.floats(-15, 6),
    layer=st.floats(0, 100),
    half_domain=st.floats(32, 1000),
    reach=st.floats(0, 1),
)
def test_elements_tile_the_inlet_and_hold_the_rupture(
    rupture, approach, log_film, log_speed, log_roughness, layer, half_domain, reach
):
    end = rupture + reach * (half_domain - rupture)
    breaks, inlet = element_breaks(
        rupture,
        approach,
        np.exp(log_film),
        np.exp(log_speed),
        np.exp(log_roughness),
        layer,
        -half_domain,
        end,
    )
    assert np.all(np.diff(breaks) > 0)
    assert breaks[0] == -half_domain
    assert breaks[inlet] == rupture
    assert breaks[-1] >= end


def test_moving_to_another_grid_keeps_polynomials():
    basis = lobatto_basis(6)
    old = make_grid(np.array([-5.0, -1.0, 0.8, 2.0]), 2, basis)
    new = make_grid(np.array([-5.0, -3.0, 0.0, 0.9, 1.5]), 3, basis)
    half_domain = 5.0
    states = np.zeros((1, old.nodes.size + 2))
    states[0, : old.nodes.size] = old.nodes**5
    states[0, -2:] = 7.0, 0.8
    moved = transfer(states, old.breaks, old.rupture, basis, new, half_domain)
    # Both grids stretch about -L to the state's rupture point; the new one was made for another.
    source = (new.nodes + half_domain) * 5.8 / 5.9 - half_domain
    np.testing.assert_allclose(moved[0, :-2], source**5, rtol=1e-10, atol=1e-10)
    np.testing.assert_array_equal(moved[0, -2:], [7.0, 0.8])


@pytest.mark.parametrize("order", range(4, 13))
def test_a_gap_with_a_node_lifted_off_is_no_film(order):
    basis = lobatto_basis(order)
    nodes = make_grid(np.array([-3.0, -1.0, 1.0, 3.0]), 3, basis).nodes
    gap = 0.05 + 0.5 * np.maximum(np.abs(nodes) - 1.0, 0.0) ** 2
    assert is_film(gap, basis)
    for node in range(1, nodes.size - 1):
        lifted = gap.copy()
        lifted[node] *= 40
        assert not is_film(lifted, basis)


@pytest.mark.parametrize("half_domain", [3.2, 64.0])
def test_the_rigid_start_carries_its_load(half_domain):
    """Load and end pressure of the starting film, by quadrature of Reynolds' equation."""
    speed_number = 60.0
    film, rupture = rigid_film(speed_number, half_domain)
    x = np.linspace(-half_domain, rupture, 200001)
    gap, outlet = film + x**2 / 2, film + rupture**2 / 2
    slope = speed_number * (gap - outlet) / gap**3
    step = x[1] - x[0]
    pressure = np.concatenate([[0], np.cumsum(0.5 * (slope[1:] + slope[:-1]) * step)])
    assert pressure[-1] == pytest.approx(0, abs=1e-6)
    assert np.trapezoid(pressure, x) == pytest.approx(np.pi / 2, rel=1e-6)
