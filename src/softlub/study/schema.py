"""The JSON schema of a study file, for editors: ``python -m softlub.study.schema`` writes config/study.schema.json."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any, get_args

from pydantic.json_schema import GenerateJsonSchema, models_json_schema

from softlub.study.base import StudyModel
from softlub.study.models import FILES, KINDS, SCENES

SCHEMA_FILE = Path("config/study.schema.json")


def generated() -> dict[str, Any]:
    """The schema, from the same models that read the file: one of several by its kind."""
    models = [FILES[kind] for kind in KINDS]
    keys, schema = models_json_schema(
        [(model, "validation") for model in models], schema_generator=GenerateJsonSchema
    )
    blocks = schema["$defs"]
    for kind, model in FILES.items():
        blocks[model.__name__]["properties"]["kind"] = {"const": kind}
        if kind != KINDS[0]:
            blocks[model.__name__]["required"].append("kind")
    for scene in SCENES.values():
        # Whatever is swept may stand in the grid alone.
        for model in (scene, *_bodies(scene)):
            blocks[model.__name__].pop("required", None)
    alternatives = [keys[model, "validation"] for model in models]
    return {"$schema": GenerateJsonSchema.schema_dialect, "$defs": blocks, "anyOf": alternatives}


def _bodies(scene: Any) -> list[Any]:
    """The model of a scene's body, whose parts may be swept too."""
    hint = scene.model_fields["body"].annotation if "body" in scene.model_fields else None
    return [
        kind for kind in (hint, *get_args(hint)) if isinstance(kind, type) and issubclass(kind, StudyModel)
    ]


def text() -> str:
    """The schema as it stands in the file."""
    return json.dumps(generated(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else SCHEMA_FILE
    target.write_text(text(), encoding="utf-8")
