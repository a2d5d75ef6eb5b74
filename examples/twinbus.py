"""Everything that a Python program needs on the bus, with nothing but the standard library: the bus, the message types, and
a command that is padded and follows the source whatever term it is in.

    import twinbus
    bus = twinbus.Bus()                            # $LCM_DEFAULT_URL, or this project's own port
    bus.listen('STATE')
    state = twinbus.newest_state(bus.receive(0.1))
    bus.send('COMMAND', twinbus.command_for(state, me, state.q, kp=[1000.0] * state.joint_count))

and for operators, whose messages name the run that they are for and count up:

    bus.listen('STATE', 'CONTROLLER_STATUS')
    state = bus.wait('STATE')
    request = twinbus.mode_request_t()
    request.mode = 4                               # balance
    bus.ask('MODE_REQUEST', request, state)
    bus.wait('CONTROLLER_STATUS', lambda status: status.mode_sequence == request.sequence)

Speaks LCM's multicast format for messages of one datagram, which all of ours are.  The message types come from the
build (build/*/lib/python, or $TWINBUS_PYTHON), written by lcm-gen, and are those of the package `twinbus` in it:
twinbus.robot_state_t and so on.
"""
import glob
import importlib
import os
import random
import re
import select
import socket
import struct
import sys
import time

# What is on each channel, as in lcmtypes/README.md; a channel of your own: twinbus.TYPES['POWER'] = power_t.
TYPES = {'STATE': 'robot_state_t', 'STATE_SIM': 'robot_state_t', 'STATE_BRIDGE': 'robot_state_t', 'STATE_REPLAY': 'robot_state_t',
         'COMMAND': 'joint_command_t', 'CONTROLLER_STATUS': 'controller_status_t', 'SOURCE_STATUS': 'source_status_t',
         'TRUTH': 'sim_truth_t', 'GUARD': 'guard_report_t', 'ARM_PATH': 'arm_path_t', 'EVENT': 'event_t',
         'HEARTBEAT': 'heartbeat_t', 'GAP': 'gap_t', 'OBSTACLES': 'obstacles_t', 'STOP': 'stop_t'}
JOINTS = 48  # arrays of a command always have this length
__path__ = []  # of the types: this module is their package too


def _load_types():
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    folders = [os.environ.get('TWINBUS_PYTHON', ''), os.path.join(root, 'build/release/lib/python'),
               os.path.join(root, '../../lib/twinbus/lib/python')]  # of an installation
    for folder in folders + sorted(glob.glob(os.path.join(root, 'build/*/lib/python'))):
        package = os.path.join(folder, 'twinbus')
        if not os.path.isfile(os.path.join(package, 'robot_state_t.py')):
            continue
        __path__.append(package)
        for file in sorted(glob.glob(os.path.join(package, '*_t.py'))):
            name = os.path.basename(file)[:-3]
            globals()[name] = getattr(importlib.import_module(f'{__name__}.{name}'), name)
        return
    sys.exit('twinbus.py: no message types; build first (./twinbus up), or set TWINBUS_PYTHON to the folder '
             'that holds twinbus/robot_state_t.py')


_load_types()


