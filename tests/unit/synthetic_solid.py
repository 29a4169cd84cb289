"""Made-up datasets of chapter 5 with the dimensions of real ones: for tests of figures and claims, and nothing else."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.datasets.store import describe
from softlub.solid.materials.moduli import tensile_dynamics
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen
from softlub.stages import solid_tables
from softlub.stages.surface_study import swept

ALONG = ("node", "component")
L_H = NeoHookean(0.5932e6, 1e-9)
Y_H = NeoHookean(0.5767e6, 1e-9)


def edge(nodes=33):
    """Places of the nodes and a displacement of 18 µm along x and 13 µm along y at the apex."""
    x = np.linspace(-0.5e-3, 0.5e-3, nodes)
    bell = 1 / (1 + (x / 1e-4) ** 2)
    return x, np.stack([18e-6 * bell, 13e-6 * bell + 1e-6], axis=1)


def body(
    nodes=33,
    compare=("reduced",),
    error=0.008,
    lateral=0.01,
    lateral_size=1.0,
    datums=(),
    half_space=1.5,
    converged=True,
    constrained=0.6,
    diagonal=2.7e6,
    far=1.0,
    degrees=12606,
    stored=212908,
    seconds=0.3,
    mesh=False,
    load_factor=1.0,
):
    """One body: what the reduced stiffness and the half-space make of its forces is wrong by the given shares."""
    x, full = edge(nodes)
    full = load_factor * full * [lateral_size, 1.0]
    found = {"full": full}
    if "reduced" in compare:
        found["reduced"] = full * [1 + lateral, 1 + error]
    if "constrained" in compare:
        found["constrained"] = full * [1 + constrained, 1 - constrained]
    dataset = xr.Dataset(solid_tables.compared(found, "method"))
    if datums:
        planes = {datum: full * half_space * (1 + np.log10(datum / 1e-2)) for datum in datums}
        theory = solid_tables.compared({"full": full, **planes}, "datum", "displacement_half_space")
        lengths = {"datum": np.array(datums, dtype=float)}
        dataset = dataset.assign(
            {name: one.isel(datum=slice(1, None)).assign_coords(lengths) for name, one in theory.items()}
        )
    pressure = np.maximum(0, 3.6e5 * (1 - (x / 3e-5) ** 2))
    width = np.gradient(x)
    distance = np.abs(x) / (x[1] - x[0])
    row = np.where(distance == 0, diagonal, -far * diagonal / (1 + distance) ** 3)
    dataset = dataset.assign(
        nodal_force=(ALONG, np.stack([0.4 * pressure * width, pressure * width], axis=1)),
        contact_pressure=("node", pressure),
        plate_height=13e-6,
        converged=converged,
        iterations=18,
        increments=3,
        residual=1e-10,
        solver_seconds=2.0,
        stop_reason="" if converged else "sliding, increment 4: the tangent is singular",
        node_width=("node", width),
        base_gap=("node", x**2 / 4e-4),
        x=("node", x),
        stiffness_diagonal=(ALONG, np.full((nodes, 2), diagonal)),
        stiffness_apex_row=(ALONG, np.stack([row, row], axis=1)),
        degrees_of_freedom=degrees,
        stored_entries=stored,
        condensation_seconds=seconds,
    )
    dataset = dataset.assign_coords(node=np.arange(nodes), component=["x", "y"])
    return dataset.merge(_mesh()) if mesh else dataset


def _mesh():
    made = TriangularSpecimen().mesh(MeshDensity(33, 6, flank_columns=8))
    return xr.Dataset(
        {
            "mesh_point": (("mesh_node", "component"), made.points),
            "mesh_displacement": (("mesh_node", "component"), 0.01 * (made.points.max() - made.points)),
            "mesh_cell": (("cell", "corner"), made.cells),
            "mesh_edge": ("edge_node", made.edge),
            "mesh_held": ("held_node", made.held),
            "stress_von_mises": ("cell", np.linspace(0, 3e5, len(made.cells))),
        },
        coords={"component": ["x", "y"]},
    )


PER_BODY = (
    "x",
    "node_width",
    "base_gap",
    "stiffness_diagonal",
    "stiffness_apex_row",
    "mesh_point",
    "mesh_cell",
)
ENTRIES = ("mesh_edge", "mesh_held", "degrees_of_freedom", "stored_entries", "condensation_seconds")


def loaded(bodies, loads=(17.0,)):
    """Bodies along `load`, but for what belongs to the mesh."""
    same = [name for name in (*PER_BODY, *ENTRIES) if name in bodies[0]]
    rows = [one.drop_vars(same) for one in bodies]
    joined = xr.concat(
        rows, dim=xr.Variable("load", np.array(loads)), join="outer", data_vars="all", coords="minimal"
    )
    return joined.assign(bodies[0][same].data_vars)


def solid(study, sweep=None, rows=None, loads=(17.0,)):
    """A study: a dimension with its labels, and a row of bodies along the load for each of them."""
    rows = rows or [[body()]]
    sweeps = [] if sweep is None else [{"dimension": sweep[0], "labels": sweep[1]}]
    joined = swept([loaded(row, loads) for row in rows], sweeps, solid_tables.PADDED).set_coords("x")
    return joined.assign_attrs(study=study, title=f"Made up for {study}")


def linear(errors=(0.012, 0.008), laterals=(0.107, 0.01)):
    """Without friction the lateral displacement is a tenth of the other."""
    rows = [
        [body(error=error, lateral=lateral, lateral_size=size, mesh=True)]
        for error, lateral, size in zip(errors, laterals, (0.08, 1.0), strict=True)
    ]
    return solid("ch5-linear", ("friction", [0.0, 0.4]), rows)


def hyperelastic(linear_size=1.0, half_space=1.5):
    """L_H, and a linear body whose displacement is `linear_size` times its own."""
    kept = {"datums": (1e-3, 1e-2), "half_space": half_space, "mesh": True}
    rows = [[body(**kept)], [body(**kept, load_factor=linear_size)]]
    return solid("ch5-hyperelastic", ("material", ["L_H", "linear with E0"]), rows)


def elements(second=0.008):
    """Two kinds of elements."""
    rows = [[body()], [body(error=second)]]
    return solid("ch5-elements", ("element", ["mean_dilatation", "reduced_integration"]), rows)


def mesh(diagonal=1.04, far=0.25, size=1.0, seconds=2.0):
    """Two densities: the finer one's entries, displacement and time over those of the coarser."""
    fine = body(
        65, diagonal=2.7e6 * diagonal, far=far, load_factor=size, seconds=0.3 * seconds, degrees=23870
    )
    return solid("ch5-mesh", ("edge_nodes", [33.0, 65.0]), [[body()], [fine]])


