#!/usr/bin/env python3
"""./twinbus bench log [--hours H] [--log FILE] [--csv F]: how fast the log tools are on a long log: info, seek, csv, filter, and the memory that reading takes.

FILE (default: a stack that is recorded for ten seconds) is repeated until it lasts so long.  Times are of one run each, with
the log in the disk cache where it fits.
"""

import argparse
import contextlib
import os
import pathlib
import re
import select
import struct
import subprocess
import sys
import tempfile
import time

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
programs.help_is(__doc__)
programs.on_own_bus(__file__, "bench log")
sys.path.insert(0, str(ROOT / "test/process"))
import harness  # noqa: E402
from harness import BIN, Stack  # noqa: E402

HEAD = struct.Struct(">IqqII")


most_memory = 0.0  # of any tool [MiB]


def timed(*words):
    """Runs a tool; its seconds.  Its memory is looked at while it runs: what a child inherited of us does not count."""
    global most_memory
    begin = time.monotonic()
    child = subprocess.Popen([BIN / "twinbus", *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    descriptor = os.pidfd_open(child.pid)
    while not select.select([descriptor], [], [], 0.05)[0]:
        with contextlib.suppress(OSError, AttributeError):
            status = pathlib.Path(f"/proc/{child.pid}/status").read_text()
            most_memory = max(most_memory, int(re.search(r"VmHWM:\s*(\d+)", status).group(1)) / 1024.0)
    took = time.monotonic() - begin
    os.close(descriptor)
    problem = child.stderr.read().decode()
    if child.wait() != 0:
        raise SystemExit(f"{words}: {problem}")
    return took


def disk_alone(folder, megabytes):
    """MB/s that this disk takes from a program that does nothing but write, as much as a tool has to."""
    block = os.urandom(1 << 20)
    begin = time.monotonic()
    with open(folder / "alone", "wb", buffering=0) as file:
        for _ in range(int(megabytes)):
            file.write(block)
    took = time.monotonic() - begin
    (folder / "alone").unlink()
    return megabytes / took


def make_long(short, long, hours):
    """The whole log again and again, times and numbers going on; our own indexes are left out and made again by filter."""
    data = short.read_bytes()
    events, at = [], 0
    while at + HEAD.size <= len(data):
        _, _, utime, name, size = HEAD.unpack_from(data, at)
        total = HEAD.size + name + size
        if data[at + 28:at + 28 + name] != b"LOG_INDEX":
            events.append((utime, name, size, data[at + 28:at + total]))
        at += total
    first, last = events[0][0], events[-1][0]
    span = last - first + 2000
    with open(long, "wb") as file:
        number = 0
        for turn in range(int(hours * 3.6e9 / span) + 1):
            parts = []
            for utime, name, size, body in events:
                parts += [HEAD.pack(0xEDA1DA01, number, utime + turn * span, name, size), body]
                number += 1
            file.write(b"".join(parts))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hours", type=float, default=1.0)
    parser.add_argument("--log", type=pathlib.Path)
    parser.add_argument("--csv", type=pathlib.Path)
    arguments = parser.parse_args()
    rows = []

    def tell(case, value, unit, asked):
        print(f"{case:34} {value:12.3f} {unit:6} asked {asked}", flush=True)
        rows.append(f"log,{case},{unit},{value:.4f}")

    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR")) as name:
        folder = pathlib.Path(name)
        short = arguments.log
        if short is None:
            os.environ["TWINBUS_RECORD"] = "1"
            with Stack("sway", "--no-viewer"):
                time.sleep(10.0)
            short = harness.newest_run_folder() / "run.log"
        raw, log = folder / "raw.log", folder / "hour.log"
        make_long(short, raw, arguments.hours)
        took = timed("log", "filter", raw, log)
        megabytes = raw.stat().st_size * 1e-6
        raw.unlink()
        print(f"a log of {arguments.hours:g} h, {megabytes:.0f} MB, copied with checksums in {took:.1f} s")
        alone = disk_alone(folder, megabytes)
        tell("the disk alone, as many bytes", alone, "MB/s", "-")
        tell("filter everything", megabytes / took, "MB/s", f">= 200 or the disk ({0.9 * alone:.0f})")
        tell("info", timed("log", "info", log), "s", "<= 1")
        seconds = 3600.0 * arguments.hours
        seeks = []
        for share in (0.01, 0.3, 0.5, 0.77, 0.99):
            start = share * seconds
            seeks.append(timed("log", "events", log, "--from", start, "--to", start + 0.01))
        tell("seek and read 10 ms, worst of 5", 1e3 * max(seeks), "ms", "<= 100")
        took = timed("log", "filter", log, folder / "part.log", "--channels", "STATE|COMMAND")
        tell("filter two channels", megabytes / took, "MB/s", ">= 200 or the disk")
        (folder / "part.log").unlink()
        minutes = min(5.0, 60.0 * arguments.hours)
        took = timed("log", "csv", log, "STATE", folder / "state.csv", "--to", 60.0 * minutes)
        read = megabytes * minutes / (60.0 * arguments.hours)
        tell("csv of STATE, all fields", read / took, "MB/s", ">= 200 or the disk")
        tell("csv written", (folder / "state.csv").stat().st_size * 1e-6 / took, "MB/s", "")
        (folder / "state.csv").unlink()
        took = timed("log", "info", log, "--check")
        tell("info --check", megabytes / took, "MB/s", "")
        tell("most memory of all of them", most_memory, "MiB", "<= 64")
    if arguments.csv:
        arguments.csv.write_text("bench,case,unit,value\n" + "\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
