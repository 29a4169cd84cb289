"""Reading YAML files of the configuration: UTF-8 text, one block of keys, no key twice."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import yaml

from softlub.study.messages import Problem, StudyError

DEEPEST = 20
"""Levels of nesting after which a file is refused; a study needs six."""

LARGEST = 1_000_000
"""Bytes after which a file is refused: no study is that long."""

# libyaml's parser where PyYAML has it.
_SafeLoader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


class _Loader(_SafeLoader):
    """Safe loader that refuses a repeated key, where PyYAML lets the last one win."""

    def construct_mapping(self, node: Any, deep: bool = False) -> dict[Any, Any]:
        keys = [key.value for key, _ in node.value if isinstance(key, yaml.ScalarNode)]
        for index, key in enumerate(keys):
            if key in keys[:index]:
                line = node.start_mark.line + 1
                hint = "; a decimal comma? numbers have a decimal point" if key[:1].isdigit() else ""
                raise yaml.YAMLError(
                    f"the key {key} stands twice in the block that begins in line {line}{hint}"
                )
        mapping: dict[Any, Any] = super().construct_mapping(node, deep)
        return mapping


# The words of YAML 1.2: PyYAML's own would read 2024-01-01 as a date, 1:30 as ninety, 010 as eight and no as false.
_Loader.yaml_implicit_resolvers = {}
for _name, _pattern, _first in (
    ("null", r"~|null|", ["~", "n", ""]),
    ("bool", r"true|false", ["t", "f"]),
    ("int", r"[-+]?(?:0|[1-9][0-9]*)", list("-+0123456789")),
    (
        "float",
        r"[-+]?(?:[0-9]+\.[0-9]*|\.[0-9]+|[0-9]+(?=[eE]))(?:[eE][-+]?[0-9]+)?",
        list("-+.0123456789"),
    ),
):
    _Loader.add_implicit_resolver(f"tag:yaml.org,2002:{_name}", re.compile(rf"(?:{_pattern})$"), _first)


def read_block(path: Path) -> dict[str, Any]:
    """The keys and values of a YAML file.

    Parameters
    ----------
    path : Path

    Returns
    -------
    dict

    Raises
    ------
    StudyError
        If there is no such file, or it is no UTF-8 text, no YAML, empty, or holds something else than keys.
    """
    text = _text(path)
    try:
        block = yaml.load(text, Loader=_Loader)
    except yaml.YAMLError as error:
        raise _error(path, f"is not YAML: {_yaml_problem(error, text)}") from None
    except (ValueError, RecursionError) as error:
        raise _error(path, f"cannot be read: {error}") from None
    if block is None:
        raise _error(path, "is empty")
    if not isinstance(block, dict):
        raise _error(path, "holds no keys and values; it must begin like `title: …`")
    if _depth(block) > DEEPEST:
        raise _error(path, f"is nested more than {DEEPEST} levels deep")
    return block


def _text(path: Path) -> str:
    try:
        with open(path, "rb") as file:
            content = file.read(LARGEST + 1)
    except FileNotFoundError:
        raise _error(path, "there is no such file") from None
    except IsADirectoryError:
        raise _error(path, "is a folder, not a study file") from None
    except OSError as error:
        raise _error(path, f"cannot be read: {error.strerror}") from None
    if len(content) > LARGEST:
        raise _error(path, f"is larger than {LARGEST} bytes: no study file")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise _error(path, "is binary, or text in another encoding than UTF-8; a study file is UTF-8 text")
    return text


def _yaml_problem(error: yaml.YAMLError, text: str) -> str:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or str(error).split("\n", 1)[0]
    if mark is None:
        return str(problem)
    # Line breaks as YAML counts them.
    lines = re.split(r"\r\n|[\n\r\x85\u2028\u2029]", text)
    line = lines[min(mark.line, len(lines) - 1)]
    indent = line[: len(line) - len(line.lstrip())]
    hint = "; a tab? indent with spaces" if "\t" in indent else ""
    return f"{problem} (line {mark.line + 1}, column {mark.column + 1}){hint}"


def _depth(value: Any, level: int = 1) -> int:
    if level > DEEPEST or not isinstance(value, (dict, list)):
        return level
    inner = value.values() if isinstance(value, dict) else value
    return max((_depth(entry, level + 1) for entry in inner), default=level)


def _error(path: Path, text: str) -> StudyError:
    return StudyError(str(path), [Problem("", text)])
