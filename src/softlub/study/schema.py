"""The JSON schema of a study file, for editors: ``python -m softlub.study.schema`` writes config/study.schema.json."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from pydantic.json_schema import GenerateJsonSchema

from softlub.study.models import StudyFile

SCHEMA_FILE = Path("config/study.schema.json")


def generated() -> dict[str, Any]:
    """The schema, from the same models that read the file."""
    schema = StudyFile.model_json_schema(mode="validation", schema_generator=GenerateJsonSchema)
    return {"$schema": GenerateJsonSchema.schema_dialect, **schema}


def text() -> str:
    """The schema as it stands in the file."""
    return json.dumps(generated(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else SCHEMA_FILE
    target.write_text(text(), encoding="utf-8")
