"""Meshes of all shapes: sound cells, no gaps, the area of the shape, and gentle growth from the contact on."""

import math

import numpy as np
import pytest

from softlub.solid.body import Body
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.mesh import BodyMesh
from softlub.solid.mesh_quality import cell_areas, inspect, sound
from softlub.solid.plate import PlateContact
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.half_cylinder import HalfCylinder
from softlub.solid.shapes.profile_file import ProfileFile
from softlub.solid.shapes.rectangle import Rectangle
from softlub.solid.shapes.strip import Strip
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.solid.steps import InContact, run

SHAPES = {
    "triangle": TriangularSpecimen(),
    "sharp_triangle": TriangularSpecimen(tip_radius=0.05e-3),
    "blunt_triangle": TriangularSpecimen(tip_radius=0.5e-3, flank_angle=math.radians(60)),
    "half_cylinder": HalfCylinder(10e-3, 14e-3),
    "half_cylinder_with_a_narrow_edge": HalfCylinder(10e-3, 2e-3),
    "rectangle": Rectangle(2e-3, 1e-3),
    "strip": Strip(1e-3, 8e-3, 1e-3),
}
DENSITIES = {
    "draft": MeshDensity(129, 10, flank_columns=20),
    "standard": MeshDensity(513, 11, flank_columns=30),
    "finer": MeshDensity(513, 20, flank_columns=40),
    "source": MeshDensity(1025, 20, flank_columns=40),
}


