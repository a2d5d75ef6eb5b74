#!/usr/bin/env python3
"""Faults of processes, data and load on a running stack; each has the name of its row in the plan of faults.

P6 viewer and recorder killed again and again; P7 processes that sleep; D4 messages of another build; D5 two simulators and two
controllers; D6 ticks that stand, go back or leap; D8 clocks that are set; T3 too little processor; T5 too little memory; T6 a
disk that is full or slow.  (P8 is restart_test, D7 a unit test of bridge/adaptor/frozen_sensors.h.)  TWINBUS_FULL=1: as often as
the plan says.  Words on the command line choose cases.
"""

import contextlib
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, FULL, Bus, Checks, Stack, alive, cli, twinbus
from loop_figures import Figures, Loop, settle
from stalls import Stalls

COMMAND_TIMEOUT, STALE = 0.040, 0.025  # [s] config/robots/hrp1s/robot.yaml
BLOCK = 20.0 if FULL else 4.0  # of undisturbed and disturbed time in turn [s]
MOST_CHANGE = 0.05  # of p99.9
# Two short blocks have four ticks above p99.9, which differ from run to run by this much with nothing disturbed [us].
RESOLVED = 0.0 if FULL else 100.0
MORE_ROUNDS = 4  # at most, before a short run has failed
OTHER_BUS = "udpm://239.255.76.67:17698?ttl=0"


def sway(bus):
    """The robot moves, whatever was before."""
    cli("clear")
    cli("sway")
    time.sleep(0.7)
    bus.forget()
    time.sleep(0.3)


class Turns:
    """Blocks of a disturbance and blocks without it, by turns, on one stack; compares p99.9 of the loop."""

    def __init__(self):
        self.loop, self.stalls = Loop(), Stalls()
        self.off, self.on = [], {}
        self.first = None  # blocks of the first rounds
        self.calm()

    def calm(self):
        begin = time.monotonic_ns()
        time.sleep(BLOCK)
        self.off.append((begin, time.monotonic_ns()))

    def disturbed(self, name, work):
        begin = time.monotonic_ns()
        work(time.monotonic() + BLOCK)
        self.on.setdefault(name, []).append((begin, time.monotonic_ns()))
        self.calm()

    def changes(self, machine, say=False):
        """name -> (change of p99.9, allowed) [us]: of all turns so far, against how blocks of the first rounds differ.

        machine: name -> name of the turns that do the same to the machine, but nothing to the bus."""
        settle()
        seen = list(self.stalls.seen)
        calm = Figures(self.loop.ticks, self.off, seen)
        each = [Figures(self.loop.ticks, [span], seen).p999 for span in self.off[:self.first]]
        found = {name: Figures(self.loop.ticks, spans, seen) for name, spans in self.on.items()}
        if say:
            print(calm.line("undisturbed"), "blocks:", " ".join(f"{x:.0f}" for x in each), flush=True)
            for name, figures in found.items():
                print(figures.line(name), flush=True)
        changes = {}
        for name, figures in found.items():
            if name in machine.values():
                continue
            # A change that is smaller than what undisturbed blocks differ by among themselves is none, nor is one that
            # any program of that size causes which starts and ends.
            base = max(calm.p999, found[machine[name]].p999) if machine.get(name) in found else calm.p999
            alike = each + [Figures(self.loop.ticks, [span], seen).p999 for span in self.on.get(machine.get(name), [])[:self.first]]
            changes[name] = figures.p999 - base, max(MOST_CHANGE * base, max(alike) - base, RESOLVED)
        return changes

    def measure(self, checks, machine, rounds, one_round):
        """Takes rounds of turns, and judges.  Two ticks are above p99.9 in one short block: where these differ, more rounds
        tell whether it was chance, and all of them count."""
        for _ in range(rounds):
            one_round()
        self.first = len(self.off)
        for _ in range(0 if FULL else MORE_ROUNDS):
            if all(change <= allowed for change, allowed in self.changes(machine).values()):
                break
            one_round()
        for name, (change, allowed) in self.changes(machine, say=True).items():
            checks.at_most(change, allowed, f"{name}: change of p99.9 of the loop [us]")
        self.loop.close()
        self.stalls.close()


