"""What all blocks of a study file have in common: no unknown keys, and one message for a misspelt one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from pydantic import BaseModel, ConfigDict, ValidationError, model_validator
from pydantic_core import InitErrorDetails

from softlub.study.fields import refusal
from softlub.study.messages import did_you_mean, nearest


class StudyModel(BaseModel):
    """A block of keys and values."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    unbuilt_keys: ClassVar[dict[str, str]] = {}
    absent_keys: ClassVar[dict[str, str]] = {}
    further_keys: ClassVar[str] = ""

    @model_validator(mode="wrap")
    @classmethod
    def _explain_keys(cls, data: Any, handler: Callable[[Any], Any]) -> Any:
        """Say for an unknown key which one is meant, and do not call that one missing as well."""
        try:
            return handler(data)
        except ValidationError as error:
            raise ValidationError.from_exception_data(cls.__name__, _explained(cls, error)) from None


def _explained(model: type[StudyModel], error: ValidationError) -> list[InitErrorDetails]:
    known = list(model.model_fields)
    known = [model.model_fields[name].alias or name for name in known]
    found = error.errors(include_url=False)
    unknown = [str(entry["loc"][0]) for entry in found if _is_own(entry, "extra_forbidden")]
    meant = {nearest(word, known) for word in unknown}
    details = []
    for entry in found:
        if _is_own(entry, "extra_forbidden"):
            problem: Any = refusal(_unknown_key(model, str(entry["loc"][0]), known))
        elif _is_own(entry, "missing"):
            if entry["loc"][0] in meant:
                continue
            problem = refusal("is missing")
        elif entry["type"] == "value_error":
            problem = refusal(str(entry["ctx"]["error"]))
        elif entry["type"] == "study":
            problem = refusal(entry["msg"])
        else:
            problem = refusal(_plain_words(entry))
        details.append(InitErrorDetails(type=problem, loc=entry["loc"], input=entry["input"]))
    return details


def _is_own(entry: Any, kind: str) -> bool:
    return entry["type"] == kind and len(entry["loc"]) == 1


def _unknown_key(model: type[StudyModel], key: str, known: list[str]) -> str:
    if key in model.unbuilt_keys:
        return f"is not yet built: {model.unbuilt_keys[key]}"
    if key in model.absent_keys:
        return model.absent_keys[key]
    if key[:1].isdigit():
        return f"is no key; a decimal comma? numbers have a decimal point; keys: {', '.join(known)}"
    return f"unknown key; {did_you_mean(key, known, 'keys')} {model.further_keys}".rstrip()


def _plain_words(entry: Any) -> str:
    words = {
        "model_type": "must hold keys and values",
        "dict_type": "must hold keys and values",
        "string_type": "must be a text",
        "list_type": "must be a list",
        "tuple_type": "must be a list",
        "missing": "is missing",
    }
    return words.get(entry["type"], entry["msg"])
