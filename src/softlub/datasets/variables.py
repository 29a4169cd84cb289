"""Every variable of every dataset: its name, unit, meaning and the equation of the source it follows."""

from __future__ import annotations

from typing import NamedTuple


class Variable(NamedTuple):
    """Attributes that a variable carries in every file."""

    units: str
    long_name: str
    source_equation: str = ""

    @property
    def attributes(self) -> dict[str, str]:
        """As xarray attributes; an empty equation is left out."""
        return {name: value for name, value in self._asdict().items() if value}


VARIABLES: dict[str, Variable] = {
    # coordinates
    "load": Variable("N/m", "applied load per length", "3-18"),
    "speed": Variable("m/s", "speed of the sliding wall"),
    "node": Variable("1", "node of the solver's grid"),
    "x": Variable("m", "position along the sliding direction"),
    # friction
    "friction_coefficient": Variable("1", "friction coefficient", "3-38"),
    "friction_coefficient_fluid": Variable("1", "friction coefficient, fluid part", "3-36"),
    "friction_coefficient_couette": Variable("1", "friction coefficient, Couette part of the fluid", "3-36"),
    "friction_coefficient_poiseuille": Variable("1", "friction coefficient, Poiseuille part of the fluid", "3-36"),
    "friction_coefficient_solid": Variable("1", "friction coefficient, solid part", "3-32"),
    "friction_coefficient_error": Variable("1", "estimated absolute error of the friction coefficient"),
    "friction_coefficient_fluid_error": Variable("1", "estimated absolute error of the fluid part of friction"),
    "shear_strength": Variable("Pa", "shear strength of the real contact", "3-32"),
    "hersey_number": Variable("N/m", "viscosity times speed"),
    # film and contact
    "separation_min": Variable("m", "smallest mean separation"),
    "separation_min_error": Variable("1", "estimated relative error of the smallest separation"),
    "separation_central": Variable("m", "mean separation at x = 0"),
    "lambda_ratio": Variable("1", "smallest separation over rms roughness"),
    "load_share_solid": Variable("1", "share of the load carried by asperities", "3-18"),
    "real_contact_width": Variable("m", "real contact area per length of the contact, integral of A/A0", "3-32"),
    "real_contact_width_error": Variable("m", "estimated absolute error of the real contact width"),
    "contact_width": Variable("m", "width over which the total pressure exceeds 1e-3 of its maximum"),
    "contact_area_ratio_max": Variable("1", "largest real over nominal contact area", "3-32"),
    "rupture_position": Variable("m", "where the pressurised film ends"),
    "rigid_approach": Variable("m", "rigid term of the separation", "3-12"),
    "pressure_centroid": Variable("m", "centroid of the total pressure"),
    # inputs of each curve
    "viscosity": Variable("Pa s", "viscosity of the lubricant"),
    "rms_roughness": Variable("m", "root mean square roughness"),
    "young_modulus": Variable("Pa", "Young's modulus"),
    "long_term_modulus": Variable("Pa", "long-term Young's modulus"),
    "plane_strain_modulus": Variable("Pa", "plane-strain modulus E/(1 - nu^2)"),
    "radius": Variable("m", "radius of the cylinder"),
    "half_domain": Variable("m", "half-width of the domain"),
    "hertz_half_width": Variable("m", "half-width of the dry contact"),
    # fields
    "fluid_pressure": Variable("Pa", "fluid pressure", "3-2"),
    "solid_pressure": Variable("Pa", "asperity pressure", "3-11"),
    "separation": Variable("m", "mean separation", "3-17"),
    # state of each point
    "converged": Variable("1", "whether the point converged"),
    "iterations": Variable("1", "iterations of the solver"),
    "residual": Variable("1", "largest scaled residual of the last iterate"),
    "load_error": Variable("1", "relative error of the load balance", "3-20"),
    "solver_seconds": Variable("s", "CPU time of the point"),
    "flags": Variable("1", "what is known against the point"),
}

FLAGS: dict[str, int] = {
    "not_converged": 1,
    "outside_half_space": 2,
    "percolates": 4,
    "law_extrapolated": 8,
    "domain_truncates": 16,
    "not_attempted": 32,
    "inaccurate": 64,
}
"""Bits of the variable `flags` (CF convention: flag_masks and flag_meanings)."""
