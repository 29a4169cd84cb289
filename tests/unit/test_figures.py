"""Every drawing: what it shows, its units, its marks for failed points, and that files repeat bit by bit."""

import csv
import io

import numpy as np
import pytest
import xarray as xr
from synthetic_contact import DATASETS as CHAPTER_4
from synthetic_datasets import fail, sample, skip, stribeck, work_precision
from synthetic_solid import DATASETS as CHAPTER_5

from softlub.datasets.variables import FLAGS
from softlub.figures import DRAWINGS, draw, style
from softlub.figures.curves import curves
from softlub.figures.looks import looks
from softlub.figures.panel import DataFigure
from softlub.figures.quantities import quantity
from softlub.figures.sample import first_order_index
from softlub.figures.save import save, table
from softlub.figures.stribeck import draw as draw_stribeck

MODULES = ["auto", "bml", "mehl", "ehl"]
SWEEPS = ["auto", "mehl", "mehl sweep=newton_raphson"]
LAWS = ["exponential", "persson", "persson gamma=0.45"]


def dataset_for(name):
    """The smallest dataset that a drawing takes."""
    speeds = np.geomspace(1e-3, 1, 7)
    return {
        "stribeck": lambda: stribeck(dimensions={"solver": MODULES}),
        "load_share": stribeck,
        "friction_and_separation": stribeck,
        "profiles": lambda: stribeck(speeds, {"contact_law": LAWS}, nodes=60),
        "sweep_comparison": lambda: stribeck(speeds, {"solver": SWEEPS}, nodes=60),
        "module_comparison": lambda: stribeck(speeds, {"solver": MODULES[:3]}, nodes=60),
        "parameter_study": lambda: stribeck(dimensions={"young_modulus": [1e7, 2e7, 5e7]}),
        "regime_map": lambda: sample(500),
        "sensitivity": lambda: sample(500),
        "work_precision": work_precision,
    }[name]()


SERIES = {
    "stribeck": 4,  # solvers
    "load_share": 3,  # fluid, asperities, the line at the minimum
    "friction_and_separation": 2,
    "profiles": 9,  # three fields by three laws
    "sweep_comparison": 9 + 3 * 2,  # three fields by three solvers; three sorts of effort by two sweeps
    "module_comparison": 9,
    "parameter_study": 6,
    "regime_map": 2,
    "sensitivity": 2 * 6,  # five inputs and their sum
    "work_precision": 4,
}


def failed_marks(figure):
    """Crosses of failed points, whoever drew them."""
    return [line for axes in figure.axes for line in axes.lines if line.get_gid() == "failed"]


@pytest.fixture(scope="module")
def figures():
    return {name: draw(name, dataset_for(name)) for name in SERIES}


def test_every_drawing_has_an_expectation():
    """Those of chapters 4 and 5 stand in files of their own."""
    assert SERIES.keys() | CHAPTER_4.keys() | CHAPTER_5.keys() == DRAWINGS.keys()


def test_an_unknown_drawing_is_refused_by_name():
    with pytest.raises(ValueError, match=r"'piechart'.*stribeck"):
        draw("piechart", stribeck())


@pytest.mark.parametrize("name", SERIES)
def test_number_of_series(figures, name):
    assert len(figures[name].series) == SERIES[name]


@pytest.mark.parametrize("name", SERIES)
def test_axes_carry_units(figures, name):
    for axes in figures[name].axes:
        labels = [axes.get_ylabel()] + ([axes.get_xlabel()] if axes.get_xlabel() else [])
        assert all("(" in label and label.endswith(")") for label in labels), labels


@pytest.mark.parametrize("name", SERIES)
def test_every_figure_has_an_axis_named_in_x(figures, name):
    assert any(axes.get_xlabel() for axes in figures[name].axes)


@pytest.mark.parametrize("name", [name for name in SERIES if name != "regime_map"])
def test_lines_show_the_recorded_data(figures, name):
    """Every recorded series lies in the figure, in the axis' unit."""
    drawn = [line.get_xydata() for axes in figures[name].axes for line in axes.lines]
    for series in figures[name].series:
        expected = np.column_stack([series.x_quantity.shown(series.x), series.y_quantity.shown(series.y)])
        assert any(
            line.shape == expected.shape and np.array_equal(line, expected, equal_nan=True) for line in drawn
        ), series.series