def kill_watchers(folder, checks, url=None):
    """Viewer and recorder started and killed until the time is over; every log is readable to its last write.

    On a bus of their own, which nobody sends to, they are the machine's part of it: programs that start and are killed."""
    count = 0
    bus = ["--url", url] if url else []

    def work(until):
        nonlocal count
        while time.monotonic() < until:
            log = folder / "killed.log"
            recorder = subprocess.Popen([BIN / "twinbus_recorder", log, "--force", *bus], stdout=subprocess.PIPE, text=True)
            viewer = subprocess.Popen([BIN / "twinbus_viewer", "--port", "0", *bus], stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL) if (BIN / "twinbus_viewer").exists() else None
            recorder.stdout.readline()
            time.sleep(0.5 + 0.3 * random.random())
            recorder.kill()
            if viewer:
                viewer.kill()
                viewer.wait()
            recorder.wait()
            count += 1
            if url:
                cli("log", "info", folder / "same.log", "--check")
                continue
            if not (folder / "same.log").exists():
                (folder / "same.log").write_bytes(log.read_bytes())
            status, said, problem = cli("log", "info", log, "--check")
            events = re.search(r"(\d+) events", said)
            checks.that(events is not None and int(events.group(1)) > 300, f"P6: a log that was killed: {problem}{said[:200]}")
            # The last event may be cut; whatever is before it is as it was written.
            checks.that(" 0 changed, 0 gone" in said and "damage" not in said.replace("no damage", "").replace("1 place of damage", ""),
                        f"P6: it is whole up to its last write: {said[-300:]}")
    return work, lambda: count


def good_disk(folder):
    """What the same recorder costs where nothing is wrong."""
    def work(until):
        recorder = subprocess.Popen([BIN / "twinbus_recorder", folder / "good.log", "--force"], stdout=subprocess.PIPE, text=True)
        recorder.stdout.readline()
        time.sleep(max(0.0, until - time.monotonic()))
        recorder.terminate()
        recorder.wait()
        cli("log", "info", folder / "good.log", "--check")
    return work


def slow_disk(folder, checks, bus):
    def work(until):
        since = time.monotonic_ns()
        log = folder / "slow.log"
        recorder = subprocess.Popen([BIN / "twinbus_recorder", log, "--force"], stdout=subprocess.PIPE, text=True,
                                    env=dict(os.environ, LD_PRELOAD=str(BIN / "slow_disk.so")))
        recorder.stdout.readline()
        time.sleep(max(0.0, until - time.monotonic()))
        beats = [b for _, b in bus.messages("HEARTBEAT", since) if b.pid == recorder.pid]
        recorder.terminate()
        said = recorder.stdout.read()
        recorder.wait()
        checks.that(" 0 dropped" in said, f"T6: a disk with 100 ms per write loses nothing: {said}")
        checks.at_least(len(beats), 5.0 * BLOCK, "T6: slow disk: heartbeats of the recorder")
    return work


def full_disk(folder, checks, bus):
    """A disk of 8 MB that is full, and has room again."""
    def work(until):
        disk = folder / "disk"
        disk.mkdir(exist_ok=True)
        since = time.monotonic_ns()
        inside = f"mount -t tmpfs -o size=8m none {disk} && head -c 5000000 /dev/zero > {disk}/filler && exec {BIN}/twinbus_recorder {disk}/run.log"
        recorder = subprocess.Popen(["unshare", "--mount", "sh", "-c", inside], stdout=subprocess.PIPE,
                                    stderr=subprocess.DEVNULL, text=True)
        if "ready" not in recorder.stdout.readline():
            print("T6: no file system of one's own can be mounted here: the full disk is left out")
            return
        time.sleep(0.6 * (until - time.monotonic()))
        lost = max((b.messages_lost for _, b in bus.messages("HEARTBEAT", since) if b.pid == recorder.pid), default=0)
        checks.at_least(lost, 500, "T6: full disk: messages that the recorder drops are counted")
        told = [harness.text_of(e) for _, e in bus.messages("EVENT", since)]
        checks.that(sum("the disk is full" in text for text in told) == 1, f"T6: and it says so, once: {told}")
        inside = pathlib.Path(f"/proc/{recorder.pid}/root{disk}")
        (inside / "filler").unlink()
        time.sleep(max(1.0, until - time.monotonic()))
        told = [harness.text_of(e) for _, e in bus.messages("EVENT", since)]
        checks.that(any("recording goes on" in text for text in told), f"T6: with room again it goes on: {told}")
        copy = folder / "full.log"
        copy.write_bytes((inside / "run.log").read_bytes())
        recorder.terminate()
        recorder.wait()
        status, said, problem = cli("log", "info", copy, "--check")
        checks.that("0 changed" in said and ("no damage" in said or "1 place of damage" in said),
                    f"T6: what is in the log of a full disk is whole: {problem}{said[-300:]}")
    return work


