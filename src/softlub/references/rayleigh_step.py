"""The step bearing of Lord Rayleigh: two parallel films, the wider one first.

The flow vh/2 - h³p'/(12η) is the same in both, so that the pressure is a triangle whose top lies at the step.
Lord Rayleigh, Notes on the theory of lubrication, Phil. Mag. 35 (1918): most load at h₁/h₂ = 1 + √3/2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class RayleighStep:
    """Step bearing of unit width, without pressure at both ends.

    Parameters
    ----------
    inlet : float
        h₁ before the step [m].
    outlet : float
        h₂ behind the step [m].
    inlet_length : float
        B₁ [m].
    outlet_length : float
        B₂ [m].
    viscosity : float
        η [Pa s].
    speed : float
        v of the wall [m/s].
    """

    inlet: float
    outlet: float
    inlet_length: float
    outlet_length: float
    viscosity: float
    speed: float

    @property
    def step_pressure(self) -> float:
        """p at the step, 6ηv(h₁ - h₂)/(h₁³/B₁ + h₂³/B₂) [Pa]."""
        conductance = self.inlet**3 / self.inlet_length + self.outlet**3 / self.outlet_length
        return 6 * self.viscosity * self.speed * (self.inlet - self.outlet) / conductance

    def pressure(self, position: FloatArray) -> FloatArray:
        """p [Pa] at positions in [0, B₁ + B₂] [m]."""
        end = self.inlet_length + self.outlet_length
        return np.interp(position, [0.0, self.inlet_length, end], [0.0, self.step_pressure, 0.0])

    @property
    def load(self) -> float:
        """∫ p dx [N/m]."""
        return self.step_pressure * (self.inlet_length + self.outlet_length) / 2

    @property
    def friction(self) -> float:
        """Drag on the moving wall [N/m]."""
        couette = self.inlet_length / self.inlet + self.outlet_length / self.outlet
        return self.viscosity * self.speed * couette + self.step_pressure * (self.inlet - self.outlet) / 2
