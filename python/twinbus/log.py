"""Logs in LCM's format: message by message, or a channel as arrays."""
from __future__ import annotations

import os
import pathlib
import struct
from typing import TYPE_CHECKING, Any, Iterator

from .channels import TYPES
from .lcm_types import KINDS, Message, renewed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MARK = 0xEDA1DA01
MOST_NAME, MOST_BYTES = 63, 1 << 24


def parts(path: str | os.PathLike[str]) -> list[pathlib.Path]:
    """The files of a log, in order: run.log, run-0002.log, ..."""
    first = pathlib.Path(path)
    found = [first]
    while True:
        following = first.with_name(f'{first.stem}-{len(found) + 1:04d}{first.suffix}')
        if not following.is_file():
            return found
        found.append(following)


def read_log(path: str | os.PathLike[str]) -> Iterator[tuple[int, str, bytes]]:
    """(time [us since 1970], channel, body) of every message of a log, in the order of its files.

    The last message of a file that was not written to its end is left out.  ValueError, with the place, for a file that is no log."""
    for file in parts(path):
        with open(file, 'rb') as log:
            while len(head := log.read(28)) == 28:
                mark, _, utime, name, size = struct.unpack('>IqqII', head)
                if mark != MARK or not 0 < name <= MOST_NAME or size > MOST_BYTES:
                    raise ValueError(f'{file}: byte {log.tell() - 28}: no log, or a damaged one: ./twinbus log info {file} --check')
                channel, body = log.read(name), log.read(size)
                if len(body) == size:
                    yield utime, channel.decode('ascii', 'replace'), body


class Log:
    """A log whose channels are asked for as arrays; read once, when it is opened.

        log = twinbus.Log('runs/.../run.log')
        log.counts                                  # {'STATE': 5000, ...}
        state = log.arrays('STATE')
        plt.plot(state['time'], state['q'][:, 3])   # [s] since the first message, [rad]
        log.frame('STATE').describe()               # a table of pandas, where that is installed
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = pathlib.Path(path)
        self._utimes: dict[str, list[int]] = {}
        self._bodies: dict[str, list[bytes]] = {}
        for utime, channel, body in read_log(path):
            self._utimes.setdefault(channel, []).append(utime)
            self._bodies.setdefault(channel, []).append(renewed(body))
        self.start = min((utimes[0] for utimes in self._utimes.values()), default=0)
        """When the first message came [us since 1970]."""

    @property
    def counts(self) -> dict[str, int]:
        """Messages of each channel."""
        return {channel: len(bodies) for channel, bodies in sorted(self._bodies.items())}

    def messages(self, channel: str) -> list[Message]:
        """All messages of a channel, oldest first; those of another type are left out.  KeyError for a channel without a type."""
        kind = self._kind(channel)
        return [kind.decode(body) for body in self._bodies.get(channel, []) if _is(kind, body)]

    def arrays(self, channel: str) -> dict[str, NDArray[Any]]:
        """{field: array [messages, ...]} and 'time', float [messages], [s] since the log's first message.  A field of one number is
        [messages], one of the .lcm file's shape S is [messages, *S]; units are those of the .lcm file.  Messages of another type are
        left out; a channel that is not in the log gives arrays of length 0."""
        import numpy as np
        kind = self._kind(channel)
        kept = [(utime, body) for utime, body in zip(self._utimes.get(channel, []), self._bodies.get(channel, [])) if _is(kind, body)]
        row = np.dtype([('', 'V8'), *((field.name, '>' + KINDS[field.kind][1], field.shape) for field in kind.LCM.fields)])
        table: NDArray[Any] = np.frombuffer(b''.join(body for _, body in kept), row)
        found: dict[str, NDArray[Any]] = {'time': 1e-6 * (np.array([utime for utime, _ in kept], dtype=np.int64) - self.start)}
        for field in kind.LCM.fields:
            found[field.name] = table[field.name].astype(KINDS[field.kind][1])
        return found

    def frame(self, channel: str) -> Any:
        """The same as a pandas.DataFrame with 'time' as index and a column per number: q[0], q[1], wrench[0,2] ..."""
        try:
            import pandas  # type: ignore[import-untyped,import-not-found,unused-ignore]
        except ImportError:
            raise ImportError('Log.frame() needs pandas: pip install pandas (Log.arrays() does without)') from None
        columns: dict[str, Any] = {}
        for name, array in self.arrays(channel).items():
            flat = array.reshape(len(array), -1)
            for k in range(flat.shape[1]):
                columns[_column(name, array.shape[1:], k)] = flat[:, k]
        return pandas.DataFrame(columns).set_index('time')

    @staticmethod
    def _kind(channel: str) -> type[Message]:
        if channel not in TYPES:
            raise KeyError(f'{channel}: no type is known for it; twinbus.TYPES[{channel!r}] = twinbus.message_type(...)')
        return TYPES[channel]


def _is(kind: type[Message], body: bytes) -> bool:
    return len(body) == kind._layout.size and body[:8] == kind._fingerprint


def _column(name: str, shape: tuple[int, ...], k: int) -> str:
    if not shape:
        return name
    indices: list[str] = []
    for size in reversed(shape):
        indices.insert(0, str(k % size))
        k //= size
    return f'{name}[{",".join(indices)}]'