class Bus:
    def __init__(self, url=None, prefix=''):
        url = url or os.environ.get('LCM_DEFAULT_URL') or 'udpm://239.255.76.67:17667?ttl=0'
        parts = re.fullmatch(r'udpm://([0-9.]+):([0-9]+)(?:\?(.*))?', url)
        if not parts:
            raise ValueError(f'{url}: write udpm://239.255.76.67:PORT?ttl=0')
        self.group, self.port = parts[1], int(parts[2])
        options = dict(pair.split('=', 1) for pair in (parts[3] or '').split('&') if '=' in pair)
        self.prefix, self.wanted, self.sequence = prefix, set(), 0
        self.sender_id, self.asked = new_id(), 0
        self.sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, int(options.get('ttl', 0)))
        self.receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, int(options.get('recv_buf_size', 4194304)))
        self.receiver.bind(('', self.port))
        membership = struct.pack('4s4s', socket.inet_aton(self.group), socket.inet_aton('0.0.0.0'))
        try:
            self.receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        except OSError as error:
            raise OSError(f'cannot join {self.group}: {error.strerror}; try `ip route add 224.0.0.0/4 dev lo` '
                          'as root') from None
        self.receiver.setblocking(False)

    def listen(self, *channels):
        self.wanted.update((self.prefix + channel).encode() for channel in channels)

    def receive(self, timeout):
        """Waits up to timeout seconds for a channel that is listened to, then returns all (channel, body) that have come,
        oldest first; none: nothing came in that time."""
        messages, until = [], time.monotonic() + timeout
        while True:
            try:
                data = self.receiver.recv(65536)
            except BlockingIOError:
                left = until - time.monotonic()
                if messages or left <= 0.0:
                    return messages
                select.select([self.receiver], [], [], left)
                continue
            end = data.find(b'\0', 8, 8 + 64)
            if data[:4] == b'LC02' and end > 0 and data[8:end] in self.wanted:
                messages.append((data[8 + len(self.prefix):end].decode(), data[end + 1:]))

    def send(self, channel, message):
        self.sequence = (self.sequence + 1) & 0xFFFFFFFF
        header = struct.pack('>4sI', b'LC02', self.sequence) + (self.prefix + channel).encode() + b'\0'
        self.sender.sendto(header + message.encode(), (self.group, self.port))


    def ask(self, channel, message, state):
        """Sends an operator's message to the run that this STATE is of, with the time, our id and the next sequence."""
        self.asked += 1
        message.utime, message.sender_id, message.sequence = time.time_ns() // 1000, self.sender_id, self.asked
        if hasattr(message, 'run_id'):
            message.run_id = state.run_id
        self.send(channel, message)

    def wait(self, channel, accept=lambda message: True, timeout=5.0):
        """The first message from now on of a channel listened to that accept() likes; TimeoutError when none comes in time."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            for name, body in self.receive(0.05):
                message = decode(name, body) if name == channel else None
                if message is not None and accept(message):
                    return message
        raise TimeoutError(f'{channel}: nothing of what was waited for in {timeout:g} s; is a stack running? (./twinbus status)')


def decode(channel, body):
    """The message, or None for one of another type."""
    kind = TYPES[channel]
    try:
        return (globals()[kind] if isinstance(kind, str) else kind).decode(body)
    except (ValueError, struct.error):
        return None


def read_log(path):
    """(time [us since 1970], channel, body) of every message of a log in LCM's format, in the order of the file."""
    with open(path, 'rb') as file:
        while len(head := file.read(28)) == 28:
            mark, _, utime, name, size = struct.unpack('>IqqII', head)
            if mark != 0xEDA1DA01:
                raise ValueError(f'{path}: no log, or a damaged one: ./twinbus log info {path} --check')
            yield utime, file.read(name).decode(), file.read(size)


def run(main):
    """Calls main; Ctrl-C ends it quietly, what goes wrong is one line."""
    try:
        main()
    except KeyboardInterrupt:
        pass
    except (OSError, ValueError) as error:
        sys.exit(f'{os.path.basename(sys.argv[0])}: {error}')


def new_id():
    """For controller_id and its like: random, below 2^53."""
    return random.SystemRandom().randrange(1, 1 << 53)


def newest_state(messages):
    """The last STATE among what was received, or None."""
    for channel, body in reversed(messages):
        if channel == 'STATE':
            try:
                return robot_state_t.decode(body)  # noqa: F821  (loaded above)
            except (ValueError, struct.error):
                continue
    return None


def padded(values):
    return list(values) + [0.0] * (JOINTS - len(values))


def command_for(state, controller_id, q, qd=(), tau=(), kp=(), kd=()):
    """The command that answers this state: says which tick, run, term and robot it is for.

    A controller that makes a balanced stop itself (state.stop_kind == 1) says so by command.flags = 1, within three ticks
    and until it rests; one that does not is held by the source.  command.flags |= 2: the first command is not faded in."""
    command = joint_command_t()  # noqa: F821  (loaded above)
    command.tick, command.run_id, command.term = state.tick, state.run_id, state.term
    command.model_hash, command.joint_count = state.model_hash, state.joint_count
    command.controller_id = controller_id
    command.q, command.qd, command.tau = padded(q), padded(qd), padded(tau)
    command.kp, command.kd = padded(kp), padded(kd)
    return command