def p6(checks):
    """Viewer and recorder are killed: the loop does not notice."""
    with tempfile.TemporaryDirectory() as name, Stack("sway", "--no-viewer", "--no-record"):
        folder = pathlib.Path(name)
        bus = Bus()
        turns = Turns()
        work, count = kill_watchers(folder, checks)
        other, _ = kill_watchers(folder, checks, OTHER_BUS)
        killed, elsewhere = "P6 viewer and recorder killed", "the same on another bus"

        def one_round():
            before = count()
            while count() - before < (100 if FULL else 3):
                turns.disturbed(killed, work)
                turns.disturbed(elsewhere, other)
            bus.forget()

        turns.measure(checks, {killed: elsewhere}, 1, one_round)
        print(f"P6: {count()} times killed and started", flush=True)
        bus.close()


def t6(checks):
    """The disk is slow, the disk is full: the loop notices no more than of a recorder whose disk is well."""
    with tempfile.TemporaryDirectory() as name, Stack("sway", "--no-viewer", "--no-record"):
        folder = pathlib.Path(name)
        bus = Bus()
        turns = Turns()
        good, slow, full = "T6 a disk that is well", "T6 100 ms per write", "T6 disk full"

        def one_round():
            turns.disturbed(slow, slow_disk(folder, checks, bus))
            turns.disturbed(good, good_disk(folder))
            turns.disturbed(full, full_disk(folder, checks, bus))
            bus.forget()

        turns.measure(checks, {slow: good, full: good}, 4 if FULL else 1, one_round)
        bus.close()


def velocity_limit():
    return 12.0  # of any joint of hrp1s, generously [rad/s]


def p7(checks):
    """A process that was stopped for a while: no backlog is replayed, a stop stays."""
    programs = ("twinbus_controller", "twinbus_simulator", "twinbus_guard", "twinbus_planner")
    for program in programs if FULL else programs[:2]:
        with Stack("sway", "--no-viewer", "--no-record") as stack:
            bus = Bus()
            time.sleep(1.0)
            for ms in (10, 50, 200, 1000) if FULL else (10, 200):
                sway(bus)
                before = bus.newest("SOURCE_STATUS")[1]
                pid = stack.pid(program)
                os.kill(pid, signal.SIGSTOP)
                time.sleep(1e-3 * ms)
                os.kill(pid, signal.SIGCONT)
                woken = time.monotonic_ns()
                time.sleep(0.8)
                what = f"P7 {program} stopped for {ms} ms"
                commands = [(at, c.tick) for at, c in bus.messages("COMMAND", woken - 2_000_000)]
                ticks = [tick for _, tick in commands]
                checks.that(len(ticks) == len(set(ticks)) and ticks == sorted(ticks), f"{what}: at most one command a tick, in order")
                states = {s.tick: at for at, s in bus.messages("STATE")}
                stale = [tick for at, tick in commands if tick in states and at - states[tick] > 1e9 * COMMAND_TIMEOUT]
                after = bus.newest("SOURCE_STATUS")[1]
                refused = after.commands_rejected - before.commands_rejected
                checks.at_most(len(stale) - refused, 0, f"{what}: stale commands that were not refused")
                order = [s.tick for _, s in bus.messages("STATE")]
                checks.that(order == sorted(set(order)), f"{what}: ticks of STATE go up")
                q = [s.q for _, s in bus.messages("STATE", woken)]
                step = max((abs(a - b) for x, y in zip(q, q[1:]) for a, b in zip(x, y)), default=0.0)
                checks.at_most(step, 1.05 * velocity_limit() * 0.002, f"{what}: largest step of a joint between two states")
                stopped = bus.newest("STATE")[1].stop_kind >= 2
                if program == "twinbus_controller":
                    checks.that(not stopped, f"{what}: a stop plan leads the robot meanwhile, and nothing is stopped")
                checks.that(not any(t.fell for _, t in bus.messages("TRUTH")), f"{what}: nobody falls")
            bus.close()


