"""Numbers with units: what they are in SI, and what is refused."""

from __future__ import annotations

import math

import pytest

from softlub.study.quantities import QuantityError, read_quantity
from softlub.units import Unit

LENGTH = Unit("m", above=0)
PRESSURE = Unit("Pa", above=0)
NUMBER = Unit("1")


@pytest.mark.parametrize(
    ("written", "unit", "read"),
    [
        ("10 mm", LENGTH, 0.01),
        ("1 cm", LENGTH, 0.01),
        ("0.01", LENGTH, 0.01),
        (0.01, LENGTH, 0.01),
        ("10mm", LENGTH, 0.01),
        (" 7 mm ", LENGTH, 0.007),
        ("+.5 um", LENGTH, 5e-7),
        ("3. µm", LENGTH, 3e-6),
        ("3 μm", LENGTH, 3e-6),
        ("1e-3", LENGTH, 1e-3),
        ("1e7", PRESSURE, 1e7),
        ("10 MPa", PRESSURE, 1e7),
        ("10 N/mm**2", PRESSURE, 1e7),
        ("1 bar", PRESSURE, 1e5),
        ("100 N/m", Unit("N/m"), 100.0),
        ("0.1 N/mm", Unit("N/m"), 100.0),
        ("1.5 mm/s", Unit("m/s"), 1.5e-3),
        ("0.1 Pa s", Unit("Pa s"), 0.1),
        ("100 mPa·s", Unit("Pa s"), 0.1),
        ("100 mPa*s", Unit("Pa s"), 0.1),
        ("1 P", Unit("Pa s"), 0.1),
        ("1e4 1/m", Unit("1/m"), 1e4),
        ("1e4 m^-1", Unit("1/m"), 1e4),
        ("7.8 1/nm", Unit("1/m"), 7.8e9),
        ("50 %", NUMBER, 0.5),
        (3, NUMBER, 3.0),
        ("-3", NUMBER, -3.0),
    ],
)
def test_quantities_in_si(written, unit, read):
    # Equal to the last bit: keys of the plan are made of these numbers.
    assert read_quantity(written, unit) == read


@pytest.mark.parametrize(
    ("written", "unit", "part"),
    [
        ("1,5 mm", LENGTH, "comma"),
        ("1,500.0 mm", LENGTH, "comma"),
        (",5 mm", LENGTH, "comma"),
        ("nan", LENGTH, "not a finite number"),
        (".nan", LENGTH, "not a finite number"),
        ("NaN m", LENGTH, "not a finite number"),
        ("-inf m", LENGTH, "not a finite number"),
        ("infinity", LENGTH, "not a finite number"),
        (math.nan, LENGTH, "finite"),
        (math.inf, LENGTH, "finite"),
        ("1e999", LENGTH, "finite"),
        ("1e308 km", LENGTH, "finite"),
        ("mm", LENGTH, "does not begin with a number"),
        ("", LENGTH, "does not begin with a number"),
        ("ten mm", LENGTH, "does not begin with a number"),
        ("10 kg", LENGTH, '"kg" is not a unit of a length'),
        ("10 mm mm", LENGTH, "not a unit"),
        ("10 mpa", PRESSURE, "not a unit"),
        ("0.1 E", PRESSURE, '"E" is not a unit'),
        ("10 2 mm", LENGTH, "not a unit"),
        ("10 000 mm", LENGTH, "not a unit"),
        ("1_000 mm", LENGTH, "not a unit"),
        ("1 (m", LENGTH, "not a unit"),
        ("1 m - m", LENGTH, "not a unit"),
        ("1 __import__('os')", LENGTH, "not a unit"),
        ("20 degC", LENGTH, "not a unit"),
        ("0.8 m", NUMBER, "a pure number"),
        ("٣ mm", LENGTH, "does not begin with a number"),
        (True, LENGTH, "not a number"),
        (None, LENGTH, "not a number"),
        ([1], LENGTH, "not a number"),
        (10**400, LENGTH, "too large"),
        ("0 mm", LENGTH, "above 0 m"),
        ("-1 mm", LENGTH, "above 0 m"),
        (0.6, Unit("1", above=0, at_most=0.5), "above 0 and at most 0.5"),
    ],
)
def test_what_is_no_such_quantity(written, unit, part):
    with pytest.raises(QuantityError) as caught:
        read_quantity(written, unit)
    assert part in str(caught.value)


def test_plain_numbers_need_no_unit_library():
    import subprocess
    import sys

    code = (
        "import sys; from softlub.study.quantities import read_quantity; from softlub.units import Unit; "
        "read_quantity('1e7', Unit('Pa')); sys.exit('pint' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
