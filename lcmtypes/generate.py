#!/usr/bin/env python3
"""generate.py FOLDER FILE.lcm...: what C++ needs of each message beside lcm-gen's class, so that a field is written once.

FOLDER/lcmtypes/bus/wire_table.h       size, sender and counter of each struct (Wire<T>)
FOLDER/lcmtypes/bus/message_of.h       lcm-gen's class of each struct (MessageOf<T>), and the list of all
FOLDER/lcmtypes/bus/message_fields.h   the fields of each with their rules, for convert.cpp
FOLDER/lcmtypes/bus/message_samples.h  a valid value of each struct, for tests

The C++ struct of a message is named in braces behind the comment of its struct, the rule of a field behind the comment of the field:
lcmtypes/README.md, "Rules of fields".  A rule that says nothing is an error with its line."""
import pathlib
import re
import sys
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'python' / 'twinbus'))
import lcm_types  # noqa: E402

BYTES = {'int8_t': 1, 'byte': 1, 'boolean': 1, 'int16_t': 2, 'int32_t': 4, 'float': 4, 'int64_t': 8, 'double': 8}
NUMBER = r'-?\d+(?:\.\d+)?'
WORDS = ('id', 'id or -1', 'instant', 'counter', 'joints', 'per joint', 'rotation', 'text', 'piece', 'sender', 'sequence')


class Mistake(Exception):
    """In an .lcm file: where and what."""


@dataclass
class Rule:
    """Of one field: what is in its braces."""
    words: list[str]

    def has(self, word: str) -> bool:
        return word in self.words

    def argument(self, pattern: str) -> 're.Match[str] | None':
        return next((found for word in self.words if (found := re.fullmatch(pattern, word))), None)

    @property
    def only(self) -> str:
        found = self.argument(r'only (\w+)')
        return found[1] if found else ''

    @property
    def inside(self) -> str:
        """Of the struct: the member that holds the field, with a dot."""
        found = self.argument(r'in (\w+)')
        return found[1] + '.' if found else ''

    @property
    def bounds(self) -> 're.Match[str] | None':
        return self.argument(rf'({NUMBER})\.\.({NUMBER})?')


def rule_of(file: str, field: lcm_types.Field) -> Rule:
    rule = Rule([word.strip() for word in field.rule.split(',')] if field.rule else [])
    for word in rule.words:
        if word not in WORDS and not re.fullmatch(rf'only \w+|in \w+|count \d+|pieces \d+\.\.\d+|{NUMBER}\.\.({NUMBER})?', word):
            raise Mistake(f'{file}: {field.name}: no rule {word!r}; there are {", ".join(WORDS)}, count N, pieces A..B, A..B, A.., '
                          'only STRUCT, in MEMBER (lcmtypes/README.md)')
    return rule


@dataclass
class Type:
    """A message: its .lcm struct, the C++ structs that carry it, a rule per field."""
    said: lcm_types.Struct
    structs: list[str]
    rules: dict[str, Rule]

    def path(self, field: str) -> str:
        return self.rules[field].inside + field

    def find(self, word: str) -> str:
        """The member with this word in its rule; empty: none."""
        return next((self.path(field.name) for field in self.said.fields if self.rules[field.name].has(word)), '')

    @property
    def size(self) -> int:
        return 8 + sum(BYTES[field.kind] * field.count for field in self.said.fields)


def read(file: pathlib.Path) -> Type:
    said, = lcm_types.parse(file.read_text(encoding='utf-8'), file.name)
    if not said.rule:
        raise Mistake(f'{file.name}: the comment above {said.name} does not end with its C++ struct in braces, as {{RobotState}}')
    return Type(said, [name.strip() for name in said.rule.split(',')], {field.name: rule_of(file.name, field) for field in said.fields})


def literal(number: str, kind: str) -> str:
    if kind in ('float', 'double'):
        return (number if '.' in number else number + '.0') + ('f' if kind == 'float' else '')
    return f'std::int64_t{{{number}}}' if kind == 'int64_t' else number


def limits_of(rule: Rule, field: lcm_types.Field) -> str:
    found = rule.bounds
    assert found
    high = literal(found[2], field.kind) if found[2] else {'float': 'static_cast<float>(kLargestNumber)'}.get(field.kind, 'kLargestNumber')
    return f'{literal(found[1], field.kind)}, {high}'


def convert(type_: Type, field: lcm_types.Field) -> list[str]:
    """Lines that copy and judge a field."""
    rule, name, path = type_.rules[field.name], field.name, type_.path(field.name)
    both = f'm.{name}, s.{path}'
    if rule.has('piece'):
        return []  # judged beside pieces
    if found := rule.argument(r'pieces (\d+)\.\.(\d+)'):
        piece = next(other for other in type_.rules if type_.rules[other].has('piece'))
        return [f'c.within({both}, {found[1]}, {found[2]});',
                f'c.within(m.{piece}, s.{type_.path(piece)}, 0, s.{path} > 0 ? s.{path} - 1 : 0);']
    lines = []
    if rule.has('per joint'):
        count = next(type_.path(other) for other in type_.rules if type_.rules[other].has('joints'))
        lines.append(f'c.per_joint({both}, s.{count});')
    elif rule.has('id or -1'):
        lines.append(f'c.within({both}, std::int64_t{{-1}}, kIds - 1);')
    elif rule.has('rotation'):
        lines.append(f'c.rotation({both});')
    elif found := rule.argument(r'count (\d+)'):
        lines.append(f'c.count({both}, {found[1]});')
    elif rule.has('joints'):
        lines.append(f'c.joint_count({both});')
    elif rule.bounds:
        return [f'c.within({both}, {limits_of(rule, field)});']
    else:
        word = next((f'.{word}' for word in ('id', 'instant', 'counter', 'text') if rule.has(word)), '')
        lines.append(f'c{word}({both});')
    if rule.bounds:
        lines.append(f'c.judge(s.{path}, {limits_of(rule, field)});')
    return lines