def rejected_by(bus, stack, since):
    """(program kind, channel row) -> refusals counted since then, by what heartbeats say of channels."""
    first, last = {}, {}
    for at, beat in bus.messages("HEARTBEAT"):
        for row in range(beat.channels):
            key = (beat.pid, beat.channel[row])
            if at <= since:
                first[key] = beat.channel_rejected[row]
            else:
                last[key] = beat.channel_rejected[row]
    return {key: count - first.get(key, 0) for key, count in last.items()}


def d4(checks):
    """Messages of a build that has one field more: ignored, and the heartbeat names the channel."""
    with Stack("sway", "--no-viewer", "--no-record") as stack:
        bus = Bus()
        time.sleep(6.0)  # `up` raises no alarm of channels in a process's first five seconds
        before = bus.newest("STATE")[1]
        bus.forget()
        time.sleep(0.3)
        since = time.monotonic_ns()
        foreign = {}
        for channel in ("STATE", "COMMAND", "GUARD", "STOP", "MODE_REQUEST", "SOURCE_REQUEST"):
            body = bytearray(harness.type_of(channel)().encode() + bytes(8))
            body[7] ^= 0x55
            foreign[channel] = bytes(body)
        for _ in range(200):
            for channel, body in foreign.items():
                bus.send_raw(channel, body)
            time.sleep(0.004)
        sent = time.monotonic_ns()
        time.sleep(max(0.0, 1.0 - 1e-9 * (sent - since)))
        # By the rows of the table in lcmtypes/bus/wire.cpp: STATE is the first, COMMAND the fifth.
        counts = rejected_by(bus, stack, since)
        for program, rows in (("twinbus_controller", {1: "STATE", 9: "MODE_REQUEST", 10: "STOP"}), ("twinbus_guard", {1: "STATE", 5: "COMMAND"}),
                              ("twinbus_simulator", {5: "COMMAND", 7: "SOURCE_REQUEST", 10: "STOP"})):
            for row, channel in rows.items():
                found = counts.get((stack.pid(program), row), 0)
                checks.at_least(found, 150, f"D4: {program} names {channel} as refused within a second")
        time.sleep(1.5)
        checks.that(any("were refused" in line for line in stack.lines), "D4: up says it in plain words")
        now = bus.newest("STATE")[1]
        checks.that((now.run_id, now.term, now.role, now.stop_kind) == (before.run_id, before.term, 2, 0), "D4: nothing else happens")
        bus.close()


