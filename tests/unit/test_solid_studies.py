"""Studies of finite-element bodies: what is planned, counted by nodes, and the message that each mistake gets."""

from __future__ import annotations

import copy
from pathlib import Path

import numpy as np
import pytest
import yaml

from softlub.study import StudyError, load, merge, plan

ROOT = Path(__file__).parents[2]
SHIPPED = sorted((ROOT / "config" / "studies").glob("ch5-*.yaml"))

SOLID = {
    "kind": "solid",
    "scene": {"body": {"shape": "triangle", "material": "L_H"}, "friction": 0.4},
    "grid": {"load": "17 N/m"},
}
EQUIVALENCE = {
    "kind": "equivalence",
    "scene": {"body": {"shape": "triangle", "material": "L"}, "friction": 0.4},
    "grid": {"load": "17 N/m", "coefficient": [1, 1.5]},
}
MATERIAL = {
    "kind": "material",
    "scene": {"body": {"material": "L", "shape": "triangle"}},
    "grid": {"frequency": [1, 1e6], "stiffness_frequency": [0, 1e3]},
}
FILM = {
    "scene": {
        "body": {"shape": "triangle", "material": "L_H", "stiffness": "initial"},
        "surface": "table_3_1",
        "lubricant": "water",
    },
    "grid": {"load": 17, "speed": [1e-3, 1e-2]},
}
PRONY = {"times": [1e-3, 1e-2], "terms": [0.5, 0.2], "normalised": "long_term"}
RELAXING = {"kind": "viscoelastic", "hyperelastic": "L_H", "prony": PRONY}
NEARLY = {"kind": "linear_elastic", "young_modulus": 3.5e6, "poisson_ratio": 0.49}
DELETE = "<left out>"


@pytest.fixture
def read(tmp_path):
    def make(block, changes=None, name="one", accuracy=None):
        block = copy.deepcopy(block)
        for key, value in (changes or {}).items():
            *parents, last = key.split("/")
            place = block
            for parent in parents:
                place = place.setdefault(parent, {})
            if value is DELETE:
                del place[last]
            else:
                place[last] = value
        path = tmp_path / f"{name}.yaml"
        path.write_text(yaml.safe_dump(block, sort_keys=False))
        return load(path, accuracy=accuracy, config_dir=ROOT / "config")

    return make


@pytest.fixture
def planned(read):
    return lambda *arguments, **options: plan(read(*arguments, **options))


@pytest.fixture
def message(read):
    def refused(*arguments, **options):
        with pytest.raises(StudyError) as caught:
            read(*arguments, **options)
        text = str(caught.value)
        assert "pydantic" not in text
        assert "Traceback" not in text
        return text

    return refused


def counts(made):
    kinds = ("state", "stiffness", "equivalence", "law", "panel", "study")
    return {kind: len(made.of_kind(kind)) for kind in kinds if made.of_kind(kind)}


def keys(made, kind="state"):
    return [node.key for node in made.of_kind(kind)]


def test_a_solid_study_has_a_state_a_stiffness_and_nothing_else(planned):
    made = planned(SOLID)
    assert counts(made) == {"state": 1, "stiffness": 1, "study": 1}
    state, stiffness, study = made.nodes
    assert state.path == f"state/{state.key}.nc"
    assert stiffness.path == f"stiffness/{stiffness.key}.nc"
    assert made.inputs(study) == (state, stiffness)


def test_a_stiffness_is_made_where_something_compares_with_it(planned):
    half_space = planned(SOLID, {"compare": ["half_space"], "datum": "1 mm"})
    assert counts(half_space) == {"state": 1, "study": 1}
    assert counts(planned(SOLID, {"compare": []})) == {"state": 1, "study": 1}
    assert counts(planned(SOLID, {"compare": ["constrained"]}))["stiffness"] == 1


