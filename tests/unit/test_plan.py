"""The plan, by counting its nodes and comparing their keys."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from softlub.study import StudyError, load, merge, plan

ROOT = Path(__file__).parents[2]
TABLE_3_1 = {
    "body": {"shape": "table_3_1", "material": "table_3_1"},
    "surface": "table_3_1",
    "lubricant": "table_3_1",
}
BASE = {"scene": TABLE_3_1, "grid": {"load": 100, "speed": [1e-3, 1e-2, 0.1]}}


@pytest.fixture
def planned(tmp_path):
    def make(changes=None, name="one", accuracy=None, **entries):
        block = copy.deepcopy(BASE) | entries
        for key, value in (changes or {}).items():
            section, _, field = key.partition("/")
            block[section][field] = value
        path = tmp_path / f"{name}.yaml"
        path.write_text(yaml.safe_dump(block, sort_keys=False))
        return plan(load(path, accuracy=accuracy, config_dir=ROOT / "config"))

    return make


def keys(of, kind="panel"):
    return [node.key for node in of.of_kind(kind)]


def counts(of):
    return tuple(len(of.of_kind(kind)) for kind in ("panel", "study", "figure"))


def test_one_panel_one_study_and_its_figures(planned):
    assert counts(planned()) == (1, 1, 0)
    assert counts(planned(figures=["stribeck", {"name": "fig_3_16", "draw": "load_share"}])) == (1, 1, 2)


def test_paths_and_inputs(planned):
    made = planned(figures=[{"name": "fig_3_15", "draw": "stribeck"}])
    panel, study, figure = made.nodes
    assert panel.path == f"panel/{panel.key}.nc"
    assert study.path == "studies/one.nc"
    assert figure.paths == tuple(f"figures/one/fig_3_15.{suffix}" for suffix in ("pdf", "png", "svg", "csv"))
    assert made.inputs(panel) == ()
    assert made.inputs(study) == (panel,)
    assert made.inputs(figure) == (study,)
    assert made.node("study", "one") is study
    assert made.node("figure", "one/fig_3_15") is figure
    assert made.figures("one") == (figure,)


def test_a_smooth_surface_has_no_law_in_its_panel(planned):
    (panel,) = planned({"scene/surface": "smooth"}).of_kind("panel")
    assert panel.spec["scene"]["contact_law"] == {"name": "none"}
    assert panel.spec["scene"]["surface"] == {"kind": "smooth"}


def test_fields_only_when_somebody_needs_them(planned):
    def fields(**entries):
        return [node.spec["fields"] for node in planned(**entries).of_kind("panel")]

    assert fields() == [False]
    assert fields(figures=["stribeck"], outputs=["friction"]) == [False]
    assert fields(figures=["profiles"]) == [True]
    assert fields(outputs=["friction", "fields"]) == [True]


def test_variables_that_nobody_asked_for_are_left_out(planned):
    left_out = planned(outputs=["friction"]).node("study", "one").spec["left_out"]
    assert "separation_min" in left_out
    assert "friction_coefficient" not in left_out
    assert (
        "separation_min" not in planned(outputs=["friction"], figures=["stribeck"]).nodes[1].spec["left_out"]
    )


def test_a_changed_shear_strength_keeps_the_panels(planned):
    one, other = planned(), planned({"scene/shear_strength": "0.2 E"})
    assert keys(one) == keys(other)
    assert keys(one, "study") != keys(other, "study")


def test_a_changed_title_or_figure_keeps_the_panels(planned):
    one = planned(figures=["stribeck"])
    other = planned(figures=[{"draw": "stribeck", "height": 3}], title="Another")
    assert keys(one) == keys(other)


def test_a_changed_figure_keeps_the_study(planned):
    one, other = planned(figures=["stribeck"]), planned(figures=[{"draw": "stribeck", "height": 3}])
    assert keys(one, "study") == keys(other, "study")
    assert keys(one, "figure") != keys(other, "figure")


def test_a_changed_speed_grid_changes_only_its_panels(planned):
    solvers = ["auto", {"name": "bml", "to": 1e-2}]
    one = planned({"grid/solver": solvers})
    other = planned({"grid/solver": solvers, "grid/speed": [1e-3, 1e-2, 0.2]})
    assert keys(one)[0] != keys(other)[0]
    assert keys(one)[1] == keys(other)[1]


def test_every_solver_has_a_panel_with_its_own_speeds(planned):
    made = planned(
        {
            "grid/solver": [
                "auto",
                {"name": "bml", "to": 1e-3},
                {"name": "ehl", "from": 0.1, "half_domain": 1e-3},
            ]
        }
    )
    assert counts(made) == (3, 1, 0)
    assert [panel.spec["speed"] for panel in made.of_kind("panel")] == [[1e-3, 1e-2, 0.1], [1e-3], [0.1]]
    assert [panel.spec["scene"]["half_domain"] for panel in made.of_kind("panel")] == [None, None, 1e-3]
    assert made.node("study", "one").spec["solvers"] == ["auto", "bml", "ehl"]


def test_swept_fields_are_one_panel(planned):
    made = planned(
        {
            "grid/scene.body.material.young_modulus": [1e7, 2e7],
            "grid/scene.contact_law": ["exponential", "persson"],
        }
    )
    assert counts(made) == (1, 1, 0)
    sweeps = made.nodes[0].spec["sweeps"]
    assert [sweep["dimension"] for sweep in sweeps] == ["young_modulus", "contact_law"]
    assert sweeps[1]["labels"] == ["exponential", "persson"]


def test_the_base_value_of_a_swept_field_is_not_in_the_key(planned):
    sweep = {"grid/scene.body.material": ["table_3_1", "pdms"]}
    other = {**TABLE_3_1, "body": {"shape": "table_3_1", "material": "pdms"}}
    assert keys(planned(sweep)) == keys(planned(sweep, scene=other))


def test_a_sample_is_cut_into_panels(planned):
    sample = {"points": 2200, "seed": 3, "ranges": {"load": {"from": 1, "to": 10, "spacing": "log"}}}
    made = planned(grid={"speed": [1e-3], "sample": sample}, figures=["regime_map"])
    assert counts(made) == (3, 1, 1)
    chunks = [panel.spec["sample"] for panel in made.of_kind("panel")]
    assert [(chunk["first"], chunk["size"]) for chunk in chunks] == [(0, 1024), (1024, 1024), (2048, 152)]
    longer = planned(grid={"speed": [1e-3], "sample": {**sample, "points": 3000}})
    assert keys(longer)[:2] == keys(made)[:2]


def test_studies_share_a_panel(planned):
    one, other = planned(), planned({"scene/shear_strength": "1 MPa"}, name="other")
    assert counts(merge([one, other])) == (1, 2, 0)
    assert counts(merge([one, one])) == counts(one)


def test_two_studies_with_one_name_do_not_merge(planned):
    with pytest.raises(StudyError, match="two different studies"):
        merge([planned(), planned(title="Another")])


def test_accuracy_is_in_the_key_by_its_numbers(planned):
    assert keys(planned(accuracy="draft")) != keys(planned())
    assert keys(planned(accuracy="standard")) == keys(planned())
    spelt_out = planned(solver={"name": "auto", "order": 6, "nodes": 129})
    assert keys(spelt_out) == keys(planned(accuracy="draft"))
    # The spectral elements know no nodes: nothing else about the accuracy is in their key.
    one, other = (
        planned(solver={"name": "spectral", "order": 7}, accuracy=name) for name in ("draft", "standard")
    )
    assert keys(one) == keys(other)


def test_source_accuracy_brings_the_sources_domain(planned):
    assert planned(accuracy="source").nodes[0].spec["scene"]["half_domain"] == 1e-3
    own = planned({"scene/half_domain": "2 mm"}, scene=copy.deepcopy(TABLE_3_1), accuracy="source")
    assert own.nodes[0].spec["scene"]["half_domain"] == 2e-3


def test_keys_do_not_depend_on_how_a_number_is_written(planned):
    other = copy.deepcopy(TABLE_3_1)
    other["body"] = {
        "material": {"poisson_ratio": "0.4999", "young_modulus": "1e7"},
        "shape": {"radius": "1 cm", "kind": "cylinder"},
    }
    assert keys(planned(scene=other)) == keys(planned())


def test_keys_are_the_same_in_another_process(planned, tmp_path):
    here = keys(planned())
    code = (
        "import sys, json; from softlub.study import load, plan; "
        "print(json.dumps([n.key for n in plan(load(sys.argv[1], config_dir=sys.argv[2])).of_kind('panel')]))"
    )
    arguments = [sys.executable, "-c", code, str(tmp_path / "one.yaml"), str(ROOT / "config")]
    there = subprocess.run(arguments, check=True, capture_output=True, text=True, env={"PYTHONHASHSEED": "7"})
    assert json.loads(there.stdout) == here


def test_specs_are_json_and_keys_are_safe_in_paths(planned):
    made = planned({"grid/scene.surface": ["table_3_1"]}, figures=["stribeck"])
    for node in made.nodes:
        assert json.loads(json.dumps(node.spec, allow_nan=False)) == node.spec
        assert all(character.isalnum() or character in "-_" for character in node.key)


def test_reading_and_planning_loads_no_heavy_library():
    heavy = {"scipy", "xarray", "numba", "matplotlib", "felupe", "SurfaceTopography", "pint"}
    code = f"import sys, softlub.study; print(sorted({heavy} & set(sys.modules)))"
    shown = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert shown.stdout.strip() == "[]"
