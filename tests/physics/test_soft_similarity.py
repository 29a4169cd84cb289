"""The two constants of the soft film: from the inlet's own similarity problem, and as the limit of whole contacts.

Inlet problem, with ξ = (X + 1) λ^(-2/5), u = λ^(3/5) h, p = λ^(1/5) g in Hertz units:

    g' = (h - h*)/h³,   h = (2√2/3) (-ξ)₊^(3/2) - (1/π) ∫ (g - √(2s)₊) ln|ξ - s| ds + const,

h ~ Hertz's gap far outside (ξ -> -∞), g -> √(2ξ) without a shift and h -> h* far inside. h* is the constant.
"""

import numpy as np
import pytest

from softlub.contact.laws.none import NoContact
from softlub.lubrication.film import Lubricant
from softlub.lubrication.hertz import HertzLine
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.spectral import Spectral
from softlub.references.soft_similarity import CENTRAL_FILM, SMALLEST_FILM


def log_matrix(position, node):
    """∫ ln|x - s| over the piecewise linear hats on the nodes."""
    distance = position[:, None] - node
    logarithm = np.log(np.where(distance == 0, 1, np.abs(distance)))
    first = -distance * (logarithm - 1)
    second = distance**2 * (logarithm / 2 - 0.75)
    mean = np.diff(second, axis=1) / np.diff(node)
    matrix = np.zeros_like(second)
    matrix[:, :-1] += mean
    matrix[:, 1:] -= mean
    matrix[:, 0] -= first[:, 0]
    matrix[:, -1] += first[:, -1]
    return matrix


def root_integral(position, end):
    """∫_0^end √s ln|x - s| ds."""
    side, root = np.sqrt(np.abs(position)), np.sqrt(end)
    arc = (
        np.where(position > 0, np.log(np.abs((side + root) / (side - root))) / 2, -np.arctan(root / side))
        / side
    )
    edge = root**3 * np.log(np.abs(position - end))
    return 2 / 3 * edge + 4 / 3 * (position**2 * arc - position * root - root**3 / 3)


def inlet_film(intervals, extent):
    """h* of the inlet problem on -extent <= ξ <= extent, by Newton on nodal g, the constant and h*."""
    parameter = np.linspace(-1, 1, intervals + 1)
    node = extent * np.sinh(8 * parameter) / np.sinh(8)
    point = np.append((node[1:] + node[:-1]) / 2, extent * (1 - 1e-9))
    gap = np.sqrt(8) / 3 * np.maximum(-point, 0) ** 1.5 + np.sqrt(2) / np.pi * root_integral(point, extent)
    matrix = np.hstack(
        [-log_matrix(point, node) / np.pi, np.ones((intervals + 1, 1)), np.zeros((intervals + 1, 1))]
    )
    count, spacing, last = intervals + 1, np.diff(node), np.sqrt(2 * extent)
    difference = np.zeros((intervals, count + 2))
    rows = np.arange(intervals)
    difference[rows, rows], difference[rows, rows + 1] = -1 / spacing, 1 / spacing

    unknown = np.concatenate([np.sqrt(node + np.sqrt(node**2 + 1)), [0.0, 0.5]])
    unknown[-2] = 0.5 - np.min(gap + matrix @ unknown)
    for _ in range(40):
        film, exit_film = gap + matrix @ unknown, unknown[-1]
        inner, slope = film[:-1], difference @ unknown
        scale = 1 / (1 + inner**3)
        residual = np.concatenate(
            [
                scale * (slope * inner**3 - inner + exit_film),
                # ahead of the inlet g' = 1/h² of Hertz's gap; far inside g' is that of √(2ξ)
                [unknown[0] - 9 / (16 * extent**2), unknown[count - 1] - last],
                [film[-1] - exit_film - exit_film**3 / last],
            ]
        )
        jacobian = np.zeros((count + 2, count + 2))
        jacobian[:intervals] = (3 * slope * inner**2 - 1)[:, None] * matrix[:-1] + inner[
            :, None
        ] ** 3 * difference
        jacobian[:intervals, -1] += 1
        jacobian[:intervals] *= scale[:, None]
        jacobian[intervals, 0] = jacobian[intervals + 1, count - 1] = 1
        jacobian[-1] = matrix[-1]
        jacobian[-1, -1] -= 1 + 3 * exit_film**2 / last
        step = np.linalg.solve(jacobian, -residual)
        change = matrix @ step
        unknown = unknown + step * min(1.0, 0.7 / np.max(-change / film, initial=0.7))
        if np.max(np.abs(step)) < 1e-9:
            return unknown[-1]
    raise AssertionError("the inlet problem did not converge")


def test_central_film_is_that_of_the_inlet_problem():
    """Second order in the grid, indifferent to where infinity is put, and the constant in the limit."""
    films = np.array([inlet_film(intervals, 400.0) for intervals in (80, 160, 320)])
    assert np.log2((films[1] - films[0]) / (films[2] - films[1])) == pytest.approx(2.0, abs=0.3)
    assert inlet_film(160, 100.0) == pytest.approx(films[1], rel=5e-4)
    assert (4 * films[2] - films[1]) / 3 == pytest.approx(CENTRAL_FILM, rel=3e-4)


def test_whole_contacts_tend_to_both_constants():
    """Smooth contacts at λ = 1e-5 and 1e-6; what is left falls like λ^(2/5) and is extrapolated away."""
    hertz = HertzLine(0.01, 1e7, 100.0)
    scaled = []
    for number in (1e-5, 1e-6):
        speed = number / hertz.speed_number(0.1, 1.0)
        problem = Problem(HalfSpaceCylinder(0.01, 1e7), NoContact(), Lubricant(0.1), 100.0, speed, 0.0)
        contact = Spectral(order=12).solve(problem)
        assert contact.converged
        films = np.array([contact.separation_central, contact.separation_min])
        scaled.append(films / hertz.gap_scale / number**0.6)
    ratio = 10**0.4
    limit = (ratio * scaled[1] - scaled[0]) / (ratio - 1)
    np.testing.assert_allclose(limit, [CENTRAL_FILM, SMALLEST_FILM], rtol=3e-4)
