"""Units and bounds as annotations."""

from dataclasses import fields
from typing import Annotated, get_args, get_origin, get_type_hints

import pytest

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.surfaces.spectrum import SelfAffine
from softlub.units import Length, PoissonRatio, Unit


@pytest.mark.parametrize(
    ("unit", "allowed", "refused"),
    [
        (Unit("m", above=0), [1e-300, 1.0], [0.0, -1.0]),
        (Unit("m", at_least=0), [0.0, 1.0], [-1e-300]),
        (Unit("1", below=1), [0.999, -5.0], [1.0]),
        (Unit("1", at_most=1), [1.0], [1.0000001]),
        (Unit("1", above=0, at_most=0.5), [0.5, 0.4999], [0.0, 0.51]),
        (Unit("K"), [-1e300, 0.0], []),
    ],
)
def test_bounds(unit, allowed, refused):
    assert all(unit.allows(value) for value in allowed)
    assert not any(unit.allows(value) for value in refused)


@pytest.mark.parametrize("unit", [Unit("m"), Unit("m", above=0), Unit("m", at_most=1)])
@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf")])
def test_numbers_that_are_none_are_never_allowed(unit, value):
    assert not unit.allows(value)


@pytest.mark.parametrize(
    ("unit", "words"),
    [
        (Unit("m", above=0), "above 0 m"),
        (Unit("1", above=0, at_most=0.5), "above 0 and at most 0.5"),
        (Unit("Pa", at_least=1, below=2), "at least 1 and below 2 Pa"),
        (Unit("Pa"), "any finite number Pa"),
        (Unit("1"), "any finite number"),
    ],
)
def test_bounds_in_words(unit, words):
    assert unit.allowed() == words


def test_named_annotations_carry_their_unit():
    assert get_args(Length) == (float, Unit("m", above=0))
    assert get_args(PoissonRatio)[1].at_most == 0.5


@pytest.mark.parametrize("parameters", [SelfAffine, PerssonLaw, Lubricant])
def test_every_number_of_a_parameter_class_has_a_unit(parameters):
    """The study reader builds its checks from these annotations: a bare float would go unchecked."""
    hints = get_type_hints(parameters, include_extras=True)
    for field in fields(parameters):
        hint = hints[field.name]
        options = [hint] if get_origin(hint) is Annotated else list(get_args(hint) or (hint,))
        assert float not in options, f"{parameters.__name__}.{field.name} is a number without a unit"
