"""Study files: what is read, and the one message that each mistake gets."""

from __future__ import annotations

import copy
from pathlib import Path

import pytest
import yaml

from softlub.study import StudyError, load, select, study_files
from softlub.study.drawings import DRAWINGS as KNOWN_DRAWINGS

ROOT = Path(__file__).parents[2]
SHIPPED = sorted((ROOT / "config" / "studies").glob("*.yaml"))
DELETE = "<left out>"


@pytest.fixture
def block():
    return {
        "title": "A study",
        "kind": "stribeck",
        "scene": {
            "body": {
                "shape": {"kind": "cylinder", "radius": "10 mm"},
                "material": {"young_modulus": "10 MPa", "poisson_ratio": 0.4999},
            },
            "surface": {
                "kind": "self_affine",
                "rms_roughness": "1 um",
                "hurst": 0.8,
                "rolloff": "1e4 1/m",
                "cutoff": 7.8e9,
            },
            "lubricant": {"viscosity": "0.1 Pa s"},
        },
        "grid": {"load": "100 N/m", "speed": ["1e-3 m/s", 0.01]},
        "figures": ["stribeck"],
    }


def write(folder, block, name="mine.yaml"):
    path = folder / name
    path.write_text(yaml.safe_dump(block, allow_unicode=True), encoding="utf-8")
    return path


def changed(block, key, value):
    block = copy.deepcopy(block)
    *parents, last = key.split("/")
    place = block
    for parent in parents:
        place = place[parent]
    if value is DELETE:
        del place[last]
    else:
        place[last] = value
    return block


def message(path, **options):
    with pytest.raises(StudyError) as caught:
        load(path, **options)
    text = str(caught.value)
    assert str(path) in text
    assert "pydantic" not in text
    assert "Traceback" not in text
    return text


def test_a_study_is_read_into_si(tmp_path, block):
    study = load(write(tmp_path, block))
    assert study.name == "mine"
    assert study.scene["body"]["shape"] == {"kind": "cylinder", "radius": 0.01}
    assert study.scene["body"]["material"]["kind"] == "linear_elastic"
    assert study.scene["contact_law"] == {"name": "persson", "gamma": 1.0, "pressure_factor": 1.0}
    assert study.scene["lubricant"]["cavitation"] == "reynolds"
    assert study.shear_strength == {"modulus_fraction": 0.1}
    assert study.loads == (100.0,)
    assert study.speeds == (1e-3, 1e-2)
    assert study.accuracy == "standard"


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_studies_are_read(path):
    study = load(path)
    assert study.name.startswith(f"ch{study.chapter}-")
    assert study.chapter in (3, 4, 5)


def test_a_smooth_surface_has_no_law(tmp_path, block):
    assert load(write(tmp_path, changed(block, "scene/surface", "smooth"))).scene["contact_law"] == {
        "name": "none"
    }


def test_accuracy_of_the_file_goes_before_the_configurations_unless_overruled(tmp_path, block):
    silent, own = write(tmp_path, block), write(tmp_path, {**block, "accuracy": "source"}, "own.yaml")
    assert load(silent, accuracy="draft").accuracy == "draft"
    assert load(own, accuracy="draft").accuracy == "source"
    assert load(own, accuracy="draft", overrule=True).accuracy == "draft"


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ("0.1 E", {"modulus_fraction": 0.1}),
        ("1 MPa", {"value": 1e6}),
        (1e6, {"value": 1e6}),
        (
            {"over": "speed", "at": ["1 mm/s", 1.0], "value": ["1 MPa", 2e6]},
            {"table": {"over": "speed", "at": [1e-3, 1.0], "value": [1e6, 2e6]}},
        ),
        (
            {"table": {"over": "load", "at": [10, 20], "value": [1e5, 0]}},
            {"table": {"over": "load", "at": [10.0, 20.0], "value": [1e5, 0.0]}},
        ),
    ],
)
def test_shear_strength(tmp_path, block, written, read):
    assert load(write(tmp_path, changed(block, "scene/shear_strength", written))).shear_strength == read


