"""YAML that knows its lines and refuses what nobody asked for: unknown keys, aliases, files too large, numbers out of range."""

import difflib
import math
import pathlib

import yaml

from errors import CampaignError, at

LARGEST = 1 << 20  # [bytes] of a file


class Value:
    """A node of a file, with where it stands."""

    def __init__(self, file, node, field):
        self.file, self.node, self.field = file, node, field

    def error(self, sentence):
        return at(self.file, self.node.start_mark.line + 1, self.field, sentence)

    def is_map(self):
        return isinstance(self.node, yaml.MappingNode)

    def is_list(self):
        return isinstance(self.node, yaml.SequenceNode)

    def is_scalar(self):
        return isinstance(self.node, yaml.ScalarNode)

    def items(self):
        """Of a map: [(key, Value)]."""
        if not self.is_map():
            raise self.error("wants a map, KEY: VALUE")
        found, seen = [], set()
        for key, value in self.node.value:
            if not isinstance(key, yaml.ScalarNode):
                raise self.error("a key must be a word")
            name = key.value
            child = Value(self.file, value, f"{self.field}.{name}" if self.field else name)
            if name in seen:
                raise at(self.file, key.start_mark.line + 1, child.field, "stands here twice; leave one out")
            seen.add(name)
            found.append((name, child))
        return found

    def keys(self, known, required=()):
        """Of a map whose keys are known: {key: Value}."""
        found = dict(self.items())
        for name, child in found.items():
            if name not in known:
                near = difflib.get_close_matches(name, known, 1)
                raise child.error(f"unknown key; {f'is {near[0]} meant?' if near else 'use ' + ', '.join(known)}")
        for name in required:
            if name not in found:
                raise self.error(f"{name} is missing; add {name}: ...")
        return found

    def entries(self):
        """Of a list; a single value is a list of one."""
        if not self.is_list():
            return [self]
        return [Value(self.file, node, f"{self.field}[{i}]") for i, node in enumerate(self.node.value)]

    def text(self):
        if not self.is_scalar():
            raise self.error("wants one word, not a list or map")
        if "\0" in self.node.value or len(self.node.value) > 1000:
            raise self.error("is no word: too long, or has a zero byte")
        return self.node.value

    def number(self, least=-math.inf, most=math.inf, whole=False):
        try:
            value = float(self.text())
        except ValueError:
            raise self.error(f"'{self.text()}' is no number") from None
        if not (math.isfinite(value) and least <= value <= most) or (whole and value != int(value)):
            raise self.error(f"{self.text()} is not {'a whole number ' if whole else ''}within {least:g} .. {most:g}")
        return int(value) if whole else value

    def truth(self):
        if self.text() not in ("true", "false"):
            raise self.error(f"'{self.text()}' is neither true nor false")
        return self.text() == "true"

    def word_of(self, known):
        if self.text() not in known:
            raise self.error(f"'{self.text()}' is not one of {', '.join(known)}")
        return self.text()


def load(path):
    """The top of a file.  Throws CampaignError."""
    try:
        file = pathlib.Path(path)
        if file.stat().st_size > LARGEST:
            raise CampaignError(f"{path}: larger than {LARGEST >> 20} MB; this is no campaign")
        text = file.read_text(encoding="utf-8")
    except OSError as error:
        raise CampaignError(f"{path}: {error.strerror}; name a campaign file (doc/campaign.md shows one)") from None
    except UnicodeDecodeError:
        raise CampaignError(f"{path}: is not UTF-8 text") from None
    try:
        for event in yaml.parse(text, Loader=yaml.SafeLoader):
            if isinstance(event, yaml.AliasEvent):
                raise at(path, event.start_mark.line + 1, "", "YAML aliases (*name) are refused; write the value out")
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        raise at(path, mark.line + 1 if mark else 1, "", f"{getattr(error, 'problem', None) or error}; mend the YAML") from None
    except RecursionError:
        raise CampaignError(f"{path}: nested too deeply") from None
    if node is None:
        raise CampaignError(f"{path}: is empty; a campaign has at least scenes: [NAME]")
    return Value(str(path), node, "")
