"""Shapes of bodies: their meshes, closed forms and refusals."""

import math

import numpy as np
import pytest

from softlub.solid.blocks import even_positions, graded, join, symmetric_positions, transfinite
from softlub.solid.mesh import BodyMesh
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.half_cylinder import HalfCylinder
from softlub.solid.shapes.rectangle import Rectangle
from softlub.solid.shapes.strip import Strip
from softlub.solid.shapes.triangle import TriangularSpecimen

COARSE = MeshDensity(edge_nodes=33, rows=8, flank_columns=10)
SHAPES = {
    "triangle": TriangularSpecimen(),
    "half_cylinder": HalfCylinder(10e-3, 14e-3),
    "rectangle": Rectangle(2e-3, 1e-3),
    "strip": Strip(1e-3, 8e-3, 1e-3),
}


@pytest.fixture(params=SHAPES.values(), ids=SHAPES.keys())
def shape(request):
    return request.param


def test_edge_nodes_are_even_in_x_and_symmetric(shape):
    mesh = shape.mesh(COARSE)
    x = mesh.edge_positions
    assert np.ptp(np.diff(x)) < 1e-12 * np.ptp(x)
    np.testing.assert_array_equal(x, -x[::-1])
    assert x.size == COARSE.edge_nodes
    width = getattr(shape, "edge_width", None) or shape.width
    assert np.ptp(x) == pytest.approx(width, rel=1e-14)