def fields(type_: Type, struct: str) -> list[str]:
    lines = [f'template <class C, class M, Is<{struct}> S>', 'void fields(C& c, M& m, S& s) noexcept {']
    for field in type_.said.fields:
        only = type_.rules[field.name].only
        lines += [f'  {line}' for line in (convert(type_, field) if only in ('', struct) else [f'c.leave_out(m.{field.name});'])]
    return lines + ['  cross_rules(c, s);', '}', '']


def fields_file(types: list[Type]) -> str:
    lines = ['// Included by lcmtypes/bus/convert.cpp.', '#pragma once', '', 'namespace twinbus {', 'namespace {']
    for type_ in types:
        for struct in type_.structs:
            lines += fields(type_, struct)
    return '\n'.join(lines + ['}  // namespace', '}  // namespace twinbus']) + '\n'


def wire_table(types: list[Type]) -> str:
    lines = ['#pragma once', '#include <cstdint>', '', '#include "lcmtypes/msg/messages.h"', '', 'namespace twinbus {', 'template <class T>',
             'struct Wire;']
    for type_ in types:
        sender, count = type_.find('sender'), type_.find('sequence')
        first, *others = type_.structs
        lines += ['template <>', f'struct Wire<{first}> {{', f'  static constexpr int kBytes = {type_.size};',
                  f'  static constexpr bool kCounted = {"true" if count else "false"};',
                  f'  static std::int64_t sender(const {first}& x) noexcept {{ return x.{sender}; }}']
        lines += [f'  static std::int64_t count(const {first}& x) noexcept {{ return x.{count}; }}'] if count else []
        lines += ['};']
        for other in others:
            lines += ['template <>', f'struct Wire<{other}> : Wire<{first}> {{}};']
    return '\n'.join(lines + ['}  // namespace twinbus']) + '\n'


def message_of(types: list[Type]) -> str:
    lines = ['#pragma once', '#include "lcmtypes/msg/messages.h"'] + [f'#include "twinbus/{type_.said.name}.hpp"' for type_ in types]
    lines += ['', 'namespace twinbus {', 'template <class T>', 'struct MessageOf;']
    every = [(struct, type_.said.name) for type_ in types for struct in type_.structs]
    for struct, name in every:
        lines += ['template <>', f'struct MessageOf<{struct}> {{', f'  using type = {name};', '};']
    lines += ['}  // namespace twinbus', '', '// X(T) for every struct.', '#define TWINBUS_MESSAGES(X) ' + ' '.join(f'X({struct})' for struct, _ in every)]
    return '\n'.join(lines) + '\n'


def sample(type_: Type, struct: str, place: int) -> list[str]:
    lines = ['template <>', f'inline {struct} sample<{struct}>() {{', f'  {struct} x;', f'  Filler fill({place});']
    for field in type_.said.fields:
        rule = type_.rules[field.name]
        x = f'x.{type_.path(field.name)}'
        most = rule.argument(r'count (\d+)')
        pieces = rule.argument(r'pieces (\d+)\.\.(\d+)')
        if rule.only not in ('', struct):
            continue
        if rule.has('joints'):
            lines.append(f'  {x} = kMaxJoints;')
        elif most:
            lines.append(f'  {x} = {most[1]};')
        elif pieces:
            lines.append(f'  {x} = 3;')
        elif rule.has('rotation'):
            lines.append(f'  fill.rotation({x});')
        elif rule.has('text'):
            lines.append(f'  fill.text({x});')
        elif rule.bounds:
            low, high = rule.bounds[1], rule.bounds[2] or '100'
            lines.append(f'  fill.between({x}, {low}, {high});')
        elif rule.has('piece'):
            lines.append(f'  {x} = 1;')
        else:
            lines.append(f'  fill({x});')
    return lines + ['  cross_sample(x);', '  return x;', '}']


def samples_file(types: list[Type]) -> str:
    lines = ['// Included by test/lcmtypes/samples.h.', '#pragma once', '', 'namespace twinbus {']
    every = [(type_, struct) for type_ in types for struct in type_.structs]
    for place, (type_, struct) in enumerate(every):
        lines += sample(type_, struct, place)
    lines += ['// Calls f.template operator()<T>() for every struct that goes over the bus.', 'template <class F>', 'void for_every_type(F&& f) {']
    lines += [f'  f.template operator()<{struct}>();' for _, struct in every]
    return '\n'.join(lines + ['}', '}  // namespace twinbus']) + '\n'


def write(path: pathlib.Path, text: str) -> None:
    """Only where it differs, so that nothing is compiled anew for nothing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    text = '// Made by lcmtypes/generate.py from lcmtypes/*.lcm.\n' + text
    if not path.exists() or path.read_text(encoding='utf-8') != text:
        path.write_text(text, encoding='utf-8')


def main() -> int:
    folder, files = pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]]
    try:
        types = [read(file) for file in sorted(files)]
    except (Mistake, ValueError) as error:
        print(f'generate.py: {error}', file=sys.stderr)
        return 1
    bus = folder / 'lcmtypes' / 'bus'
    write(bus / 'wire_table.h', wire_table(types))
    write(bus / 'message_of.h', message_of(types))
    write(bus / 'message_fields.h', fields_file(types))
    write(bus / 'message_samples.h', samples_file(types))
    return 0


if __name__ == '__main__':
    sys.exit(main())
