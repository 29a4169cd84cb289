"""Claims: every statement of the source held against the studies' datasets, as a table and as a page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import xarray as xr

from softlub.claims.evaluate import evaluate
from softlub.claims.table import read_claims, write_judgements, write_page
from softlub.datasets import store


def run(spec: Mapping[str, Any], inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Judge all claims.

    Parameters
    ----------
    spec : mapping
        Nothing but the stage's name and revision.
    inputs : mapping
        ``studies``: datasets; ``claims``: the table of statements.
    outputs : sequence of Path
        The table (.csv) and the page (.md).
    """
    studies = {path.stem: path for path in inputs["studies"]}

    def open_dataset(study: str) -> xr.Dataset | None:
        return store.read(studies[study]) if study in studies else None

    judgements = evaluate(read_claims(inputs["claims"][0]), open_dataset)
    write_judgements(judgements, outputs[0])
    write_page(judgements, outputs[1])