@pytest.mark.parametrize("name", SERIES)
def test_csv_holds_the_recorded_data(figures, name):
    figure = figures[name]
    rows = list(csv.DictReader(io.StringIO(table(figure))))
    assert len(rows) == sum(series.x.size for series in figure.series)
    at = 0
    for series in figure.series:
        part = rows[at : at + series.x.size]
        at += series.x.size
        column = f"{series.y_quantity.name} [{series.y_quantity.unit}]"
        assert {row["series"] for row in part} == {series.series}
        assert np.allclose([float(row[column]) for row in part], series.y, rtol=1e-9, equal_nan=True)


def test_csv_is_in_si():
    header = table(draw("friction_and_separation", stribeck())).splitlines()[0]
    assert header == "panel,series,hersey_number [N/m],friction_coefficient [1],separation_min [m]"


def test_failed_points_leave_a_gap_and_a_mark():
    good, bad = stribeck(), fail(stribeck(), speed=[3, 4])
    assert not failed_marks(draw("stribeck", good))
    figure = draw("stribeck", bad)
    (mark,) = failed_marks(figure)
    assert np.allclose(mark.get_xdata(), bad["hersey_number"].values[[3, 4]])
    assert np.isnan(figure.series[0].y[[3, 4]]).all()
    assert np.isfinite(np.delete(figure.series[0].y, [3, 4])).all()
    assert any(text.get_text() == "did not converge" for text in figure.axes[0].get_legend().get_texts())


@pytest.mark.parametrize("name", ["load_share", "friction_and_separation", "parameter_study"])
def test_other_curves_mark_failures_too(name):
    assert failed_marks(draw(name, fail(dataset_for(name), speed=[2])))


def flagged(dataset, name, **where):
    """A copy with one flag raised at integer positions."""
    marked = dataset.copy(deep=True)
    marked["flags"][where] |= FLAGS[name]
    return marked


def doubtful_lines(figure):
    return [line for axes in figure.axes for line in axes.lines if line.get_gid() == "doubtful"]


def legend_texts(figure):
    legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes)]
    return [text.get_text() for legend in legends if legend is not None for text in legend.get_texts()]


@pytest.mark.parametrize(
    ("name", "flag", "lines"),
    [
        *(("stribeck", flag, 1) for flag in ("outside_half_space", "inaccurate_friction", "inaccurate_area")),
        *(("load_share", flag, 2) for flag in ("outside_half_space", "inaccurate_area")),
        # One of two curves is the separation, which is doubted by itself.
        *(
            (name, flag, lines)
            for name in ("friction_and_separation", "parameter_study")
            for flag, lines in (
                ("outside_half_space", 2),
                ("inaccurate_friction", 1),
                ("inaccurate_separation", 1),
            )
        ),
    ],
)
def test_doubtful_points_are_drawn_thin_and_explained(name, flag, lines):
    plain = stribeck(dimensions={"young_modulus": [1e7]})
    dataset = flagged(plain, flag, speed=[26, 27, 28])
    before, figure = draw(name, plain), draw(name, dataset)
    assert not doubtful_lines(before)
    assert not any(text.startswith("thin") for text in legend_texts(before))
    thin = doubtful_lines(figure)
    assert len(thin) == lines
    # They begin at the last sound point, so that the curve has no gap.
    assert all(np.flatnonzero(np.isfinite(line.get_ydata())).tolist() == [25, 26, 27, 28] for line in thin)
    (text,) = (text for text in legend_texts(figure) if text.startswith("thin"))
    assert text == ("thin: no half-space" if flag == "outside_half_space" else "thin: inaccurate")
    for series, same in zip(figure.series, before.series, strict=True):
        assert np.array_equal(series.y, same.y)


@pytest.mark.parametrize("name", ["friction_and_separation", "parameter_study"])
def test_each_reason_for_doubt_stands_in_the_legend_once(name):
    plain = stribeck(dimensions={"young_modulus": [1e7]})
    wide = flagged(plain, "outside_half_space", speed=[27, 28])
    figure = draw(name, flagged(wide, "inaccurate_separation", speed=[3, 4, 27]))
    assert len(doubtful_lines(figure)) == 2
    thin = [text for text in legend_texts(figure) if text.startswith("thin")]
    assert thin == ["thin: no half-space", "thin: inaccurate"]


