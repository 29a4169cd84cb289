"""Study of viscoelastic materials: moduli over frequency and temperature, and reduced stiffnesses at some frequencies.

Over the swept fields, `temperature` where there is one and `frequency`: `storage_modulus`, `loss_modulus`,
`loss_factor` in tension; over `temperature` `shift_factor`; over `term` `relaxation_time` and `prony_term` (relative to
the long-term modulus); over none `long_term_modulus`, `instantaneous_modulus` and `bulk_modulus`. Over
`stiffness_frequency` `stiffness_storage_modulus` and, over `node` and `component`, `stiffness_diagonal` and
`stiffness_apex_row`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.solid.materials.material import young_modulus
from softlub.solid.materials.moduli import tensile_dynamics
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.stages import solid_bodies, solid_tables
from softlub.stages.surface_study import swept
from softlub.study import kinds

Spec = Mapping[str, Any]
ENTRIES = ("stiffness_diagonal", "stiffness_apex_row")


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Compute the moduli and write the study's dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: sweeps, materials, time_temperature, frequency, temperature, stiffness_frequency,
        and which stiffnesses each scene reads.
    inputs : mapping
        ``stiffness``: files in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    read = [store.read(path).drop_attrs(deep=False) for path in inputs.get("stiffness", ())]
    rows = []
    for index, block in enumerate(spec["materials"]):
        material = solid_bodies.make_material(block)
        row = _moduli(material, spec, spec["time_temperature"][index])
        own = [
            solid_tables.stiffness_entries(read[place])[[*ENTRIES]] for place in spec["stiffnesses"][index]
        ]
        if own:
            row = row.merge(_at_frequencies(material, own, spec["stiffness_frequency"]))
        rows.append(row)
    store.write(swept(rows, spec["sweeps"]), outputs[0], dict(spec))


def _moduli(material: Viscoelastic, spec: Spec, shift: Mapping[str, Any] | None) -> xr.Dataset:
    """Moduli of one material."""
    frequency = np.array(spec["frequency"])
    series = material.prony
    glassy = young_modulus(material.instantaneous_shear_modulus, material.bulk_modulus)
    dataset = xr.Dataset(
        {
            "relaxation_time": ("term", series.relaxation_times),
            "prony_term": ("term", series.long_term_terms),
            "long_term_modulus": material.long_term_modulus,
            "instantaneous_modulus": glassy,
            "bulk_modulus": material.bulk_modulus,
        },
        coords={"term": np.arange(series.relaxation_times.size), "frequency": frequency},
    )
    if not spec["temperature"]:
        return dataset.assign(_dynamics(material, frequency))
    law = kinds.TIME_TEMPERATURE(**(shift or {}))
    temperatures = xr.Variable("temperature", np.array(spec["temperature"]))
    shifted = [
        xr.Dataset(_dynamics(replace(material, prony=law.at_temperature(series, value)), frequency))
        for value in spec["temperature"]
    ]
    factors = [law.shift_factor(value) for value in spec["temperature"]]
    dynamics = xr.concat(shifted, dim=temperatures).assign(shift_factor=("temperature", factors))
    return dataset.merge(dynamics)


def _dynamics(material: Viscoelastic, frequency: np.ndarray) -> dict[str, tuple[str, np.ndarray]]:
    dynamic = tensile_dynamics(material, frequency)
    return {
        "storage_modulus": ("frequency", dynamic.storage),
        "loss_modulus": ("frequency", dynamic.loss),
        "loss_factor": ("frequency", dynamic.loss_factor),
    }


def _at_frequencies(
    material: Viscoelastic, entries: Sequence[xr.Dataset], frequencies: Sequence[float]
) -> xr.Dataset:
    """Entries of reduced stiffnesses along the frequencies that they were made for."""
    along = xr.Variable("stiffness_frequency", np.array(frequencies))
    storage = tensile_dynamics(material, frequencies).storage
    return xr.concat(entries, dim=along).assign(stiffness_storage_modulus=("stiffness_frequency", storage))