def d5(checks):
    """A second controller and a second simulator on the same bus: the first ones stay."""
    with Stack("sway", "--no-viewer", "--no-record") as stack:
        bus = Bus()
        time.sleep(1.0)
        first = bus.newest("SOURCE_STATUS")[1]
        second = subprocess.Popen([BIN / "twinbus_controller", "--mode", "hold"], stdout=subprocess.DEVNULL)
        time.sleep(2.0)
        bus.forget()
        time.sleep(1.0)
        status = bus.newest("SOURCE_STATUS")[1]
        senders = {c.controller_id for _, c in bus.messages("COMMAND")}
        checks.that(len(senders) == 2, f"D5: two controllers speak: {senders}")
        checks.that(status.controller_id == first.controller_id, "D5: the source obeys the first")
        checks.at_least(status.commands_rejected - first.commands_rejected, 500, "D5: commands of the second are counted")
        second.kill()
        second.wait()
        another = subprocess.Popen([BIN / "twinbus_simulator", "squat"], stdout=subprocess.DEVNULL)
        found = bus.wait_for("STATE_SIM", lambda s: s.role == 1, 5.0)[1]
        checks.that(found is not None, "D5: a second simulator is parked")
        live = bus.newest("STATE")[1]
        bus.forget()
        before = rejected_by(bus, stack, time.monotonic_ns())
        until, seen = time.monotonic() + 5.0, 0
        while found is not None and seen < 300 and time.monotonic() < until:  # as if it held STATE too
            _, state = bus.newest("STATE_SIM")
            if state is not None:
                state.role, state.term, state.tick = 2, live.term, live.tick + 1000 + seen
                bus.send("STATE", state)
                seen += 1
            time.sleep(0.002)
        time.sleep(0.3)
        mixed = [c for _, c in bus.messages("COMMAND") if c.run_id == found.run_id]
        checks.that(not mixed and seen > 200, f"D5: {len(mixed)} commands for the second of {seen} of its states")
        count = rejected_by(bus, stack, 0).get((stack.pid("twinbus_controller"), 1))
        heard = max((b.messages_rejected for _, b in bus.messages("HEARTBEAT") if b.pid == stack.pid("twinbus_controller")), default=0)
        checks.at_least(heard, seen, f"D5: and they are counted ({count} {before})")
        another.kill()
        another.wait()
        bus.close()


def d6(checks):
    """Ticks that go back or leap by a million are refused; ticks that stand still are stale."""
    with Stack("sway", "--no-viewer", "--no-record") as stack:
        bus = Bus()
        time.sleep(1.0)
        for step, what in ((-100, "back by 100"), (1_000_000, "leap by a million")):
            bus.forget()
            forged = set()
            for _ in range(50):
                time.sleep(0.004)
                _, state = bus.newest("STATE", lambda s: s.tick not in forged)
                if state is None:
                    continue
                state.tick += step
                state.time_ns += step * state.period_ns
                forged.add(state.tick)
                bus.send("STATE", state)
            time.sleep(0.1)
            since = time.monotonic_ns()
            time.sleep(0.3)
            answered = [c.tick for _, c in bus.messages("COMMAND") if step > 0 and c.tick in forged]
            order = [c.tick for _, c in bus.messages("COMMAND")]
            checks.that(not answered and order == sorted(set(order)), f"D6 ticks {what}: {len(answered)} were answered")
            checks.at_least(len(list(bus.messages("COMMAND", since))), 120, f"D6 ticks {what}: commands go on, in 0.3 s")
            checks.that(bus.newest("STATE")[1].stop_kind == 0, f"D6 ticks {what}: nobody stops")
        pid = stack.pid("twinbus_simulator")
        os.kill(pid, signal.SIGSTOP)
        time.sleep(0.01)
        at, state = bus.newest("STATE")
        begin = time.monotonic()
        while time.monotonic() < begin + 0.3:
            bus.send("STATE", state)
            time.sleep(0.002)
        # A repeated tick is answered by the same command, as lock-step wants it; the gate takes no tick twice.
        late = [c for c_at, c in bus.messages("COMMAND") if c_at > at + 1e9 * STALE]
        fresh = [c for c in late if c.tick > state.tick or list(c.q) != list(late[0].q)]
        checks.that(not fresh, f"D6 a tick that stands still: {len(fresh)} of {len(late)} commands later than 25 ms say anything new")
        os.kill(pid, signal.SIGCONT)
        time.sleep(0.1)
        bus.close()


def hash_of(words, environment=None):
    done = subprocess.run([BIN / "twinbus", "up", *words], capture_output=True, text=True, timeout=120,
                          env=dict(os.environ, **(environment or {})), stdin=subprocess.DEVNULL)
    found = re.search(r"state_hash (\S+)", done.stdout)
    return found.group(1) if found else done.stdout[-400:] + done.stderr[-200:]


