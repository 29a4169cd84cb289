"""Grids of studies of finite-element bodies: loads, equivalence coefficients, frequencies."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import ConfigDict

from softlub.study.base import StudyModel
from softlub.study.grid import LOAD, SWEPT_SCHEMA
from softlub.study.ranges import Values
from softlub.units import Unit

FREQUENCY = Unit("rad/s", above=0)
REST_OR_FREQUENCY = Unit("rad/s", at_least=0)


class SolidGrid(StudyModel):
    """Loads; swept fields of the scene are read apart."""

    model_config = ConfigDict(json_schema_extra=SWEPT_SCHEMA)
    further_keys: ClassVar[str] = "and any field of the scene as scene.…"
    load: Annotated[tuple[float, ...], Values(LOAD)]


class EquivalenceGrid(SolidGrid):
    """Loads, and coefficients that are tried beside the fitted one."""

    coefficient: Annotated[tuple[float, ...], Values(Unit("1", above=0))] = ()


class MaterialGrid(StudyModel):
    """Frequencies of the moduli, and those that a reduced stiffness is made for; temperatures."""

    model_config = ConfigDict(json_schema_extra=SWEPT_SCHEMA)
    further_keys: ClassVar[str] = "and any field of the scene as scene.…"
    frequency: Annotated[tuple[float, ...], Values(FREQUENCY)]
    stiffness_frequency: Annotated[tuple[float, ...], Values(REST_OR_FREQUENCY)] = ()
    temperature: Annotated[tuple[float, ...], Values(Unit("K", above=0))] = ()


Datum = Annotated[tuple[float, ...], Values(Unit("m", above=0))]
