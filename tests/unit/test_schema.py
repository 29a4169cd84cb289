"""The JSON schema: it is the generated one, and it accepts what the reader accepts."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import jsonschema
import pytest
import yaml

from softlub.study import StudyError, load
from softlub.study.files import read_block
from softlub.study.schema import text

CONFIG = Path(__file__).parents[2] / "config"
VALIDATOR = jsonschema.Draft202012Validator(
    json.loads((CONFIG / "study.schema.json").read_text(encoding="utf-8"))
)

MINIMAL = {
    "scene": {
        "body": {
            "shape": {"kind": "cylinder", "radius": "10 mm"},
            "material": {"young_modulus": 1e7, "poisson_ratio": 0.5},
        },
        "surface": "table_3_1",
        "lubricant": {"viscosity": "0.1 Pa s"},
    },
    "grid": {"load": "100 N/m", "speed": [1e-3]},
}

ACCEPTED = {
    "minimal": {},
    "names": {
        "scene": {
            "body": {"shape": "table_3_1", "material": "pdms"},
            "surface": "smooth",
            "lubricant": "water",
        }
    },
    "spaces": {"grid": {"load": " 1 kN/m", "speed": "1e-3"}},
    "range": {
        "grid": {
            "load": {"from": 1, "to": "10 N/m", "points": 3},
            "speed": {"from": 1, "to": 2, "points": "4", "spacing": "log"},
        }
    },
    "sweeps": {
        "grid": {
            "load": 1,
            "speed": 1,
            "scene.body.shape.radius": ["1 mm", 0.01],
            "scene.contact_law": ["none", {"name": "persson", "label": "a"}],
        }
    },
    "solvers": {
        "grid": {
            "load": 1,
            "speed": 1,
            "solver": ["auto", {"name": "mehl", "sweep": "newton_raphson", "from": "1 mm/s", "every": 2}],
        }
    },
    "solver": {"solver": {"name": "spectral", "order": 4, "label": "fine"}},
    "sample": {
        "grid": {
            "speed": 1,
            "sample": {"points": 8, "seed": 2, "ranges": {"load": {"from": 1, "to": "2 N/m"}}},
        }
    },
    "words": {
        "title": "a",
        "about": "b",
        "accuracy": "draft",
        "outputs": ["fields"],
        "solver": "finite_volume",
    },
    "figures": {"figures": ["stribeck", {"draw": "profiles", "name": "a", "speed": "1 mm/s", "amplify": 10}]},
    "stand_ins": {"stand_ins": [{"key": "scene.surface", "reason": "why"}]},
}

REFUSED = {
    "unknown key": {"nonsense": 1},
    "negative": {"grid": {"load": -1, "speed": 1}},
    "no number": {"grid": {"load": "mm", "speed": 1}},
    "kind": {"kind": "solid"},
    "figure": {"figures": ["nonsense"]},
    "figure option": {"figures": [{"draw": "stribeck", "speed": 1}]},
    "solver option": {"solver": {"name": "bml", "order": 4}},
}


def test_the_committed_schema_is_the_generated_one():
    committed = (CONFIG / "study.schema.json").read_text(encoding="utf-8")
    assert committed == text(), "run python -m softlub.study.schema"


def test_the_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(VALIDATOR.schema)


@pytest.mark.parametrize("path", sorted((CONFIG / "studies").glob("*.yaml")), ids=lambda path: path.stem)
def test_shipped_studies_fit(path):
    VALIDATOR.validate(read_block(path))
    # An editor's YAML reads 1e-3 as text and no less must fit.
    VALIDATOR.validate(yaml.safe_load(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize("changes", ACCEPTED.values(), ids=ACCEPTED)
def test_what_the_reader_accepts_fits(tmp_path, changes):
    block = copy.deepcopy(MINIMAL) | changes
    path = tmp_path / "mine.yaml"
    path.write_text(yaml.safe_dump(block))
    load(path, config_dir=CONFIG)
    VALIDATOR.validate(block)


@pytest.mark.parametrize("changes", REFUSED.values(), ids=REFUSED)
def test_what_does_not_fit_is_refused_by_the_reader(tmp_path, changes):
    block = copy.deepcopy(MINIMAL) | changes
    assert not VALIDATOR.is_valid(block)
    path = tmp_path / "mine.yaml"
    path.write_text(yaml.safe_dump(block))
    with pytest.raises(StudyError):
        load(path, config_dir=CONFIG)