MISTAKES = [
    # key, value, what the message must hold
    ("scene/surface/rms_rougness", 1e-6, ["scene.surface.rms_rougness", "did you mean rms_roughness?"]),
    ("scne", 1, ["scne", "did you mean scene?"]),
    ("grid/laod", 1, ["grid.laod", "did you mean load?"]),
    (
        "scene/lubricant/viscosity",
        "0.1 Pa",
        ["scene.lubricant.viscosity", '"0.1 Pa"', "viscosity", "0.1 Pa s"],
    ),
    ("scene/body/shape/radius", "10 kg", ["scene.body.shape.radius", '"10 kg"', "a length", "10 mm"]),
    ("scene/body/shape/radius", "mm", ["does not begin with a number"]),
    ("scene/body/shape/radius", "1,5 mm", ['"1,5 mm"', "comma"]),
    ("scene/body/shape/radius", "1.5 furlogs", ["furlogs", "not a unit"]),
    ("scene/body/shape/radius", float("nan"), ['radius = ".nan"', "not a finite number"]),
    ("scene/body/shape/radius", "nan m", ["not a finite number"]),
    ("scene/body/shape/radius", float("inf"), ["finite"]),
    ("scene/body/shape/radius", "1e400 m", ["finite"]),
    ("scene/body/shape/radius", 10**400, ["too large"]),
    ("scene/body/shape/radius", True, ["not a number"]),
    ("scene/body/shape/radius", None, ["scene.body.shape.radius = (empty)", "not a number"]),
    ("scene/body/shape/radius", [1], ["not a number"]),
    ("scene/body/shape/radius", -0.01, ["-0.01", "above 0 m"]),
    ("scene/body/shape/radius", 0, ["above 0 m"]),
    ("scene/body/shape/radius", DELETE, ["scene.body.shape.radius: is missing"]),
    ("scene/body/material/young_modulus", "-10 MPa", ["-10 MPa", "above 0 Pa"]),
    ("scene/body/material/young_modulus", 0, ["above 0 Pa"]),
    ("scene/body/material/poisson_ratio", 0.51, ["0.51", "above 0 and at most 0.5"]),
    ("scene/body/material/poisson_ratio", 0, ["above 0 and at most 0.5"]),
    ("scene/body/material/poisson_ratio", "0.3 m", ["a pure number"]),
    ("scene/lubricant/viscosity", 0, ["above 0 Pa s"]),
    ("scene/lubricant/viscosity", "-1 mPa s", ["above 0 Pa s"]),
    ("scene/lubricant/cavitation", "reynold", ["scene.lubricant.cavitation", "did you mean reynolds?"]),
    ("scene/lubricant/flow_factor", "percolation", ["not yet built"]),
    ("scene/surface/rms_roughness", 0, ["scene.surface.rms_roughness", "above 0 m"]),
    ("scene/surface/rms_roughness", -1e-6, ["above 0 m"]),
    ("scene/surface/hurst", 1.5, ["at most 1"]),
    ("scene/surface/cutoff", "1e3 1/m", ["scene.surface", "cutoff", "above rolloff"]),
    ("scene/surface/long_cutoff", 1e5, ["long_cutoff"]),
    ("scene/surface/seed", -1, ["scene.surface.seed", "at least 0"]),
    ("scene/surface/kind", "self_afine", ["did you mean self_affine?"]),
    ("scene/surface", "measured", ["needs its parameters", "file: …"]),
    ("scene/surface", "self_affine", ["needs its parameters"]),
    ("scene/surface", "tabel_3_1", ["scene.surface", '"tabel_3_1"', "no block"]),
    ("scene/surface", 3, ["scene.surface"]),
    ("scene/body/material", "rubber", ["scene.body.material", '"rubber"', "no block"]),
    ("scene/body/shape", "wiper", ["not yet built"]),
    ("scene/body/shape", {"kind": "triangle"}, ["scene.body", "half_space", "take stiffness: initial"]),
    ("scene/body/stiffness", "initial", ["scene.body", "shape is cylinder", "triangle"]),
    ("scene/body/mesh", {"rows": 4}, ["mesh is for bodies of finite elements"]),
    ("scene/body/shape", {"radius": 1}, ["needs the key kind"]),
    ("scene/body/stiffness", "deformed", ["scene.body.stiffness", "not yet built", "half_space"]),
    ("scene/body", 1, ["scene.body", "keys and values"]),
    ("scene", 1, ["scene", "keys and values"]),
    ("scene", DELETE, ["scene: is missing"]),
    ("scene/contact_law", "person", ["did you mean persson?"]),
    ("scene/contact_law", "boundary_element", ["surface.size and surface.points"]),
    ("scene/contact_law", {"name": "persson", "gama": 1}, ["did you mean gamma?"]),
    ("scene/contact_law", {"name": "persson", "gamma": 2}, ["scene.contact_law.gamma", "at most 1"]),
    ("scene/contact_law", {"name": "exponential", "gamma": 1}, ["scene.contact_law.gamma", "unknown key"]),
    ("scene/shear_strength", "calibrated", ["not yet built"]),
    ("scene/shear_strength", "0.1 Q", ["scene.shear_strength", '"0.1 Q"', "0.1 E"]),
    ("scene/shear_strength", "-0.1 E", ["at least 0"]),
    ("scene/shear_strength", {"over": "time", "at": [1, 2], "value": [1, 2]}, ["over time", "speed"]),
    ("scene/shear_strength", {"over": "speed", "at": [2, 1], "value": [1, 2]}, ["ascending"]),
    ("scene/shear_strength", {"over": "speed", "at": [1], "value": [1, 2]}, ["one length"]),
    ("grid", DELETE, ["grid: is missing"]),
    ("grid", [1], ["grid", "keys and values"]),
    ("grid/load", DELETE, ["load is missing"]),
    ("grid/speed", DELETE, ["grid.speed: is missing"]),
    ("grid/speed", [], ["grid.speed", "empty"]),
    ("grid/speed", [1.0, 0.1], ["grid.speed", "ascending order", "0.1 follows 1"]),
    ("grid/speed", [1.0, 1.0], ["ascending order"]),
    ("grid/speed", [1.0, "2 m"], ["entry 2", '"2 m"', "a speed"]),
    ("grid/speed", {"from": 1, "to": 2}, ["lacks points"]),
    ("grid/speed", {"from": 1, "to": 2, "points": 3, "spcing": "log"}, ["did you mean spacing?"]),
    ("grid/speed", {"from": 1, "to": 2, "points": 3, "spacing": "lin"}, ["did you mean linear?"]),
    ("grid/speed", {"from": 2, "to": 1, "points": 3}, ["from 2 must lie below to 1"]),
    ("grid/speed", {"from": 1, "to": 2, "points": 1}, ["points", "at least 2"]),
    ("grid/speed", {"from": 1, "to": 2, "points": 2.5}, ["whole number"]),
    (
        "grid/scene.surface.rms_rougness",
        [1e-6],
        ["grid.scene.surface.rms_rougness", "did you mean rms_roughness?"],
    ),
    ("grid/scene.surfase.rms_roughness", [1e-6], ["surfase", "did you mean surface?"]),
    ("grid/scene.surface.rms_roughness", [], ["grid.scene.surface.rms_roughness", "is empty"]),
    ("grid/scene.surface.rms_roughness", [2e-6, 1e-6], ["grid.scene.surface.rms_roughness", "ascending"]),
    ("grid/scene.surface.rms_roughness", [1e-6, "2 Pa"], ["entry 2", '"2 Pa"', "a length"]),
    ("grid/scene.surface.rms_roughness", {"from": 1e-6, "to": "-1 um", "points": 3}, ["to", "above 0 m"]),
    ("grid/scene.surface.rms_roughness.x", [1], ["has no fields"]),
    ("grid/scene.surface.kind", ["smooth"], ["cannot be swept by itself"]),
    ("grid/scene.shear_strength", ["0.1 E"], ["cannot be swept yet"]),
    ("grid/scene.contact_law", ["persson", "persson"], ["twice", "label"]),
    ("grid/scene.contact_law", ["persson", "perssson"], ["entry 2", "did you mean persson?"]),
    ("grid/scene.surface.rolloff", [1e4, 1e10], ["cutoff", "rolloff"]),
    ("grid/solver", [], ["grid.solver"]),
    ("grid/solver", ["auto", "auto"], ["auto twice"]),
    ("grid/solver", [{"name": "bml", "to": 1e-9}], ["bml is left no speed"]),
    ("grid/sample", {"points": 8, "ranges": {}}, ["ranges is empty"]),
    ("grid/sample", {"points": 8, "ranges": {"lod": {"from": 1, "to": 2}}}, ["lod", "load"]),
    ("grid/sample", {"points": 8, "ranges": {"load": {"from": 1, "to": 2}}}, ["load is given twice"]),
    (
        "grid/sample",
        {"points": 8, "ranges": {"scene.surface.hurst": {"from": 0.5, "to": 2}}},
        ["grid.sample.ranges.scene.surface.hurst", "at most 1"],
    ),
    ("solver", "atuo", ["solver", "did you mean auto?"]),
    ("solver", {"name": "spectral", "ordr": 8}, ["solver.ordr", "did you mean order?"]),
    ("solver", {"name": "spectral", "order": 1}, ["solver.order", "at least 3"]),
    ("solver", {"name": "mehl", "sweep": "gauss"}, ["solver.sweep", "gauss_seidel"]),
    ("accuracy", "standart", ["accuracy", "did you mean standard?"]),
    ("kind", "benchmark", ["kind", "not yet built"]),
    ("kind", "stribek", ["did you mean stribeck?"]),
    ("outputs", ["frictoin"], ["outputs", "frictoin", "did you mean friction?"]),
    ("outputs", "friction", ["outputs", "list"]),
    ("figures", ["stribek"], ["figures[1]", "stribek", "did you mean stribeck?"]),
    ("figures", [{"name": "a"}], ["needs the key draw"]),
    ("figures", [{"name": "a/b", "draw": "stribeck"}], ["no file name"]),
    ("figures", [{"draw": "profiles", "sped": 1}], ["did you mean speed?"]),
    ("figures", [{"draw": "profiles", "speed": "1 m"}], ["a speed"]),
    ("figures", [{"draw": "profiles", "speed": 5}], ["not among the speeds"]),
    ("figures", [{"draw": "profiles", "load": 5}], ["asks for 5 N/m", "not among the loads"]),
    ("figures", [{"draw": "profiles", "load": "5 m/s"}], ["5 m/s", "N/m"]),
    ("figures", [{"draw": "module_comparison"}], ["several solvers"]),
    ("figures", ["parameter_study"], ["a swept field"]),
    ("figures", ["regime_map"], ["a designed sample"]),
    ("figures", ["stribeck", "stribeck"], ["two figures"]),
    ("figures", "stribeck", ["figures", "list"]),
    (
        "stand_ins",
        [{"key": "scene.surface.rms", "reason": "why"}],
        ["scene.surface.rms", "no key of this file"],
    ),
    ("stand_ins", [{"key": "scene.surface"}], ["stand_ins[1].reason", "missing"]),
    ("title", 3, ["title", "text"]),
]


