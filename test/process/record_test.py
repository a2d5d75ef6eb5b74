#!/usr/bin/env python3
"""A run is recorded, read, computed again bit for bit, and replayed.

The log of a stack that stands, sways, stops and goes on is whole and without a gap; `log rerun` gives every command, guard
report and estimate again; one flipped bit of an input is found and named; a recorder that is killed leaves a log that
stock tools read; the log takes the place of the robot, pauses, seeks and loops.
"""

import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, Bus, Checks, Stack, cli

os.environ["TWINBUS_RECORD"] = "1"


def events_of(data, channel):
    """(offset of the data, data) of each event of one channel of a healthy log."""
    at = 0
    while at + 28 <= len(data):
        mark, _, _, name, size = struct.unpack(">IqqII", data[at:at + 28])
        assert mark == 0xEDA1DA01
        if data[at + 28:at + 28 + name] == channel.encode():
            yield at + 28 + name, data[at + 28 + name:at + 28 + name + size]
        at += 28 + name + size


def record_a_run(checks):
    with Stack("stand", "--no-viewer"):
        plug_in = subprocess.Popen([sys.executable, harness.ROOT / "examples/09_add_channel.py", "--for", "2"],
                                   stdout=subprocess.DEVNULL)
        time.sleep(0.5)
        checks.that(cli("sway")[0] == 0, "sway is asked")
        time.sleep(1.0)
        checks.that(cli("mode", "balance")[0] == 0, "balance is asked")
        checks.that(cli("reach", "left", "0.35", "0.25", "0.75")[0] == 0, "reach is done")
        checks.that(cli("stop", "hold")[0] == 0, "the robot stops")
        checks.that(cli("clear")[0] == 0, "the stop is cleared")
        time.sleep(0.5)
        checks.that(plug_in.wait(10) == 0, "the logger plug-in ends well")
    return harness.newest_run_folder() / "run.log"


def whole(checks, log):
    status, said, problems = cli("log", "info", log, "--check")
    checks.that(status == 0, f"log info --check: {problems}{said[-600:]}")
    for channel in ("STATE", "COMMAND", "GUARD", "CONTROLLER_STATUS", "TRUTH", "JOURNAL"):
        row = re.search(rf"^{channel} .* (\d+)$", said, re.MULTILINE)
        checks.that(row is not None, f"{channel} is in the log")
        # The guard's process may leave a tick out on a busy machine; its journal and the states are all there.
        if row is not None and channel in ("STATE", "TRUTH", "JOURNAL"):
            checks.at_most(int(row.group(1)), 0, f"{channel}: messages that the log misses")
    checks.that(re.search(r"^POWER ", said, re.MULTILINE) is not None, "what the plug-in computes is in the log")
    begin = time.monotonic()
    status, quick, _ = cli("log", "info", log)
    checks.that(status == 0 and "STATE" in quick, "log info reads the index")
    checks.at_most(time.monotonic() - begin, 1.0, "seconds that log info takes")
    status, said, _ = cli("log", "events", log)
    for part in ("holds STATE", "stop: hold", "mode asked: balance"):
        checks.that(status == 0 and part in said, f"log events tells '{part}':\n{said[:1500]}")