def test_every_load_and_scene_has_a_state_and_loads_share_a_stiffness(planned):
    made = planned(SOLID, {"grid/load": [10, 17], "grid/scene.friction": [0, 0.4]})
    assert counts(made) == {"state": 4, "stiffness": 1, "study": 1}
    study = made.node("study", "one").spec
    assert study["states"] == [[0, 1], [2, 3]]
    assert study["stiffnesses"] == [0, 0]


@pytest.mark.parametrize(
    "change",
    [
        {"grid/load": 18},
        {"scene/friction": 0.5},
        {"scene/body/material": "Y_H"},
        {"scene/body/shape": {"kind": "triangle", "tip_radius": 1e-4}},
        {"scene/body/element": "reduced_integration"},
        {"scene/body/mesh": {"rows": 12}},
        {"scene/contact_law": {"name": "hard", "penalty": 1e13}},
        {"scene/steps": {"overlap": 3e-6}},
    ],
    ids=str,
)
def test_whatever_decides_a_state_changes_its_key(planned, change):
    assert keys(planned(SOLID, change)) != keys(planned(SOLID))


def test_durations_matter_to_materials_with_a_memory_alone(planned):
    slow = {"scene/steps": {"loading": 10}}
    assert keys(planned(SOLID, slow)) == keys(planned(SOLID))
    relaxing = {"scene/body/material": "L"}
    assert keys(planned(SOLID, {**relaxing, **slow})) != keys(planned(SOLID, relaxing))


def test_the_slide_takes_its_distance_over_its_speed(planned):
    def duration(**steps):
        (state,) = planned(SOLID, {"scene/body/material": "L", "scene/steps": steps}).of_kind("state")
        return state.spec["steps"][-1]["duration"]

    assert duration(sliding_distance="1 mm", sliding_speed="2 mm/s") == 0.5
    assert duration(sliding="50 us") == 5e-5


def test_a_body_without_friction_is_not_slid(planned):
    (state,) = planned(SOLID, {"scene/friction": 0}).of_kind("state")
    assert [step["name"] for step in state.spec["steps"]] == ["in_contact", "loading"]


def test_the_mesh_follows_the_accuracy_and_the_study(planned):
    def mesh(accuracy="standard", **numbers):
        change = {"scene/body/mesh": numbers} if numbers else {}
        (state,) = planned(SOLID, change, accuracy=accuracy).of_kind("state")
        return state.spec["body"]["mesh"]

    assert mesh() == {"edge_nodes": 513, "rows": 11, "flank_columns": 30, "first_height": None}
    assert mesh("draft")["edge_nodes"] == 129
    assert mesh("draft", edge_nodes=65)["edge_nodes"] == 65
    swept = planned(SOLID, {"grid/scene.body.mesh.edge_nodes": [65, 129]})
    assert [node.spec["body"]["mesh"]["edge_nodes"] for node in swept.of_kind("state")] == [65, 129]
    assert (
        keys(swept, "stiffness")[1]
        == keys(planned(SOLID, {"scene/body/mesh": {"edge_nodes": 129}}), "stiffness")[0]
    )


def test_studies_share_what_they_have_in_common(planned):
    one = planned(SOLID, name="one")
    other = planned(SOLID, {"compare": ["reduced", "constrained"], "grid/load": [17, 20]}, name="other")
    film = planned(FILM, name="film")
    assert counts(merge([one, other, film])) == {"state": 2, "stiffness": 1, "panel": 1, "study": 3}


def test_rough_bodies_meet_a_law_and_only_tabulated_ones_wait_for_it(planned):
    surface = {
        "kind": "self_affine",
        "rms_roughness": 1e-6,
        "hurst": 0.8,
        "rolloff": 6e4,
        "cutoff": 1e6,
        "size": 4e-4,
        "points": 256,
    }
    persson = planned(SOLID, {"scene/surface": surface})
    assert counts(persson) == {"state": 1, "stiffness": 1, "study": 1}
    assert persson.of_kind("state")[0].spec["contact"]["name"] == "persson"
    tabulated = planned(SOLID, {"scene/surface": surface, "scene/contact_law": "boundary_element"})
    assert counts(tabulated) == {"state": 1, "stiffness": 1, "law": 1, "study": 1}
    (state,) = tabulated.of_kind("state")
    assert tabulated.inputs(state) == tabulated.of_kind("law")


