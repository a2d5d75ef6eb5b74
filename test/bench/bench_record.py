#!/usr/bin/env python3
"""./twinbus bench record [--minutes M] [--block S] [--rest S] [--csv F]: a swaying stack with and without a recorder of everything.

M minutes (default 10) of recording in blocks of S seconds (default 30), by turns with blocks without (default 10), so that both
see the same machine: messages lost (by the recorder's socket or disk, or a gap in the numbered pages of the journal), the time from STATE to COMMAND of both, what kill -9 of the last recorder costs, and whether lcm-logplayer
plays what it left.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
programs.on_own_bus(__file__, "bench record")
programs.help_is(__doc__)
sys.path.insert(0, str(ROOT / "test/process"))
import harness  # noqa: E402
from harness import BIN, Checks, Stack, cli  # noqa: E402
from loop_figures import Figures, Loop, settle  # noqa: E402
from stalls import Stalls  # noqa: E402

MOST_CHANGE, LEAST_CHANGE = 0.10, 30.0  # of p99: share, and microseconds that are too little to count


def events(log):
    """(time [us], channel) of each whole event."""
    data = log.read_bytes()
    at = 0
    while at + 28 <= len(data):
        name, size = (int.from_bytes(data[at + k:at + k + 4], "big") for k in (20, 24))
        if at + 28 + name + size > len(data):
            return
        yield int.from_bytes(data[at + 12:at + 20], "big"), data[at + 28:at + 28 + name].decode()
        at += 28 + name + size


class Recorder:
    def __init__(self, log):
        self.log = log
        self.child = subprocess.Popen([BIN / "twinbus_recorder", log], stdout=subprocess.PIPE, text=True)
        self.child.stdout.readline()  # ready
        self.begin = time.monotonic_ns()

    def end(self):
        end = time.monotonic_ns()
        self.child.terminate()
        said = self.child.stdout.read()
        self.child.wait()
        return self.begin, end, said

    def kill(self):
        end = time.monotonic_ns()
        self.child.kill()
        died = time.time()
        self.child.wait()
        return self.begin, end, died


def killed(log, died, checks):
    times = [at for at, channel in events(log) if channel == "STATE"]
    checks.at_most(died - 1e-6 * times[-1], 1.0, "kill -9: seconds of the end that are not readable")
    print(f"kill -9: the last STATE in the log is {1e3 * (died - 1e-6 * times[-1]):.0f} ms older than the kill")
    player = shutil.which("lcm-logplayer")
    if player is None:
        return print("lcm-logplayer is missing")
    done = subprocess.run([player, "-v", "-s", "1000", "-l", "udpm://239.255.76.67:17699?ttl=0", log], capture_output=True,
                          timeout=600)
    checks.that(done.returncode == 0, f"lcm-logplayer plays it: {done.stderr[-200:]}")


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--block", type=float, default=30.0)
    parser.add_argument("--rest", type=float, default=10.0)
    parser.add_argument("--csv", type=pathlib.Path)
    arguments = parser.parse_args()
    blocks = max(2, round(60.0 * arguments.minutes / arguments.block))
    checks = Checks()
    off, on, lost, written, logs, died, left_out = [], [], 0, 0, [], 0.0, {}
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR")) as name:
        folder = pathlib.Path(name)
        with Stack("sway", "--no-viewer", "--no-record"):
            time.sleep(2.0)
            loop, stalls = Loop(), Stalls()
            time.sleep(1.0)
            for block in range(blocks):
                begin = time.monotonic_ns()
                time.sleep(arguments.rest)
                off.append((begin, time.monotonic_ns()))
                logs.append(folder / f"block{block:03}.log")
                recorder = Recorder(logs[-1])
                time.sleep(arguments.block)
                if block == blocks - 1:
                    begin, end, died = recorder.kill()
                else:
                    begin, end, said = recorder.end()
                    found = re.search(r"(\d+) events, .* (\d+) dropped", said)
                    written, lost = written + int(found.group(1)), lost + int(found.group(2))
                on.append((begin, end))
            settle()
            loop.close()
            stalls.close()
        for log in logs[:-1]:
            said = cli("log", "info", log, "--check", timeout=600)[1]
            # A tick that a process left out on a busy machine was never on the bus; a page of the journal was.
            gaps = {channel: int(re.search(rf"^{channel} .* (\d+)$", said, re.MULTILINE).group(1))
                    for channel in ("STATE", "COMMAND", "TRUTH", "JOURNAL")}
            journal = gaps.pop("JOURNAL")
            checks.at_most(journal, 0, f"{log.name}: pages of the journal that are not in it")
            left_out = {channel: left_out.get(channel, 0) + gap for channel, gap in gaps.items()}
            checks.that("no damage" in said and " 0 changed, 0 gone" in said, f"{log.name}: {said[-300:]}")
        size = sum(log.stat().st_size for log in logs)
        killed(logs[-1], died, checks)
    seconds = sum(b - a for a, b in on) * 1e-9
    print(f"ticks that their sender left out: {left_out}")
    print(f"recorded {seconds:.0f} s in {blocks} blocks, {written} events ({1e-6 * size / seconds:.2f} MB/s)")
    checks.at_most(lost, 0, "messages that the recorder counts as lost")
    rows = []
    for title, stalled in (("every tick", ()), ("without the machine's stalls", stalls.seen)):
        print(title)
        without, with_it = Figures(loop.ticks, off, stalled), Figures(loop.ticks, on, stalled)
        print(without.line("  without recorder"))
        print(with_it.line("  with recorder"))
        rows += [f"record,{title},us,{without.p99:.1f},{with_it.p99:.1f}"]
    change, allowed = with_it.p99 - without.p99, max(MOST_CHANGE * without.p99, LEAST_CHANGE)
    print(f"p99 changes by {change:+.0f} us, at most {allowed:.0f} asked")
    checks.at_most(change, allowed, "change of p99 [us]")
    if arguments.csv:
        arguments.csv.write_text("bench,case,unit,p99_without,p99_with\n" + "\n".join(rows) + "\n")
    checks.exit()


if __name__ == "__main__":
    main()