@pytest.mark.parametrize("density", DENSITIES.values(), ids=DENSITIES.keys())
@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES.keys())
def test_cells_are_sound(shape, density):
    mesh = shape.mesh(density)
    quality = inspect(mesh)
    assert quality.scaled_jacobian > 0.3
    assert quality.aspect < 2000
    assert quality.hanging_nodes == 0
    assert quality.boundaries == 1
    assert np.all(cell_areas(mesh) > 0)
    # Of a quadrilateral mesh of a disc: 4 m sides, the inner ones twice.
    sides = np.sort(np.stack([mesh.cells, np.roll(mesh.cells, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    assert len(mesh.points) - len(np.unique(sides, axis=0)) + len(mesh.cells) == 1


@pytest.mark.parametrize("rows", [11, 20, 40])
def test_the_triangle_grows_no_faster_than_its_rows(rows):
    mesh = TriangularSpecimen().mesh(MeshDensity(513, rows))
    depth = mesh.points[:, 1].max()
    ratio = np.roots([*np.ones(rows - 1), 1 - depth * 512e3])
    growth = ratio[np.isreal(ratio) & (ratio.real > 1)].real[0]
    widths = np.diff(mesh.points[: 513 + 60, 0])[-30:]
    assert inspect(mesh).jump == pytest.approx(max(growth, widths[-1] / widths[-2]), rel=0.01)


@pytest.mark.parametrize("name", ["triangle", "half_cylinder", "half_cylinder_with_a_narrow_edge"])
def test_cells_at_the_contact_are_nearly_square(name):
    shape = SHAPES[name]
    mesh = shape.mesh(DENSITIES["standard"])
    # Within a sixth of the tip's radius, where the surface is inclined by less than 10°.
    near = np.abs(mesh.points[mesh.cells, 0]).max(axis=1) < shape.tip_radius / 6
    first = mesh.cells[near & np.isin(mesh.cells[:, 0], mesh.edge) & np.isin(mesh.cells[:, 1], mesh.edge)]
    assert len(first) > 30
    quality = inspect(BodyMesh(*_part(mesh, first)))
    assert quality.scaled_jacobian > 0.9
    assert quality.aspect < 1.1


def _part(mesh, cells):
    nodes, numbers = np.unique(cells, return_inverse=True)
    cells = numbers.reshape(-1, 4)
    lowest = np.append(cells[:, 0], cells[-1, 1])
    return mesh.points[nodes], cells, lowest, np.setdiff1d(cells, lowest)


@pytest.mark.parametrize("name", ["rectangle", "strip"])
def test_straight_shapes_have_their_area_to_rounding(name):
    shape = SHAPES[name]
    assert inspect(shape.mesh(DENSITIES["draft"])).area == pytest.approx(shape.area, rel=1e-13)


@pytest.mark.parametrize("name", ["triangle", "half_cylinder"])
def test_the_area_converges_with_the_square_of_the_spacing(name):
    shape = SHAPES[name]
    spacings = [32, 64, 128]
    errors = [
        abs(inspect(shape.mesh(MeshDensity(cells + 1, 8, flank_columns=cells // 2))).area - shape.area)
        for cells in spacings
    ]
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(rates > 1.8)


def test_the_area_of_a_triangle_is_that_of_its_profile():
    shape = TriangularSpecimen(0.3e-3, 6e-3, math.radians(35), 1e-3, 1e-3)
    x = np.linspace(0, shape.width / 2, 200_001)
    below = 2 * np.trapezoid(shape.profile(x), x)
    assert shape.area == pytest.approx(shape.width * shape.height - below, rel=1e-9)


def test_a_wavy_measured_edge_is_meshed_soundly(tmp_path):
    x = np.linspace(-0.5, 0.5, 201)
    y = 0.05 * x**2 + 0.004 * np.cos(40 * x)
    rows = "\n".join(f"{a:.9g},{b:.9g}" for a, b in zip(x, y, strict=True))
    (tmp_path / "edge.csv").write_text(f"x [mm],y [mm]\n{rows}\n", encoding="utf-8")
    quality = inspect(ProfileFile(str(tmp_path / "edge.csv"), 4e-3, 2e-3).mesh(DENSITIES["standard"]))
    assert quality.scaled_jacobian > 0.9
    assert quality.hanging_nodes == 0


def test_a_half_cylinder_survives_an_indentation_of_three_tenths_of_its_radius():
    mesh = HalfCylinder(10e-3, 16e-3).mesh(MeshDensity(65, 8, flank_columns=24))
    body = Body(mesh, NeoHookean(0.5932e6, 1e-9))
    history = run(body, PlateContact(), [InContact(3e-3)])
    assert history.converged
    moved = BodyMesh(mesh.points + history.displacement, mesh.cells, mesh.edge, mesh.held)
    np.testing.assert_allclose(cell_areas(moved), cell_areas(mesh), rtol=0.01)
    # The free surface folds around the two ends of the held side, whatever the mesh.
    at_ends = np.isin(mesh.cells, np.flatnonzero(np.abs(mesh.points[:, 0]) > 10e-3 * (1 - 1e-9))).any(axis=1)
    assert at_ends.sum() == 2
    assert np.all(_scaled_jacobians(moved)[~at_ends] > 0.1)
    # The contact ends well inside the edge.
    touching = mesh.edge_positions[history.last.normal > 0]
    assert 6e-3 < touching.max() < 7e-3


def _scaled_jacobians(mesh):
    sides = np.roll(mesh.points[mesh.cells], -1, axis=1) - mesh.points[mesh.cells]
    sides /= np.linalg.norm(sides, axis=-1, keepdims=True)
    before = np.roll(sides, 1, axis=1)
    return np.min(before[..., 0] * sides[..., 1] - before[..., 1] * sides[..., 0], axis=1)


def mesh_of(points, cells, edge=(0, 1, 2), held=(3,)):
    return BodyMesh(np.array(points, dtype=float), np.array(cells), np.array(edge), np.array(held))


GRID = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]]


def test_numbers_of_two_squares():
    quality = inspect(mesh_of(GRID, [[0, 1, 4, 3], [1, 2, 5, 4]]))
    assert (quality.nodes, quality.cells, quality.edge_nodes) == (6, 2, 3)
    assert (quality.scaled_jacobian, quality.aspect, quality.jump, quality.area) == (1, 1, 1, 2)
    assert (quality.hanging_nodes, quality.boundaries) == (0, 1)


def test_numbers_of_oblique_and_of_unequal_cells():
    oblique = [[x + y, y] for x, y in GRID]
    quality = inspect(mesh_of(oblique, [[0, 1, 4, 3], [1, 2, 5, 4]]))
    assert quality.scaled_jacobian == pytest.approx(math.sqrt(0.5))
    assert quality.aspect == pytest.approx(math.sqrt(2))
    unequal = [[x**3, y] for x, y in GRID]
    assert inspect(mesh_of(unequal, [[0, 1, 4, 3], [1, 2, 5, 4]])).jump == pytest.approx(7)


def test_a_node_that_hangs_is_counted():
    # The upper cell spans both lower ones, whose middle node lies on its side.
    points = [*GRID, [0, 2], [2, 2]]
    quality = inspect(mesh_of(points, [[0, 1, 4, 3], [1, 2, 5, 4], [3, 5, 7, 6]]))
    assert quality.hanging_nodes == 1


def test_nodes_in_one_place_are_counted():
    points = [*GRID, [1, 0], [1, 1]]
    quality = inspect(mesh_of(points, [[0, 1, 4, 3], [6, 2, 5, 7]], edge=(0, 1, 2)))
    assert quality.hanging_nodes == 4


def test_a_hole_is_counted():
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0))
    corner = np.array([0, 1, 2, 4, 6, 8, 9, 10])
    cells = corner[:, None] + np.array([0, 1, 5, 4])
    quality = inspect(mesh_of(np.stack([x, y], axis=-1).reshape(-1, 2), cells, edge=(0, 1, 2, 3), held=(12,)))
    assert quality.boundaries == 2


@pytest.mark.parametrize(
    ("points", "cells", "said"),
    [
        (GRID, [[0, 3, 4, 1], [1, 4, 5, 2]], "the smallest scaled Jacobian is -1, must be above 0.02"),
        (GRID, [[0, 1, 4, 3], [1, 4, 5, 2]], "neighbouring cells of the mesh turn in opposite ways"),
        ([[x, 1e-4 * y] for x, y in GRID], [[0, 1, 4, 3], [1, 2, 5, 4]], "aspect of a cell is 1e+04"),
        (
            [[x, min(y, 0.0)] for x, y in GRID],
            [[0, 1, 4, 3], [1, 2, 5, 4]],
            "the smallest scaled Jacobian is nan",
        ),
        ([[2 * x, y] for x, y in GRID], [[0, 1, 4, 3], [1, 2, 5, 4]], "its area is 4 m², the shape's 2 m²"),
    ],
)
def test_an_unsound_mesh_is_refused(points, cells, said):
    with pytest.raises(ValueError, match=r"mesh") as caught:
        sound(mesh_of(points, cells), "test", area=2.0)
    assert said in str(caught.value)
