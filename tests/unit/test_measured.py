"""Instruments' files are read, prepared, or refused with a message that names them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from softlub.surfaces import (
    Profile,
    SelfAffine,
    Topography,
    read,
    read_profile,
    synthesize,
    synthesize_profile,
)
from softlub.surfaces.filtering import separate_form, separate_waviness, taper
from softlub.surfaces.measured import channels
from softlub.surfaces.preparation import Measured, prepare

DATA = Path(__file__).parents[3] / "shared" / "data"


def instrument_file(name: str) -> Path:
    path = DATA / name
    if not path.is_file():
        pytest.skip(f"{name} is not on this machine")
    return path


def matrix_file(
    path: Path, heights: np.ndarray, header: str = "Width: 20 um\nHeight: 10 um\nValue units: um"
) -> Path:
    """A text export: one row per y, in the unit of the header."""
    np.savetxt(path, heights.T, header=header)
    return path


def rough(shape: tuple[int, int] = (20, 10), seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=shape)


def test_text_export_is_read_in_metres_with_x_first(tmp_path):
    heights = rough()
    surface = read(matrix_file(tmp_path / "area.txt", heights))
    np.testing.assert_allclose(surface.heights, 1e-6 * heights, rtol=1e-12)
    assert surface.spacing == pytest.approx(1e-6, rel=1e-12)
    assert not surface.periodic


def test_line_scan_is_read_once_its_unit_is_stated(tmp_path):
    x = np.arange(50) * 0.5
    path = tmp_path / "line.xyz"
    np.savetxt(path, np.column_stack([x, np.sin(x)]))
    with pytest.raises(ValueError, match=r"line\.xyz: the file states no unit of length; state one"):
        read_profile(path)
    for unit, metres in (("um", 1e-6), ("µm", 1e-6), ("mm", 1e-3)):
        line = read_profile(path, unit=unit)
        assert line.spacing == pytest.approx(0.5 * metres)
        np.testing.assert_allclose(line.heights, metres * np.sin(x), rtol=1e-9)
    with pytest.raises(ValueError, match=r"line\.xyz.*holds a line: read it with read_profile"):
        read(path, unit="um")
    with pytest.raises(ValueError, match=r"line\.xyz: cannot be read.*furlong"):
        read_profile(path, unit="furlong")


def test_uneven_line_scan_is_brought_onto_even_points(tmp_path):
    x = np.sort(np.random.default_rng(1).uniform(0, 10, 200))
    path = tmp_path / "line.xyz"
    np.savetxt(path, np.column_stack([x, 3 * x + 1]))
    line = read_profile(path, unit="um")
    assert line.heights.size == 200
    np.testing.assert_allclose(np.diff(line.heights), 3 * line.spacing, rtol=1e-9)


def test_missing_points_need_a_rule(tmp_path):
    x, y = np.meshgrid(np.arange(20.0), np.arange(10.0), indexing="ij")
    heights = x + 2 * y
    heights[7:10, 4:6] = np.nan
    path = matrix_file(tmp_path / "holes.txt", heights)
    with pytest.raises(ValueError, match=r"holes\.txt: 6 of 200 points are missing .* missing: fill"):
        read(path)
    # A plane is harmonic, so the filling restores it.
    filled = read(path, missing="fill")
    np.testing.assert_allclose(filled.heights, 1e-6 * (x + 2 * y), rtol=1e-9)
    with pytest.raises(
        ValueError, match=r"holes\.txt: rule for missing points 'guess' is unknown; allowed: refuse, fill"
    ):
        read(path, missing="guess")


def test_surfaces_that_are_none_are_refused(tmp_path):
    infinite = rough()
    infinite[3, 4] = np.inf
    for name, heights, message in (
        ("infinite.txt", infinite, "1 of 200 points are missing .not measured, NaN or infinite"),
        ("flat.txt", np.full((20, 10), 3.0), "all heights are equal"),
    ):
        with pytest.raises(ValueError, match=rf"{name}: .*{message}"):
            read(matrix_file(tmp_path / name, heights))


def test_oblong_pixels_are_refused(tmp_path):
    header = "Width: 20 um\nHeight: 20 um\nValue units: um"
    with pytest.raises(ValueError, match=r"area\.txt: pixels of 1e-06 m × 2e-06 m are not square"):
        read(matrix_file(tmp_path / "area.txt", rough(), header))


def test_a_stated_unit_must_not_contradict_the_file(tmp_path):
    path = matrix_file(tmp_path / "area.txt", rough())
    assert read(path, unit="um").spacing == pytest.approx(1e-6)
    with pytest.raises(ValueError, match=r"area\.txt: the file states its unit as um, not mm"):
        read(path, unit="mm")


def test_unreadable_files_are_named(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"nowhere\.di: no such file"):
        read(tmp_path / "nowhere.di")
    noise = tmp_path / "noise.opd"
    noise.write_bytes(b"\x01\x00Directory" + bytes(200))
    with pytest.raises(ValueError, match=r"noise\.opd: cannot be read as a topography: OPDReader: "):
        read(noise)
    letter = tmp_path / "letter.doc"
    letter.write_text("Dear Sir or Madam,\n")
    with pytest.raises(ValueError, match=r"letter\.doc: cannot be read .* none of the formats"):
        read(letter)
    broken = matrix_file(tmp_path / "broken.txt", rough())
    broken.write_text(broken.read_text()[:-40])
    with pytest.raises(
        ValueError, match=r"broken\.txt: cannot be read as a topography: AscReader: .*truncated"
    ):
        read(broken)


def test_too_few_points_are_refused():
    with pytest.raises(ValueError, match="at least 2 by 2"):
        Topography(np.zeros((1, 5)), 1e-6)
    with pytest.raises(ValueError, match="at least 2 points"):
        Profile(np.zeros(1), 1e-6)
    with pytest.raises(ValueError, match="1 heights are NaN or infinite"):
        Profile(np.array([0.0, np.nan]), 1e-6)
    with pytest.raises(ValueError, match="spacing"):
        Profile(np.zeros(3), 0.0)


@pytest.mark.parametrize("form", ["mean", "tilt", "curvature"])
def test_form_is_taken_off_and_the_parts_add_up(form):
    x = np.arange(40)[:, None] * 1e-6
    y = np.arange(30) * 1e-6
    shapes = {
        "mean": 3e-6 + 0 * x * y,
        "tilt": 0.1 * x - 0.3 * y + 1e-6,
        "curvature": 50 * x**2 - 20 * x * y + 0.1 * y,
    }
    finite = Topography(shapes[form] + 1e-9 * rough((40, 30)), 1e-6, periodic=False)
    kept, removed = separate_form(finite, form)
    np.testing.assert_allclose(kept.heights + removed.heights, finite.heights, rtol=0, atol=1e-18)
    assert np.std(kept.heights) < 1.1e-9
    np.testing.assert_allclose(removed.heights, shapes[form], rtol=0, atol=3e-9)
    again = separate_form(kept, form)
    assert np.abs(again.removed.heights).max() < 1e-18


def test_form_of_a_line():
    x = np.arange(100) * 1e-6
    line = Profile(0.02 * x + 30 * x**2 + 1e-9 * np.cos(x / 3e-6), 1e-6)
    assert np.abs(separate_form(line, "curvature").kept.heights).max() < 1.3e-9
    with pytest.raises(ValueError, match="form 'cubic' is unknown; allowed: mean, tilt, curvature"):
        separate_form(line, "cubic")


@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize("ratio", [0.5, 1.0, 2.0])
def test_gaussian_filter_transmits_as_the_standard_says(periodic, ratio):
    """A wave of λ is left in the waviness with the share 2^(−(λ_c/λ)²)."""
    x = np.arange(2000) * 1e-6
    wavelength = 100e-6
    line = Profile(1e-6 * np.sin(2 * np.pi * x / wavelength), 1e-6, periodic)
    rough_part, wavy = separate_waviness(line, ratio * wavelength)
    inner = slice(500, 1500)
    share = np.dot(wavy.heights[inner], line.heights[inner]) / np.dot(
        line.heights[inner], line.heights[inner]
    )
    assert share == pytest.approx(2.0 ** -(ratio**2), rel=1e-6)
    np.testing.assert_allclose(rough_part.heights + wavy.heights, line.heights, rtol=0, atol=1e-20)


def test_filter_of_an_area_is_isotropic_and_agrees_inside_with_the_periodic_one():
    spectrum = SelfAffine(1e-6, 0.8, 2 * np.pi / 5e-5, 2 * np.pi / 5e-6, 2 * np.pi / 2e-4)
    surface = synthesize(spectrum, 4e-4, 200, seed=1)
    periodic = separate_waviness(surface, 3e-5).removed.heights
    finite = separate_waviness(replace(surface, periodic=False), 3e-5).removed.heights
    inner = (slice(50, 150), slice(50, 150))
    np.testing.assert_allclose(finite[inner], periodic[inner], rtol=0, atol=1e-10)
    mirrored = separate_waviness(replace(surface, heights=surface.heights.T.copy()), 3e-5).removed.heights
    np.testing.assert_allclose(mirrored.T, periodic, rtol=0, atol=1e-18)
    # A constant stays whole in the waviness, up to the edges.
    flat = Topography(np.full((40, 60), 2e-6), 1e-6, periodic=False)
    np.testing.assert_allclose(separate_waviness(flat, 2e-5).removed.heights, 2e-6, rtol=1e-12)


@pytest.mark.parametrize("wavelength", [0.0, 2e-6, float("inf"), float("nan")])
def test_waviness_shorter_than_the_grid_is_refused(wavelength):
    with pytest.raises(ValueError, match="longer than two spacings"):
        separate_waviness(Profile(np.arange(10.0), 1e-6), wavelength)


def test_taper_makes_a_finite_surface_periodic():
    finite = Topography(1e-6 * rough((101, 80)) + 5e-6, 1e-6, periodic=False)
    tapered = taper(finite, 0.4)
    assert tapered.periodic
    assert np.abs(tapered.heights[[0, -1]]).max() < 1e-2 * np.std(finite.heights)
    inner = (slice(25, 75), slice(20, 60))
    np.testing.assert_allclose(
        tapered.heights[inner], (finite.heights - finite.heights.mean())[inner], rtol=0, atol=1e-18
    )
    for fraction in (0.0, 1.5, float("nan")):
        with pytest.raises(ValueError, match="fraction"):
            taper(finite, fraction)


def test_the_three_stages_of_figure_4_1():
    """Raw line, form off, waviness off: what was put in is found again."""
    spectrum = SelfAffine(0.3e-6, 0.8, 2 * np.pi / 1e-4, 2 * np.pi / 4e-6)
    texture = synthesize_profile(spectrum, 8e-3, 8000, seed=1)
    x = texture.positions
    wave = 2e-6 * np.sin(2 * np.pi * x / 3.2e-3)
    raw = Profile(texture.heights + wave + 1e-3 * x, texture.spacing)
    level = separate_form(raw, "tilt").kept
    roughness, waviness = separate_waviness(level, 0.8e-3)
    assert np.ptp(raw.heights) > np.ptp(level.heights) > np.ptp(roughness.heights)
    inner = slice(800, -800)
    assert np.corrcoef(roughness.heights[inner], texture.heights[inner])[0, 1] > 0.95
    assert np.corrcoef(waviness.heights[inner], wave[inner])[0, 1] > 0.95


def test_preparation_follows_the_study(tmp_path):
    x = np.arange(64.0)[:, None]
    heights = 0.3 * x + 2 * np.sin(2 * np.pi * x / 64) + 0.05 * rough((64, 64))
    heights[10, 10] = np.nan
    path = matrix_file(tmp_path / "area.txt", heights, "Width: 64 um\nHeight: 64 um\nValue units: um")
    raw = prepare(Measured(str(path), missing="fill", form="mean"))
    level = prepare(Measured(str(path), missing="fill"))
    fine = prepare(Measured(str(path), missing="fill", waviness_wavelength=1e-5))
    faded = prepare(Measured(str(path), missing="fill", waviness_wavelength=1e-5, tapered_fraction=0.5))
    spreads = [np.std(surface.heights) for surface in (raw, level, fine, faded)]
    assert spreads == sorted(spreads, reverse=True)
    assert spreads[2] < 0.1e-6
    assert [surface.periodic for surface in (raw, level, fine, faded)] == [False, False, False, True]
    with pytest.raises(ValueError, match="missing"):
        prepare(Measured(str(path)))


def test_profilometer_export():
    surface = read(instrument_file("profilometry-650x650.txt"))
    assert surface.heights.shape == (650, 650)
    assert surface.size[0] == pytest.approx(240.4103e-6, rel=1e-6)
    assert np.std(separate_form(surface, "tilt").kept.heights) == pytest.approx(0.28e-6, rel=0.03)


def test_atomic_force_microscope_has_several_channels():
    path = instrument_file("afm-512x512.di")
    assert channels(path) == ["Height", "Height", "Phase", "AmplitudeError"]
    first, second = read(path), read(path, channel=1)
    assert first.size == pytest.approx((500e-9, 500e-9))
    assert not np.array_equal(first.heights, second.heights)
    np.testing.assert_array_equal(read(path, channel=0).heights, first.heights)
    for channel, message in (
        ("Depth", "no channel 'Depth'; it has 0: Height, 1: Height, 2: Phase, 3: AmplitudeError"),
        (9, "no channel 9; it has 0: Height"),
        ("Height", "2 channels are called 'Height'; choose by number: 0, 1"),
        ("Phase", "channel 'Phase' holds no heights"),
    ):
        with pytest.raises(ValueError, match=message):
            read(path, channel=channel)


def test_interferometer_with_missing_points():
    path = instrument_file("interferometry-missing-640x480.opd")
    with pytest.raises(ValueError, match=r"\.opd: 116 of 307200 points are missing"):
        read(path)
    surface = read(path, missing="fill")
    assert surface.size == pytest.approx((126e-6, 94e-6), rel=0.01)
    assert np.all(np.isfinite(surface.heights))


def test_stylus_line():
    path = instrument_file("line-scan-10001.txt")
    with pytest.raises(ValueError, match="states no unit"):
        read_profile(path)
    line = read_profile(path, unit="mm")
    assert line.heights.size == 10001
    assert line.spacing == pytest.approx(9.9561e-8, rel=1e-4)
    level = separate_form(line).kept
    assert np.std(separate_waviness(level, 8e-5).kept.heights) < 0.8 * np.std(level.heights)
    with pytest.raises(ValueError, match="holds a line"):
        read(path, unit="mm")


@pytest.mark.parametrize("share", [0.5, 0.001])
@pytest.mark.parametrize(
    "name", ["profilometry-650x650.txt", "afm-512x512.di", "interferometry-missing-640x480.opd"]
)
def test_truncated_instrument_files_are_named(tmp_path, name, share, capfd):
    content = instrument_file(name).read_bytes()
    path = tmp_path / name
    path.write_bytes(content[: int(share * len(content))])
    with pytest.raises(
        ValueError, match=rf"{name}: .*(truncated|not large enough|ended after|does not match)"
    ) as caught:
        read(path, missing="fill")
    assert len(str(caught.value)) < len(str(path)) + 500
    assert capfd.readouterr() == ("", "")