@pytest.mark.parametrize(("key", "value", "parts"), MISTAKES, ids=lambda part: str(part)[:40])
def test_a_mistake_gets_one_clear_message(tmp_path, block, key, value, parts):
    text = message(write(tmp_path, changed(block, key, value)))
    for part in parts:
        assert part in text
    assert len(text.splitlines()) == 1


def test_a_misspelt_key_is_not_called_missing_as_well(tmp_path, block):
    surface = block["scene"]["surface"]
    surface["rms_rougness"] = surface.pop("rms_roughness")
    text = message(write(tmp_path, block))
    assert "did you mean rms_roughness?" in text
    assert "missing" not in text


def test_all_mistakes_of_a_file_are_listed_together(tmp_path, block):
    block["scene"]["body"]["shape"]["radius"] = "1,5 mm"
    block["scene"]["lubricant"]["viscosity"] = -1
    block["grid"]["scene.body.material.young_modulus"] = [1e7, "x"]
    block["figures"] = ["nonsense"]
    lines = message(write(tmp_path, block)).splitlines()
    assert "problems" in lines[0]
    for place in ("scene.body.shape.radius", "scene.lubricant.viscosity", "figures[1]"):
        assert sum(place in line for line in lines) == 1


def test_an_unquoted_decimal_comma_is_recognised(tmp_path, block):
    path = tmp_path / "comma.yaml"
    whole = yaml.safe_dump(changed(block, "scene/lubricant", {"viscosity": "XXX"}))
    path.write_text(
        whole.replace("viscosity: XXX", "{viscosity: 1,5 Pa s}").replace("lubricant:\n", "lubricant: ")
    )
    assert "decimal comma" in message(path)