def test_an_equivalence_has_one_search_and_a_state_a_coefficient(planned):
    made = planned(EQUIVALENCE)
    assert counts(made) == {"state": 3, "stiffness": 3, "equivalence": 1, "study": 1}
    (fit,) = made.of_kind("equivalence")
    assert made.inputs(fit)[0].spec["body"]["material"]["kind"] == "viscoelastic"
    read_by = [node for node in made.of_kind("stiffness") if fit.key in node.inputs]
    assert len(read_by) == 1
    # A coefficient of 1 is the material itself, which other studies know.
    assert keys(planned(SOLID))[0] in keys(made)
    assert keys(planned(SOLID), "stiffness")[0] in keys(made, "stiffness")


def test_durations_are_swept_as_blocks_and_share_the_hyperelastic_bodies(planned):
    steps = [{"label": "slow"}, {"label": "fast", "loading": "1 us", "sliding": "1 us"}]
    made = planned(EQUIVALENCE, {"grid/scene.steps": steps})
    assert counts(made) == {"state": 4, "stiffness": 4, "equivalence": 2, "study": 1}
    assert made.node("study", "one").spec["sweeps"] == [{"dimension": "steps", "labels": ["slow", "fast"]}]


def test_a_material_has_a_stiffness_a_frequency_and_that_at_rest_is_the_hyperelastic_ones(planned):
    made = planned(MATERIAL)
    assert counts(made) == {"stiffness": 2, "study": 1}
    assert keys(made, "stiffness")[0] == keys(planned(SOLID), "stiffness")[0]
    assert made.of_kind("stiffness")[1].spec["frequency"] == 1e3
    bare = {"scene/body": {"material": "L"}, "grid/stiffness_frequency": DELETE}
    assert counts(planned(MATERIAL, bare)) == {"study": 1}


def test_a_film_on_a_meshed_body_waits_for_its_stiffness_alone(planned):
    made = planned(FILM)
    assert counts(made) == {"stiffness": 1, "panel": 1, "study": 1}
    (panel,) = made.of_kind("panel")
    assert panel.spec["stiffnesses"] == [0]
    assert panel.spec["scene"]["half_domain"] is None
    faster = planned(FILM, {"grid/speed": [1e-3, 1e-1]})
    assert keys(faster, "stiffness") == keys(made, "stiffness")
    half_space = {"scene/body": {"shape": "table_3_1", "material": "L_H"}}
    assert counts(planned(FILM, half_space)) == {"panel": 1, "study": 1}
    assert "stiffnesses" not in planned(FILM, half_space).of_kind("panel")[0].spec


def test_chapter_5_is_planned_whole(planned):
    made = merge(plan(load(path, accuracy="standard")) for path in SHIPPED)
    assert set(made.chapters.values()) == {5}
    assert counts(made) == {"state": 17, "stiffness": 21, "equivalence": 4, "study": 8}


def profile(path, x=None, y=None, header="x [mm],y [um]"):
    x = np.linspace(-0.5, 0.5, 41) if x is None else x
    y = 100 * np.asarray(x) ** 2 if y is None else y
    path.write_text("\n".join([header, *(f"{a:g},{b:g}" for a, b in zip(x, y, strict=True))]))


MEASURED = {"kind": "profile", "file": "edge.csv", "width": "3 mm", "height": "2 mm"}


def test_a_measured_edge_is_known_by_what_is_in_its_file(planned, tmp_path):
    profile(tmp_path / "edge.csv")
    body = {"scene/body/shape": MEASURED}
    one = planned(SOLID, body)
    (state,) = one.of_kind("state")
    assert state.files == (str((tmp_path / "edge.csv").resolve()),)
    assert str(tmp_path) not in str(state.spec)
    (tmp_path / "copy.csv").write_bytes((tmp_path / "edge.csv").read_bytes())
    assert keys(planned(SOLID, {"scene/body/shape": {**MEASURED, "file": "copy.csv"}})) == keys(one)
    profile(tmp_path / "edge.csv", y=np.linspace(-0.5, 0.5, 41) ** 2 * 50)
    assert keys(planned(SOLID, body)) != keys(one)
    assert counts(planned(FILM, body)) == {"stiffness": 1, "panel": 1, "study": 1}


