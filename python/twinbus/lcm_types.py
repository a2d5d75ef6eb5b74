"""Message types made from .lcm texts: each struct becomes a dataclass that encodes and decodes itself as lcm-gen's does.

    power_t = twinbus.message_type(open('power_t.lcm').read())
    twinbus.TYPES['POWER'] = power_t

Fields of one number are int, float or bool; arrays are numpy arrays of the native byte order with the shape that the .lcm file
says, or lists (of lists) where numpy is not installed.  Known are the numbers of LCM in arrays of a fixed size, which is all that is
on this bus; strings, arrays of a variable size and structs in structs are refused with their line: those need lcm-gen.
"""
from __future__ import annotations

import dataclasses
import math
import pathlib
import re
import struct
from typing import Any, Callable, ClassVar, Sequence, TypeVar

try:
    import numpy
except ImportError:  # the bus does without
    numpy = None  # type: ignore[assignment,unused-ignore]

# LCM's name: letter of module struct, numpy's type, bytes, Python's type.
KINDS = {'int8_t': ('b', 'i1', 1, 'int'), 'int16_t': ('h', 'i2', 2, 'int'), 'int32_t': ('i', 'i4', 4, 'int'),
         'int64_t': ('q', 'i8', 8, 'int'), 'byte': ('B', 'u1', 1, 'int'), 'float': ('f', 'f4', 4, 'float'),
         'double': ('d', 'f8', 8, 'float'), 'boolean': ('?', '?', 1, 'bool')}
MOST_BYTES = 65000  # of a message: one datagram
RULE = re.compile(r'\s*\{([^{}]*)\}$')  # at the end of a comment: for generators of code, not for readers
TOKEN = re.compile(r'//(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/|(?P<word>[A-Za-z_][\w.]*|-?\d[\w.]*)|(?P<mark>[{}\[\];,=])|(?P<blank>\s+)|(?P<other>.)',
                   re.DOTALL)
M = TypeVar('M', bound='Message')


@dataclasses.dataclass(frozen=True)
class Field:
    """A field of a message: name, type of LCM, shape (() for one number), the comment behind it, and its rule: what that ended with
    in braces."""
    name: str
    kind: str
    shape: tuple[int, ...] = ()
    about: str = ''
    rule: str = ''

    @property
    def count(self) -> int:
        """How many numbers it has."""
        return math.prod(self.shape)


@dataclasses.dataclass(frozen=True)
class Struct:
    """A message type as its .lcm file says it; rule: what its comment ended with in braces."""
    package: str
    name: str
    about: str
    fields: tuple[Field, ...]
    rule: str = ''

    def fingerprint(self) -> int:
        """The hash of names, types and dimensions that begins every encoded message; lcm-gen's."""
        def update(value: int, number: int) -> int:
            arithmetic = value >> 55 if value < 1 << 63 else (value >> 55) | (~0 << 9)  # as of a signed number
            return (((value << 8) ^ arithmetic) + number) & 0xFFFFFFFFFFFFFFFF

        def update_text(value: int, text: str) -> int:
            value = update(value, len(text))
            for letter in text.encode():
                value = update(value, letter)
            return value

        value = 0x12345678
        for field in self.fields:
            value = update_text(update_text(value, field.name), field.kind)
            value = update(value, len(field.shape))
            for size in field.shape:
                value = update_text(update(value, 0), str(size))
        return ((value << 1) + (value >> 63)) & 0xFFFFFFFFFFFFFFFF


@dataclasses.dataclass(frozen=True)
class Older:
    """How a message of an older version of its type becomes one of now: parts (from, to, bytes) are copied into blank, which holds the
    rest."""
    fingerprint: bytes
    size: int
    blank: bytes
    parts: tuple[tuple[int, int, int], ...]

    def renewed(self, data: bytes) -> bytes:
        now = bytearray(self.blank)
        for source, to, size in self.parts:
            now[to:to + size] = data[source:source + size]
        return bytes(now)


OLDER: dict[bytes, Older] = {}  # by fingerprint


def renewed(data: bytes) -> bytes:
    """The bytes that a message of an older log has now; any other as it is."""
    older = OLDER.get(data[:8])
    return data if older is None or len(data) != older.size else older.renewed(data)


