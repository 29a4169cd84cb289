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
    "friction_coefficient_poiseuille": Variable(
        "1", "friction coefficient, Poiseuille part of the fluid", "3-36"
    ),
    "friction_coefficient_solid": Variable("1", "friction coefficient, solid part", "3-32"),
    "friction_coefficient_error": Variable("1", "estimated absolute error of the friction coefficient"),
    "friction_coefficient_fluid_error": Variable(
        "1", "estimated absolute error of the fluid part of friction"
    ),
    "shear_strength": Variable("Pa", "shear strength of the real contact", "3-32"),
    "hersey_number": Variable("N/m", "viscosity times speed"),
    # film and contact
    "separation_min": Variable("m", "smallest mean separation"),
    "separation_min_error": Variable("1", "estimated relative error of the smallest separation"),
    "separation_central": Variable("m", "mean separation at x = 0"),
    "lambda_ratio": Variable("1", "smallest separation over rms roughness"),
    "load_share_solid": Variable("1", "share of the load carried by asperities", "3-18"),
    "real_contact_width": Variable(
        "m", "real contact area per length of the contact, integral of A/A0", "3-32"
    ),
    "real_contact_width_error": Variable("m", "estimated absolute error of the real contact width"),
    "contact_width": Variable("m", "width over which the total pressure exceeds 1e-3 of its maximum"),
    "contact_area_ratio_max": Variable("1", "largest real over nominal contact area", "3-32"),
    "rupture_position": Variable("m", "where the pressurised film ends"),
    "rigid_approach": Variable("m", "rigid term of the separation", "3-12"),
    "pressure_centroid": Variable("m", "centroid of the total pressure"),
    # surfaces
    "height": Variable("m", "height of the surface, positive outwards"),
    "y": Variable("m", "position across the sliding direction"),
    "average_roughness": Variable("m", "mean distance from the mean height", "4-1"),
    "rms_slope_spectral": Variable("1", "root mean square slope, from the Fourier series", "4-3"),
    "rms_slope_forward": Variable("1", "root mean square slope, from neighbouring points", "4-3"),
    "rms_slope_central": Variable("1", "root mean square slope, from next-nearest points", "4-3"),
    "skewness": Variable("1", "third moment of the heights over h_rms cubed; 0 for Gaussian heights"),
    "kurtosis": Variable(
        "1", "fourth moment of the heights over h_rms to the fourth; 3 for Gaussian heights"
    ),
    "nayak_parameter": Variable("1", "Nayak's bandwidth parameter m0 m4/m2^2"),
    "spacing": Variable("m", "distance of neighbouring points"),
    "size": Variable("m", "side of the surface, a period where it is periodic"),
    "points": Variable("1", "points along a side"),
    "seed": Variable("1", "seed of the first realisation"),
    "hurst": Variable("1", "Hurst exponent", "4-5"),
    "rolloff": Variable("1/m", "roll-off wavevector q_r", "4-5"),
    "cutoff": Variable("1/m", "short-wavelength cut-off q_s, as far as the grid resolves it", "4-5"),
    "long_cutoff": Variable("1/m", "long-wavelength cut-off q_L; q_r where there is no plateau", "4-5"),
    "realisations": Variable(
        "1", "pieces of the surface that were made; 0 where it was too large for the accuracy"
    ),
    "wavevector": Variable("1/m", "wavevector q"),
    "wavevector_profile": Variable("1/m", "wavevector q along a line"),
    "power_spectrum": Variable("m4", "power spectrum C(q) averaged over directions", "4-4"),
    "power_spectrum_profile": Variable("m3", "one-sided power spectrum C1D+(q) of lines", "4-6"),
    "lag": Variable("m", "distance of two points"),
    "autocorrelation": Variable("m2", "autocorrelation of the heights averaged over directions", "4-4"),
    "height_bin": Variable("m", "height about the mean"),
    "height_density": Variable("1/m", "probability density of the heights"),
    "position": Variable("m", "position along the scan"),
    "profile_raw": Variable("m", "height of a line as measured"),
    "profile_form_removed": Variable("m", "height of a line without its form"),
    "profile_roughness": Variable("m", "height of a line without form and waviness"),
    # rough contact
    "load_step": Variable("1", "number of the load"),
    "pressure": Variable("Pa", "nominal pressure"),
    "reduced_pressure": Variable("1", "nominal pressure over E*"),
    "mean_separation": Variable("m", "mean gap over the surface", "4-22"),
    "mean_separation_persson": Variable("m", "mean separation by Persson's full integral, gamma = 1", "4-22"),
    "mean_separation_persson_gamma": Variable(
        "m", "mean separation by Persson's full integral, gamma = 0.45", "4-22"
    ),
    "pressure_exponential": Variable(
        "Pa", "pressure of the exponential tail at the separation of Persson's full integral", "4-23"
    ),
    "contact_area_ratio": Variable(
        "1", "real over nominal contact area, corrected for the pixels along its edge"
    ),
    "contact_area_ratio_pixel": Variable("1", "share of the points under pressure"),
    "contact_area_ratio_gap": Variable("1", "share of the points whose gap is below a threshold"),
    "contact_area_ratio_persson": Variable("1", "real over nominal contact area by Persson's theory", "4-13"),
    "threshold": Variable("m", "gap below which a point counts as touching"),
    "kappa": Variable("1", "area over load, A/A0 E* h'rms/p, with the spectral slope", "4-15"),
    "kappa_local": Variable("1", "local slope of A/A0 over p/(E* h'rms), with the spectral slope", "4-15"),
    "contact_pressure": Variable("Pa", "contact pressure", "4-31"),
    "gap": Variable("m", "gap between the surfaces", "4-32"),
    "full_contact": Variable("1", "whether every point carries pressure"),
    "convolutions": Variable("1", "pairs of transforms of the whole grid"),
    "deflection": Variable("m", "deflection of the half-space", "4-25"),
    "deflection_hertz": Variable("m", "deflection of the half-space, closed form"),
    "contact_radius": Variable("m", "radius of the contact of a sphere", "2-3"),
    "seconds": Variable("s", "CPU time of a method"),
    # soft solid
    "stiffness": Variable(
        "N/m2", "force on a node of the contact edge by the displacement of another", "5-3"
    ),
    "base_gap": Variable("m", "height of the contact edge above its lowest node in the base state"),
    "node_width": Variable("m", "length along x that a node of the contact edge stands for, undeformed"),
    "nodal_force": Variable("N/m", "force on a node of the contact edge", "5-3"),
    "displacement": Variable("m", "displacement with the holder at rest"),
    "component": Variable("1", "x along the sliding direction, y away from the plate"),
    # finite-element bodies
    "friction": Variable("1", "friction coefficient of the plate, which slides under the body"),
    "edge_nodes": Variable("1", "nodes of the contact edge"),
    "increment": Variable("1", "number of the increment"),
    "step_number": Variable("1", "number of the step: in contact, loading, sliding"),
    "step_number_history": Variable("1", "number of the step: in contact, loading, sliding"),
    "time": Variable("s", "time since the first step began"),
    "time_history": Variable("s", "time since the first step began"),
    "applied_load": Variable("N/m", "load of the plate"),
    "applied_load_history": Variable("N/m", "load of the plate"),
    "applied_friction": Variable("1", "friction coefficient of the plate"),
    "applied_friction_history": Variable("1", "friction coefficient of the plate"),
    "plate_height": Variable(
        "m", "height of the plate above the apex of the unloaded body, its holder at rest"
    ),
    "plate_height_history": Variable(
        "m", "height of the plate above the apex of the unloaded body, its holder at rest"
    ),
    "displacement_history": Variable("m", "displacement of the contact edge, the holder at rest"),
    "displacement_error": Variable(
        "1", "longest difference from the displacement by finite elements over the longest displacement"
    ),
    "displacement_error_component": Variable(
        "1", "largest difference of a component of the displacement over that component's largest"
    ),
    "displacement_half_space": Variable("m", "displacement of the half-space's surface", "2-1"),
    "displacement_half_space_error": Variable(
        "1", "longest difference from the displacement by finite elements over the longest displacement"
    ),
    "displacement_half_space_error_component": Variable(
        "1", "largest difference of a component of the displacement over that component's largest"
    ),
    "datum": Variable("m", "distance from a line load at which the half-space's displacement is 0"),
    "nodal_force_history": Variable("N/m", "force of the plate on a node of the contact edge"),
    "mesh_point": Variable("m", "place of a node of the mesh in the unloaded body"),
    "mesh_displacement": Variable("m", "displacement of a node of the mesh"),
    "mesh_cell": Variable("1", "nodes of a cell of the mesh, counter-clockwise; -1 where there is none"),
    "mesh_edge": Variable("1", "nodes of the mesh on the contact edge"),
    "mesh_held": Variable("1", "nodes of the mesh that the holder fixes; -1 where there is none"),
    "stress_von_mises": Variable("Pa", "von Mises stress, mean over a cell"),
    "stress_vertical": Variable("Pa", "Cauchy stress away from the plate, mean over a cell"),
    "completed": Variable("1", "whether all steps were gone through"),
    "stop_reason": Variable("1", "where and why the steps were stopped; empty where they were not"),
    "increments": Variable("1", "increments of all steps"),
    "reaches_edge_end": Variable(
        "1", "whether the contact reaches an end of the contact edge and would go beyond"
    ),
    "rejected_increments": Variable("1", "increments that were tried and found too large"),
    "stiffness_diagonal": Variable("N/m2", "diagonal of the reduced stiffness", "5-3"),
    "stiffness_apex_row": Variable("N/m2", "row of the apex in the reduced stiffness", "5-3"),
    "degrees_of_freedom": Variable("1", "degrees of freedom of the whole body"),
    "stored_entries": Variable("1", "entries of the whole body's sparse stiffness"),
    "condensation_seconds": Variable("s", "CPU time of condensing the stiffness"),
    # equivalent bodies and materials
    "tried_coefficient": Variable("1", "equivalence coefficient that the search tried", "5-17"),
    "tried_difference": Variable("m2", "mean squared distance of the contact edges at it", "5-16"),
    "fit_converged": Variable("1", "whether the search ended at a minimum within its bounds"),
    "shape_difference_rigid": Variable(
        "m2", "mean squared displacement: what a body that does not deform scores", "5-16"
    ),
    "displacement_reduced": Variable(
        "m", "displacement by the model's reduced stiffness under the viscoelastic body's nodal forces", "5-3"
    ),
    "displacement_reduced_error": Variable(
        "1", "longest difference from the viscoelastic body's displacement over its longest"
    ),
    "displacement_reduced_error_component": Variable(
        "1", "largest difference of a component of the displacement over that component's largest"
    ),
    "relaxation_time": Variable("s", "relaxation time of a term of the Prony series", "5-10"),
    "prony_term": Variable("1", "term of the Prony series, relative to the long-term modulus", "5-10"),
    "instantaneous_modulus": Variable("Pa", "Young's modulus at once", "5-12"),
    "bulk_modulus": Variable("Pa", "bulk modulus", "5-7"),
    "stiffness_storage_modulus": Variable(
        "Pa", "storage modulus that a reduced stiffness is made with", "5-14"
    ),
    "coefficient": Variable("1", "equivalence coefficient alpha", "5-17"),
    "shape_difference": Variable("m2", "mean squared distance of the contact edges", "5-16"),
    "shape_difference_normalised": Variable(
        "1", "mean squared distance of the contact edges over the mean squared displacement", "5-16"
    ),
    "frequency": Variable("rad/s", "angular frequency"),
    "temperature": Variable("K", "temperature"),
    "shift_factor": Variable("1", "factor of the relaxation times at a temperature"),
    "storage_modulus": Variable("Pa", "storage modulus in tension", "5-14"),
    "loss_modulus": Variable("Pa", "loss modulus in tension", "5-14"),
    "loss_factor": Variable("1", "loss factor, loss over storage modulus", "5-15"),
    "stiffness_frequency": Variable("rad/s", "angular frequency of a reduced stiffness"),
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
    "inaccurate_friction": 64,
    "inaccurate_separation": 128,
    "inaccurate_area": 256,
}
"""Bits of the variable `flags` (CF convention: flag_masks and flag_meanings)."""

FLAG_EXPLANATIONS: dict[str, str] = {
    "not_converged": "the solver did not reach its tolerance; the point holds no numbers",
    "outside_half_space": "the pressure reaches further than 0.9 R from the middle, where neither the parabola stands "
    "for the cylinder nor the cylinder for a half-space; such points carry no meaning for a real body",
    "percolates": "real contact takes more than 0.4 of the nominal area somewhere, which closes the channels through "
    "which the model still lets the fluid flow",
    "law_extrapolated": "the separation is smaller than the contact law knows; its pressure there is a continuation",
    "domain_truncates": "the fluid still carries more than 0.001 of its largest pressure at the inlet's edge, so that "
    "a wider domain would change film and friction",
    "not_attempted": "the study does not ask this solver for this speed",
    "inaccurate_friction": "the estimated error of the fluid's friction exceeds 1e-3, or could not be formed",
    "inaccurate_separation": "the estimated error of the smallest separation exceeds 5 %, or could not be formed",
    "inaccurate_area": "the estimated error of the real contact width, on which friction depends, exceeds 1 %, or "
    "could not be formed",
}
"""What each flag means for somebody who reads a figure."""