def d8(checks):
    """Clocks that are set, or that differ by an hour between processes: control computes the same."""
    lockstep = ["sway", "--lockstep", "--for", "2", "--no-viewer", "--no-record"]
    plain = hash_of(lockstep)
    checks.that(len(plain) < 40, f"D8: a run in lock-step: {plain}")
    jumping = hash_of(lockstep, {"LD_PRELOAD": str(BIN / "wall_jump.so")})
    checks.that(jumping == plain, f"D8: the same states with a wall clock that jumps by an hour: {jumping} {plain}")
    away = ["unshare", "--fork", "--time", "--monotonic", "3600"]
    if subprocess.run([*away, "true"], capture_output=True).returncode == 0:
        controller = subprocess.Popen([*away, BIN / "twinbus_controller"], stdout=subprocess.DEVNULL)
        time.sleep(1.0)
        hour = hash_of([*lockstep, "--stack", "client"])
        subprocess.run(["pkill", "-P", str(controller.pid)], check=False)
        controller.wait(10)
        checks.that(hour == plain, f"D8: the same states with a controller whose steady clock is an hour ahead: {hour} {plain}")
    else:
        print("D8: this system has no time namespaces: left out")
    with tempfile.TemporaryDirectory() as name, Stack("stand", "--no-viewer", "--no-record"):
        log = pathlib.Path(name) / "clock.log"
        recorder = subprocess.Popen([BIN / "twinbus_recorder", log], stdout=subprocess.DEVNULL,
                                    env=dict(os.environ, LD_PRELOAD=str(BIN / "wall_jump.so")))
        time.sleep(3.0)
        recorder.terminate()
        recorder.wait()
        table = cli("log", "csv", log, "STATE", "--fields", "tick")[1].splitlines()[1:]
        times = [int(row.split(",")[0]) for row in table]
        checks.that(len(times) > 1000 and times == sorted(times), f"D8: times in a log do not go back ({len(times)} states)")


def own_group(kind):
    """The control group that this test is in."""
    for line in pathlib.Path("/proc/self/cgroup").read_text().splitlines():
        _, kinds, path = line.split(":", 2)
        if kind in kinds.split(","):
            return pathlib.Path("/sys/fs/cgroup") / kind / path.lstrip("/")
    return pathlib.Path("/sys/fs/cgroup") / kind


@contextlib.contextmanager
def cgroup(kind):
    """A control group of one's own; None where that is not allowed."""
    folder = pathlib.Path("/sys/fs/cgroup") / kind / f"twinbus_test_{os.getpid()}"
    try:
        folder.mkdir()
    except OSError as error:
        print(f"no control group for {kind} here ({error}): left out")
        yield None
        return
    try:
        yield folder
    finally:
        for _ in range(50):
            try:
                folder.rmdir()
                break
            except OSError:
                time.sleep(0.1)


def t3(checks):
    """Half and a fifth of a processor for the controller, without FIFO: it slows down, the source follows stop plans, then stops."""
    with cgroup("cpu") as folder:
        if folder is None:
            return
        with Stack("sway", "--no-viewer", "--no-record", "--no-fifo") as stack:
            bus = Bus()
            time.sleep(1.0)
            for share in (0.5, 0.2, 0.05):
                sway(bus)
                pid = stack.pid("twinbus_controller")
                (folder / "cpu.cfs_period_us").write_text("100000")
                (folder / "cpu.cfs_quota_us").write_text(str(int(100000 * share)))
                # The thread of the loop; others, that only watch, may have a priority that such a group refuses.
                (folder / "tasks").write_text(str(pid))
                time.sleep(3.0)
                (own_group("cpu") / "tasks").write_text(str(pid))
                ticks = [c.tick for _, c in bus.messages("COMMAND")]
                what = f"T3 {share:.0%} of a processor"
                answers = {}  # a world that waits asks again for the same tick, and gets the same again
                for _, c in bus.messages("COMMAND"):
                    answers.setdefault(c.tick, set()).add(tuple(c.q))
                checks.that(ticks == sorted(ticks) and all(len(q) == 1 for q in answers.values()), f"{what}: one command a tick, in order")
                # In the robot's time: without FIFO the world waits for a late command, 0.2 s at most, and meanwhile nothing is missing.
                silence = max((0.002 * (b - a) for a, b in zip(ticks, ticks[1:])), default=9.9)
                stopped = bus.newest("STATE")[1].stop_kind >= 2
                led = any(s.plan_number for _, s in bus.messages("STATE"))
                checks.that(stopped or led or silence < 0.06, f"{what}: silent for {silence:.3f} s, so led or stopped")
                checks.that(not any(t.fell for _, t in bus.messages("TRUTH")), f"{what}: nobody falls")
                print(f"{what}: {len(ticks)} commands in 3.7 s, {'stopped' if stopped else 'goes on'}", flush=True)
            bus.close()