def older_of(now: Struct, older: Struct) -> Older:
    """Of two versions of a type.  Rules of a field of now: `older rows A B ...`, the places of the rows that there were (else the first
    ones); `older X`, its value where there was none (else 0)."""
    def places(said: Struct) -> tuple[dict[str, tuple[Field, int]], int]:
        at, found = 8, {}
        for field in said.fields:
            found[field.name] = (field, at)
            at += KINDS[field.kind][2] * field.count
        return found, at

    (was, size), (_, now_size) = places(older), places(now)
    blank, at = bytearray(now_size), 8
    parts: list[tuple[int, int, int]] = []  # from, to, bytes
    blank[:8] = struct.pack('>Q', now.fingerprint())
    for field in now.fields:
        letter, _, number, python = KINDS[field.kind]
        rule = next((word.split()[1:] for word in re.split(r'\s*,\s*', field.rule) if word.startswith('older ')), [])
        if field.name in was:
            before, source = was[field.name]
            if before.kind != field.kind or before.shape[1:] != field.shape[1:]:
                raise ValueError(f'{now.name}: {field.name} was {before.kind}{list(before.shape)}')
            row = number * math.prod(field.shape[1:])
            count = before.shape[0] if before.shape else 1
            for k, to in enumerate([int(word) for word in rule[1:]] or range(count)):
                part = (source + k * row, at + to * row, row)
                if parts and all(parts[-1][i] + parts[-1][2] == part[i] for i in (0, 1)):
                    parts[-1] = (*parts[-1][:2], parts[-1][2] + row)
                else:
                    parts.append(part)
        elif rule:
            blank[at:at + number * field.count] = struct.pack(f'>{field.count}{letter}', *[(float if python == 'float' else int)(rule[0])] * field.count)
        at += number * field.count
    return Older(struct.pack('>Q', older.fingerprint()), size, bytes(blank), tuple(parts))


class Message:
    """What every message type can do.  Subclasses are dataclasses; all fields are zero at first."""
    LCM: ClassVar[Struct]
    _layout: ClassVar[struct.Struct]
    _fingerprint: ClassVar[bytes]

    def encode(self) -> bytes:
        """The bytes of the message.  ValueError for a field of a wrong shape, or of a number that does not fit, with its name."""
        parts: list[Any] = [self._fingerprint]
        for field in self.LCM.fields:
            value = getattr(self, field.name)
            parts.append(value if not field.shape else _packed(self.LCM.name, field, value))
        try:
            return self._layout.pack(*parts)
        except struct.error as error:
            raise ValueError(f'{self.LCM.name}: {self._culprit() or error}') from None

    def _culprit(self) -> str:
        for field in self.LCM.fields:
            if not field.shape:
                try:
                    struct.pack('>' + KINDS[field.kind][0], getattr(self, field.name))
                except struct.error as error:
                    return f'{field.name} = {getattr(self, field.name)!r}: {error}'
        return ''

    @classmethod
    def decode(cls: type[M], data: bytes) -> M:
        """The message of these bytes, also of those of an older version.  ValueError when they are of another type or of another length."""
        data = renewed(data)
        if len(data) != cls._layout.size or data[:8] != cls._fingerprint:
            raise ValueError(f'{cls.LCM.name}: {len(data)} bytes that are none: {cls._layout.size} with its fingerprint were expected; '
                             'sender and receiver are of different versions')
        message = cls.__new__(cls)
        for field, value in zip(cls.LCM.fields, cls._layout.unpack(data)[1:]):
            message.__dict__[field.name] = value if not field.shape else _unpacked(field, value)
        return message

    def __eq__(self, other: object) -> bool:
        """Equal to the last bit."""
        return type(self) is type(other) and isinstance(other, Message) and self.encode() == other.encode()

    __hash__ = None  # type: ignore[assignment]


def _packed(name: str, field: Field, value: Any) -> bytes:
    letter, kind, size, python = KINDS[field.kind]
    if isinstance(value, (bytes, bytearray)) and size == 1 and len(field.shape) == 1:
        if len(value) > field.count:
            raise ValueError(f'{name}.{field.name}: {len(value)} bytes, at most {field.count}')
        return bytes(value)  # the layout fills up with zeros
    if numpy is not None:
        array = numpy.asarray(value)
        if array.shape != field.shape:
            raise ValueError(f'{name}.{field.name}: shape {array.shape}, must be {field.shape}')
        wanted = numpy.dtype(kind)
        if python == 'int' and array.size:
            limits = numpy.iinfo(wanted)
            if array.dtype.kind not in 'iub' or array.min() < limits.min or array.max() > limits.max:
                raise ValueError(f'{name}.{field.name}: must be whole numbers from {limits.min} to {limits.max}')
        if array.dtype.kind not in 'iubf':
            raise ValueError(f'{name}.{field.name}: must be numbers')
        return array.astype(wanted.newbyteorder('>'), order='C').tobytes()
    flat = [value]
    for length in field.shape:
        if any(len(row) != length for row in flat):
            raise ValueError(f'{name}.{field.name}: wrong length, shape must be {field.shape}')
        flat = [one for row in flat for one in row]
    try:
        return struct.pack(f'>{field.count}{letter}', *flat)
    except struct.error as error:
        raise ValueError(f'{name}.{field.name}: {error}') from None