@pytest.mark.parametrize(
    ("content", "part"),
    [
        (b"", "is empty"),
        (b"# only a comment\n", "is empty"),
        (b"a: [1\n", "is not YAML"),
        (b"a: b: c\n", "is not YAML"),
        (b"a: 1\na: 2\n", "the key a stands twice"),
        (b"- a\n- b\n", "no keys and values"),
        (b"just words\n", "no keys and values"),
        (b"CDF\x02\x00\x00\xff\xfe", "is binary"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "is binary"),
        ("title: für".encode("latin-1"), "UTF-8"),
        ("title: a".encode("utf-16"), "UTF-8"),
        (b"a: &a [*a]\n", "nested"),
        (b"a: !!python/object/apply:os.getcwd []\n", "is not YAML"),
        (b"? [a, b]\n: 1\n", "is not YAML"),
        (b"[" * 4000, ""),
    ],
    ids=lambda part: str(part)[:24],
)
def test_a_file_that_is_no_study(tmp_path, content, part):
    path = tmp_path / "bad.yaml"
    path.write_bytes(content)
    assert part in message(path)


def test_a_missing_file_and_a_folder(tmp_path):
    assert "no such file" in message(tmp_path / "absent.yaml")
    (tmp_path / "folder.yaml").mkdir()
    assert "is a folder" in message(tmp_path / "folder.yaml")


