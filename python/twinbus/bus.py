"""The bus: LCM's multicast format for messages of one datagram, which all of ours are, with the standard library alone."""
from __future__ import annotations

import os
import random
import re
import select
import socket
import struct
import sys
import time
from types import TracebackType
from typing import Any, Callable, Iterable, Protocol, Sequence

from . import messages
from .channels import TYPES
from .home import as_typed

JOINTS = 48  # arrays of a command always have this length
GROUP = 'udpm://239.255.76.67:17667?ttl=0'
ACCEPT_ALL: Callable[[Any], bool] = lambda message: True  # noqa: E731


class Encodes(Protocol):
    """A message of any type: ours, or one that lcm-gen wrote."""
    def encode(self) -> bytes: ...


class Bus:
    """A place on the bus.  url: $LCM_DEFAULT_URL, or this project's own port; prefix: put before every channel, as `--prefix`.

    ValueError for a URL that is none, OSError when the multicast group cannot be joined (it says the remedy)."""

    def __init__(self, url: str | None = None, prefix: str = '') -> None:
        url = url or os.environ.get('LCM_DEFAULT_URL') or GROUP
        parts = re.fullmatch(r'udpm://([0-9.]+):([0-9]+)(?:\?(.*))?', url)
        if not parts:
            raise ValueError(f'{url}: write udpm://239.255.76.67:PORT?ttl=0')
        self.group, self.port = parts[1], int(parts[2])
        options = dict(pair.split('=', 1) for pair in (parts[3] or '').split('&') if '=' in pair)
        self.prefix, self.wanted, self.sequence = prefix, set[bytes](), 0
        self.sender_id = new_id()
        self.asked = self.sender_id & 0x3FFFFFFF  # answers name it: one to somebody before us is none to us
        self.sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, int(options.get('ttl', 0)))
        self.receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, int(options.get('recv_buf_size', 4194304)))
        self.receiver.bind(('', self.port))
        try:
            membership = struct.pack('4s4s', socket.inet_aton(self.group), socket.inet_aton('0.0.0.0'))
            self.receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            self.close()
            raise OSError(f'cannot join {self.group}: {error.strerror or error}; try `ip route add 224.0.0.0/4 dev lo` as root') from None
        self.receiver.setblocking(False)

    def __enter__(self) -> Bus:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Leaves the bus."""
        self.sender.close()
        self.receiver.close()

    def listen(self, *channels: str) -> None:
        """Messages of these channels are received from now on."""
        self.wanted.update((self.prefix + channel).encode() for channel in channels)

    def receive(self, timeout: float) -> list[tuple[str, bytes]]:
        """Waits up to timeout [s] for a channel that is listened to, then returns all (channel, body) that have come, oldest first;
        none: nothing came in that time."""
        heard: list[tuple[str, bytes]] = []
        until = time.monotonic() + timeout
        while True:
            try:
                data = self.receiver.recv(65536)
            except BlockingIOError:
                left = until - time.monotonic()
                if heard or left <= 0.0:
                    return heard
                select.select([self.receiver], [], [], left)
                continue
            end = data.find(b'\0', 8, 8 + 64)
            if data[:4] == b'LC02' and end > 0 and data[8:end] in self.wanted:
                heard.append((data[8 + len(self.prefix):end].decode(), data[end + 1:]))

    def send(self, channel: str, message: Encodes) -> None:
        """Sends a message.  ValueError names a field that does not fit."""
        self.sequence = (self.sequence + 1) & 0xFFFFFFFF
        header = struct.pack('>4sI', b'LC02', self.sequence) + (self.prefix + channel).encode() + b'\0'
        self.sender.sendto(header + message.encode(), (self.group, self.port))

    def ask(self, channel: str, message: Any, state: messages.robot_state_t | messages.source_status_t) -> None:
        """Sends an operator's message to the run that this STATE or SOURCE_STATUS is of, with the time, our id and the next sequence."""
        self.asked += 1
        message.utime, message.sender_id, message.sequence = time.time_ns() // 1000, self.sender_id, self.asked
        if hasattr(message, 'run_id'):
            message.run_id = state.run_id
        self.send(channel, message)

    def wait(self, channel: str, accept: Callable[[Any], bool] = ACCEPT_ALL, timeout: float = 5.0) -> Any:
        """The first message from now on of a channel listened to that accept() likes; TimeoutError when none comes in timeout [s]."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            for name, body in self.receive(0.05):
                message = decode(name, body) if name == channel else None
                if message is not None and accept(message):
                    return message
        raise TimeoutError(f'{channel}: nothing of what was waited for in {timeout:g} s; is a stack running? (./twinbus status)')


def decode(channel: str, body: bytes) -> Any:
    """The message of that channel's type, or None for one of another type."""
    if channel not in TYPES:
        raise ValueError(f'{channel}: no type is known for it; twinbus.TYPES[{channel!r}] = its type')
    try:
        return TYPES[channel].decode(body)
    except (ValueError, struct.error):
        return None


