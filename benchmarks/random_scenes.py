"""Random contacts: every input even in its logarithm within its range, from a seed."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.surfaces.spectrum import SelfAffine

POISSON_RATIO = 0.4999
HURST, ROLLOFF, CUTOFF = 0.8, 1e4, 7.8e9
"""Of table 3-1."""
SHEAR_STRENGTH_SHARE = 0.1
"""σ1 over E."""

Ranges = Mapping[str, tuple[float, float]]

STRESS_RANGES: Ranges = {
    "rms_roughness": (0.05e-6, 10e-6),
    "young_modulus": (0.5e6, 50e6),
    "load": (1.0, 1e4),
    "viscosity": (1e-3, 1.0),
    "radius": (0.01, 0.01),
}
STRESS_SPEEDS = (1e-7, 10.0)
MAP_RANGES: Ranges = {
    "rms_roughness": (0.1e-6, 10e-6),
    "young_modulus": (1e6, 50e6),
    "load": (10.0, 1e3),
    "viscosity": (1e-3, 1.0),
    "radius": (1e-3, 50e-3),
}
"""Those of the study ch3-map."""
MAP_SPEEDS = (1e-5, 10.0)


class Scene(NamedTuple):
    """Inputs of one contact, SI."""

    rms_roughness: float
    young_modulus: float
    load: float
    viscosity: float
    radius: float

    @property
    def shear_strength(self) -> float:
        """σ1 [Pa]."""
        return SHEAR_STRENGTH_SHARE * self.young_modulus

    def problem(self, speed: float = 1.0) -> Problem:
        """The contact, its law not yet tabulated."""
        modulus = LinearElastic(self.young_modulus, POISSON_RATIO).plane_strain_modulus
        surface = SelfAffine(self.rms_roughness, hurst=HURST, rolloff=ROLLOFF, cutoff=CUTOFF)
        return Problem(
            body=HalfSpaceCylinder(self.radius, modulus),
            law=PerssonLaw(surface, modulus),
            lubricant=Lubricant(self.viscosity),
            load=self.load,
            speed=speed,
            rms_roughness=self.rms_roughness,
        )

    def study(self, title: str, speed: float) -> dict:
        """The same contact at one speed as the content of a study file."""
        return {
            "title": title,
            "kind": "stribeck",
            "scene": {
                "body": {
                    "shape": {"kind": "cylinder", "radius": self.radius},
                    "material": {"young_modulus": self.young_modulus, "poisson_ratio": POISSON_RATIO},
                },
                "surface": {
                    "kind": "self_affine",
                    "rms_roughness": self.rms_roughness,
                    "hurst": HURST,
                    "rolloff": ROLLOFF,
                    "cutoff": CUTOFF,
                },
                "lubricant": {"viscosity": self.viscosity},
            },
            "grid": {"load": [self.load], "speed": [speed]},
        }


def log_uniform(generator: np.random.Generator, bounds: tuple[float, float], *size: int) -> np.ndarray:
    """Numbers even in their logarithm."""
    low, high = np.log(bounds)
    return np.exp(generator.uniform(low, high, size))


def random_scenes(generator: np.random.Generator, ranges: Ranges, count: int) -> list[Scene]:
    """Contacts within the ranges."""
    columns = [log_uniform(generator, ranges[name], count) for name in Scene._fields]
    return [Scene(*map(float, row)) for row in zip(*columns, strict=True)]