def test_a_name_that_is_no_file_name(tmp_path, block):
    assert "letters, digits" in message(write(tmp_path, block, "my study.yaml"))


def test_persson_on_a_smooth_surface_is_refused(tmp_path, block):
    block["scene"] |= {"surface": "smooth", "contact_law": "persson"}
    assert "needs a rough surface" in message(write(tmp_path, block))


@pytest.mark.parametrize("solver", ["spectral", "bml", "mehl", "ehl"])
def test_solvers_that_know_one_cavitation_condition(tmp_path, block, solver):
    block["scene"]["lubricant"]["cavitation"] = "mass_conserving"
    assert "reynolds only" in message(write(tmp_path, {**block, "solver": solver}))


def test_named_blocks(tmp_path, block):
    blocks = tmp_path / "surfaces"
    blocks.mkdir()
    (blocks / "ground.yaml").write_text(
        "about: mine\nstand_in: not measured\n" + yaml.safe_dump(block["scene"]["surface"])
    )
    named = write(tmp_path, changed(block, "scene/surface", "ground"))
    study = load(named, config_dir=tmp_path)
    assert study.scene == load(write(tmp_path, block, "spelt_out.yaml")).scene
    assert study.stand_ins[0].reason == "not measured"
    (blocks / "ground.yaml").write_text("kind: self_affine\nrms_roughness: 1 kg\n")
    text = message(named, config_dir=tmp_path)
    assert "ground.yaml" in text
    assert "1 kg" in text


def test_sweeps_become_dimensions(tmp_path, block):
    del block["scene"]["body"]["material"]["young_modulus"]
    block["grid"] |= {
        "scene.body.material.young_modulus": ["10 MPa", 2e7],
        "scene.contact_law": ["exponential", {"name": "persson"}, {"name": "persson", "gamma": 0.45}],
        "scene.lubricant": [{"viscosity": 1, "label": "oil"}, "water"],
    }
    sweeps = {
        sweep.dimension: sweep for sweep in load(write(tmp_path, block), config_dir=ROOT / "config").sweeps
    }
    assert sweeps["young_modulus"].values == (1e7, 2e7)
    assert sweeps["young_modulus"].path == "body.material.young_modulus"
    assert sweeps["contact_law"].labels == ("exponential", "persson gamma=1", "persson gamma=0.45")
    assert sweeps["contact_law"].values[2] == {"name": "persson", "gamma": 0.45, "pressure_factor": 1.0}
    assert sweeps["lubricant"].labels == ("oil", "water")


def test_a_sweep_inside_another_is_refused(tmp_path, block):
    block["grid"] |= {"scene.surface": ["smooth"], "scene.surface.hurst": [0.5]}
    assert "which it lies inside of" in message(write(tmp_path, block))


def test_parameters_that_clash_only_together_are_refused(tmp_path, block):
    rough = block["scene"]["surface"]
    block["grid"] |= {"scene.contact_law": ["none", "persson"], "scene.surface": [rough, "smooth"]}
    assert "do not go together" in message(write(tmp_path, block))