def constraint(constrained=0.6):
    """The constraint kept besides."""
    return solid(
        "ch5-constraint", None, [[body(compare=("reduced", "constrained"), constrained=constrained)]]
    )


def half_cylinder(half_space=1.5, datums=(1e-3, 1e-2, 1.0)):
    """Two loads, against the half-space."""
    rows = [[body(datums=datums, half_space=half_space, mesh=True, load_factor=f) for f in (0.1, 1.0)]]
    return solid("ch5-half-cylinder", None, rows, (100.0, 6000.0))


def equivalence(fitted=(1.001, 2.1), differences=(1e-7, 0.05), source=(0.11, 0.5), reduced=(0.008, 0.33)):
    """Two durations of the steps: α of the fit, and normalised differences of the fit and of α = 1 and 1.5."""
    labels = ["viscoelastic", "fitted", "alpha=1", "alpha=1.5"]
    rows = []
    for alpha, fit, given in zip(fitted, differences, source, strict=True):
        x, full = edge()
        shares = [0.0, np.sqrt(fit), 0.01, np.sqrt(given)]
        one = loaded([solid_bodies(x, full, shares, labels, alpha, reduced)])
        rows.append(one)
    joined = swept(rows, [{"dimension": "steps", "labels": ["1 s", "1 us"]}], solid_tables.PADDED)
    return joined.set_coords("x").assign_attrs(study="ch5-equivalence", title="Made up for ch5-equivalence")