def computed_again(checks, log, folder):
    status, said, problems = cli("log", "rerun", log, timeout=120)
    checks.that(status == 0, f"log rerun: {problems}{said[-2000:]}")
    print(said.strip())
    data = bytearray(log.read_bytes())
    states = list(events_of(bytes(data), "STATE"))
    offset, _ = states[len(states) // 2]
    # q[3]: behind the type hash, 8 int64, 4 int32, 1 int16, 3 int8 and 4 int8 lie 48 doubles.
    at = offset + 8 + 9 * 8 + 5 * 4 + 2 + 3 + 4 + 3 * 8 + 5
    data[at] ^= 0x10
    damaged = folder / "flipped.log"
    damaged.write_bytes(data)
    status, said, _ = cli("log", "rerun", damaged, timeout=120)
    checks.that(status == 1 and "STATE" in said and "flipped bit" in said and "q[3]" in said,
                f"the flipped bit is found and named: {said[-1500:]}")
    status, said, _ = cli("log", "info", damaged, "--check")
    checks.that(status == 1 and "1 changed" in said, f"the checksum tells it too: {said[-300:]}")


def tools(checks, log, folder):
    part, only, renamed, table = (folder / name for name in ("part.log", "only.log", "renamed.log", "state.csv"))
    checks.that(cli("log", "cut", log, part, "--from", "1", "--to", "2.5")[0] == 0, "log cut")
    checks.that(cli("log", "filter", part, only, "--channels", "STATE|COMMAND")[0] == 0, "log filter")
    checks.that(cli("log", "rename", only, renamed, "STATE=OTHER")[0] == 0, "log rename")
    said = cli("log", "info", renamed, "--check")[1]
    checks.that("OTHER" in said and "COMMAND" in said and "GUARD" not in said, f"what was filtered and renamed: {said}")
    checks.that(cli("log", "csv", part, "STATE", table, "--fields", "tick,q,attitude")[0] == 0, "log csv")
    rows = table.read_text().splitlines()
    checks.that(rows[0].startswith("utime,tick,q.RLEG_HIP_R,") and "q.CHEST" in rows[0] and "q[29]" not in rows[0], rows[0][:200])
    numbered = cli("log", "csv", part, "STATE", "--fields", "q.LLEG_KNEE", "--numbers")[1].splitlines()
    checks.that(numbered[0] == "utime,q[16]", f"and by numbers: {numbered[0]}")
    checks.at_least(len(rows), 700, "rows of 1.5 s")
    status, said, problems = cli("log", "compare", part, part, "--plot", folder / "same.svg", "--most-mrad", "1e-9")
    checks.that(status == 0 and (folder / "same.svg").stat().st_size > 1000, f"log compare: {problems}{said[-300:]}")
    status, _, said = cli("log", "cut", log, log)
    checks.that(status == 2 and "itself" in said, "a log is not copied onto itself")
    status, _, said = cli("log", "csv", part, "STATE", part)
    checks.that(status == 2 and "itself" in said, "nor is a table written over it")
    before = renamed.read_bytes()
    for words in (("cut", log, renamed), ("filter", log, renamed), ("rename", log, renamed, "STATE=OTHER"), ("mcap", log, renamed)):
        status, _, said = cli("log", *words)
        checks.that(status == 1 and "--force" in said and renamed.read_bytes() == before, f"log {words[0]} writes over no file unasked: {said}")
    checks.that(cli("log", "cut", part, renamed, "--to", "0.5", "--force")[0] == 0 and renamed.read_bytes() != before, "with --force it does")
    status, _, said = cli("log", "filter", part, folder / "none.log", "--channels", "NOBODY")
    checks.that(status == 1 and not (folder / "none.log").exists(), f"a copy of nothing leaves no file: {said}")


def killed(checks, folder):
    log = folder / "killed.log"
    with Stack("stand", "--no-viewer", "--no-record"):
        recorder = subprocess.Popen([BIN / "twinbus_recorder", log], stdout=subprocess.DEVNULL)
        time.sleep(2.5)
        recorder.send_signal(signal.SIGKILL)
        died = time.time()
        recorder.wait()
    states = list(events_of(log.read_bytes()[:last_whole(log)], "STATE"))
    checks.at_least(len(states), 600, "states in the log of a recorder that was killed after 2.5 s")
    newest = max(struct.unpack(">q", log.read_bytes()[at - 5 - 16:at - 5 - 8])[0] for at, _ in states[-1:])
    checks.at_most(died - 1e-6 * newest, 1.0, "seconds lost by kill -9")
    player = shutil.which("lcm-logplayer")
    if player:
        done = subprocess.run([player, "-s", "50", "-l", "udpm://239.255.76.67:17699?ttl=0", log], capture_output=True,
                              timeout=60)
        checks.that(done.returncode == 0, f"lcm-logplayer plays it: {done.stderr[-200:]}")


def a_log_that_is_there(checks, folder):
    """Is not written over unasked; a recorder of a stack that is started again goes on in a new part."""
    log = folder / "killed.log"
    before = log.read_bytes()
    for words in ((log,), ("--output", log)):
        status, said, problem = cli("record", *words)
        checks.that(status == 1 and "there already" in problem and "--force" in problem and problem.count("\n") == 1 and not said,
                    f"record {words}: {said}{problem}")
    status, said, problem = cli("run", "stand", "--for", "0.1", "--log", log)
    checks.that(status == 1 and "there already" in problem and "--force" in problem and problem.count("\n") == 1 and not said,
                f"run --log: {said}{problem}")
    checks.that(log.read_bytes() == before, "and it is as it was")
    short = folder / "short.log"
    for name in ("short.log", "short-0002.log"):
        (folder / name).write_bytes(before)
    status, said, problem = cli("run", "stand", "--for", "0.1", "--log", short, "--force")
    checks.that("there already" not in problem and b"STATE" in short.read_bytes() and len(short.read_bytes()) < len(before)
                and not (folder / "short-0002.log").exists(), f"run --log --force writes over it and removes its parts: {problem}")
    with Stack("stand", "--no-viewer"):
        time.sleep(1.5)
        checks.that(cli("restart", "recorder")[0] == 0, "the recorder of a stack is started anew")
        time.sleep(2.0)
        run = harness.newest_run_folder() / "run.log"
    status, said, problem = cli("log", "info", run, "--check")
    checks.that(status == 0 and (run.parent / "run-0002.log").exists() and "2 parts" in said, f"its log has two parts: {said[:400]}{problem}")
    first = next(events_of(run.read_bytes(), "STATE"), None)
    checks.that(first is not None, "the first of which is what was recorded before")
    recorder = subprocess.Popen([BIN / "twinbus", "record", log, "--force"], stdout=subprocess.PIPE, text=True)
    checks.that("ready" in recorder.stdout.readline(), "--force writes over it")
    recorder.send_signal(signal.SIGINT)
    recorder.wait(10)
    checks.that(len(log.read_bytes()) < len(before), "and it is new")


def in_parts(checks, folder):
    """Only some channels, in files of a megabyte, not more of them than the quota allows: the oldest go."""
    parts = folder / "parts"
    parts.mkdir()
    with Stack("stand", "--no-viewer", "--no-record"):
        done = subprocess.Popen([BIN / "twinbus_recorder", parts / "run.log", "--channels", "STATE|TRUTH", "--split", "1MB",
                                 "--quota", "0.0035"], stdout=subprocess.PIPE, text=True)
        time.sleep(7.0)
        done.terminate()
        said = done.communicate(timeout=10)[0]
    files = sorted(parts.iterdir(), key=lambda file: file.stat().st_mtime)
    # The oldest that is left has the name of the whole, and the whole is one log.
    checks.that(files[0].name == "run.log" and files[1].name > "run-0002.log", f"names: {[file.name for file in files]}")
    status, table, problem = cli("log", "info", parts / "run.log", "--check")
    checks.that(status == 0 and f"{len(files)} parts, " in table, f"log info of all parts: {problem}{table[:300]}")
    counted = re.search(r"^STATE +robot_state_t +(\d+) .* (\d+)$", table, re.MULTILINE)
    quick = re.search(r"^STATE +robot_state_t +(\d+) ", cli("log", "info", parts / "run.log")[1], re.MULTILINE)
    checks.that(counted and quick and counted[1] == quick[1] and counted[2] == "0", f"counted and by index: {counted and counted[0]} {quick and quick[0]}")
    ticks = [int(row.split(",")[1]) for row in cli("log", "csv", parts / "run.log", "STATE", "--fields", "tick")[1].splitlines()[1:]]
    checks.that(ticks == list(range(ticks[0], ticks[0] + len(ticks))), "a table of all parts has every tick")
    # Alone they are parts.
    whole = parts / "run.log"
    files[0] = whole.rename(parts / "alone.log")
    checks.that(2 <= len(files) <= 4, f"{len(files)} parts are left: {said[-300:]}")
    checks.at_most(sum(file.stat().st_size for file in files), 4.8e6, "bytes of all parts")
    spans = []
    for file in files:
        status, table, problem = cli("log", "info", file, "--check")
        checks.that(status == 0 and "COMMAND " not in table and "STATE " in table, f"{file.name}: {problem}{table[-300:]}")
        ticks = [int(row.split(",")[1]) for row in cli("log", "csv", file, "STATE", "--fields", "tick")[1].splitlines()[1:]]
        spans.append((ticks[0], ticks[-1]))
    gaps = [after[0] - before[1] for before, after in zip(spans, spans[1:])]
    checks.that(all(gap == 1 for gap in gaps), f"from one part to the next no tick is missing: {gaps}")


def of_two_sources(checks, folder):
    """The shadow twin: how robot and simulator differ is on GAP, in the log, and drawn afterwards."""
    with Stack("sway", "--stack", "twin", "--no-viewer"):
        bus = Bus()
        _, gap = bus.wait_for("GAP", lambda g: g.joint_count > 20, 8.0)
        checks.that(gap is not None, "GAP says how they differ")
        bus.forget()
        time.sleep(2.0)
        checks.at_least(sum(1 for _ in bus.messages("GAP")), 15, "GAP in 2 s")
        bus.close()
    log, plot = harness.newest_run_folder() / "run.log", folder / "gap.svg"
    status, said, problem = cli("log", "compare", log, "--channels", "STATE,STATE_BRIDGE", "--plot", plot)
    checks.that(status == 0 and "LLEG_KNEE" in said and plot.stat().st_size > 1000, f"compare of two sources: {problem}{said[-300:]}")


def last_whole(log):
    data = log.read_bytes()
    at = 0
    while at + 28 <= len(data):
        name, size = struct.unpack(">II", data[at + 20:at + 28])
        if at + 28 + name + size > len(data):
            break
        at += 28 + name + size
    return at


def replayed(checks, log):
    with Stack("--stack", "replay", "--log", str(log), "--no-viewer"):
        bus = Bus()
        time.sleep(1.0)
        _, state = bus.newest("STATE")
        checks.that(state is not None and state.source == 3 and state.term >= 1, "the log is the active source")
        names = {name for _, name, _ in bus.records}
        checks.that("REPLAY_COMMAND" in names and "REPLAY_TRUTH" in names and "TRUTH" not in names,
                    f"the rest appears under REPLAY_: {sorted(names)}")
        states = list(bus.messages("STATE"))
        checks.at_least(len(states), 350, "states a second")
        commands = list(bus.messages("COMMAND"))
        checks.at_least(len(commands), 300, "commands that answer them")
        bus.close()


def controlled(checks, log):
    replay = subprocess.Popen([BIN / "twinbus_replay", log], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        def ask(word):
            replay.stdin.write(word + "\n")
            replay.stdin.flush()
            while True:
                line = replay.stdout.readline()
                if " of " in line or not line:
                    return line
        ask("where")
        begin = time.monotonic()
        said = ask("seek 2")
        checks.at_most(time.monotonic() - begin, 0.2, "seconds to seek")
        checks.that(said.startswith("replay: 2.0"), said)
        ask("pause")
        first, time_between = ask("where"), time.sleep(0.2)
        checks.that(time_between is None and ask("where") == first and "paused" in first, f"it pauses: {first}")
        ask("speed 2")
        said = ask("play")
        checks.that("speed 2" in said and "paused" not in said, said)
        ask("speed 1")
        length = float(re.search(r" of ([\d.]+)", said).group(1))
        ask("loop on")
        ask(f"seek {length - 0.3:.3f}")
        time.sleep(0.8)
        said = ask("where")
        checks.at_most(float(re.search(r"replay: ([\d.]+)", said).group(1)), 2.0, "it begins again behind its end")
        replay.stdin.write("quit\n")
        replay.stdin.flush()
        checks.that(replay.wait(5) == 0, "it ends")
    finally:
        if replay.poll() is None:
            replay.kill()


def an_old_log_moves_nothing(checks, log, folder):
    """The stock player over a live stack: no effect, one alarm.  Stops are left out: anybody may stop, even a log."""
    player = shutil.which("lcm-logplayer")
    if player is None:
        print("lcm-logplayer is missing: no old log was played")
        return
    old = folder / "old.log"
    checks.that(cli("log", "filter", log, old, "--not", "STOP|EVENT|LOG_INDEX", "--from", "0.5", "--to", "4")[0] == 0,
                "a log to play")
    with Stack("stand", "--no-viewer", "--no-record"):
        bus = Bus()
        time.sleep(0.5)
        _, before = bus.newest("STATE")
        done = subprocess.run([player, "-l", "udpm://239.255.76.67:17667?ttl=0", old], capture_output=True, timeout=60)
        checks.that(done.returncode == 0, f"lcm-logplayer: {done.stderr[-200:]}")
        time.sleep(0.5)
        live = [s for _, s in bus.messages("STATE") if s.run_id == before.run_id]
        foreign = sum(1 for _, s in bus.messages("STATE") if s.run_id != before.run_id)
        checks.at_least(foreign, 1000, "states of the old log on the bus")
        checks.that({(s.term, s.role, s.stop_kind, s.grant_run_id) for s in live} == {(before.term, 2, 0, 0)},
                    "the live source goes on in its term, active, not stopped, nothing granted")
        moved = max(max(abs(a - b) for a, b in zip(s.q, before.q)) for s in live)
        checks.at_most(moved, 0.01, "radians that a joint moved")
        statuses = [m for _, m in bus.messages("SOURCE_STATUS") if m.run_id == before.run_id]
        checks.that(len({m.controller_id for m in statuses}) == 1, "it obeys the same controller")
        alarms = [bytes(c & 255 for c in m.text).split(b"\0")[0].decode() for _, m in bus.messages("EVENT")
                  if m.severity == 2 and m.sender_id == before.run_id]
        checks.that(len(alarms) == 1 and "nobody granted" in alarms[0], f"one alarm: {alarms}")
        bus.close()


def named(checks, folder):
    """STATE_NAMED: the robot's own joint names, for lcm-spy."""
    script = [sys.executable, harness.ROOT / "launcher/named_state.py"]
    made = subprocess.run([*script, "--make", folder / "named", "--twinbus", BIN / "twinbus"], capture_output=True, text=True)
    checks.that(made.returncode == 0, f"named_state.py --make: {made.stderr[-300:]}")
    with Stack("stand", "--no-viewer", "--no-record"):
        bus = Bus()
        publisher = subprocess.Popen([*script, "--run", folder / "named"], stdout=subprocess.DEVNULL)
        end = time.monotonic() + 10.0
        while time.monotonic() < end and sum(name == "STATE_NAMED" for _, name, _ in bus.records[:]) < 25:
            time.sleep(0.1)
        publisher.terminate()
        publisher.wait(5)
        sent = [body for _, name, body in bus.records if name == "STATE_NAMED"]
        checks.at_least(len(sent), 25, "messages on STATE_NAMED")
        module = {}
        exec((folder / "named/python/twinbus/hrp1s_state_t.py").read_text(), module)
        if sent:
            message = module["hrp1s_state_t"].decode(sent[-1])
            state = next(s for _, s in bus.messages("STATE") if s.tick == message.tick)
            checks.that(message.RLEG_KNEE_q == state.q[3] and message.CHEST_tau == state.tau[28], "fields by their names")
        bus.close()


def main():
    harness.require(*harness.STACK, "twinbus_recorder", "twinbus_replay")
    checks = Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        log = record_a_run(checks)
        whole(checks, log)
        computed_again(checks, log, folder)
        tools(checks, log, folder)
        killed(checks, folder)
        a_log_that_is_there(checks, folder)
        in_parts(checks, folder)
        of_two_sources(checks, folder)
        replayed(checks, log)
        controlled(checks, log)
        an_old_log_moves_nothing(checks, log, folder)
        named(checks, folder)
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