def test_two_studies_with_one_name(tmp_path, block):
    (tmp_path / "studies").mkdir()
    first = write(tmp_path / "studies", block)
    with pytest.raises(StudyError, match="name of another study") as caught:
        select({"study": str(write(tmp_path, {**block, "title": "Another"}))}, tmp_path)
    assert str(first) in str(caught.value)
    assert select({"study": str(first)}, tmp_path) == [first]
    write(tmp_path / "studies", block, "mine.yml")
    with pytest.raises(StudyError, match="name of another study"):
        study_files(tmp_path)


def test_the_configuration_names_studies(tmp_path, block):
    (tmp_path / "studies").mkdir()
    first = write(tmp_path / "studies", block)
    assert select({"studies": ["mine"]}, tmp_path) == [first]
    for config, part in (
        ({"studies": ["mnie"]}, "did you mean mine?"),
        ({"studies": []}, "list the studies"),
        ({"studies": ["mine"], "accuracy": "drafft"}, "did you mean draft?"),
        ({"studies": ["mine"], "acuracy": "draft"}, "did you mean accuracy?"),
    ):
        with pytest.raises(StudyError, match=r"config\.yaml") as caught:
            select(config, tmp_path)
        assert part in str(caught.value)


def test_groups_of_outputs_hold_variables_of_the_datasets():
    from softlub.datasets.variables import VARIABLES
    from softlub.study.outputs import OUTPUTS

    assert {name for names in OUTPUTS.values() for name in names} <= set(VARIABLES)


def test_the_drawings_are_those_that_are_drawn():
    from softlub.figures import DRAWINGS

    # Work and precision is drawn of the benchmarks, whose datasets no study makes.
    assert set(KNOWN_DRAWINGS) == set(DRAWINGS) - {"work_precision"}


@pytest.mark.parametrize(("draw", "most"), [("stribeck", 16), ("load_share", 8)])
def test_more_curves_than_a_figure_tells_apart_are_refused(tmp_path, block, draw, most):
    """The reader's numbers are the drawings' own."""
    from softlub.figures import looks

    def study(count):
        values = [1e7 * step for step in range(1, count + 1)]
        swept = changed(block, "grid/scene.body.material.young_modulus", values)
        return write(tmp_path, changed(swept, "figures", [draw]))

    assert KNOWN_DRAWINGS[draw].curves == most == (looks.MOST_CURVES if most == 16 else looks.MOST_DASHED)
    assert load(study(most)).figures
    assert f"would show {most + 1} curves and tells {most} apart" in message(study(most + 1))


def test_options_of_drawings_are_those_of_their_functions():
    import inspect
    from importlib import import_module

    from softlub.figures import DRAWINGS
    from softlub.study.figures import options_of

    for name in KNOWN_DRAWINGS:
        parameters = set(inspect.signature(import_module(DRAWINGS[name].module).draw).parameters) - {
            "dataset"
        }
        assert set(options_of(name)) == parameters


def test_the_examples_of_the_configurations_readme(tmp_path):
    text = (ROOT / "config" / "README.md").read_text(encoding="utf-8")
    first, second, contact, solid, material = (
        part.split("```", 1)[0] for part in text.split("```yaml\n")[1:]
    )
    mine = tmp_path / "mine.yaml"
    mine.write_text(first, encoding="utf-8")
    assert load(mine, config_dir=ROOT / "config").figures[0].draw == "stribeck"
    assert len(first.splitlines()) <= 6
    mine.write_text(first.split("grid:")[0] + second.rstrip() + "\n  load: 1\n  speed: 1\n", encoding="utf-8")
    sweeps = load(mine, config_dir=ROOT / "config").sweeps
    assert [sweep.labels for sweep in sweeps] == [
        ("exponential", "persson gamma=1", "persson gamma=0.45"),
        ("table_3_1", "ground"),
    ]
    mine.write_text(contact, encoding="utf-8")
    assert load(mine, config_dir=ROOT / "config").kind == "rough_contact"
    mine.write_text(solid, encoding="utf-8")
    assert load(mine, config_dir=ROOT / "config").scene["body"]["mesh"]["edge_nodes"] == 513
    relaxing = yaml.safe_load(solid)
    relaxing["scene"]["body"]["material"] = yaml.safe_load(material)
    mine.write_text(yaml.safe_dump(relaxing), encoding="utf-8")
    series = load(mine, config_dir=ROOT / "config").scene["body"]["material"]["prony"]
    assert series["times"] == (1e-6, 1e-3)