@pytest.mark.parametrize(
    ("points", "parts"),
    [
        ({"x": [0, 1, 2], "y": [0, 0, 0]}, ["3 points", "at least 10"]),
        ({"x": [*range(10), 4], "y": [*range(10), 20]}, ["two heights at one x", "point 10"]),
        (
            {"x": [0, 1, 2, 3, 4, 5, 6, 7, 8, 7, 6, 5], "y": [0, 0, 0, 0, 0, 0, 0, 0, 5, 5, 5, -5]},
            ["crosses itself"],
        ),
        ({"header": "x [mm],y [furlong]"}, ['the unit "furlong"', "mm"]),
        ({"header": "x [mm],z [um]"}, ['the column "z" is unknown', "x [mm],y [mm]"]),
        ({"x": np.linspace(-2, 2, 41)}, ["wide", "3"]),
    ],
    ids=lambda value: str(value)[:30],
)
def test_a_measured_edge_that_makes_no_body_is_refused_before_any_job(message, tmp_path, points, parts):
    profile(tmp_path / "edge.csv", **points)
    text = message(SOLID, {"scene/body/shape": MEASURED})
    for part in ("scene.body.shape.file", "edge.csv", *parts):
        assert part in text


def test_a_measured_edge_with_decimal_commas_or_nan_is_refused(message, tmp_path):
    body = {"scene/body/shape": MEASURED}
    (tmp_path / "edge.csv").write_text("x [mm];y [um]\n0,1;0,2\n")
    assert "semicolons" in message(SOLID, body)
    (tmp_path / "edge.csv").write_text('x [mm],y [um]\n"0,1","0,2"\n')
    assert "decimal comma" in message(SOLID, body)
    (tmp_path / "edge.csv").write_text("x [mm],y [um]\n0.1,nan\n")
    assert "not finite" in message(SOLID, body)
    (tmp_path / "edge.csv").unlink()
    assert "no such file" in message(SOLID, body)


def test_a_prony_file_becomes_its_numbers(read, planned, tmp_path):
    text = "# normalised: long_term\nrelaxation_time [ms],term\n1,0.5\n10,0.2\n"
    (tmp_path / "mine.csv").write_text(text)
    written = {"scene/body/material": {**RELAXING, "prony": {"file": "mine.csv"}}}
    series = read(EQUIVALENCE, written).scene["body"]["material"]["prony"]
    assert series["times"] == pytest.approx((1e-3, 1e-2))
    assert series["terms"] == (0.5, 0.2)
    assert keys(planned(EQUIVALENCE, written)) == keys(
        planned(EQUIVALENCE, {"scene/body/material": RELAXING})
    )


def test_measured_moduli_become_a_series(read, tmp_path):
    omega = np.logspace(0, 4, 17)
    phase = 1j * omega * 1e-2
    modulus = 3e6 * (1 + 4 * phase / (1 + phase))
    rows = [f"{w:g},{e.real / 1e6:.8f},{e.imag / 1e6:.8f}" for w, e in zip(omega, modulus, strict=True)]
    header = "frequency [rad/s],storage_modulus [MPa],loss_modulus [MPa]"
    (tmp_path / "dmta.csv").write_text("\n".join([header, *rows]))
    written = {"scene/body/material": {**RELAXING, "prony": {"dmta": "dmta.csv"}}}
    series = read(MATERIAL, written).scene["body"]["material"]["prony"]
    assert series["normalised"] == "long_term"
    assert sum(series["terms"]) == pytest.approx(4, rel=0.1)


