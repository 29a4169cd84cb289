"""Figure: one picture of a study's dataset, the data it shows, and its caption."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import xarray as xr

from softlub.claims.caption import caption
from softlub.claims.table import read_claims, write_text
from softlub.datasets import store
from softlub.figures import DRAWINGS, draw
from softlub.figures.save import save


def run(spec: Mapping[str, Any], inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Draw the figure and write it in every format, with its caption.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: figure, draw, options.
    inputs : mapping
        ``study``: the dataset drawn; ``judged``: further studies that the source's statements about the figure are
        held against; ``claims``: the table of those statements.
    outputs : sequence of Path
        The pictures and the data drawn, by their endings, and the caption (.rst).
    """
    dataset = store.read(inputs["study"][0])
    captions = [path for path in outputs if path.suffix == ".rst"]
    figure = draw(spec["draw"], dataset, **spec["options"])
    save(figure, [path for path in outputs if path not in captions])
    studies = {path.stem: path for path in (*inputs["study"], *inputs["judged"])}

    def open_dataset(study: str) -> xr.Dataset | None:
        return store.read(studies[study]) if study in studies else None

    claims = read_claims(inputs["claims"][0])
    shows = " ".join([DRAWINGS[spec["draw"]].shows, *figure.notes])
    text = caption(spec["figure"], shows, dataset, claims, open_dataset)
    for path in captions:
        write_text(path, text)
