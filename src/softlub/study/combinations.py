"""Every scene of a study: the product of its swept fields, in the order of the dataset's dimensions."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

from softlub.study import paths
from softlub.study.parsed import Study


def scenes_of(study: Study) -> Iterator[dict[str, Any]]:
    """Canonical scenes, the last swept field varying fastest.

    Parameters
    ----------
    study : Study

    Yields
    ------
    dict
    """
    for values in itertools.product(*(sweep.values for sweep in study.sweeps)):
        scene: dict[str, Any] = dict(study.scene)
        for sweep, value in zip(study.sweeps, values, strict=True):
            scene = paths.replaced(scene, sweep.path, value)
        yield scene