def _unpacked(field: Field, data: bytes) -> Any:
    letter, kind, _, _ = KINDS[field.kind]
    if numpy is not None:
        wanted = numpy.dtype(kind)
        return numpy.frombuffer(data, wanted.newbyteorder('>')).astype(wanted).reshape(field.shape)
    return _nested(struct.unpack(f'>{field.count}{letter}', data), field.shape)


def _nested(flat: Sequence[Any], shape: tuple[int, ...]) -> list[Any]:
    if len(shape) == 1:
        return list(flat)
    part = len(flat) // shape[0]
    return [_nested(flat[k * part:(k + 1) * part], shape[1:]) for k in range(shape[0])]


def _zeros(field: Field) -> Callable[[], Any]:
    if numpy is not None:
        return lambda: numpy.zeros(field.shape, KINDS[field.kind][1])
    zero = {'int': 0, 'float': 0.0, 'bool': False}[KINDS[field.kind][3]]
    return lambda: _nested([zero] * field.count, field.shape)


def parse(text: str, name: str = '.lcm') -> list[Struct]:
    """The structs of an .lcm text; name is that of the file, for errors.  ValueError with file, line and what was expected."""
    tokens: list[tuple[str, int]] = []  # and the line each is on
    comments: dict[int, tuple[str, bool]] = {}  # line: comment, and whether it is alone on its line
    line = 1
    for found in TOKEN.finditer(text):
        if found['line'] is not None or found['block'] is not None:
            said = ' '.join((found['line'] or found['block'] or '').replace('*', ' ').split())
            comments[line] = (said, not tokens or tokens[-1][1] != line)
        elif found['other'] is not None:
            raise ValueError(f'{name}:{line}: {found["other"]!r} is no part of an .lcm file')
        elif found['blank'] is None:
            tokens.append((found[0], line))
        line += found[0].count('\n')
    return _Parser(tokens, comments, name, line).structs()


def _without_rule(about: str) -> tuple[str, str]:
    found = RULE.search(about)
    return (about[:found.start()], found[1]) if found else (about, '')


class _Parser:
    def __init__(self, tokens: list[tuple[str, int]], comments: dict[int, tuple[str, bool]], name: str, last: int) -> None:
        self.tokens, self.comments, self.name, self.at = tokens + [('', last)], comments, name, 0

    def fail(self, what: str) -> ValueError:
        word, line = self.tokens[self.at]
        return ValueError(f'{self.name}:{line}: {what}, not {word!r}' if word else f'{self.name}:{line}: {what}, but the text ends')

    def take(self, *wanted: str) -> str:
        word = self.tokens[self.at][0]
        if not word or (wanted and word not in wanted) or (not wanted and not re.fullmatch(r'[A-Za-z_][\w.]*', word)):
            raise self.fail('expected ' + (' or '.join(wanted) if wanted else 'a name'))
        self.at += 1
        return word

    def structs(self) -> list[Struct]:
        package, found = '', []
        while self.tokens[self.at][0]:
            if self.take('package', 'struct') == 'package':
                package = self.take()
                self.take(';')
            else:
                found.append(self.struct(package))
        return found

    def above(self, line: int) -> str:
        """The comment that stands alone on the lines before this one."""
        lines: list[str] = []
        while (before := self.comments.get(line - 1)) and before[1]:
            lines.insert(0, before[0])
            line -= 1
        return ' '.join(lines)

    def struct(self, package: str) -> Struct:
        about = self.above(self.tokens[self.at - 1][1])
        name = self.take()
        self.take('{')
        fields: list[Field] = []
        constants: dict[str, int] = {}
        while self.tokens[self.at][0] != '}':
            if self.tokens[self.at][0] == 'const':
                self.constants(constants)
            else:
                fields += self.members(constants)
        self.take('}')
        if len({field.name for field in fields}) != len(fields):
            raise self.fail(f'{name}: every field needs a name of its own')
        size = 8 + sum(KINDS[field.kind][2] * field.count for field in fields)
        if size > MOST_BYTES:
            raise self.fail(f'{name}: {size} bytes, at most {MOST_BYTES} fit into a datagram')
        said, rule = _without_rule(about)
        return Struct(package, name, said, tuple(fields), rule)

    def constants(self, constants: dict[str, int]) -> None:
        self.take('const')
        self.take()
        while True:
            name = self.take()
            self.take('=')
            value = self.tokens[self.at][0]
            if re.fullmatch(r'-?(0x[0-9A-Fa-f]+|\d+)', value):
                constants[name] = int(value, 0)
            self.at += 1
            if self.take(',', ';') == ';':
                return

    def members(self, constants: dict[str, int]) -> list[Field]:
        line = self.tokens[self.at][1]
        kind = self.tokens[self.at][0]
        if kind not in KINDS:
            raise self.fail(f'expected one of {", ".join(KINDS)} (for others use lcm-gen)')
        self.at += 1
        found = []
        while True:
            name, shape = self.take(), []
            while self.tokens[self.at][0] == '[':
                self.at += 1
                size = self.tokens[self.at][0]
                if not re.fullmatch(r'[1-9]\d{0,5}', size):
                    raise self.fail('expected a fixed size in figures (for others use lcm-gen)')
                self.at += 1
                self.take(']')
                shape.append(int(size))
            found.append((name, tuple(shape)))
            if self.take(',', ';') == ';':
                break
        said, alone = self.comments.get(self.tokens[self.at - 1][1], ('', True))
        about, rule = _without_rule(self.above(line) if alone else said)
        return [Field(name, kind, shape, about, rule) for name, shape in found]