def test_measured_moduli_near_glass_are_fitted_with_the_bulk_modulus_of_the_material(read, tmp_path):
    """Tension of 1.2 GPa against K = 2 GPa: taken for incompressible, the terms would come out 7 % too small."""
    omega, shear, bulk = np.logspace(0, 4, 17), 2 * 0.6e6, 2e9
    phase = 1j * omega * 1e-2
    stiff = shear * (1 + 400 * phase / (1 + phase))
    modulus = 9 * bulk * stiff / (3 * bulk + stiff)
    rows = [f"{w:g},{e.real / 1e6:.8f},{e.imag / 1e6:.8f}" for w, e in zip(omega, modulus, strict=True)]
    header = "frequency [rad/s],storage_modulus [MPa],loss_modulus [MPa]"
    (tmp_path / "dmta.csv").write_text("\n".join([header, *rows]))
    rubber = {"kind": "neo_hookean", "c10": "0.6 MPa", "d1": "0.001 1/MPa"}
    written = {
        "scene/body/material": {"kind": "viscoelastic", "hyperelastic": rubber, "prony": {"dmta": "dmta.csv"}}
    }
    series = read(MATERIAL, written).scene["body"]["material"]["prony"]
    assert sum(series["terms"]) == pytest.approx(400, rel=0.01)


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("relaxation_time [s],term\n1,0.5\n", ["normalised"]),
        ("# normalised: instantaneous\nrelaxation_time [s],term\n1,0.7\n2,0.4\n", ["1.1", "below 1"]),
        ("# normalised: long_term\nrelaxation_time [s],term\n1,-0.5\n", ["-0.5", "at least 0"]),
        ("# normalised: long_term\ntime [s],term\n1,0.5\n", ['the column "time"']),
        ('# normalised: long_term\nrelaxation_time [s],term\n"0,5",0.5\n', ["decimal comma"]),
    ],
)
def test_a_prony_file_that_cannot_be_used_is_refused(message, tmp_path, text, parts):
    (tmp_path / "mine.csv").write_text(text)
    said = message(EQUIVALENCE, {"scene/body/material": {**RELAXING, "prony": {"file": "mine.csv"}}})
    for part in ("scene.body.material.prony.file", "mine.csv", *parts):
        assert part in said
    assert "is missing" not in said