SWEPT_ROUGHNESS = """\
scene:
  body: {shape: {kind: cylinder, radius: 10 mm}, material: pdms}
  surface: table_3_1
  lubricant: water
grid:
  load: 50 N/m
  speed: {from: 1e-5 m/s, to: 1 m/s, points: 40, spacing: log}
  scene.surface.rms_roughness: [1 um, 2 um]
figures: [stribeck]
"""


def told(tmp_path, old, new, text=SWEPT_ROUGHNESS):
    """What the reader says of the study above with one piece of its text replaced."""
    assert old in text
    (tmp_path / "mine.yaml").write_text(text.replace(old, new), encoding="utf-8")
    return message(tmp_path / "mine.yaml", config_dir=ROOT / "config")


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("pdms", "nbbr", 'scene.body.material = "nbbr"'),
        ("table_3_1", "tabel_3_1", 'scene.surface = "tabel_3_1"'),
        ("water", "wine", 'scene.lubricant = "wine"'),
        ("surface.rms_roughness: [1 um, 2 um]", "surface: [tabel_3_1, smooth]", "grid.scene.surface"),
    ],
)
def test_an_unknown_name_spoils_no_other_block(tmp_path, old, new, place):
    text = told(tmp_path, old, new)
    assert len(text.splitlines()) == 1
    assert place in text


def test_every_unknown_name_is_said(tmp_path):
    text = told(tmp_path, "table_3_1\n  lubricant: water", "tabel_3_1\n  lubricant: wine")
    assert [line.split(" = ")[0].strip() for line in text.splitlines()[1:]] == [
        "scene.surface",
        "scene.lubricant",
    ]


def test_what_figures_lack_is_said_beside_a_wrong_scene(tmp_path, block):
    block["scene"]["body"]["material"]["poisson_ratio"] = 0.6
    block["figures"] = ["regime_map", {"name": "mine", "draw": "module_comparison"}, "stribeck", "deflection"]
    lines = message(write(tmp_path, block)).splitlines()[1:]
    assert len(lines) == 4
    assert "poisson_ratio" in lines[0]
    assert "regime_map needs a designed sample" in lines[1]
    assert "module_comparison (mine) needs several solvers" in lines[2]
    assert "deflection draws studies of the kind deflection" in lines[3]


def test_a_figure_of_a_sweep_that_is_wrong_is_not_called_in_need_of_one(tmp_path):
    text = told(tmp_path, "[1 um, 2 um]\nfigures: [stribeck]", "[2 um, 1 um]\nfigures: [parameter_study]")
    assert "ascending" in text
    assert len(text.splitlines()) == 1


@pytest.mark.parametrize(
    ("entries", "told_of"),
    [
        ({"load": {"from": 1, "to": 2, "points": 1000}, "speed": 2001}, ["2,001,000 points", "sample"]),
        ({"scene.surface.hurst": {"from": 0.5, "to": 1, "points": 1001}}, ["1,001 curves", "sample"]),
        # Several large sweeps: refused without listing 1e12 scenes.
        (
            {
                f"scene.{path}": {"from": low, "to": 2 * low, "points": 10_000}
                for path, low in (
                    ("surface.rolloff", 1e4),
                    ("lubricant.viscosity", 0.1),
                    ("body.material.young_modulus", 1e6),
                )
            },
            ["2,000,000,000,000 points"],
        ),
    ],
    ids=["points", "curves", "three sweeps"],
)
def test_too_large_a_grid_is_refused_with_what_would_do(tmp_path, block, entries, told_of):
    speeds = entries.pop("speed", 2)
    block["grid"] |= {"speed": {"from": 0.1, "to": 1, "points": speeds}, **entries}
    text = message(write(tmp_path, block))
    for part in ["take fewer points", *told_of]:
        assert part in text
    assert len(text.splitlines()) == 1


def test_the_largest_grid_and_too_large_a_sample(tmp_path, block):
    del block["figures"]  # no figure tells so many curves apart
    block["grid"]["load"] = {"from": 1, "to": 2, "points": 1000}
    assert len(load(write(tmp_path, block)).loads) == 1000
    block["grid"] |= {
        "load": 100,
        "speed": {"from": 0.1, "to": 1, "points": 5},
        "sample": {"points": 400_000, "ranges": {"scene.surface.hurst": {"from": 0.5, "to": 1}}},
    }
    assert load(write(tmp_path, block)).sample.points == 400_000
    block["grid"]["speed"]["points"] = 6
    text = message(write(tmp_path, block))
    assert "2,400,000 points" in text
    assert "grid.sample" not in text