def test_the_apex_is_the_origin(shape):
    mesh = shape.mesh(COARSE)
    np.testing.assert_allclose(mesh.points[mesh.edge[COARSE.edge_nodes // 2]], 0.0, atol=1e-18)
    assert mesh.points[:, 1].min() == 0.0


def test_held_nodes_are_all_those_at_the_top(shape):
    mesh = shape.mesh(COARSE)
    top = mesh.points[:, 1].max()
    np.testing.assert_array_equal(np.sort(mesh.held), np.flatnonzero(mesh.points[:, 1] > top * (1 - 1e-9)))


def test_edge_widths_add_up_to_the_edge(shape):
    mesh = shape.mesh(COARSE)
    assert mesh.edge_widths.sum() == pytest.approx(np.ptp(mesh.edge_positions), rel=1e-14)
    assert mesh.edge_widths[0] == pytest.approx(mesh.edge_widths[1] / 2)


def test_degrees_of_freedom_are_numbered_by_node_and_component(shape):
    mesh = shape.mesh(COARSE)
    np.testing.assert_array_equal(mesh.edge_dofs[::2] // 2, mesh.edge)
    np.testing.assert_array_equal(mesh.edge_dofs % 2, np.tile([0, 1], mesh.edge.size))
    held = np.concatenate([2 * mesh.held, 2 * mesh.held + 1])
    assert np.intersect1d(held, mesh.free_dofs).size == 0
    assert held.size + mesh.free_dofs.size == 2 * len(mesh.points)


def test_the_boundary_lies_on_the_shape():
    radius = 10e-3
    mesh = HalfCylinder(radius, 14e-3).mesh(COARSE)
    away = np.hypot(mesh.points[:, 0], mesh.points[:, 1] - radius)
    assert away.max() <= radius * (1 + 1e-12)
    gap = radius - np.sqrt(radius**2 - mesh.edge_positions**2)
    np.testing.assert_allclose(mesh.base_gap, gap, atol=1e-15)


def test_the_triangle_is_round_at_the_tip_and_straight_on_the_flanks():
    shape = TriangularSpecimen(tip_radius=0.2e-3, flank_angle=math.pi / 6)
    tangent = 0.2e-3 * math.sin(math.pi / 6)
    x = np.array([0.0, 0.5 * tangent, tangent, 2 * tangent])
    y = shape.profile(x)
    circle = 0.2e-3 - np.sqrt(0.2e-3**2 - x[:3] ** 2)
    np.testing.assert_allclose(y[:3], circle, rtol=1e-12, atol=1e-18)
    assert (y[3] - y[2]) / tangent == pytest.approx(math.tan(math.pi / 6))


def test_the_standard_triangle_has_the_size_that_times_are_stated_for():
    mesh = TriangularSpecimen().mesh(MeshDensity())
    assert 2 * len(mesh.points) == 13752
    assert mesh.edge.size == 513
    first_row = mesh.points[:, 1][mesh.cells[:, 3]] - mesh.points[:, 1][mesh.cells[:, 0]]
    assert first_row[256 + 30] == pytest.approx(1e-3 / 512)


def test_a_first_height_is_kept():
    mesh = Rectangle(1e-3, 1e-3).mesh(MeshDensity(11, 5, first_height=5e-5))
    levels = np.unique(np.round(mesh.points[:, 1], 12))
    heights = np.diff(levels)
    assert heights[0] == pytest.approx(5e-5, rel=1e-6)
    np.testing.assert_allclose(heights[1:] / heights[:-1], heights[1] / heights[0], rtol=1e-5)


def test_rows_that_need_no_growth_are_even():
    mesh = Rectangle(1e-3, 1e-4).mesh(MeshDensity(11, 5, first_height=5e-5))
    levels = np.unique(np.round(mesh.points[:, 1], 12))
    np.testing.assert_allclose(np.diff(levels), 2e-5, rtol=1e-6)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Rectangle(-1e-3, 1e-3), "Rectangle: width = -0.001 must be above 0 m"),
        (lambda: Rectangle(1e-3, 0.0), "Rectangle: height = 0 must be above 0 m"),
        (
            lambda: Strip(1e-3, 1e-3, 2e-3),
            "Strip: the contact edge, 0.002 m wide, is not narrower than the body",
        ),
        (lambda: Strip(math.nan, 1e-3, 2e-3), "thickness = nan must be above 0 m"),
        (lambda: HalfCylinder(1e-3, 2e-3), "HalfCylinder: the contact edge, 0.002 m wide, is not narrower"),
        (lambda: HalfCylinder(0.0, 2e-3), "HalfCylinder: radius = 0 must be above 0 m"),
        (lambda: TriangularSpecimen(tip_radius=-1e-3), "tip_radius = -0.001 must be above 0 m"),
        (lambda: TriangularSpecimen(block_height=0.0), "block_height = 0 must be above 0 m"),
        (lambda: TriangularSpecimen(flank_angle=2.0), "flank_angle = 2 must be above 0 and below"),
        (lambda: TriangularSpecimen(tip_radius=6e-3), "tip_radius = 0.006 m does not fit between the flanks"),
        (lambda: TriangularSpecimen(edge_width=8e-3), "TriangularSpecimen: the contact edge, 0.008 m wide"),
        (lambda: MeshDensity(edge_nodes=2), "MeshDensity: edge_nodes = 2 must be at least 3"),
        (lambda: MeshDensity(rows=0), "MeshDensity: rows = 0 must be at least 2"),
        (lambda: MeshDensity(flank_columns=0), "MeshDensity: flank_columns = 0 must be at least 1"),
        (lambda: MeshDensity(first_height=-1.0), "MeshDensity: first_height = -1 must be above 0 m"),
    ],
)
def test_impossible_shapes_are_refused(make, said):
    with pytest.raises(ValueError, match=r"must|not narrower|fit") as caught:
        make()
    assert said in str(caught.value)


def test_the_tip_message_names_a_radius_that_is_accepted():
    with pytest.raises(ValueError, match=r"allowed is a tip_radius below 0\.0053033 m"):
        TriangularSpecimen(tip_radius=5.4e-3)
    TriangularSpecimen(tip_radius=5.3033e-3)


def test_a_half_cylinder_with_too_few_flank_columns_says_how_many_it_needs():
    with pytest.raises(ValueError, match="set rows to at least 3 and flank_columns to at least 3"):
        HalfCylinder(10e-3, 14e-3).mesh(MeshDensity(33, 3, flank_columns=2))
    HalfCylinder(10e-3, 14e-3).mesh(MeshDensity(33, 3, flank_columns=3))


def test_needles_are_refused_with_the_number_and_the_bound():
    with pytest.raises(
        ValueError, match=r"strip: the largest aspect of a cell is 2\.456e\+05, must be below 2000"
    ):
        Strip(1.0, 8e-3, 1e-3).mesh(MeshDensity(513, 20))


def square_of_cells():
    points = np.array([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]], dtype=float)
    return {
        "points": points,
        "cells": np.array([[0, 1, 4, 3], [1, 2, 5, 4]]),
        "edge": np.array([0, 1, 2]),
        "held": np.array([3, 4, 5]),
    }


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"points": np.zeros((6, 3))}, r"points of shape \(6, 3\)"),
        ({"points": np.full((6, 2), np.nan)}, "6 nodes of the mesh have no finite place"),
        ({"cells": np.array([[0, 1, 4, 6], [1, 2, 5, 4]])}, "cells name nodes outside 0 to 5"),
        ({"cells": np.array([[0, 1, 4, 3]])}, "2 nodes belong to no cell, the first is node 2"),
        ({"edge": np.array([2, 1, 0])}, "must ascend in x"),
        ({"edge": np.array([0, 1])}, "a contact edge of 2 nodes"),
        ({"held": np.array([2, 5])}, "a node of the contact edge is held"),
    ],
)
def test_a_mesh_that_is_none_is_refused(changed, said):
    BodyMesh(**square_of_cells())
    with pytest.raises(ValueError, match=said):
        BodyMesh(**square_of_cells() | changed)


