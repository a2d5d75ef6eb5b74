"""What every process test needs: a bus of its own, a stack that is started and ended, and a record of what was said.

Run under test/tools/private_bus.sh: these tests start robots and must not hear each other.
"""

import glob
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("TWINBUS_BIN", ROOT / "build/release/bin"))
FULL = os.environ.get("TWINBUS_FULL", "") != ""
GROUP, PORT = "239.255.76.67", 17667
SKIPPED = 77

sys.path.insert(0, str(BIN.parent / "lib/python"))
try:
    import twinbus  # noqa: E402  (message types that lcm-gen wrote)
except ImportError:
    print(f"skipped: no message types in {BIN.parent / 'lib/python'}")
    sys.exit(SKIPPED)

CHANNEL_TYPES = {
    "STATE": "robot_state_t", "STATE_SIM": "robot_state_t", "STATE_BRIDGE": "robot_state_t",
    "STATE_REPLAY": "robot_state_t", "COMMAND": "joint_command_t", "SOURCE_STATUS": "source_status_t",
    "ESTIMATE": "estimate_t", "TRUTH": "sim_truth_t", "GUARD": "guard_report_t", "CONTROLLER_STATUS": "controller_status_t",
    "HEARTBEAT": "heartbeat_t", "EVENT": "event_t", "STOP": "stop_t", "SOURCE_REQUEST": "source_request_t",
    "MODE_REQUEST": "mode_request_t", "ARM_GOAL": "arm_goal_t", "ARM_PATH": "arm_path_t",
    "CONTROLLER_REQUEST": "controller_request_t", "GAP": "gap_t",
}


def type_of(channel):
    return getattr(twinbus, CHANNEL_TYPES[channel])


class Bus:
    """Sends messages, and records every datagram with the instant it came.  Decoding is done by whoever looks."""

    def __init__(self, port=PORT):
        self.port = port
        self.records = []  # (steady clock [ns], channel, bytes)
        self._sequence = 0
        self._sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4194304)
        self._socket.bind(("", port))
        self._socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP,
                                struct.pack("4sl", socket.inet_aton(GROUP), socket.INADDR_ANY))
        self._socket.settimeout(0.2)
        self._run = True
        self._thread = threading.Thread(target=self._listen, daemon=True)
        self._thread.start()

    def _listen(self):
        while self._run:
            try:
                data = self._socket.recv(65536)
            except socket.timeout:
                continue
            except OSError:
                return
            end = data.find(b"\0", 8)
            if data[:4] == b"LC02" and end > 0:
                self.records.append((time.monotonic_ns(), data[8:end].decode("ascii", "replace"), data[end + 1:]))

    def close(self):
        self._run = False
        self._thread.join()
        self._socket.close()
        self._sender.close()

    def send(self, channel, message):
        self.send_raw(channel, message.encode())

    def send_raw(self, channel, body):
        self._sequence += 1
        data = struct.pack(">4sI", b"LC02", self._sequence) + channel.encode() + b"\0" + body
        self._sender.sendto(data, (GROUP, self.port))

    def messages(self, channel, since_ns=0, until_ns=1 << 62, start=0):
        """(instant, message) of one channel, oldest first."""
        kind = type_of(channel)
        for at, name, body in self.records[start:]:
            if name == channel and since_ns <= at <= until_ns:
                try:
                    yield at, kind.decode(body)
                except ValueError:
                    pass

    def newest(self, channel, accept=lambda message: True, look_back=20000):
        kind = type_of(channel)
        for at, name, body in reversed(self.records[-look_back:]):
            if name == channel:
                message = kind.decode(body)
                if accept(message):
                    return at, message
        return None, None

    def wait_for(self, channel, accept=lambda message: True, timeout=5.0, start=None):
        """The first message that accept() likes, from now on or from record `start` on; None when it does not come in
        time."""
        start, end = len(self.records) if start is None else start, time.monotonic() + timeout
        kind = type_of(channel)
        while time.monotonic() < end:
            stop = len(self.records)
            for at, name, body in self.records[start:stop]:
                if name == channel:
                    message = kind.decode(body)
                    if accept(message):
                        return at, message
            start = stop
            time.sleep(0.002)
        return None, None

    def forget(self):
        """Drops what was recorded, to keep memory small in long runs."""
        del self.records[:]


def text_of(event):
    """What an EVENT says."""
    text = event.text if isinstance(event.text, bytes) else bytes(c & 0xFF for c in event.text)
    return text.split(b"\0")[0].decode("ascii", "replace")


def story_of_a_stop(bus, look_back_s=10.0, stalls=None):
    """Lines that tell how the newest stop came: the last STATEs and COMMANDs before it, the longest silences, and
    where they were watched (stalls.py) the stalls of the machine."""
    now = time.monotonic_ns()
    states = list(bus.messages("STATE", now - int(1e9 * look_back_s)))
    first = next((k for k, (_, s) in enumerate(states) if s.stop_kind >= 2), None)
    if first is None:
        return ["  no STATE of a stopped source was heard"]
    at, state = states[first]
    lines = [f"  stopped: kind {state.stop_kind}, tick {state.tick}, run {state.run_id}, "
             f"term {state.term}; milliseconds before it:"]
    for channel in ("STATE", "COMMAND", "GUARD"):
        heard = list(bus.messages(channel, at - 400_000_000, at))
        gaps = sorted(((b[0] - a[0]) * 1e-6 for a, b in zip(heard, heard[1:])), reverse=True)[:3]
        lines.append(f"  {channel}: {len(heard)} in 400 ms, longest silences {', '.join(f'{g:.1f}' for g in gaps)} ms")
        lines += [f"    {(at - t) * 1e-6:7.1f}  tick {m.tick} run {m.run_id} "
                  f"{'term %d' % m.term if hasattr(m, 'term') else ''}" for t, m in heard[-6:]]
    if stalls is not None:
        lines += [f"    {(at - a) * 1e-6:7.1f}  the machine stood still for {(b - a) * 1e-6:.1f} ms"
                  for a, b in stalls.between(at - 400_000_000, at)]
    lines += [f"    {(at - t) * 1e-6:7.1f}  {text_of(e)}"
              for t, e in bus.messages("EVENT", at - 2_000_000_000, at + 200_000_000)]
    return lines


