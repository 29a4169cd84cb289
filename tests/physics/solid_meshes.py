"""Small meshes and a plain material for tests of the solid's mechanics."""

from dataclasses import dataclass

import felupe
import numpy as np

from softlub.solid.mesh import BodyMesh


@dataclass(frozen=True)
class Rubber:
    """Neo-Hooke by felupe itself."""

    shear_modulus: float = 1.19e6
    bulk_modulus: float = 2e9

    def element_material(self):
        return felupe.NeoHooke(mu=self.shear_modulus)


@dataclass(frozen=True)
class PlainMesh:
    """Nodes and elements, for tests without contact."""

    points: np.ndarray
    cells: np.ndarray


def rectangle(width, height, columns, rows):
    """Nodes (n, 2) and elements of a block from the origin, numbered row by row from the bottom."""
    x, y = np.meshgrid(np.linspace(0, width, columns + 1), np.linspace(0, height, rows + 1))
    first = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    cells = np.stack([first, first + 1, first + columns + 2, first + columns + 1], axis=1)
    return PlainMesh(np.column_stack([x.ravel(), y.ravel()]), cells)


def distorted(mesh, amount, seed=1):
    """The mesh with its inner nodes moved by up to `amount`."""
    points = mesh.points.copy()
    inner = np.all((points > points.min(axis=0)) & (points < points.max(axis=0)), axis=1)
    shift = np.random.default_rng(seed).uniform(-amount, amount, points.shape)
    points[inner] += shift[inner]
    return PlainMesh(points, mesh.cells)


def on_the_edge(mesh):
    """Which nodes lie on the outline of a block."""
    points = mesh.points
    return np.any((points == points.min(axis=0)) | (points == points.max(axis=0)), axis=1)


def rounded_block(columns=24, rows=6, radius=1e-3, width=1e-3, height=1e-3):
    """A block with a parabolic underside, x² / (2 radius), held at its top."""
    plain = rectangle(width, height, columns, rows)
    x, y = plain.points.T
    x = x - width / 2
    bottom = x**2 / (2 * radius)
    points = np.column_stack([x, bottom + (height - bottom) * y / height])
    nodes = np.arange(len(points))
    return BodyMesh(points, plain.cells, nodes[: columns + 1], nodes[-(columns + 1) :])
