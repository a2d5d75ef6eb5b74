#!/usr/bin/env python3
"""generate.py FOLDER FILE.lcm...: what C++ needs of each message beside lcm-gen's class, so that a field is written once.

FOLDER/lcmtypes/msg/messages.h         structs, enumerations and sizes, without the bus
FOLDER/lcmtypes/msg/labels.h           what the enumerations are called in sentences for people
FOLDER/lcmtypes/bus/wire_table.h       size, sender and counter of each struct (Wire<T>)
FOLDER/lcmtypes/bus/message_of.h       lcm-gen's class of each struct (LcmClassOf<T>), and the list of all
FOLDER/lcmtypes/bus/message_fields.h   the fields of each with their rules, for convert.cpp
FOLDER/lcmtypes/bus/message_samples.h  a valid value of each struct, for tests
FOLDER/lcmtypes/bus/older_messages.h   of the files in a folder `older`: how a message of that version becomes one of now

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
WORDS = ('id', 'id or -1', 'instant', 'counter', 'joints', 'per joint', 'rotation', 'text', 'piece', 'sender', 'sequence', 'flag', 'letters', 'open')
VALUES = rf'= {NUMBER}(?: {NUMBER})*'
ENTRY = re.compile(r'(?P<value>\d+) (?P<name>[a-z][a-z ]*?)(?: "(?P<label>[^"]*)")?(?: \((?P<about>[^()]*)\))?(?:, |$)')
CPP = {'int8_t': 'std::int8_t', 'byte': 'std::uint8_t', 'boolean': 'bool', 'int16_t': 'std::int16_t', 'int32_t': 'std::int32_t', 'int64_t': 'std::int64_t',
       'float': 'float', 'double': 'double'}


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
    def enumeration(self) -> str:
        found = self.argument(r'(?:enum )?([A-Z]\w*)')
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
        if word not in WORDS and not re.fullmatch(rf'in \w+|(?:enum )?[A-Z]\w*|{VALUES}|older (?:{NUMBER}|rows(?: \d+)+)|count \d+(?: k\w+)?|pieces \d+\.\.\d+|{NUMBER}\.\.({NUMBER})?', word):
            raise Mistake(f'{file}: {field.name}: no rule {word!r}; there are {", ".join(WORDS)}, count N, count N kNAME, pieces A..B, A..B, A.., '
                          'enum ENUMERATION, ENUMERATION, in MEMBER, = VALUE, older VALUE, older rows A B ... (lcmtypes/README.md)')
    return rule


@dataclass
class Enumeration:
    """The values of a field, as its comment lists them: 1 standby track "track" (what it is), 2 ..."""
    name: str
    about: str
    entries: list['re.Match[str]']
    last: int  # that is let through

    @property
    def zero(self) -> bool:
        """Whether 0 stands for none without being listed."""
        return self.entries[0]['value'] != '0'

    def labels(self) -> list[str]:
        return ['none'] * self.zero + [entry['label'] or entry['name'] for entry in self.entries]


def enumeration_of(file: str, field: lcm_types.Field, rule: Rule) -> Enumeration:
    first = re.search(r'(?:^|: )(?=[01] )', field.about)
    entries, at = [], first.end() if first else 0
    while found := ENTRY.match(field.about, at):
        entries.append(found)
        at = found.end()
    values = [int(entry['value']) for entry in entries]
    if at < len(field.about) or not entries or values != list(range(values[0], values[0] + len(values))):
        raise Mistake(f'{file}: {field.name}: the comment of an enumeration lists its values, as 0 none, 1 standby track "track" (what it is), '
                      f'2 ...; it is not read from {field.about[at:]!r} on')
    return Enumeration(rule.enumeration, f'{field.name} of {file}', entries, 127 if rule.has('open') else values[-1])


@dataclass
class Type:
    """A message: its .lcm struct, the C++ struct that carries it, the one in it that holds some of its fields, a rule per field."""
    said: lcm_types.Struct
    struct: str
    head: list[str]  # type and member
    rules: dict[str, Rule]
    enumerations: list[Enumeration]

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
    struct, *head = said.rule.replace(',', ' ').split()
    rules = {field.name: rule_of(file.name, field) for field in said.fields}
    enumerations = [enumeration_of(file.name, field, rules[field.name]) for field in said.fields if rules[field.name].argument(r'enum \w+')]
    return Type(said, struct, head, rules, enumerations)


def check(types: list[Type]) -> None:
    """What only all files together can tell."""
    known = {enumeration.name for type_ in types for enumeration in type_.enumerations}
    for type_ in types:
        for name, rule in type_.rules.items():
            if rule.enumeration and rule.enumeration not in known:
                raise Mistake(f'{type_.said.name}.lcm: {name}: no field says enum {rule.enumeration}')


def camel(words: str) -> str:
    return 'k' + ''.join(word.capitalize() for word in words.split())


def comment(text: str) -> str:
    return f'  // {text}' if text else ''


def member(type_: Type, field: lcm_types.Field) -> str:
    """Its declaration in the C++ struct."""
    rule = type_.rules[field.name]
    kind = rule.enumeration or ('bool' if rule.has('flag') else 'char' if rule.has('text') or rule.has('letters') else CPP[field.kind])
    array = kind
    for size in reversed(field.shape):
        array = f'std::array<{array}, {size}>'
    if found := rule.argument(VALUES):
        values = found[0].split()[1:]
    else:
        values = ['-1'] if rule.has('id or -1') else ['1', '0', '0', '0'] if rule.has('rotation') else []
    if field.shape:
        values = values * (field.count if len(values) == 1 else 1)
        value = '{' + ', '.join(literal(number, field.kind) if kind == 'float' else number for number in values) + '}'
    elif values:
        value = ' = ' + literal(values[0], field.kind)
    else:
        value = '{}' if rule.enumeration else ' = false' if kind == 'bool' else ' = 0'
    return f'  {array} {field.name}{value};{comment(field.about)}'


def struct(type_: Type) -> list[str]:
    inside = [field for field in type_.said.fields if type_.rules[field.name].inside]
    lines = []
    if inside:
        lines += [f'// The same in every piece: {type_.said.name}.', f'struct {type_.head[0]} {{'] + [member(type_, field) for field in inside]
        lines += [f'  bool operator==(const {type_.head[0]}&) const = default;', '};']
    lines += [f'// {type_.said.name}.  {type_.said.about}', f'struct {type_.struct} {{'] + ([f'  {type_.head[0]} {type_.head[1]};'] if inside else [])
    return lines + [member(type_, field) for field in type_.said.fields if field not in inside] + ['};', '']


def messages(types: list[Type]) -> str:
    lines = ['#pragma once', '#include <array>', '#include <cstdint>', '', 'namespace twinbus::inline lcmtypes {']
    for type_ in types:
        for name, rule in type_.rules.items():
            if found := rule.argument(r'count (\d+) (k\w+)'):
                lines.append(f'inline constexpr int {found[2]} = {found[1]};  // {name} of {type_.said.name}, at most')
    for enumeration in (one for type_ in types for one in type_.enumerations):
        lines += ['', f'// {enumeration.about}', f'enum class {enumeration.name} : std::int8_t {{'] + ['  kNone = 0,'] * enumeration.zero
        lines += [f'  {camel(entry["name"])} = {entry["value"]},{comment(entry["about"])}' for entry in enumeration.entries] + ['};']
    return '\n'.join(lines + [''] + [line for type_ in types for line in struct(type_)] + ['}  // namespace twinbus::lcmtypes']) + '\n'


def labels(types: list[Type]) -> str:
    lines = ['#pragma once', '#include "common/text/name_of.h"', '#include "lcmtypes/msg/messages.h"', '', 'namespace twinbus::inline lcmtypes {',
             '// label(x): x in sentences for people.  last_of(x): the largest value that a message may carry.']
    for enumeration in (one for type_ in types for one in type_.enumerations):
        names = ', '.join(f'"{name}"' for name in enumeration.labels())
        lines += [f'constexpr const char* label({enumeration.name} x) noexcept {{', f'  constexpr const char* kNames[] = {{{names}}};',
                  '  return name_of(x, kNames);', '}', f'constexpr int last_of({enumeration.name}) {{ return {enumeration.last}; }}', '']
    return '\n'.join(lines + ['}  // namespace twinbus::lcmtypes']) + '\n'


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
    elif found := rule.argument(r'count (\d+).*'):
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


def fields(type_: Type) -> list[str]:
    lines = [f'template <class C, class M, Is<{type_.struct}> S>', 'void fields(C& c, M& m, S& s) noexcept {']
    return lines + [f'  {line}' for field in type_.said.fields for line in convert(type_, field)] + ['  cross_rules(c, s);', '}', '']


def fields_file(types: list[Type]) -> str:
    lines = ['// Included by lcmtypes/bus/convert.cpp.', '#pragma once', '', 'namespace twinbus::inline lcmtypes {', 'namespace {']
    lines += [line for type_ in types for line in fields(type_)]
    return '\n'.join(lines + ['}  // namespace', '}  // namespace twinbus::lcmtypes']) + '\n'


def wire_table(types: list[Type]) -> str:
    lines = ['#pragma once', '#include <cstdint>', '', '#include "lcmtypes/msg/messages.h"', '', 'namespace twinbus::inline lcmtypes {', 'template <class T>',
             'struct Wire;']
    for type_ in types:
        sender, count = type_.find('sender'), type_.find('sequence')
        lines += ['template <>', f'struct Wire<{type_.struct}> {{', f'  static constexpr int kBytes = {type_.size};',
                  f'  static constexpr bool kCounted = {"true" if count else "false"};',
                  f'  static std::int64_t sender(const {type_.struct}& x) noexcept {{ return x.{sender}; }}']
        lines += [f'  static std::int64_t count(const {type_.struct}& x) noexcept {{ return x.{count}; }}'] if count else []
        lines += ['};']
    return '\n'.join(lines + ['}  // namespace twinbus::lcmtypes']) + '\n'


def message_of(types: list[Type]) -> str:
    lines = ['#pragma once', '#include "lcmtypes/msg/messages.h"'] + [f'#include "twinbus/{type_.said.name}.hpp"' for type_ in types]
    lines += ['', 'namespace twinbus::inline lcmtypes {', 'template <class T>', 'struct LcmClassOf;']
    for type_ in types:
        lines += ['template <>', f'struct LcmClassOf<{type_.struct}> {{', f'  using type = {type_.said.name};', '};']
    lines += ['}  // namespace twinbus::lcmtypes', '', '// X(T) for every struct.', '#define TWINBUS_MESSAGES(X) ' + ' '.join(f'X({type_.struct})' for type_ in types)]
    return '\n'.join(lines) + '\n'


def sample(type_: Type, place: int) -> list[str]:
    lines = ['template <>', f'inline {type_.struct} sample<{type_.struct}>() {{', f'  {type_.struct} x;', f'  Filler fill({place});']
    for field in type_.said.fields:
        rule = type_.rules[field.name]
        x = f'x.{type_.path(field.name)}'
        most = rule.argument(r'count (\d+).*')
        pieces = rule.argument(r'pieces (\d+)\.\.(\d+)')
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
    for place, type_ in enumerate(types):
        lines += sample(type_, place)
    lines += ['// Calls f.template operator()<T>() for every struct that goes over the bus.', 'template <class F>', 'void for_every_type(F&& f) {']
    lines += [f'  f.template operator()<{type_.struct}>();' for type_ in types]
    return '\n'.join(lines + ['}', '}  // namespace twinbus']) + '\n'


def older_messages(types: list[Type], files: list[pathlib.Path]) -> str:
    lines = ['// Included by lcmtypes/bus/older.cpp.', '#pragma once', '', 'namespace twinbus::inline lcmtypes {', 'namespace {']
    rows = []
    for file in files:  # of one type there may be several; as_before() makes the first of them
        was, = lcm_types.parse(file.read_text(encoding='utf-8'), f'older/{file.name}')
        now = next((type_.said for type_ in types if type_.said.name == was.name), None)
        if now is None:
            raise Mistake(f'older/{file.name}: there is no {was.name} now')
        older, name = lcm_types.older_of(now, was), file.stem.title().replace('_', '')
        for kind, numbers in (('Older', was.fingerprint().to_bytes(8, 'big')), ('Blank', older.blank)):
            lines.append(f'constexpr std::uint8_t k{kind}{name}[] = {{{", ".join(map(str, numbers))}}};')
        lines.append(f'constexpr OlderPart kParts{name}[] = {{{", ".join(f"{{{a}, {b}, {c}}}" for a, b, c in older.parts)}}};')
        rows.append(f'{{kOlder{name}, {older.size}, kBlank{name}, kParts{name}}}')
    return '\n'.join(lines + [f'constexpr OlderMessage kOlderMessages[] = {{{", ".join(rows)}}};', '}  // namespace', '}  // namespace twinbus::lcmtypes']) + '\n'


def write(path: pathlib.Path, text: str) -> None:
    """Only where it differs, so that nothing is compiled anew for nothing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    text = '// Made by lcmtypes/generate.py from lcmtypes/*.lcm.\n' + text
    if not path.exists() or path.read_text(encoding='utf-8') != text:
        path.write_text(text, encoding='utf-8')


def main() -> int:
    folder, files = pathlib.Path(sys.argv[1]), sorted(pathlib.Path(name) for name in sys.argv[2:])
    try:
        types = [read(file) for file in files if file.parent.name != 'older']
        check(types)
        older = older_messages(types, [file for file in files if file.parent.name == 'older'])
    except (Mistake, ValueError) as error:
        print(f'generate.py: {error}', file=sys.stderr)
        return 1
    bus, msg = folder / 'lcmtypes' / 'bus', folder / 'lcmtypes' / 'msg'
    write(msg / 'messages.h', messages(types))
    write(msg / 'labels.h', labels(types))
    write(bus / 'wire_table.h', wire_table(types))
    write(bus / 'message_of.h', message_of(types))
    write(bus / 'message_fields.h', fields_file(types))
    write(bus / 'message_samples.h', samples_file(types))
    write(bus / 'older_messages.h', older)
    return 0


if __name__ == '__main__':
    sys.exit(main())