def go_ahead():
    """Before ordinary processes, where that is allowed; not FIFO: Python would use up the share of a CPU that FIFO may have, and the
    kernel then stops the robot's own loops too, for 50 ms.  In a session of its own: a kernel that groups processes by
    session (autogroup) asks the nice value of the group, and that of a process counts within its group only."""
    try:
        os.nice(-15)
        group = pathlib.Path("/proc/self/autogroup")
        if group.exists() and os.getsid(0) == os.getpid():
            group.write_text("-15")
    except OSError:
        pass


def cli(*words, timeout=60.0):
    """Runs `twinbus WORDS` and gives (exit status, stdout, stderr)."""
    done = subprocess.run([BIN / "twinbus", *map(str, words)], capture_output=True, text=True, timeout=timeout,
                          stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout, done.stderr


class Stack:
    """`twinbus up WORDS`, as a context: running inside, ended behind."""

    def __init__(self, *words, timeout=60.0):
        self.words = [str(word) for word in words]
        self.timeout = timeout
        self.lines = []

    def __enter__(self):
        self.process = subprocess.Popen([BIN / "twinbus", "up", *self.words], stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        end = time.monotonic() + self.timeout
        while not any("FIFO priority" in line for line in self.lines):
            if self.process.poll() is not None or time.monotonic() > end:
                self._reader.join(1.0)
                self.process.kill()
                raise RuntimeError("up " + " ".join(self.words) + " does not run:\n" + "".join(self.lines))
            time.sleep(0.02)
        return self

    def _read(self):
        for line in self.process.stdout:
            self.lines.append(line)

    def __exit__(self, *unused):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(20)
            except subprocess.TimeoutExpired:
                self.process.kill()
        self._reader.join(1.0)

    def pids(self, program):
        """Process ids of this stack's children that run this program."""
        found = []
        for stat in glob.glob("/proc/[0-9]*/stat"):
            try:
                fields = pathlib.Path(stat).read_text().rsplit(")", 1)
                parent = int(fields[1].split()[1])
                name = pathlib.Path(os.readlink(stat[:-4] + "exe")).name
            except (OSError, IndexError, ValueError):
                continue
            if parent == self.process.pid and name == program:
                found.append(int(stat.split("/")[2]))
        return found

    def pid(self, program, wait=0.0):
        """wait [s]: for one that was killed and is started again."""
        end = time.monotonic() + wait
        found = self.pids(program)
        while len(found) != 1 and time.monotonic() < end:
            time.sleep(0.05)
            found = self.pids(program)
        if len(found) != 1:
            raise RuntimeError(f"{len(found)} processes run {program}")
        return found[0]


def alive(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in ("Z", "X")
    except OSError:
        return False


def urdf_of(robot):
    """The root element of one of our robots' URDF."""
    return xml.etree.ElementTree.parse(next((ROOT / "config/robots" / robot).glob("*.urdf"))).getroot()


def bus_joints(robot="hrp1s"):
    """Joint elements of the URDF that are on the bus, in the bus's order: that of the URDF."""
    return [joint for joint in urdf_of(robot).iter("joint")
            if joint.get("type") in ("revolute", "continuous", "prismatic") and joint.find("mimic") is None]


def effort_limits(robot="hrp1s"):
    """Of the joints on the bus."""
    return [float(joint.find("limit").get("effort")) for joint in bus_joints(robot)]


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else float("nan")


class Checks:
    """Counts claims; every failed one is a line with the number that was found and the number that was asked."""

    def __init__(self):
        self.failed = 0
        self.made = 0

    def that(self, good, sentence):
        self.made += 1
        if not good:
            self.failed += 1
            print("FAILED:", sentence, flush=True)
        return good

    def tentative(self):
        """Checks of one attempt, not counted nor printed until adopt()."""
        return Attempt()

    def adopt(self, attempt):
        for good, sentence in attempt.claims:
            self.that(good, sentence)

    def at_most(self, value, limit, what):
        return self.that(value <= limit, f"{what}: {value:.6g}, at most {limit:g} asked")

    def at_least(self, value, limit, what):
        return self.that(value >= limit, f"{what}: {value:.6g}, at least {limit:g} asked")

    def exit(self):
        print(f"{self.made - self.failed} of {self.made} checks hold")
        sys.exit(1 if self.failed else 0)


class Attempt(Checks):
    def __init__(self):
        super().__init__()
        self.claims = []

    def that(self, good, sentence):
        self.claims.append((good, sentence))
        self.failed += not good
        return good


def newest_run_folder():
    runs = pathlib.Path(os.environ.get("TWINBUS_RUNS", ROOT / "runs"))
    return max(runs.glob("*"), key=lambda folder: folder.stat().st_mtime)


STACK = ("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_planner")  # the programs of `up`


def require(*programs):
    """Skips the test while a program of the stack is not there."""
    for program in programs:
        if not (BIN / program).exists():
            print(f"skipped: {program} is not built")
            sys.exit(SKIPPED)


def address_of(line):
    found = re.search(r"http://\S+", line)
    return found.group(0) if found else None