def two_inputs(moduli=3, roughnesses=3):
    return stribeck(
        dimensions={
            "young_modulus": 1e7 * np.arange(1, moduli + 1),
            "rms_roughness": 1e-6 * np.arange(1, roughnesses + 1),
        }
    )


def test_first_input_by_colour_second_by_dashes():
    found = np.array(looks(list(curves(two_inputs())))).reshape(3, 3)
    colours = [[look["color"] for look in row] for row in found]
    dashes = [[look["linestyle"] for look in row] for row in found]
    assert all(len(set(row)) == 1 for row in colours)
    assert len({row[0] for row in colours}) == 3
    assert dashes[0] == dashes[1] == dashes[2] == ["-", "--", ":"]


@pytest.mark.parametrize(
    "dimensions",
    [
        {"young_modulus": np.linspace(1e7, 5e7, 16)},
        {"solver": ["auto", "auto domain=±1mm", "auto domain=±2mm", "mehl", "mehl sweep=newton_raphson"]},
        {"solver": ["auto", "bml", "ehl"], "young_modulus": [1e7, 2e7, 5e7]},
    ],
)
def test_no_two_curves_look_alike(dimensions):
    found = looks(list(curves(stribeck(dimensions=dimensions))))
    assert len({(look["color"], look["linestyle"], look.get("marker")) for look in found}) == len(found)


def test_curves_that_would_look_alike_are_refused():
    with pytest.raises(ValueError, match="7 colours for the first swept input"):
        draw("parameter_study", two_inputs(8, 2))


@pytest.mark.parametrize(
    ("name", "most"),
    [("stribeck", 16), ("parameter_study", 16), ("load_share", 8), ("friction_and_separation", 8)],
)
def test_more_curves_than_a_figure_holds_are_refused(name, most):
    assert draw(name, stribeck(dimensions={"young_modulus": np.linspace(1e7, 5e7, most)})).series
    with pytest.raises(ValueError, match=f"{most + 1} curves and tells {most} apart; sweep fewer"):
        draw(name, stribeck(dimensions={"young_modulus": np.linspace(1e7, 5e7, most + 1)}))


@pytest.mark.parametrize("name", ["stribeck", "parameter_study", "load_share", "friction_and_separation"])
@pytest.mark.parametrize(("count", "below"), [(1, False), (5, True)])
def test_long_legends_stand_below_the_axes_and_within_the_figure(name, count, below):
    figure = draw(name, stribeck(dimensions={"young_modulus": np.linspace(1e7, 5e7, count)}))
    assert bool(figure.legends) == below
    assert any(axes.get_legend() is not None for axes in figure.axes) == (not below and name[0] in "lf")
    figure.draw_without_rendering()
    for legend in figure.legends:
        box = legend.get_window_extent()
        assert box.x0 >= 0
        assert box.x1 <= figure.bbox.x1
        assert all(box.y1 < axes.get_window_extent().y0 for axes in figure.axes)


@pytest.mark.parametrize("flag", ["domain_truncates", "inaccurate_separation"])
def test_other_flags_leave_curves_as_they_are(flag):
    assert not doubtful_lines(draw("stribeck", flagged(stribeck(), flag, speed=[3])))


def test_flags_stand_in_the_csv_where_there_are_any():
    dataset = flagged(flagged(stribeck(), "outside_half_space", speed=28), "domain_truncates", speed=[27, 28])
    rows = list(csv.DictReader(io.StringIO(table(draw("stribeck", dataset)))))
    assert [row["flags"] for row in rows[-3:]] == [
        "",
        "domain_truncates",
        "outside_half_space domain_truncates",
    ]
    assert "flags" not in table(draw("stribeck", stribeck())).splitlines()[0]


def test_points_that_nobody_asked_for_are_no_failures():
    assert not failed_marks(
        draw("stribeck", skip(stribeck(dimensions={"solver": MODULES}), solver=1, speed=[5]))
    )


