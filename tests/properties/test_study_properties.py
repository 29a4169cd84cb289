"""What holds for every number and every order of keys."""

from __future__ import annotations

import copy
import json
import random
import tempfile
from pathlib import Path

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from softlub.study import StudyError, load, plan
from softlub.study.nodes import digest
from softlub.study.quantities import read_quantity
from softlub.units import Unit

PREFIXES = {"": 0, "k": 3, "M": 6, "m": -3, "u": -6, "µ": -6, "n": -9}
UNITS = {"m": "m", "Pa": "Pa", "N/m": "N/m", "m/s": "m/s", "Pa s": "Pa s"}

mantissas = st.integers(1, 10**9)
shifts = st.integers(-6, 3)
numbers = st.floats(1e-12, 1e12, allow_nan=False)


@settings(deadline=None)  # pint is loaded within the first example
@given(numbers, st.sampled_from(sorted(UNITS)), st.sampled_from(sorted(PREFIXES)))
def test_a_quantity_is_its_number_times_its_prefix(number, unit, prefix):
    read = read_quantity(f"{number!r} {prefix}{unit}", Unit(UNITS[unit]))
    assert read == pytest.approx(number * 10.0 ** PREFIXES[prefix], rel=1e-13)


@settings(deadline=None)  # pint is loaded within the first example
@given(numbers, st.sampled_from(sorted(UNITS)))
def test_a_number_comes_back_as_it_was_written(number, unit):
    for written in (number, repr(number), f"{number!r} {unit}"):
        assert read_quantity(written, Unit(UNITS[unit])) == number


@settings(deadline=None)
@given(mantissas, shifts, st.sampled_from(sorted(PREFIXES)))
def test_every_way_of_writing_a_decimal_number_gives_the_same_bits(mantissa, shift, prefix):
    plain = read_quantity(f"{mantissa}e{shift}", Unit("m"))
    assert read_quantity(f"{mantissa}e{shift - PREFIXES[prefix]} {prefix}m", Unit("m")) == plain


blocks = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False, allow_infinity=False) | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner, max_size=4),
    max_leaves=12,
)


def shuffled(block, order):
    if isinstance(block, dict):
        keys = list(block)
        order.shuffle(keys)
        return {key: shuffled(block[key], order) for key in keys}
    return [shuffled(entry, order) for entry in block] if isinstance(block, list) else block


@settings(deadline=None)
@given(blocks, st.randoms(use_true_random=False))
def test_a_hash_does_not_depend_on_the_order_of_keys(block, order):
    assert digest(shuffled(block, order)) == digest(block)
    assert digest(json.loads(json.dumps(block))) == digest(block)


@settings(max_examples=25, deadline=None)
@given(
    modulus=st.integers(1, 99),
    radius=st.integers(1, 99),
    speeds=st.lists(st.integers(1, 10**6), min_size=1, max_size=4, unique=True),
    order=st.randoms(use_true_random=False),
)
def test_keys_of_a_study_depend_on_its_meaning_alone(modulus, radius, speeds, order):
    speeds = sorted(speeds)
    plain = study(1e6 * modulus, f"{radius}e-3", [f"{speed}e-6" for speed in speeds])
    worded = shuffled(study(f"{modulus} MPa", f"{radius} mm", [f"{speed} µm/s" for speed in speeds]), order)
    changed = study(f"{modulus + 1} MPa", f"{radius} mm", [f"{speed} µm/s" for speed in speeds])
    assert panel_key(plain) == panel_key(worded)
    assert panel_key(plain) != panel_key(changed)


def study(modulus, radius, speeds):
    return {
        "scene": {
            "body": {
                "shape": {"kind": "cylinder", "radius": radius},
                "material": {"young_modulus": modulus, "poisson_ratio": 0.5},
            },
            "surface": "smooth",
            "lubricant": {"viscosity": "0.1 Pa s"},
        },
        "grid": {"load": 100, "speed": speeds},
    }


def panel_key(block):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "drawn.yaml"
        path.write_text(json.dumps(block), encoding="utf-8")
        (panel,) = plan(load(path)).of_kind("panel")
        return panel.key


junk = st.one_of(
    blocks,
    st.integers(),
    st.floats(),
    st.sampled_from(
        ["smooth", "persson", "10 mm", "-1", "1,5", "nan", {}, [], {"kind": "cylinder"}, {"name": "auto"}]
    ),
)


@settings(max_examples=200, deadline=None)
@given(st.data())
def test_whatever_stands_in_a_file_it_is_read_or_refused_with_a_message(data):
    block = study("10 MPa", "10 mm", ["1 mm/s"]) | {
        "solver": {"name": "mehl", "from": 1e-3, "label": "a"},
        "outputs": ["friction"],
        "figures": [{"draw": "stribeck"}],
        "stand_ins": [{"key": "scene", "reason": "why"}],
    }
    block["scene"]["shear_strength"] = {"over": "speed", "at": [1, 2], "value": [1, 2]}
    block["scene"]["surface"] = {"kind": "self_affine", "rms_roughness": 1e-6, "rolloff": 1e4, "cutoff": 1e6}
    block["scene"]["contact_law"] = {"name": "persson"}
    block["grid"] |= {
        "scene.surface.hurst": [0.5],
        "scene.contact_law": ["exponential", {"name": "persson", "gamma": 0.5, "label": "b"}],
        "sample": {"points": 4, "ranges": {"load": {"from": 1, "to": 2}}},
    }
    for _ in range(data.draw(st.integers(1, 3))):
        place = block
        while True:
            key = data.draw(st.sampled_from(sorted(place) if isinstance(place, dict) else range(len(place))))
            if isinstance(place[key], (dict, list)) and place[key] and data.draw(st.booleans()):
                place = place[key]
            else:
                break
        action = (
            data.draw(st.sampled_from(["replace", "drop", "rename"]))
            if isinstance(place, dict)
            else "replace"
        )
        if action == "replace" or len(place) == 1:
            place[key] = copy.deepcopy(data.draw(junk))
        elif action == "drop":
            del place[key]
        else:
            place[data.draw(st.text(max_size=6))] = place.pop(key)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "drawn.yaml"
        path.write_text(yaml.safe_dump(block), encoding="utf-8")
        try:
            plan(load(path, config_dir=folder))
            return
        except StudyError as error:
            refusal = str(error)
    assert refusal.startswith(str(path))


def test_the_random_order_is_one():
    # Guards the two tests above: a shuffle that shuffles nothing would prove nothing.
    block = {str(i): i for i in range(9)}
    assert list(shuffled(block, random.Random(1))) != list(block)
