"""YAML files of others, read as plain data: tags of Python objects are taken for what is under them, nothing is ever constructed."""
from __future__ import annotations

import math
import pathlib
from typing import Any, Sequence

from .arguments import REMEDY
from .errors import PolicyError

LARGEST = 4 << 20  # [bytes] of a file


def _loader() -> Any:
    try:
        import yaml  # type: ignore[import-untyped,unused-ignore]
    except ImportError:
        raise PolicyError(REMEDY) from None

    class Plain(getattr(yaml, 'CSafeLoader', yaml.SafeLoader)):  # type: ignore[misc,name-defined,unused-ignore]
        pass

    def plain(loader: Any, tag: str, node: Any) -> Any:
        if isinstance(node, yaml.MappingNode):
            return loader.construct_mapping(node, deep=True)
        if isinstance(node, yaml.SequenceNode):
            return loader.construct_sequence(node, deep=True)
        return loader.construct_scalar(node)

    Plain.add_multi_constructor('tag:yaml.org,2002:python/', plain)
    return yaml, Plain


def parse(text: str, name: str) -> dict[str, Any]:
    """The map that a text is.  PolicyError names file and line."""
    yaml, loader = _loader()
    try:
        for token in yaml.scan(text, Loader=loader):
            if isinstance(token, yaml.AliasToken):
                raise PolicyError(f'{name}:{token.start_mark.line + 1}: references (*NAME) are not read; write the values out')
        found = yaml.load(text, Loader=loader)
    except (yaml.YAMLError, RecursionError) as error:
        mark = getattr(error, 'problem_mark', None)
        where = f':{mark.line + 1}' if mark is not None else ''
        raise PolicyError(f'{name}{where}: no YAML: {getattr(error, "problem", None) or "nested too deeply"}') from None
    if not isinstance(found, dict):
        raise PolicyError(f'{name}: it is a {type(found).__name__}, not a map KEY: VALUE')
    return found


def load_map(path: pathlib.Path) -> dict[str, Any]:
    """The map that a file is."""
    try:
        if path.stat().st_size > LARGEST:
            raise PolicyError(f'{path}: larger than {LARGEST >> 20} MB; that is no specification')
        return parse(path.read_text(encoding='utf-8'), str(path))
    except UnicodeDecodeError:
        raise PolicyError(f'{path}: no text in UTF-8') from None
    except OSError as error:
        raise PolicyError(f'{path}: {error.strerror}') from None


class Field:
    """A value of a file, with the place it has in it: what is wrong is said with both."""

    def __init__(self, value: Any, file: str, name: str) -> None:
        self.value, self.file, self.name = value, file, name

    def error(self, sentence: str) -> PolicyError:
        return PolicyError(f'{self.file}: {self.name}: {sentence}')

    def get(self, key: str) -> Field | None:
        """The entry of a map, or None where there is none or it is empty."""
        inside = self.mapping().get(key)
        return None if inside is None else Field(inside, self.file, f'{self.name}.{key}' if self.name else key)

    def need(self, key: str) -> Field:
        found = self.get(key)
        if found is None:
            raise self.error(f'{key} is missing')
        return found

    def mapping(self) -> dict[str, Any]:
        if not isinstance(self.value, dict):
            raise self.error('wants a map')
        return self.value

    def only(self, keys: Sequence[str]) -> None:
        """Refuses keys that nobody reads."""
        for key in self.mapping():
            if key not in keys:
                raise self.error(f'no key {key!r} is known; there are: {", ".join(keys)}')

    def items(self) -> list[tuple[str, Field]]:
        return [(str(key), Field(value, self.file, f'{self.name}.{key}')) for key, value in self.mapping().items()]

    def entries(self) -> list[Field]:
        if not isinstance(self.value, (list, tuple)):
            raise self.error('wants a list')
        return [Field(value, self.file, f'{self.name}[{number}]') for number, value in enumerate(self.value)]

    def number(self, low: float = -math.inf, high: float = math.inf) -> float:
        if isinstance(self.value, bool) or not isinstance(self.value, (int, float)):
            try:
                value = float(str(self.value))  # YAML 1.1 takes 1e-3 for a word
            except ValueError:
                raise self.error(f'{self.value!r} is no number') from None
        else:
            value = float(self.value)
        if not math.isfinite(value) or not low <= value <= high:
            raise self.error(f'{value:g} is outside of {low:g} to {high:g}')
        return value

    def whole(self, low: int, high: int) -> int:
        value = self.number(low, high)
        if value != int(value):
            raise self.error(f'{value:g} is no whole number')
        return int(value)

    def word(self, choices: Sequence[str] = ()) -> str:
        if not isinstance(self.value, str):
            raise self.error(f'{self.value!r} is no word')
        if choices and self.value not in choices:
            raise self.error(f'{self.value!r} is none of {", ".join(choices)}')
        return self.value

    def flag(self) -> bool:
        if not isinstance(self.value, bool):
            raise self.error(f'{self.value!r} is neither true nor false')
        return self.value

    def numbers(self, count: int | None = None, low: float = -math.inf, high: float = math.inf) -> list[float]:
        """A list of so many numbers; one number stands for all."""
        if not isinstance(self.value, (list, tuple)):
            return [self.number(low, high)] * (count or 1)
        values = [entry.number(low, high) for entry in self.entries()]
        if count is not None and len(values) != count:
            raise self.error(f'{len(values)} numbers, {count} are needed')
        return values

    def range(self) -> tuple[float, float]:
        low, high = self.numbers(2)
        if low > high:
            raise self.error(f'{low:g} is above {high:g}')
        return low, high