MISTAKES = [
    # block, key, value, what the message must hold
    (
        SOLID,
        "scene/body/material",
        {"kind": "neo_hookean", "c10": -1, "d1": 1e-9},
        ["c10 = -1", "above 0 Pa"],
    ),
    (SOLID, "scene/body/material", {"kind": "neo_hooke", "c10": 1, "d1": 1}, ["did you mean neo_hookean?"]),
    (SOLID, "scene/body/material", {"kind": "neo_hookean", "c10": "1 MPa"}, ["d1: is missing"]),
    (SOLID, "scene/body/material", {"kind": "mooney_rivlin", "c10": 0, "c01": 0, "d1": 1e-9}, ["both 0"]),
    (
        SOLID,
        "scene/body/material",
        {"kind": "yeoh", "c10": 1e6, "c20": -1e6, "c30": 1, "d1": 1e-9},
        ["c20", "fall under large strain"],
    ),
    (SOLID, "scene/body/material", "L_X", ["scene.body.material", "no block of this name", "L_H"]),
    (SOLID, "scene/body/material", {"young_modulus": 1e6, "poisson_ratio": 0.51}, ["at most 0.5"]),
    (SOLID, "scene/body/element", "mean_dilation", ["did you mean mean_dilatation?"]),
    (SOLID, "scene/body/shape", "cylinder", ["scene.body.shape", "cylinder"]),
    (SOLID, "scene/body/shape", "wiper", ["not yet built"]),
    (
        SOLID,
        "scene/body/shape",
        {"kind": "triangle", "edge_width": "8 mm"},
        ["edge", "0.008 m", "0.0075 m", "narrower"],
    ),
    (SOLID, "scene/body/shape", {"kind": "triangle", "tip_radius": "20 mm"}, ["does not fit"]),
    (SOLID, "scene/body/shape", {"kind": "triangle", "flank_angle": "100 deg"}, ["flank_angle", "below"]),
    (SOLID, "scene/body/shape", {"kind": "half_cylinder", "radius": "-1 mm", "edge_width": 1}, ["above 0 m"]),
    (SOLID, "scene/body/mesh", {"edge_nodes": 2}, ["scene.body.mesh.edge_nodes", "at least 3"]),
    (SOLID, "scene/body/mesh", {"edge_nodes": 10.5}, ["whole number"]),
    (SOLID, "scene/body/mesh", {"first_height": "1 nm"}, ["scene.body.mesh", "aspect", "below 2000"]),
    (SOLID, "scene/body/stiffness", "initial", ["scene.body.stiffness", "unknown key"]),
    (SOLID, "scene/friction", -0.1, ["scene.friction", "at least 0"]),
    (SOLID, "scene/lubricant", "water", ["scene.lubricant", "unknown key"]),
    (SOLID, "scene/contact_law", "persson", ["needs a rough surface", "hard"]),
    (SOLID, "scene/steps", {"loading": 0}, ["scene.steps.loading", "above 0 s"]),
    (SOLID, "scene/steps", {"loading": "1 m"}, ["a time"]),
    (SOLID, "grid/load", DELETE, ["grid.load: is missing"]),
    (SOLID, "grid/load", "-1 N/m", ["above 0 N/m"]),
    (SOLID, "grid/speed", [1], ["grid.speed", "unknown key"]),
    (SOLID, "compare", ["reduce"], ["did you mean reduced?"]),
    (SOLID, "compare", ["half_space"], ["give datum"]),
    (SOLID, "datum", "1 mm", ["not among compare"]),
    (SOLID, "outputs", ["meshes"], ["did you mean mesh?"]),
    (SOLID, "figures", ["stribeck"], ["stribeck draws studies of the kind stribeck"]),
    (SOLID, "grid/load", {"from": 1, "to": 600, "points": 600}, ["601 jobs", "500 at most"]),
    (EQUIVALENCE, "scene/body/material", "L_H", ["body.material is neo_hookean", "viscoelastic"]),
    (
        EQUIVALENCE,
        "scene/body/material",
        {**RELAXING, "hyperelastic": {"kind": "linear_elastic", "young_modulus": 1e6, "poisson_ratio": 0.5}},
        ["viscoelastic on linear_elastic", "neo_hookean only"],
    ),
    (
        EQUIVALENCE,
        "scene/body/material",
        {**RELAXING, "prony": {**PRONY, "terms": [0.5, -0.2]}},
        ["terms", "entry 2", "at least 0"],
    ),
    (
        EQUIVALENCE,
        "scene/body/material",
        {**RELAXING, "prony": {**PRONY, "terms": [0.8, 0.2], "normalised": "instantaneous"}},
        ["add up to 1", "below 1"],
    ),
    (
        EQUIVALENCE,
        "scene/body/material",
        {**RELAXING, "prony": {**PRONY, "terms": [0.5]}},
        ["2 times and 1 term"],
    ),
    (
        EQUIVALENCE,
        "scene/body/material",
        {**RELAXING, "prony": {"times": [1], "terms": [1]}},
        ["normalised: is missing"],
    ),
    (EQUIVALENCE, "scene/body/material", {**RELAXING, "hyperelastic": "L_Q"}, ["hyperelastic", "no block"]),
    (
        EQUIVALENCE,
        "scene/body/material",
        {**RELAXING, "prony": {**PRONY, "file": "nowhere.csv"}},
        ["scene.body.material.prony.file", "no such file"],
    ),
    (EQUIVALENCE, "grid/coefficient", [0], ["above 0"]),
    (MATERIAL, "scene/body/material", "L_H", ["depend on no frequency", "viscoelastic"]),
    (MATERIAL, "grid/frequency", ["1 kHz"], ["kHz", "2π"]),
    (MATERIAL, "grid/frequency", DELETE, ["grid.frequency: is missing"]),
    (MATERIAL, "scene/body/shape", DELETE, ["give scene.body.shape"]),
    (MATERIAL, "grid/temperature", ["300 K"], ["give scene.time_temperature"]),
    (FILM, "scene/half_domain", "1 mm", ["half_domain is for half-spaces", "edge_width"]),
    (FILM, "solver", "spectral", ["spectral knows half-spaces only", "auto, finite_volume"]),
    (FILM, "solver", {"name": "auto", "half_domain": "1 mm"}, ["as wide as the contact edge"]),
    (FILM, "scene/body/shape", {"kind": "strip", "thickness": 1, "width": 1, "edge_width": 0.5}, ["is flat"]),
    (FILM, "scene/body/stiffness", "half_space", ["take stiffness: initial"]),
    (FILM, "scene/body/mesh", {"first_height": "1 nm"}, ["scene.body.mesh", "aspect", "below 2000"]),
]