def solid_bodies(x, full, shares, labels, alpha, reduced):
    """The bodies of one scene along `model`, each smaller than the first by its share."""
    moved = np.stack([full * (1 - share) for share in shares])
    square = np.mean(np.sum(full**2, axis=1))
    normalised = np.array([np.nan, *(share**2 for share in shares[1:])])
    errors = np.array([np.nan, reduced[0], reduced[0], reduced[1]])
    by_stiffness = np.stack([np.full_like(full, np.nan), *(full * (1 - error) for error in errors[1:])])
    pressure = np.maximum(0, 3.6e5 * (1 - (x / 6e-5) ** 2))
    along = ("model", *ALONG)
    return xr.Dataset(
        {
            "displacement": (along, moved),
            "displacement_reduced": (along, by_stiffness),
            "displacement_reduced_error": ("model", errors),
            "displacement_reduced_error_component": (
                ("model", "component"),
                np.stack([errors, errors], axis=1),
            ),
            "contact_pressure": (("model", "node"), np.tile(pressure, (len(labels), 1))),
            "coefficient": ("model", [np.nan, alpha, 1.0, 1.5]),
            "shape_difference": ("model", normalised * square),
            "shape_difference_normalised": ("model", normalised),
            "shape_difference_rigid": square,
            "fit_converged": 1,
            "converged": ("model", np.ones(len(labels), dtype=bool)),
            "stop_reason": ("model", [""] * len(labels)),
            "node_width": ("node", np.gradient(x)),
            "base_gap": ("node", x**2 / 4e-4),
            "x": ("node", x),
        },
        coords={"model": labels, "node": np.arange(x.size), "component": ["x", "y"]},
    )


def moduli(stiffened=True):
    """Three materials; without `stiffened` the reduced stiffness at a frequency is that at rest."""
    frequency = np.geomspace(1e-2, 1e14, 161)
    asked = np.array([0.0, 1e3, 1e5, 1e7])
    rows = []
    for material in MATERIALS.values():
        dynamic, at = tensile_dynamics(material, frequency), tensile_dynamics(material, asked).storage
        ratio = at / at[0] if stiffened else np.ones(asked.size)
        entries = 2.7e6 * ratio[:, None, None] * np.ones((1, 5, 2))
        rows.append(
            xr.Dataset(
                {
                    "storage_modulus": ("frequency", dynamic.storage),
                    "loss_modulus": ("frequency", dynamic.loss),
                    "loss_factor": ("frequency", dynamic.loss_factor),
                    "long_term_modulus": material.long_term_modulus,
                    "bulk_modulus": material.bulk_modulus,
                    "stiffness_storage_modulus": ("stiffness_frequency", at),
                    "stiffness_diagonal": (("stiffness_frequency", *ALONG), entries),
                    "stiffness_apex_row": (("stiffness_frequency", *ALONG), entries),
                },
                coords={"frequency": frequency, "stiffness_frequency": asked, "component": ["x", "y"]},
            )
        )
    joined = swept(rows, [{"dimension": "material", "labels": list(MATERIALS)}])
    return describe(joined).assign_attrs(study="ch5-moduli", title="Made up for ch5-moduli")


def _viscoelastic(rest, times, terms):
    return Viscoelastic(rest, PronySeries(times, terms, "long_term"))


DECADES = tuple(10.0**power for power in range(-13, 0))
MATERIALS = {
    "maxwell_arm": _viscoelastic(L_H, (1e-3,), (99.0,)),
    "L": _viscoelastic(L_H, DECADES, (60, 120, 150, 120, 60, 22, 5, 0.8, 0.22, 0.08, 0.03, 0.012, 0.005)),
    "Y": _viscoelastic(Y_H, DECADES, (50, 95, 125, 110, 65, 28, 7.5, 1.3, 0.35, 0.12, 0.045, 0.018, 0.008)),
}

DATASETS = {
    "mesh": linear,
    "deformed_mesh": linear,
    "half_cylinder": half_cylinder,
    "reduced_against_full": hyperelastic,
    "matrix_entries": mesh,
    "moduli": moduli,
    "equivalent_shape": equivalence,
    "equivalent_against_full": equivalence,
}
"""Every drawing of chapter 5 -> a dataset for it."""
