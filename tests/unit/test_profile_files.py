"""Measured contact edges: what a file may hold, and what is said about one that may not."""

import numpy as np
import pytest

from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.profile import edge_profile
from softlub.solid.shapes.profile_file import ProfileFile

DENSITY = MeshDensity(edge_nodes=65, rows=10, flank_columns=12)
RADIUS = 0.2e-3


def parabola(points=41):
    x = np.linspace(-50.0, 50.0, points)
    return x, x**2 / (2 * RADIUS * 1e6)


def write(path, rows, header="x [um],y [um]"):
    lines = [
        header,
        *(",".join(f"{value:.12g}" if isinstance(value, float) else value for value in row) for row in rows),
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


@pytest.fixture
def file(tmp_path):
    return tmp_path / "edge.csv"


def shape(file, width=1e-3, height=0.5e-3):
    return ProfileFile(str(file), width, height)


def refused(body):
    with pytest.raises(ValueError, match=r"\S") as caught:
        body.mesh(DENSITY)
    return str(caught.value)


def test_a_parabola_comes_back(file):
    write(file, zip(*parabola(), strict=True))
    mesh = shape(file).mesh(DENSITY)
    x = mesh.edge_positions
    assert np.ptp(x) == pytest.approx(100e-6)
    assert np.ptp(np.diff(x)) < 1e-12 * np.ptp(x)
    # Monotone cubics between points 2.5 µm apart, whose slope falls short at the ends and the apex.
    np.testing.assert_allclose(mesh.base_gap, x**2 / (2 * RADIUS), atol=3e-9)
    assert mesh.points[:, 1].max() == pytest.approx(0.5e-3)
    assert np.ptp(mesh.points[:, 0]) == pytest.approx(1e-3)


def test_the_interpolated_edge_converges_to_the_measured_curve(file):
    errors = []
    for points in (21, 41, 81):
        write(file, zip(*parabola(points), strict=True))
        x = shape(file).edge.positions
        between = (x[1:] + x[:-1]) / 2
        errors.append(np.abs(shape(file).edge.at(between) - between**2 / (2 * RADIUS)).max())
    assert errors[0] / errors[1] > 3
    assert errors[1] / errors[2] > 3


def test_units_order_level_and_comments_do_not_matter(file, tmp_path):
    x, y = parabola()
    write(file, zip(x, y, strict=True))
    other = tmp_path / "other.csv"
    rows = [(b, a) for a, b in zip((x[::-1] + 300) * 1e-3, (y + 70) * 1e-6, strict=True)]
    write(other, rows, header="# worn tip, stylus\ny [m] , x [mm]")
    one, two = shape(file).mesh(DENSITY), shape(other).mesh(DENSITY)
    np.testing.assert_allclose(one.points, two.points, atol=1e-14)


def test_the_apex_is_the_origin_of_a_lopsided_edge(file):
    x, y = parabola()
    write(file, zip(x[10:], y[10:], strict=True))
    mesh = shape(file).mesh(DENSITY)
    lowest = mesh.points[mesh.edge[np.argmin(mesh.base_gap)]]
    np.testing.assert_allclose(lowest, 0.0, atol=1.5e-6)
    assert mesh.points[:, 0].min() + mesh.points[:, 0].max() == pytest.approx(25e-6)


def test_the_area_is_the_closed_form(file):
    write(file, zip(*parabola(), strict=True))
    body = shape(file)
    half, end = 50e-6, 50e-6**2 / (2 * RADIUS)
    exact = 1e-3 * 0.5e-3 - 2 * half * end / 3 - end * (1e-3 - 2 * half)
    assert body.area == pytest.approx(exact, rel=1e-6)


def test_a_loop_is_said_to_cross_itself(file):
    angle = np.linspace(-2 * np.pi, 2 * np.pi, 60)
    loop = zip(angle - 2 * np.sin(angle), 1 - np.cos(angle), strict=True)
    message = refused(shape(write(file, loop)))
    assert str(file) in message
    assert "crosses itself: the piece from point" in message
    assert "delete" in message


def test_an_overhang_is_said_to_have_two_heights(file):
    x = np.array([0, 1, 2, 3, 4, 5, 6, 5.5, 5, 5.2, 6, 7, 8])
    y = np.array([5, 4, 3, 2, 1, 0, 1, 2.0, 3, 4.0, 5, 6, 7])
    message = refused(shape(write(file, zip(x, y, strict=True))))
    assert f"{file}: the contact edge has two heights at one x: from point 7" in message
    assert "to point 8" in message


def test_an_upright_step_is_refused(file):
    x, y = parabola()
    x[20] = x[19]
    assert "two heights at one x: from point 20" in refused(shape(write(file, zip(x, y, strict=True))))


def test_nine_points_are_too_few(file):
    message = refused(shape(write(file, zip(*parabola(9), strict=True))))
    assert f"{file}: a contact edge of 9 points; at least 10 are needed" in message
    shape(write(file, zip(*parabola(10), strict=True))).mesh(DENSITY)


@pytest.mark.parametrize(
    ("header", "row", "said"),
    [
        ("x [um],y [um]", ("nan", "1"), "line 7: x = nan is not finite"),
        ("x [um],y [um]", ("3", "inf"), "line 7: y = inf is not finite"),
        ("x [um],y [um]", ("3", "high"), 'line 7: y = "high" is no number'),
        ("x [um],y [um]", ("1,5", "2,5"), "line 7: 4 entries below 2 columns; a decimal comma?"),
        ("x [um],y [um]", ('"1,5"', "2.5"), 'line 7: x = "1,5" has a decimal comma'),
        ("x [um],z [um]", ("3", "1"), 'line 1: the column "z" is unknown; the header must be x [mm],y [mm]'),
        ("x [um]", ("3",), "line 1: the column y is missing"),
        ("x [um],y", ("3", "1"), "line 1: y has no unit; allowed: mm, m, um"),
        (
            "x [um],y [inch]",
            ("3", "1"),
            'line 1: the unit "inch" of the column y is unknown; allowed: mm, m, um',
        ),
        ("x [um];y [um]", ("3;1",), "line 1: columns are separated by semicolons"),
    ],
)
def test_rows_that_are_no_points_are_refused(file, header, row, said):
    rows = [row if index == 5 else (str(10.0 * index), "0") for index in range(14)]
    message = refused(shape(write(file, rows, header)))
    assert f"{file}, {said}" in message


def test_a_missing_file_is_named(file):
    with pytest.raises(FileNotFoundError, match=r"edge\.csv: no such file"):
        shape(file).mesh(DENSITY)


def test_bytes_are_refused(file):
    file.write_bytes(bytes(range(200, 256)))
    assert "is no text in UTF-8" in refused(shape(file))


def test_an_edge_wider_than_the_body_is_refused(file):
    write(file, zip(*parabola(), strict=True))
    message = refused(shape(file, width=0.1e-3))
    assert f"{file}: the contact edge, 0.0001 m wide, is not narrower than the body, 0.0001 m" in message


def test_an_edge_higher_than_the_body_is_refused(file):
    write(file, zip(*parabola(), strict=True))
    message = refused(shape(file, height=5e-6))
    assert f"{file}: the contact edge rises 6.25e-06 m above its lowest point" in message


@pytest.mark.parametrize(("width", "height"), [(0.0, 1e-3), (1e-3, -1e-3)])
def test_sizes_that_are_not_positive_are_refused(file, width, height):
    with pytest.raises(ValueError, match=r"ProfileFile: .* must be above 0 m"):
        shape(file, width, height)


def test_points_given_as_arrays_are_checked_alike():
    x, y = parabola()
    y[3] = np.nan
    with pytest.raises(ValueError, match="point 4 is not finite"):
        edge_profile(x, y)
