"""Pictures of meshes: what they show and what they record."""

import numpy as np
import pytest

from softlub.figures import deformed_mesh, mesh
from softlub.figures.panel import styled
from softlub.figures.save import table
from softlub.solid.mesh_dataset import mesh_dataset
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.solid.von_mises import von_mises


@pytest.fixture(scope="module")
def body():
    return TriangularSpecimen().mesh(MeshDensity(33, 6, flank_columns=8))


@pytest.fixture(scope="module")
def squeezed(body):
    """Lower in proportion to the height, coloured by the distance from the plate, but for one singular cell."""
    height = body.points[:, 1]
    displacement = np.stack([np.zeros_like(height), 0.1 * (height.max() - height)], axis=1)
    stress = 0.9e6 - 1e8 * body.points[body.cells, 1].mean(axis=1)
    stress[-1] = 1e9
    return mesh_dataset(body, displacement, {"stress_von_mises": stress})


def drawn(figure):
    with styled():
        figure.draw_without_rendering()
    return figure


def test_the_mesh_shows_its_edge_and_its_held_nodes(body):
    figure = drawn(mesh.draw(mesh_dataset(body)))
    shown = {(one.panel, one.series): one for one in figure.series}
    np.testing.assert_array_equal(shown["a", "contact edge"].x, body.edge_positions)
    held = shown["a", "nodes held by the holder"]
    np.testing.assert_allclose(held.y, body.points[:, 1].max())
    assert held.x.size == body.held.size
    assert f"{len(body.cells)} cells, 33 nodes" in figure.notes[0]


def test_lines_of_fine_cells_are_thinner(body):
    figure = drawn(mesh.draw(mesh_dataset(body)))
    widths = np.asarray(figure.axes[0].collections[0].get_linewidths())
    assert widths.min() < 0.5 * widths.max()


def test_a_deformed_mesh_is_coloured_where_it_now_is(body, squeezed):
    figure = drawn(deformed_mesh.draw(squeezed))
    cells = next(one for one in figure.series if (one.panel, one.series) == ("a", "cells"))
    assert cells.z.size == len(body.cells)
    assert cells.y.min() > 0.09 * body.points[:, 1].max()
    border = next(one for one in figure.series if one.series == "body at rest")
    assert border.y.min() == 0.0
    assert (border.x[0], border.y[0]) == (border.x[-1], border.y[-1])
    assert table(figure).startswith("panel,series,x [m],y [m],stress_von_mises [Pa]")


def test_one_singular_cell_does_not_take_the_colours(squeezed):
    without = squeezed.copy(deep=True)
    without["stress_von_mises"][-1] = 0.0
    figures = [drawn(deformed_mesh.draw(dataset)) for dataset in (squeezed, without)]
    limits = [axes.collections[0].get_clim() for figure in figures for axes in figure.axes[:2]]
    assert len(set(limits)) == 1
    assert figures[0].axes[-1].get_ylabel() == "von Mises stress (kPa)"


def test_von_mises_of_simple_states():
    uniaxial = np.diag([3e6, 0.0, 0.0])
    shear = np.array([[0.0, 2e6, 0], [2e6, 0, 0], [0, 0, 0]])
    stress = np.stack([uniaxial, shear, -5e6 * np.eye(3), uniaxial + 7e6 * np.eye(3)])
    np.testing.assert_allclose(von_mises(stress), [3e6, np.sqrt(3) * 2e6, 0, 3e6], atol=1e-6)
