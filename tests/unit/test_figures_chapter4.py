"""Drawings of chapter 4: what they show, what they say about it, and that nothing drawn is lost from the data."""

import csv
import io

import numpy as np
import pytest
from synthetic_contact import DATASETS, LOADS, areas, deflections, maps, surface, table, validation, with_axes

from softlub.claims.printed_surfaces import rows
from softlub.datasets.contact_curves import (
    contact_curve,
    inputs,
    local_kappa,
    secant_kappa,
    surfaces,
    window_kappa,
)
from softlub.figures import draw
from softlub.figures.quantities import Quantity
from softlub.figures.save import table as written
from softlub.figures.surface_labels import surface_labels


@pytest.fixture(scope="module")
def figures():
    return {name: draw(name, make()) for name, make in DATASETS.items()}


def texts(figure):
    legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes)]
    return [text.get_text() for legend in legends if legend is not None for text in legend.get_texts()]


@pytest.mark.parametrize("name", DATASETS)
def test_axes_carry_units(figures, name):
    for axes in figures[name].axes:
        labels = [label for label in (axes.get_ylabel(), axes.get_xlabel()) if label]
        assert all("(" in label and label.endswith(")") for label in labels), labels


@pytest.mark.parametrize("name", DATASETS)
def test_lines_show_the_recorded_data(figures, name):
    drawn = [line.get_xydata() for axes in figures[name].axes for line in axes.lines]
    assert figures[name].series
    for series in figures[name].series:
        if series.z is not None:
            continue
        expected = np.column_stack([series.x_quantity.shown(series.x), series.y_quantity.shown(series.y)])
        assert any(
            line.shape == expected.shape and np.array_equal(line, expected, equal_nan=True) for line in drawn
        ), series.series


@pytest.mark.parametrize("name", DATASETS)
def test_csv_holds_every_point(figures, name):
    read = list(csv.DictReader(io.StringIO(written(figures[name]))))
    assert len(read) == sum(series.x.size for series in figures[name].series)


# labels


def test_surfaces_are_named_by_what_tells_them_apart():
    def labels(name, largest=8192):
        return surface_labels([inputs(one) for one in surfaces(table(name, largest))])

    assert labels("table_4_2") == ["N = 1024", "N = 2048", "N = 4096", "N = 8192"]
    assert labels("table_4_5") == ["H = 0.1", "H = 0.3", "H = 0.5", "H = 0.8"]
    assert all("lambda_\\mathrm{s}" in label and "N" not in label for label in labels("table_4_4"))
    assert [label[-1] for label in labels("table_4_3")] == ["1", "2", "4", "8"]


def test_equal_surfaces_are_numbered():
    assert surface_labels([{"hurst": 0.8}, {"hurst": 0.8}]) == ["no. 1", "no. 2"]
    assert surface_labels([{"hurst": 0.8}]) == [""]


def test_prefixes_of_areas_and_inverse_lengths():
    assert Quantity("a", "a", "m²", -12).shown_unit == "µm²"
    assert Quantity("d", "d", "1/m", 6).shown_unit == "1/µm"


# curves


def test_kappa_of_a_straight_line_is_its_slope():
    load = np.geomspace(1e-3, 1, 20)
    assert window_kappa(load, 1.9 * load) == pytest.approx(1.9, rel=1e-3)
    assert np.allclose(local_kappa(load, 1.9 * load), 1.9)
    assert np.allclose(secant_kappa(load, 1.9 * load), 1.9)


def test_kappa_of_the_window_does_not_hang_on_the_loads():
    """∫Ax/∫x² of A = erf(√2 x) up to A = 0.2, by quadrature, from 8 and from 60 loads."""
    from scipy.integrate import quad
    from scipy.special import erf, erfinv

    end = erfinv(0.2) / np.sqrt(2)
    exact = quad(lambda x: erf(np.sqrt(2) * x) * x, 0, end)[0] / quad(lambda x: x * x, 0, end)[0]
    for count in (8, 60):
        load = np.geomspace(1e-3, 1, count)
        assert window_kappa(load, erf(np.sqrt(2) * load)) == pytest.approx(exact, rel=2e-3)


def test_kappa_needs_three_loads_in_the_window():
    load = np.array([0.01, 0.02, 0.5, 0.9])
    assert np.isnan(window_kappa(load, 2 * load))
    gap = np.where(np.arange(20) == 3, np.nan, 1.0)
    assert np.isfinite(window_kappa(np.geomspace(1e-3, 1, 20), gap * 2 * np.geomspace(1e-3, 1, 20)))


def test_a_curve_averages_the_realisations_that_converged():
    one = with_axes(surface(rows("table_4_1")[0], 3))
    one["contact_area_ratio"][0] *= 1.3
    one["converged"][1, 4] = False
    curve = contact_curve(one)
    area = one["contact_area_ratio"].values
    assert np.allclose(curve.load, LOADS)
    assert curve.mean["contact_area_ratio"][4] == pytest.approx(area[[0, 2], 4].mean())
    assert curve.mean["contact_area_ratio"][5] == pytest.approx(area[:, 5].mean())
    assert curve.high["contact_area_ratio"][5] == pytest.approx(area[0, 5])
    assert list(np.flatnonzero(curve.failed)) == [4]


def test_padding_is_no_realisation_and_no_surface():
    """Surfaces made once beside others made thrice are filled up with NaN; those not made at all are left out."""
    whole = table("table_4_3")
    padded = whole.copy(deep=True)
    padded["rms_slope_spectral"][0, 1] = np.nan
    padded["contact_area_ratio"][0, 1] = np.nan
    padded["rms_slope_spectral"][1] = np.nan
    kept = list(surfaces(padded))
    assert len(kept) == len(list(surfaces(whole))) - 1
    assert contact_curve(kept[0]).realisations == 1
    assert not contact_curve(kept[0]).failed.any()


