"""Types of a study file's entries for pydantic: how each is read, refused, and described in the JSON schema."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

from softlub.study.messages import did_you_mean
from softlub.study.quantities import NUMBER, QuantityError, read_quantity
from softlub.units import Unit

JsonSchema = dict[str, Any]


def refusal(text: str) -> PydanticCustomError:
    """An error whose text is ours, word for word."""
    return PydanticCustomError("study", "{text}", {"text": text})


class Entry:
    """Base of the annotations that read an entry by themselves: subclasses have `read` and `json_schema`."""

    def read(self, value: Any) -> Any:
        """The entry as the study holds it; raises `refusal`."""
        raise NotImplementedError

    def json_schema(self) -> JsonSchema:
        """What may be written."""
        raise NotImplementedError

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchema:
        return self.json_schema()


@dataclass(frozen=True)
class Quantity(Entry):
    """A number with a unit; `whole` for integers."""

    unit: Unit
    whole: bool = False

    def read(self, value: Any) -> float | int:
        """The number in SI."""
        try:
            number = read_quantity(value, self.unit)
        except QuantityError as error:
            raise refusal(str(error)) from None
        if self.whole and number != int(number):
            raise refusal(f"must be a whole number, {self.unit.allowed()}")
        return int(number) if self.whole else number

    def json_schema(self) -> JsonSchema:
        """Plain number within the bounds, or text that begins with a number."""
        bounds = {
            "exclusiveMinimum": self.unit.above,
            "minimum": self.unit.at_least,
            "exclusiveMaximum": self.unit.below,
            "maximum": self.unit.at_most,
        }
        number = {name: bound for name, bound in bounds.items() if bound is not None}
        return {"anyOf": [{"type": "number", **number}, {"type": "string", "pattern": rf"^\s*{NUMBER}"}]}


@dataclass(frozen=True)
class Choice(Entry):
    """One of a few words; `unbuilt` are words that the design knows and this version cannot do."""

    allowed: tuple[str, ...]
    unbuilt: Mapping[str, str] = field(default_factory=dict, hash=False)

    def read(self, value: Any) -> str:
        """The word itself."""
        if isinstance(value, str) and value in self.unbuilt:
            raise refusal(f"is not yet built ({self.unbuilt[value]}); allowed: {', '.join(self.allowed)}")
        if not isinstance(value, str) or value not in self.allowed:
            raise refusal(f"is unknown; {did_you_mean(str(value), self.allowed)}")
        return value

    def json_schema(self) -> JsonSchema:
        """One of the words."""
        return {"enum": list(self.allowed)}


@dataclass(frozen=True)
class Text(Entry):
    """A text; `numbers` where it may also be counted from 0."""

    numbers: bool = False

    def read(self, value: Any) -> str | int:
        """The text itself."""
        if self.numbers and isinstance(value, int) and not isinstance(value, bool) and value >= 0:
            return value
        if not isinstance(value, str) or not value:
            raise refusal("must be a text" + (", or a number from 0" if self.numbers else ""))
        return value

    def json_schema(self) -> JsonSchema:
        """A text that is not empty, or a whole number."""
        text = {"type": "string", "minLength": 1}
        return {"anyOf": [text, {"type": "integer", "minimum": 0}]} if self.numbers else text


@dataclass(frozen=True)
class Words(Entry):
    """A list of words, each one of a few."""

    allowed: tuple[str, ...]

    def read(self, value: Any) -> tuple[str, ...]:
        """The words, none twice."""
        if not isinstance(value, list):
            raise refusal(f"must be a list; allowed in it: {', '.join(self.allowed)}")
        choice = Choice(self.allowed)
        for entry in value:
            try:
                choice.read(entry)
            except PydanticCustomError as error:
                raise refusal(f"{entry} {error.message()}") from None
        return tuple(dict.fromkeys(value))

    def json_schema(self) -> JsonSchema:
        """A list of the words."""
        return {"type": "array", "items": {"enum": list(self.allowed)}}


@dataclass(frozen=True)
class Tagged:
    """One of several blocks, told apart by the word under `tag`.

    pydantic's own discriminated union would do, but puts the word into the place that an error names.
    """

    tag: str
    models: Mapping[str, Any] = field(hash=False)
    default: str | None = None
    unbuilt: Mapping[str, str] = field(default_factory=dict, hash=False)
    bare: str | None = None
    """What a bare word may stand for here, for the JSON schema; None where a block is needed."""

    def read(self, value: Any, handler: Callable[[Any], Any], info: core_schema.ValidationInfo) -> Any:
        """The block as the model that its word names."""
        if isinstance(value, str):
            raise refusal(f"is unknown; {did_you_mean(value, tuple(self.models))}")
        if not isinstance(value, Mapping):
            raise refusal(f"must hold keys and values, among them {self.tag}: {', '.join(self.models)}")
        word = value.get(self.tag, self.default)
        if word is None:
            raise refusal(f"needs the key {self.tag}; allowed: {', '.join(self.models)}")
        choice = Choice(tuple(self.models), self.unbuilt)
        try:
            choice.read(word)
        except PydanticCustomError as error:
            raise refusal(f"{self.tag} {word} {error.message()}") from None
        return self.models[word].model_validate({**value, self.tag: word}, context=info.context)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        # The union is there for the JSON schema; `read` picks the one model that is meant.
        union = core_schema.union_schema([handler.generate_schema(model) for model in self.models.values()])
        return core_schema.with_info_wrap_validator_function(self.read, union)

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchema:
        blocks = handler(schema)
        if self.bare is None:
            return blocks
        return {"anyOf": [{"type": "string", "description": self.bare}, blocks]}


@dataclass(frozen=True)
class Single:
    """A block of one kind, for which a name may stand."""

    model: Any
    bare: str
    files: tuple[str, ...] = ()
    """Keys that may name a CSV file with the block's numbers instead of them, for the JSON schema."""

    def read(self, value: Any, handler: Callable[[Any], Any]) -> Any:
        """The block as its model."""
        if not isinstance(value, Mapping):
            raise refusal(f"must hold keys and values, or be the {self.bare}")
        return handler(value)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_wrap_validator_function(self.read, handler.generate_schema(self.model))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchema:
        from_files = [
            {"type": "object", "properties": {key: {"type": "string", "minLength": 1}}, "required": [key]}
            for key in self.files
        ]
        return {"anyOf": [{"type": "string", "description": self.bare}, handler(schema), *from_files]}