def run(main: Callable[[], None]) -> None:
    """Calls main; Ctrl-C ends it quietly, what goes wrong is one line."""
    try:
        main()
    except KeyboardInterrupt:
        pass
    except (OSError, ValueError) as error:
        sys.exit(as_typed(f'{os.path.basename(sys.argv[0])}: {error}'))


def new_id() -> int:
    """For controller_id and its like: random, below 2^53."""
    return random.SystemRandom().randrange(1, 1 << 53)


def newest_state(heard: Sequence[tuple[str, bytes]]) -> messages.robot_state_t | None:
    """The last STATE among what was received, or None."""
    for channel, body in reversed(heard):
        if channel == 'STATE':
            try:
                return messages.robot_state_t.decode(body)
            except ValueError:
                continue
    return None


class Obedience:
    """Whether the active source obeys this controller: it obeys the first that it hears, until that one is gone and the operator
    clears.  Listen to SOURCE_STATUS."""

    def __init__(self, controller_id: int) -> None:
        self.controller_id, self.bound = controller_id, 0

    def problem(self, heard: Sequence[tuple[str, bytes]]) -> str | None:
        """A sentence, once, when another controller is obeyed; else None."""
        for channel, body in heard:
            status = decode(channel, body) if channel == 'SOURCE_STATUS' else None
            if status is None or status.role not in (2, 6) or status.controller_id == self.bound:  # active, stopped
                continue
            self.bound = status.controller_id
            if self.bound not in (0, self.controller_id):
                return as_typed(f'NOT OBEYED, another controller (id {self.bound}) is; end that one, then ./twinbus clear takes this one on')
        return None


def text(values: Iterable[int]) -> str:
    """A text field (int8 array that ends with a zero, as EVENT has) as str."""
    return bytes(int(value) & 0xFF for value in values).split(b'\0')[0].decode(errors='replace')


def padded(values: Iterable[float]) -> Any:
    """An array of 48: these values [joint_count or fewer], then zeros."""
    numbers = [float(value) for value in values]
    return numbers + [0.0] * (JOINTS - len(numbers))


def command_for(state: messages.robot_state_t, controller_id: int, q: Iterable[float], qd: Iterable[float] = (), tau: Iterable[float] = (),
                kp: Iterable[float] = (), kd: Iterable[float] = ()) -> messages.joint_command_t:
    """The command that answers this state: says which tick, run, term and robot it is for.

    Per joint, in the order of STATE: q [rad or m], qd [rad/s or m/s], tau [N m or N], kp [N m/rad], kd [N m s/rad]; the robot applies
    tau + kp (q - q_measured) + kd (qd - qd_measured).  What is left out is zero.

    A controller that makes a balanced stop itself (state.stop_kind == 1) says so by command.flags = 1, within three ticks
    and until it rests; one that does not is held by the source.  command.flags |= 2: the first command is not faded in."""
    command = messages.joint_command_t()
    command.tick, command.run_id, command.term = state.tick, state.run_id, state.term
    command.model_hash, command.joint_count = state.model_hash, state.joint_count
    command.controller_id = controller_id
    command.q, command.qd, command.tau = padded(q), padded(qd), padded(tau)
    command.kp, command.kd = padded(kp), padded(kd)
    return command