# what each drawing shows


def test_area_and_separation_counts_the_area_twice(figures):
    names = [series.series for series in figures["area_and_separation"].series if series.panel == "a"]
    assert any("pixels counted" in name for name in names)
    assert {"Persson, κ = 1.60", "Bush, Gibson, Thomas, κ = 2.51"} <= set(
        texts(figures["area_and_separation"])
    )


def test_area_and_separation_marks_failed_loads():
    failed = table("table_4_3")
    failed["converged"][0, :, 5] = False
    figure = draw("area_and_separation", failed)
    marks = [line for axes in figure.axes for line in axes.lines if line.get_gid() == "failed"]
    assert len(marks) == 3
    assert "did not converge" in texts(figure)
    (area,) = (s for s in figure.series if s.panel == "b" and s.series.endswith(" = 1"))
    assert np.isnan(area.y[5])
    assert np.isfinite(area.y[6])


def test_area_ends_where_the_window_does(figures):
    area = figures["area_and_separation"].axes[0]
    assert area.get_ylim() == (0.0, 0.2)
    lines = [s for s in figures["area_and_separation"].series if s.panel == "a" and "pixels" not in s.series]
    assert all(s.y.max() >= 0.2 for s in lines)


def test_profile_stages_add_up(figures):
    series = {s.series: s.y for s in figures["profile_stages"].series}
    raw = series["form"] + series["waviness"] + series["waviness removed: roughness"]
    assert np.allclose(raw, series["raw"], atol=1e-12)


def test_lines_of_the_height_distribution_are_normalised(figures):
    for series in figures["spectra_and_heights"].series:
        if "relative_height" in series.x_quantity.name:
            assert np.trapezoid(series.y, series.x) == pytest.approx(1.0, abs=2e-2)


def test_spectra_follow_the_asked_ones(figures):
    series = {s.series: s for s in figures["spectra_and_heights"].series if s.panel == "a"}
    asked = [name for name in series if name.endswith(", asked")]
    assert asked
    for name in asked:
        measured = series[name.removesuffix(", asked")]
        known = np.isfinite(measured.y)
        expected = np.interp(np.log(measured.x[known]), np.log(series[name].x), np.log(series[name].y))
        assert np.allclose(np.log(measured.y[known])[1:-1], expected[1:-1], atol=0.05)


def test_the_spectrum_of_lines_stands_beside_both_factors(figures):
    series = {s.series: s.y for s in figures["surface_spectra"].series}
    printed = next(y for name, y in series.items() if "printed" in name)
    right = next(y for name, y in series.items() if name.startswith("3.42"))
    assert np.allclose(right / printed, 3.4159 / np.pi, rtol=1e-3)


def test_a_map_of_many_points_is_thinned():
    many = areas().drop_vars(["height", "x", "y"])
    points = 1100
    many = many.assign(height=(("x", "y"), np.ones((points, points)) * np.arange(points)))
    figure = draw(
        "topography_map", many.assign_coords(x=np.arange(points) * 1e-6, y=np.arange(points) * 1e-6)
    )
    (height,) = (s for s in figure.series if s.z is not None)
    assert height.z.size == 367**2


def test_deflection_gives_the_times(figures):
    said = texts(figures["deflection"])
    assert "direct summation: 7.1 s" in said
    assert "DC-FFT: 0.06 s" in said


def test_deflection_shows_the_error():
    figure = draw("deflection", deflections(1e-3))
    errors = [s.y for s in figure.series if s.panel == "b"]
    assert np.allclose(errors[0], 1e-4, rtol=1e-6)
    assert np.allclose(errors[1], 1.1e-3, rtol=1e-2)


def test_contact_lines_stand_in_the_order_of_the_loads():
    shuffled = maps().isel(load_step=[2, 0, 3, 1])
    shuffled["converged"][1] = False
    figure = draw("contact_lines", shuffled)
    names = [s.series for s in figure.series if s.panel.startswith("a")]
    assert names == ["p = 30 kPa", "p = 230 kPa", "p = 600 kPa", "p = 1.6 MPa"]
    titles = [axes.get_title(loc="right") for axes in figure.axes]
    assert sum("did not converge" in title for title in titles) == 2
    (first,) = (s.y for s in figure.series if s.panel == "a1")
    assert np.allclose(first, maps()["contact_pressure"].values[0, :, 16])


def test_solver_comparison_names_solvers_boundaries_and_gaps(figures):
    said = texts(figures["solver_comparison"])
    assert "ours, finite patch (DC-FFT)" in said
    assert "Polonsky–Keer, periodic" in said
    assert "gap < $10^{-9}$ m" in said


def test_gap_thresholds_follow_the_loads():
    shuffled = validation().isel(load_step=slice(None, None, -1))
    figure = draw("solver_comparison", shuffled)
    (counted,) = (s for s in figure.series if s.series.startswith("gap < 1e-20"))
    assert np.all(np.diff(counted.x) > 0)
    assert np.all(np.diff(counted.y) >= 0)


def test_persson_is_drawn_over_the_modulus(figures):
    series = {s.series: s for s in figures["persson_separation"].series}
    full = series["full integral, γ = 1"]
    tail = series["exponential tail, equation 4-23"]
    assert np.allclose(tail.y, 0.8 * full.y)
    assert np.allclose(tail.x, full.x)