@pytest.mark.parametrize(("block", "key", "value", "parts"), MISTAKES, ids=lambda part: str(part)[:40])
def test_a_mistake_gets_one_clear_message(message, block, key, value, parts):
    text = message(block, {key: value})
    for part in parts:
        assert part in text


def test_an_element_that_locks_is_refused_for_an_incompressible_body_alone(message, read):
    change = {"scene/body/material": "specimen_5_4", "scene/body/element": "full_integration"}
    text = message(SOLID, change)
    assert "poisson_ratio = 0.5" in text
    assert "mean_dilatation" in text
    nearly = {"young_modulus": 3.5e6, "poisson_ratio": 0.49}
    assert (
        read(SOLID, {**change, "scene/body/material": nearly}).scene["body"]["element"] == "full_integration"
    )


@pytest.mark.parametrize("block", [SOLID, MATERIAL], ids=["solid", "material"])
def test_an_element_that_locks_is_refused_for_a_relaxing_body_too(message, block):
    relaxing = {**RELAXING, "hyperelastic": {**NEARLY, "poisson_ratio": 0.5}}
    text = message(block, {"scene/body/material": relaxing, "scene/body/element": "full_integration"})
    assert "hyperelastic.poisson_ratio = 0.5" in text


def test_a_frequency_that_leaves_no_volume_to_keep_is_refused(message):
    glassy = {"times": [1e-3], "terms": [3000.0], "normalised": "long_term"}
    relaxing = {**RELAXING, "hyperelastic": NEARLY, "prony": glassy}
    text = message(MATERIAL, {"scene/body/material": relaxing, "grid/stiffness_frequency": [1e5]})
    assert "grid.stiffness_frequency" in text
    assert "Poisson's ratio" in text


def test_rules_over_several_keys_are_told_in_our_words(message):
    text = message(SOLID, {"compare": ["half_space"]})
    assert "give datum" in text
    assert "Value error" not in text


def test_temperatures_in_other_scales_or_below_the_pole_are_refused(message, read):
    shift = {"first_constant": 17.4, "second_constant": "51.6 K", "reference_temperature": "250 K"}
    warm = {"scene/time_temperature": shift, "grid/temperature": ["280 K"]}
    assert read(MATERIAL, warm).solid["temperature"] == (280.0,)
    assert "another zero" in message(MATERIAL, {**warm, "grid/temperature": ["20 degC"]})
    assert "190" in message(MATERIAL, {**warm, "grid/temperature": ["190 K"]})


def test_a_constraint_is_kept_of_a_hard_contact_alone(message):
    surface = {"kind": "self_affine", "rms_roughness": 1e-6, "hurst": 0.8, "rolloff": 6e4, "cutoff": 1e6}
    text = message(SOLID, {"scene/surface": surface, "compare": ["constrained"]})
    assert "contact_law is persson" in text


def test_a_sample_over_a_meshed_body_is_refused(message):
    ranges = {"scene.body.shape.tip_radius": {"from": 1e-4, "to": 2e-4}}
    grid = {"load": 17, "speed": [1e-3], "sample": {"points": 8, "ranges": ranges}}
    assert "a reduced stiffness for every point" in message({**FILM, "grid": grid})