HOG = """
import os, sys, time
open(sys.argv[1] + '/cgroup.procs', 'w').write(str(os.getpid()))
kept = []
while True:
    kept.append(bytearray(os.urandom(1 << 20) * 4))
    time.sleep(0.01)
"""


def t5(checks):
    """Memory runs out: viewer and recorder end first, bridge and controller live."""
    with tempfile.TemporaryDirectory() as name:
        file = pathlib.Path(name) / "no_restart.yaml"
        file.write_text((harness.ROOT / "config/stacks/both.yaml").read_text().replace("    restart: true\n", ""))
        for number in range(10 if FULL else 1):
            with cgroup("memory") as folder:
                if folder is None:
                    return
                with open(folder / "memory.limit_in_bytes", "w") as limit:
                    limit.write(str(600 << 20))
                os.environ["TWINBUS_RECORD"] = "1"
                before = own_group("memory")
                (folder / "cgroup.procs").write_text(str(os.getpid()))  # children inherit it
                stack = Stack("stand", "--stack", file)
                try:
                    stack.__enter__()
                finally:
                    (before / "cgroup.procs").write_text(str(os.getpid()))
                try:
                    watchers = {p: stack.pid(p) for p in ("twinbus_viewer", "twinbus_recorder")}
                    others = {p: stack.pid(p) for p in ("twinbus_bridge", "twinbus_controller", "twinbus_simulator", "twinbus_guard")}
                    hog = subprocess.Popen([sys.executable, "-c", HOG, str(folder)])
                    end = time.monotonic() + 60.0
                    while time.monotonic() < end and hog.poll() is None and any(alive(pid) for pid in watchers.values()):
                        time.sleep(0.02)
                    # A victim whose memory is already taken may still be ending, in the middle of a write to the disk.
                    end = time.monotonic() + 5.0
                    while time.monotonic() < end and any(alive(pid) for pid in watchers.values()):
                        time.sleep(0.02)
                    hog.kill()
                    hog.wait()
                    checks.that(not any(alive(pid) for pid in watchers.values()), f"T5 {number}: viewer and recorder have ended")
                    dead = [p for p, pid in others.items() if not alive(pid)]
                    checks.that(not dead, f"T5 {number}: those that move the robot live; dead: {dead}")
                finally:
                    stack.__exit__()
        print(f"T5: {number + 1} times", flush=True)


CASES = {"P6": p6, "P7": p7, "D4": d4, "D5": d5, "D6": d6, "D8": d8, "T3": t3, "T5": t5, "T6": t6}


def main():
    harness.require(*harness.STACK, "twinbus_recorder")
    seed = int(os.environ.get("RELIABILITY_SEED", random.randrange(1 << 30)))
    random.seed(seed)
    print(f"RELIABILITY_SEED={seed}")
    checks = Checks()
    unknown = [word for word in sys.argv[1:] if word not in CASES]
    if unknown:
        sys.exit(f"unknown case {' '.join(unknown)}; there are {' '.join(CASES)}")
    for name, case in CASES.items():
        if sys.argv[1:] and name not in sys.argv[1:]:
            continue
        begin, made, failed = time.monotonic(), checks.made, checks.failed
        case(checks)
        print(f"{name}: {checks.made - made - checks.failed + failed} of {checks.made - made} checks hold, "
              f"{time.monotonic() - begin:.0f} s", flush=True)
    checks.exit()


if __name__ == "__main__":
    main()
