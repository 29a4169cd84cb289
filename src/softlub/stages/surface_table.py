"""Surface table: one of the source's tables of surfaces beside ours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from softlub.claims.surface_table import write
from softlub.datasets import store


def run(spec: Mapping[str, Any], inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Write the table.

    Parameters
    ----------
    spec : mapping
        ``table``: its name, ``"table_4_2"``.
    inputs : mapping
        ``study``: the dataset of the study that runs its surfaces.
    outputs : sequence of Path
        The table (.csv).
    """
    write(spec["table"], store.read(inputs["study"][0]), outputs[0])