def test_too_many_surfaces_are_refused_before_they_are_listed(tmp_path):
    surface = {"kind": "self_affine", "rms_roughness": 1e-6, "hurst": 0.8, "rolloff": 1e5, "cutoff": 1e6}
    study = {
        "kind": "rough_contact",
        "scene": {"surface": surface | {"size": 1e-4, "points": 64}},
        "grid": {"scene.surface.hurst": {"from": 0.5, "to": 1, "points": 501}},
    }
    assert "501 surfaces" in message(write(tmp_path, study))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("[1 um, 2 um]", "[1e-6, 1.1e-3]"),
        ("[1 um, 2 um]", "[1e-6, 2]"),
        ("radius: 10 mm", "radius: 10 um"),
    ],
)
def test_a_roughness_like_the_shape_itself_is_refused(tmp_path, old, new):
    text = told(tmp_path, old, new)
    assert "a tenth of body.shape.radius" in text
    assert "check the units" in text
    assert len(text.splitlines()) == 1


@pytest.mark.parametrize(
    ("old", "new", "parts"),
    [
        ("  load: 50", "\tload: 50", ["a tab? indent with spaces", "line 6"]),
        ("from: 1e-5", "from: -1e-5", ['from "-1e-5 m/s" must be above 0']),
        ("points: 40", "points: 2.5", ["points 2.5 must be a whole number"]),
        ("lubricant: water", "lubricant: {viscosity: 100 cSt}", ["kinematic: multiply by the density"]),
        ("surface: table_3_1", "surface: smooth", ["a smooth surface has none"]),
        ("[stribeck]", "[parameter_study, regime_map]", ["figures: regime_map needs"]),
    ],
)
def test_a_message_says_what_to_do(tmp_path, old, new, parts):
    text = told(tmp_path, old, new)
    for part in parts:
        assert part in text
    assert len(text.splitlines()) == 1


def test_a_wrong_swept_value_is_not_blamed_on_the_block_that_it_replaces(tmp_path):
    text = told(tmp_path, "[1 um, 2 um]", "{from: 0, to: 2 um, points: 3}")
    assert "rms_roughness = 0: must be above 0 m" in text
    assert "table_3_1.yaml" not in text


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("10 mm", "3,5 mm", "scene.body.shape.radius = 3,5 mm"),
        ("10 mm", "0,5 mm", "scene.body.shape.radius = 0,5 mm"),
        ("from: 1e-5 m/s", "from: 0,5 m/s", "grid.speed.from = 0,5 m/s"),
        ("water", "{viscosity: 0,05}", "scene.lubricant.viscosity = 0,05"),
        ("[stribeck]", "[{draw: stribeck, height: 3,5}]", "figures[1].height = 3,5"),
    ],
)
def test_a_decimal_comma_inside_braces_gets_one_message(tmp_path, old, new, place):
    text = told(tmp_path, old, new)
    meant = place.split(" = ")[1].replace(",", ".")
    assert text.endswith(f"{place}: a decimal comma? numbers have a decimal point: {meant}")
    assert len(text.splitlines()) == 1


def test_a_decimal_comma_hides_no_other_mistake(tmp_path):
    text = told(tmp_path, "10 mm}, material: pdms", "3,5 mm}, material: nbbr")
    assert len(text.splitlines()) == 3
    assert '"nbbr"' in text


def test_two_equal_decimals_behind_commas(tmp_path):
    assert "a decimal comma?" in told(tmp_path, "from: 1e-5 m/s, to: 1", "from: 0,5 m/s, to: 1,5")


def test_what_the_command_line_says_is_not_blamed_on_the_configuration_alone(tmp_path):
    for config, part in (
        ({"studies": ["a"], "accuracy": "hi"}, "accuracy"),
        ({"study": ""}, "study: names no file"),
        ({"study": None}, "study: names no file"),
    ):
        with pytest.raises(StudyError, match=r"config\.yaml or --config") as caught:
            select(config, tmp_path)
        assert part in str(caught.value)


def test_a_file_to_be_renamed(tmp_path, block):
    text = message(write(tmp_path, block, "my study.yaml"))
    assert text.endswith("rename the file: letters, digits, - and _ only")
