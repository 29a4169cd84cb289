"""What a study's dataset keeps: groups of variables that a study file names under `outputs`."""

from __future__ import annotations

from collections.abc import Iterable

OUTPUTS: dict[str, tuple[str, ...]] = {
    "friction": (
        "friction_coefficient",
        "friction_coefficient_fluid",
        "friction_coefficient_couette",
        "friction_coefficient_poiseuille",
        "friction_coefficient_solid",
        "friction_coefficient_error",
        "friction_coefficient_fluid_error",
        "shear_strength",
    ),
    "separation": (
        "separation_min",
        "separation_min_error",
        "separation_central",
        "lambda_ratio",
        "rupture_position",
        "rigid_approach",
    ),
    "contact": (
        "load_share_solid",
        "real_contact_width",
        "real_contact_width_error",
        "contact_width",
        "contact_area_ratio_max",
        "pressure_centroid",
    ),
    "fields": ("x", "fluid_pressure", "solid_pressure", "separation"),
}
"""Group -> variables; the state of each point and the inputs are always kept."""

CONTACT_OUTPUTS = ("maps",)
"""Of a rough contact: contact pressure and gap over the surface; curves over the load are always kept."""
SURFACE_OUTPUTS = ("heights",)
"""Of a surface: its heights; statistics and spectra are always kept."""
SOLID_OUTPUTS = ("history", "mesh")
"""Of a finite-element body: the contact edge at every increment; all nodes and the stress of the last one."""

SCALARS = ("friction", "separation", "contact")
"""Groups without fields over x: the default."""


def left_out(outputs: Iterable[str]) -> list[str]:
    """Variables of the groups that nobody asked for."""
    asked = set(outputs)
    return [name for group, names in OUTPUTS.items() if group not in asked for name in names]
