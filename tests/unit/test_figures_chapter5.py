"""Drawings of chapter 5: what they show, what they say about it, and that nothing drawn is lost from the data."""

import csv
import io

import numpy as np
import pytest
from synthetic_solid import (
    DATASETS,
    body,
    constraint,
    equivalence,
    half_cylinder,
    hyperelastic,
    linear,
    mesh,
    moduli,
    solid,
)

from softlub.figures import draw
from softlub.figures.bodies import bodies, trimmed
from softlub.figures.panel import styled
from softlub.figures.save import table as written


@pytest.fixture(scope="module")
def figures():
    return {name: draw(name, make()) for name, make in DATASETS.items()}


def series(figure, name, panel=None):
    (found,) = [one for one in figure.series if one.series == name and panel in (None, one.panel)]
    return found


def labels(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def marks(figure):
    """Crosses of bodies that did not get to their end."""
    return [line for axes in figure.axes for line in axes.lines if line.get_gid() == "failed"]


@pytest.mark.parametrize("name", DATASETS)
def test_axes_carry_units(figures, name):
    for axes in figures[name].axes:
        found = [label for label in (axes.get_ylabel(), axes.get_xlabel()) if label]
        assert all("(" in label and label.endswith(")") for label in found), found


@pytest.mark.parametrize("name", DATASETS)
def test_lines_show_the_recorded_data(figures, name):
    drawn = [line.get_xydata() for axes in figures[name].axes for line in axes.lines]
    assert figures[name].series
    for one in (one for one in figures[name].series if one.z is None):
        expected = np.column_stack([one.x_quantity.shown(one.x), one.y_quantity.shown(one.y)])
        assert any(
            line.shape == expected.shape and np.array_equal(line, expected, equal_nan=True) for line in drawn
        ), one.series


@pytest.mark.parametrize("name", DATASETS)
def test_csv_holds_every_point(figures, name):
    read = list(csv.DictReader(io.StringIO(written(figures[name]))))
    assert len(read) == sum(one.x.size for one in figures[name].series)


# reduced stiffness against finite elements


def test_one_friction_is_drawn_where_it_is_chosen():
    figure = draw("reduced_against_full", linear(), friction=0.0)
    assert labels(figure) == ["finite elements", "reduced stiffness"]
    off = series(figure, "reduced stiffness, difference", "d")
    full = series(figure, "finite elements", "b")
    np.testing.assert_allclose(off.y, 0.107 * full.y, rtol=1e-9)


def test_the_caption_gives_the_lateral_difference_that_the_longest_vector_hides():
    (sentence,) = draw("reduced_against_full", linear(), friction=0.0).notes
    assert "at most 1.6 % of the largest displacement, 11 % of the largest lateral and 1.2 % of" in sentence


def test_bodies_are_told_apart_and_their_markers_do_not_hide_each_other():
    figure = draw("reduced_against_full", hyperelastic())
    lines = [line for line in figure.axes[0].lines if line.get_marker() not in ("None", "")]
    assert len({line.get_marker() for line in lines}) == 2
    wide = draw("reduced_against_full", solid("wide", ("element", ["a", "b"]), [[body(513)], [body(513)]]))
    apart = [line for line in wide.axes[0].lines if line.get_marker() not in ("None", "")]
    first, second = ({*np.arange(513)[line.get_markevery()[0] :: line.get_markevery()[1]]} for line in apart)
    assert not first & second


def test_the_half_space_is_that_of_the_first_body_at_every_datum():
    figure = draw("reduced_against_full", hyperelastic())
    assert [label for label in labels(figure) if "half-space" in label] == [
        "half-space, datum 1 mm",
        "half-space, datum 10 mm",
    ]
    assert any("differs by at most 100 % (datum 1 mm), 50 % (datum 10 mm)" in note for note in figure.notes)


def test_the_kept_constraint_shows_every_node():
    """A single node holds it, which sparse markers would jump over."""
    figure = draw("reduced_against_full", constraint())
    (line,) = [
        line for line in figure.axes[0].lines if line.get_label() == "reduced stiffness, constraint kept"
    ]
    assert line.get_linestyle() == "--"
    assert line.get_marker() == "None"


def test_nodes_of_other_meshes_are_left_out():
    coarse, fine = bodies(mesh())
    assert (coarse.label, fine.label) == ("33 edge nodes", "65 edge nodes")
    assert (coarse.x.size, fine.x.size) == (33, 65)


def test_cells_and_points_of_other_meshes_are_left_out():
    dataset = hyperelastic().isel(material=0, load=0)
    padded = dataset.pad(cell=(0, 3), mesh_node=(0, 5), edge_node=(0, 2), held_node=(0, 1))
    for name in ("mesh_cell", "mesh_edge", "mesh_held"):
        padded[name] = padded[name].fillna(-1)
    kept = trimmed(padded)
    for name in ("mesh_cell", "mesh_edge", "mesh_held", "mesh_point", "stress_von_mises"):
        np.testing.assert_array_equal(kept[name].values, dataset[name].values)


def test_a_body_that_stopped_early_is_marked_and_explained():
    rows = [[body()], [body(converged=False)]]
    figure = draw("reduced_against_full", solid("ch5-elements", ("element", ["a", "b"]), rows))
    assert np.isnan(series(figure, "b: finite elements", "a").y).all()
    assert np.isfinite(series(figure, "a: finite elements", "a").y).all()
    assert len(marks(figure)) == 4
    assert "B stopped before the end" in figure.notes[-1].capitalize()
    assert figure.notes[-1].endswith("sliding, increment 4: the tangent is singular.")


def test_a_load_that_is_not_there_is_refused():
    with pytest.raises(ValueError, match=r"no load = 20, only 17"):
        draw("reduced_against_full", linear(), load=20.0)


def test_more_bodies_than_can_be_told_apart_are_refused():
    rows = [[body(nodes=9)] for _ in range(5)]
    with pytest.raises(ValueError, match="5 bodies and tells 4 apart"):
        draw("reduced_against_full", solid("mine", ("radius", [1.0, 2.0, 3.0, 4.0, 5.0]), rows))


# half cylinder, meshes, matrices


def test_the_half_cylinder_states_every_datum():
    figure = draw("half_cylinder", half_cylinder())
    assert labels(figure) == [
        "finite elements",
        *(f"half-space, datum {text}" for text in ("1 mm", "10 mm", "1 m")),
    ]
    assert figure.notes[0] == "Drawn at W = 6000 N/m."
    assert "14 µm in finite elements" in figure.notes[1]
    assert series(draw("half_cylinder", half_cylinder(), load=100.0), "finite elements").y.max() < 2e-6


def test_the_half_cylinder_needs_its_half_space_and_its_mesh():
    with pytest.raises(ValueError, match=r"compare: \[half_space\]"):
        draw("half_cylinder", linear())
    with pytest.raises(ValueError, match=r"outputs: \[mesh\]"):
        draw("half_cylinder", constraint())


def test_entries_are_gathered_in_classes_of_the_distance():
    figure = draw("matrix_entries", mesh(diagonal=1.0, far=1.0))
    coarse = series(figure, "33 edge nodes: vertical, row of the apex")
    entries = 2.7e6 / (1 + np.arange(1, 17)) ** 3
    assert coarse.y[0] == pytest.approx(entries[0])
    assert coarse.y.min() > entries[-1] * 0.99
    assert np.all(np.diff(coarse.x) > 0)
    assert "condensed from 12606 degrees of freedom in 0.3 s" in figure.notes[0]


# moduli


def test_one_material_is_drawn_by_quantity_several_by_material():
    one, three = draw("moduli", moduli(), material="L"), draw("moduli", moduli())
    assert labels(one) == ["storage modulus E′", "loss modulus E″", "loss factor tan φ"]
    assert len(labels(three)) == 9
    assert len({line.get_color() for line in one.axes[0].lines}) == 2
    assert "3.56 MPa at the lowest frequency, 5 % more from 3000 rad/s on" in one.notes[0]


def test_temperatures_are_told_apart():
    warm = moduli().isel(material=[1]).expand_dims(temperature=[293.0, 313.0])
    assert labels(draw("moduli", warm))[0] == "T = 293 K: storage modulus E′"


def test_a_material_that_is_not_there_is_refused():
    with pytest.raises(ValueError, match=r"no material M, only maxwell_arm, L, Y"):
        draw("moduli", moduli(), material="M")


# equivalent bodies


def test_equivalents_are_named_by_their_coefficient():
    figure = draw("equivalent_shape", equivalence())
    assert labels(figure) == [
        "body at rest",
        "viscoelastic",
        "hyperelastic, α = 1.001 (fitted)",
        "hyperelastic, α = 1",
        "hyperelastic, α = 1.5",
    ]
    assert "Fitted α: 1.001 (steps of 1 s), 2.1 (steps of 1 µs)." in figure.notes


def test_distances_are_those_of_nodes():
    dataset = equivalence()
    figure = draw("equivalent_shape", dataset, steps="1 us")
    one = dataset.sel(steps="1 us", load=17.0)["displacement"]
    off = one.sel(model="alpha=1.5") - one.sel(model="viscoelastic")
    distance = series(figure, "hyperelastic, α = 1.5, distance").y
    np.testing.assert_allclose(distance, np.hypot(*off.transpose("component", "node").values), atol=1e-20)


def test_the_stiffness_of_an_equivalent_is_held_against_the_viscoelastic_body():
    figure = draw("equivalent_against_full", equivalence())
    full = series(figure, "finite elements, viscoelastic", "a")
    off = series(figure, "reduced stiffness, α = 1.5, difference", "c")
    np.testing.assert_allclose(off.y, -0.33 * full.y)
    assert "by at most 33 % of the largest displacement" in figure.notes[-1]


def test_a_model_that_stopped_early_is_marked_and_explained():
    dataset = equivalence()
    dataset["converged"] = dataset["converged"].copy()
    dataset["converged"].loc[{"model": "alpha=1.5"}] = False
    dataset["stop_reason"].loc[{"model": "alpha=1.5"}] = "loading, increment 2: no convergence"
    for name, count in (("equivalent_shape", 2), ("equivalent_against_full", 2)):
        figure = draw(name, dataset)
        assert len(marks(figure)) == count
        assert any("alpha=1.5 stopped before the end" in note for note in figure.notes)


def test_steps_that_are_not_there_are_refused():
    with pytest.raises(ValueError, match=r"no steps 2 s, only 1 s, 1 us"):
        draw("equivalent_shape", equivalence(), steps="2 s")


@pytest.mark.parametrize("name", ["equivalent_shape", "equivalent_against_full"])
@pytest.mark.parametrize("stopped", [["fitted"], ["viscoelastic", "fitted"]])
def test_a_search_that_found_nothing_leaves_a_gap(name, stopped):
    dataset = equivalence()
    for model in stopped:
        at = {"model": model, "steps": "1 s"}
        dataset["converged"].loc[at] = False
        for gone in ("coefficient", "shape_difference", "displacement_reduced", "displacement_reduced_error"):
            dataset[gone].loc[at] = np.nan
    figure = draw(name, dataset)
    assert len(marks(figure)) >= 2
    assert any("no α found" in label for label in labels(figure))
    assert "Fitted α: none found (steps of 1 s), 2.1 (steps of 1 µs)." in figure.notes
    assert written(figure)
    with styled():
        figure.draw_without_rendering()


@pytest.mark.parametrize("name", ["half_cylinder", "deformed_mesh"])
def test_a_body_that_did_not_reach_its_load_says_so(name):
    dataset = half_cylinder()
    dataset["converged"].loc[{"load": 6000.0}] = False
    figure = draw(name, dataset)
    assert any(
        "stopped before the end, the last state that it reached is drawn" in note for note in figure.notes
    )
    with styled():
        figure.draw_without_rendering()