def test_modules_are_points_over_the_newton_line():
    lines = {line.get_label(): line for line in draw("stribeck", dataset_for("stribeck")).axes[0].lines}
    assert lines["Newton"].get_linestyle() == "-"
    assert {lines[name].get_marker() for name in ("BML", "MEHL", "EHL")} == {"s", "o", "^"}
    assert all(lines[name].get_linestyle() == "None" for name in ("BML", "MEHL", "EHL"))


def test_a_module_that_failed_is_drawn_by_its_last_iterate_and_says_so():
    failed = fail(dataset_for("module_comparison"), solver=1, speed=3)
    figure = draw("module_comparison", failed, speed=float(failed["speed"][3]))
    texts = [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    (said,) = (text for text in texts if text.startswith("BML"))
    assert "NOT CONVERGED" in said
    assert "3.0e-02" in said
    assert any("BML" in series.series and np.isfinite(series.y).any() for series in figure.series)


def test_sweep_comparison_crosses_failed_points():
    failed = fail(dataset_for("sweep_comparison"), solver=2, speed=[0, 1])
    marks = failed_marks(draw("sweep_comparison", failed))
    assert len(marks) == 3
    assert all(np.isfinite(mark.get_ydata()).sum() == 2 for mark in marks)


def test_profiles_refuse_a_speed_that_is_not_there():
    with pytest.raises(ValueError, match="no speed near 50"):
        draw("profiles", dataset_for("profiles"), speed=50.0)


def test_amplified_pressure_is_a_further_line_of_one_profile():
    dataset = dataset_for("profiles")
    plain = draw("profiles", dataset)
    figure = draw("profiles", dataset, amplify=1e5, amplified="persson gamma=0.45")
    assert [s.series for s in figure.series[:9]] == [s.series for s in plain.series]
    (further,) = figure.series[9:]
    (true,) = (s for s in plain.series if s.series == "asperity pressure, Persson integral, γ = 0.45")
    assert further.series == "asperity pressure × 100000, Persson integral, γ = 0.45"
    assert np.array_equal(further.y, 1e5 * true.y)
    assert any("asperity pressure × " in text for text in legend_texts(figure))


def test_amplified_pressure_of_every_profile_or_of_none_of_that_label():
    assert len(draw("profiles", dataset_for("profiles"), amplify=10.0).series) == 12
    with pytest.raises(ValueError, match=r"'persson gamma=2'; there are exponential law 3-11"):
        draw("profiles", dataset_for("profiles"), amplify=10.0, amplified="persson gamma=2")


def several_loads(**options):
    heavier = [stribeck(nodes=60, load=load, **options) for load in (100.0, 200.0, 400.0)]
    for factor, dataset in enumerate(heavier, start=1):
        dataset["fluid_pressure"].values[:] *= factor
    return xr.concat(heavier, "load", data_vars="minimal", coords="minimal", compat="override")


@pytest.mark.parametrize("name", ["profiles", "sweep_comparison", "module_comparison"])
def test_profiles_are_of_one_load_that_is_named(name):
    dataset = several_loads(dimensions={"solver": SWEEPS})
    speed = float(dataset["speed"][10])
    for options, factor in (({"load": 100}, 1), ({"load": 400}, 3), ({}, 2)):
        figure = draw(name, dataset, speed=speed, **options)
        fluid = next(series for series in figure.series if series.series.startswith("fluid"))
        expected = factor * dataset["fluid_pressure"].sel(load=100.0, speed=speed).values[0]
        assert np.allclose(np.sort(fluid.y), np.sort(expected))
        load = {1: 100, 2: 200, 3: 400}[factor]
        assert any(f"W = {load} N/m" in axes.get_title("right") for axes in figure.axes)
        assert f"Drawn for v = {speed:.4g} m/s and W = {load} N/m." in figure.notes
    with pytest.raises(ValueError, match="no load near 50 N/m"):
        draw(name, dataset, load=50.0)


def test_profiles_refuse_what_they_cannot_tell_apart():
    with pytest.raises(ValueError, match="which value of hurst to draw"):
        draw("profiles", stribeck(dimensions={"young_modulus": [1e7, 2e7], "hurst": [0.7, 0.8]}, nodes=60))
    with pytest.raises(ValueError, match="8 values of young_modulus"):
        draw("profiles", stribeck(dimensions={"young_modulus": np.linspace(1e7, 5e7, 9)}, nodes=60))


@pytest.mark.parametrize("name", ["stribeck", "sweep_comparison", "module_comparison"])
def test_names_of_solvers_are_explained(figures, name):
    assert any(note.startswith("Newton solves") for note in figures[name].notes)
    assert not draw("stribeck", stribeck()).notes


@pytest.mark.parametrize(
    ("shown", "text"),
    [(r"$h_\mathrm{rms}$ = 1 µm", "h_rms = 1 µm"), (r"v = $10^{-5}$ m/s", "v = 1e-05 m/s"),
     (r"× $2.5\times 10^{7}$", "× 2.5e+07"), ("$E$ = 10 MPa, $R$ = 1 mm", "E = 10 MPa, R = 1 mm"),
     ("BML", "BML")],
)  # fmt: skip
def test_plain_text(shown, text):
    assert style.plain(shown) == text


def test_csv_names_series_in_plain_text(figures):
    names = {series.series for series in figures["parameter_study"].series}
    assert names == {"E = 10 MPa", "E = 20 MPa", "E = 50 MPa"}


def test_load_share_marks_the_minimum_of_friction():
    figure = draw("load_share", stribeck())
    (line,) = (series for series in figure.series if series.series == "minimum of friction")
    friction = draw("stribeck", stribeck()).series[0]
    lowest = friction.x[np.argmin(friction.y)]
    assert 0.5 < line.x[0] / lowest < 2


def test_files_repeat_bit_by_bit(tmp_path):
    for folder in ("first", "second"):
        figure = draw("stribeck", dataset_for("stribeck"))
        save(figure, [tmp_path / folder / f"figure.{kind}" for kind in ("pdf", "png", "svg", "csv")])
    for kind in ("pdf", "png", "svg", "csv"):
        assert (tmp_path / f"first/figure.{kind}").read_bytes() == (
            tmp_path / f"second/figure.{kind}"
        ).read_bytes()
    assert sorted(path.name for path in (tmp_path / "first").iterdir()) == [
        f"figure.{kind}" for kind in ("csv", "pdf", "png", "svg")
    ]


def test_another_format_is_refused(tmp_path):
    with pytest.raises(ValueError, match="pdf, png, svg, csv"):
        save(draw("stribeck", stribeck()), [tmp_path / "figure.bmp"])


def test_a_user_matplotlibrc_changes_nothing(tmp_path):
    import matplotlib

    before = table(draw("stribeck", stribeck()))
    plain = draw("stribeck", stribeck())
    with matplotlib.rc_context({"font.size": 30, "lines.linewidth": 9}):
        other = draw("stribeck", stribeck())
    assert before == table(other)
    assert plain.axes[0].lines[0].get_linewidth() == other.axes[0].lines[0].get_linewidth()


def test_drawings_leave_pyplot_alone():
    import matplotlib.pyplot as plt

    assert isinstance(draw_stribeck(stribeck()), DataFigure)
    assert plt.get_fignums() == []


@pytest.mark.parametrize(
    ("name", "value", "unit"),
    [("separation_min", 2e-6, "µm"), ("separation_min", 999e-9, "nm"), ("fluid_pressure", 2.06e5, "kPa"),
     ("friction_coefficient", 0.3, "–"), ("hersey_number", 1e-4, "N/m"), ("x", 1e-3, "mm")],
)  # fmt: skip
def test_prefixes(name, value, unit):
    assert quantity(name, value).shown_unit == unit


def test_first_order_index_of_a_known_function():
    """Y = 2 A + B with independent unit inputs: 4/5 and 1/5 of the variance, an idle input none."""
    random = np.random.default_rng(2)
    first, second, idle = random.uniform(size=(3, 20000))
    effect = 2 * first + second
    assert first_order_index(first, effect, 25) == pytest.approx(0.8, abs=0.01)
    assert first_order_index(second, effect, 25) == pytest.approx(0.2, abs=0.01)
    assert abs(first_order_index(idle, effect, 25)) < 0.01


def test_first_order_index_of_nothing_is_nan():
    assert np.isnan(first_order_index(np.arange(200.0), np.ones(200), 10))
    assert np.isnan(first_order_index(np.arange(10.0), np.arange(10.0), 10))