def make_type(said: Struct, module: str = __name__) -> type[Message]:
    """The dataclass of a struct."""
    fields: list[tuple[str, Any, Any]] = []
    letters = '>8s'
    for field in said.fields:
        letter, _, size, python = KINDS[field.kind]
        if field.shape:
            fields.append((field.name, 'numpy.ndarray', dataclasses.field(default_factory=_zeros(field))))
            letters += f'{size * field.count}s'
        else:
            fields.append((field.name, python, dataclasses.field(default={'int': 0, 'float': 0.0, 'bool': False}[python])))
            letters += letter
    space = {'LCM': said, '_layout': struct.Struct(letters), '_fingerprint': struct.pack('>Q', said.fingerprint()), '__doc__': docstring(said),
             '__module__': module}
    return dataclasses.make_dataclass(said.name, fields, bases=(Message,), namespace=space, eq=False)


def message_type(text: str, name: str = '.lcm') -> type[Message]:
    """The message type of an .lcm text with one struct: a type of your own for a channel of your own."""
    structs = parse(text, name)
    if len(structs) != 1:
        raise ValueError(f'{name}: {len(structs)} structs, one is expected')
    return make_type(structs[0])


def docstring(said: Struct) -> str:
    """Of a message type: what its .lcm file says of it and of its fields."""
    lines = [said.about or said.name, '']
    for field in said.fields:
        size = '' if not field.shape else f'[{", ".join(map(str, field.shape))}]'
        lines.append(f'{field.name}: {field.kind}{size}' + (f'  {field.about}' if field.about else ''))
    return '\n'.join(lines)


def read_folder(folder: pathlib.Path) -> list[Struct]:
    """All structs of the .lcm files of a folder, by name."""
    found = [said for file in sorted(folder.glob('*.lcm')) for said in parse(file.read_text(encoding='utf-8'), file.name)]
    return sorted(found, key=lambda said: said.name)


def stubs(structs: Sequence[Struct]) -> str:
    """The text of messages.pyi."""
    lines = ['# Made from lcmtypes/*.lcm by test/structure/python_test.py --write; for type checkers and editors.',
             'from dataclasses import dataclass', '', 'import numpy as np', 'from numpy.typing import NDArray', '',
             'from .lcm_types import Message', '', 'ALL: dict[str, type[Message]]']
    names = {'i1': 'np.int8', 'i2': 'np.int16', 'i4': 'np.int32', 'i8': 'np.int64', 'u1': 'np.uint8', 'f4': 'np.float32', 'f8': 'np.float64',
             '?': 'np.bool_'}
    for said in structs:
        lines += ['', '', '@dataclass(eq=False)', f'class {said.name}(Message):']
        lines += [f'    """{said.about}"""'] if said.about else []
        for field in said.fields:
            _, kind, _, python = KINDS[field.kind]
            hint = f'NDArray[{names[kind]}]' if field.shape else python
            size = f'  # [{", ".join(map(str, field.shape))}]' if field.shape else ''
            about = f'{" " if size else "  # "}{field.about}' if field.about else ''
            lines.append(f'    {field.name}: {hint} = ...{size}{about}'.rstrip())
    return '\n'.join(lines) + '\n'