def test_graded_cells_fill_the_length_in_a_constant_ratio():
    ends = graded(np.array([1e-6, 1e-4]), np.array([1e-3, 5e-3]), 12)
    sizes = np.diff(ends, axis=-1)
    np.testing.assert_allclose(sizes[:, 0], [1e-6, 1e-4], rtol=1e-9)
    np.testing.assert_allclose(ends[:, -1], [1e-3, 5e-3], rtol=1e-15)
    ratios = sizes[:, 1:] / sizes[:, :-1]
    np.testing.assert_allclose(ratios, ratios[:, :1] * np.ones(11), rtol=1e-9)


def test_graded_cells_end_even_where_asked():
    sizes = np.diff(graded(1e-3, 1.0, 10, even=3))
    np.testing.assert_allclose(sizes[-4:], sizes[-1], rtol=1e-12)
    assert sizes[5] < sizes[6]


def test_columns_grow_from_the_edge_on():
    x = symmetric_positions(1.0, 11, 4.0, 6)
    steps = np.diff(x)
    np.testing.assert_allclose(steps[6:16], 0.1)
    assert steps[16] == pytest.approx(0.1)
    assert np.all(np.diff(steps[16:]) > 0)
    np.testing.assert_array_equal(even_positions(1.0, 11), x[6:17])


def test_a_transfinite_block_keeps_its_sides_and_straight_lattices():
    lower, upper = np.array([[0.0, 0], [1, 0], [3, 0]]), np.array([[0.0, 2], [1, 2], [3, 2]])
    left, right = np.array([[0.0, 0], [0, 0.5], [0, 2]]), np.array([[3.0, 0], [3, 0.5], [3, 2]])
    block = transfinite(lower, upper, left, right)
    x, y = np.meshgrid([0.0, 1, 3], [0.0, 0.5, 2])
    np.testing.assert_allclose(block, np.stack([x, y], axis=-1), atol=1e-15)
    bent = left + np.array([[0, 0], [0.3, 0.1], [0, 0]])
    np.testing.assert_allclose(transfinite(lower, upper, bent, right)[:, 0], bent, atol=1e-15)


def test_blocks_join_in_the_nodes_that_they_share():
    x, y = np.meshgrid(np.linspace(0, 1, 4), np.linspace(0, 1, 3))
    first = np.stack([x, y], axis=-1)
    second = first + np.array([1.0, 1e-13])
    points, cells, numbers = join([first, second], 1e-9)
    assert len(points) == 2 * 12 - 3
    assert len(cells) == 12
    np.testing.assert_array_equal(numbers[0][:, -1], numbers[1][:, 0])
    np.testing.assert_allclose(points[numbers[1]], second, atol=1e-12)
