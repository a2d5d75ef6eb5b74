#!/usr/bin/env python3
"""./twinbus bench viewer [page] [loop] [log] [--pairs N] [--hours H] [--log FILE] [--csv F]: what the viewer gives, and what it costs.

page  a running stack in a headless Chromium with software rendering, 900x600: until the first drawn robot, pictures and
      messages per second
loop  three clients that read everything against none, N paired runs (default 10): p99 from STATE to COMMAND, CPU of the viewer
      per client; then one client that never reads
log   a log of H hours (default 1), or FILE: opening, seeking, memory of the log viewer; exports in MB of log read per second
Without a name: all of them.
"""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
programs.on_own_bus(__file__, "bench viewer")
programs.help_is(__doc__)
sys.path[:0] = [str(ROOT / "test/process"), str(ROOT / "test/viewer"), str(ROOT / "test/bench")]
from bench_log import disk_alone, make_long  # noqa: E402
from browser import Browser, find_browser  # noqa: E402
from harness import BIN, Checks, Stack  # noqa: E402
from loop_figures import Figures, Loop, settle  # noqa: E402
from stalls import Stalls  # noqa: E402
from web_socket import WebSocket  # noqa: E402

MOST_CHANGE, LEAST_CHANGE = 0.10, 30.0  # of p99: share, and microseconds that are too little to count
TICK = os.sysconf("SC_CLK_TCK")
rows = []


def tell(case, value, unit, asked):
    print(f"{case:52} {value:10.2f} {unit:6} asked {asked}", flush=True)
    rows.append(f"viewer,{case},{unit},{value:.4f}")


def address_of(stack):
    end = time.monotonic() + 20.0
    while time.monotonic() < end:
        found = re.search(r"http://127\.0\.0\.1:(\d+)/#token=\w+", "".join(stack.lines))
        if found:
            return found[0], int(found[1])
        time.sleep(0.1)
    raise SystemExit("bench viewer: the stack tells no address:\n" + "".join(stack.lines))


class Reader(threading.Thread):
    """A page without pictures: reads all and acknowledges it."""

    def __init__(self, port):
        super().__init__(daemon=True)
        self.socket, self.messages, self.ends = WebSocket(port, "/ws"), 0, False
        self.start()

    def run(self):
        try:
            while not self.ends:
                self.socket.receive()
                self.messages += 1
                self.socket.send("ack")
        except (ConnectionError, OSError):
            pass

    def close(self):
        self.ends = True
        self.join(5.0)
        self.socket.close()


def cpu_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def page(checks):
    if not find_browser():
        return print("page: no chromium")
    with Stack("sway", "--no-record") as stack:
        address, _ = address_of(stack)
        time.sleep(3.0)
        browser = Browser("about:blank", (900, 600))
        browser.call("Page.navigate", url=address)
        seen = browser.wait_for("globalThis.twinbus?.figures.first", 30.0)
        first = 1e-3 * browser.value("twinbus.figures.first") if seen else 99.0
        tell("page opens until the first drawn robot", first, "s", "<= 3")
        time.sleep(3.0)
        count = "[performance.now(), twinbus.figures.drawn, twinbus.link.received, innerWidth, innerHeight]"
        before = browser.value(count)
        time.sleep(10.0)
        after = browser.value(count)
        seconds = 1e-3 * (after[0] - before[0])
        frames, messages = (after[1] - before[1]) / seconds, (after[2] - before[2]) / seconds
        tell(f"pictures, {after[3]}x{after[4]}, software rendering", frames, "1/s", ">= 20")
        tell("messages", messages, "1/s", ">= 60")
        browser.end()
    checks.at_most(first, 3.0, "seconds to the first robot")
    checks.at_least(frames, 20.0, "pictures per second")
    checks.at_least(messages, 60.0, "messages per second")


def loop(checks, pairs):
    kinds = {"none": [], "three": [], "stalled": []}
    cpu = {"none": [], "three": []}
    with Stack("sway", "--no-record") as stack:
        _, port = address_of(stack)
        viewer = stack.pids("twinbus_viewer")[0]
        time.sleep(2.0)
        figures, stalls = Loop(), Stalls()
        time.sleep(1.0)

        def run(kind):
            readers = [Reader(port) for _ in range(3)] if kind == "three" else []
            stalled = [WebSocket(port, "/ws", small_buffer=True)] if kind == "stalled" else []
            time.sleep(0.5)
            begin, used = time.monotonic_ns(), cpu_seconds(viewer)
            time.sleep(4.0)
            end = time.monotonic_ns()
            kinds[kind].append((begin, end))
            if kind in cpu:
                cpu[kind].append((cpu_seconds(viewer) - used) / (1e-9 * (end - begin)))
            for reader in readers:
                reader.close()
            for socket in stalled:
                socket.close()
            return sum(reader.messages for reader in readers)

        read = 0
        for _ in range(pairs):
            run("none")
            read += run("three")
        for _ in range(max(1, pairs // 3)):
            run("stalled")
        settle()
        figures.close()
        stalls.close()
    print(f"the clients read {read / (3 * pairs * 4.5):.0f} messages per second each")
    without = Figures(figures.ticks, kinds["none"], stalls.seen)
    print(without.line("  without clients"))
    for kind in ("three", "stalled"):
        with_it = Figures(figures.ticks, kinds[kind], stalls.seen)
        print(with_it.line(f"  {kind}"))
        allowed = max(MOST_CHANGE * without.p99, LEAST_CHANGE)
        change = with_it.p99 - without.p99
        tell(f"p99 from STATE to COMMAND, {kind}: change", change, "us", f"<= {allowed:.0f}")
        checks.at_most(change, allowed, f"change of p99, {kind} [us]")
    share = 100.0 * (statistics.median(cpu["three"]) - statistics.median(cpu["none"])) / 3.0
    tell("CPU of the viewer without clients", 100.0 * statistics.median(cpu["none"]), "%", "")
    tell("CPU of the viewer per client", share, "%", "<= 10 of a core")
    checks.at_most(share, 10.0, "percent of a core per client")


class LogPage(WebSocket):
    def ask(self, **request):
        self.send(json.dumps(request))

    def wait_for(self, kind, condition, seconds=120.0):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            message = json.loads(self.receive())
            self.send("ack")
            if message["type"] == kind and condition(message):
                return message
        raise SystemExit(f"bench viewer: no {kind} within {seconds:g} s")


def log(checks, hours, given):
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR")) as name:
        folder = pathlib.Path(name)
        short, long = folder / "short.log", folder / "long.log"
        if given:
            long = given
        else:
            subprocess.run([BIN / "twinbus", "run", "sway", "--for", "60", "--log", short], stdout=subprocess.DEVNULL, check=False)
            make_long(short, long, hours)
        begin = time.monotonic()
        viewer = subprocess.Popen([BIN / "twinbus_log_viewer", long, "--port", "0", "--no-open"], stdout=subprocess.PIPE, text=True)
        found = re.search(r"127\.0\.0\.1:(\d+)/#token=(\w+)", viewer.stdout.readline())
        client = LogPage(int(found[1]), f"/ws?token={found[2]}", timeout=30)
        client.wait_for("live", lambda m: True)
        opened = time.monotonic() - begin
        tell(f"{1e-9 * long.stat().st_size:.1f} GB: opens, until the first picture", opened, "s", "<= 2")
        state = client.wait_for("replay", lambda m: True)
        seeks = []
        for k in range(20):
            place = round(state["duration"] * (0.03 + 0.94 * ((7 * k) % 20) / 20.0), 3)
            asked = time.monotonic()
            client.ask(do="seek", s=place)
            client.wait_for("live", lambda m: abs(m["log_s"] - place) < 2e-3)
            seeks.append(1e3 * (time.monotonic() - asked))
        tell("seek until the picture is there, median of 20", statistics.median(seeks), "ms", "")
        tell("seek until the picture is there, worst of 20", max(seeks), "ms", "<= 100")
        memory = int(re.search(r"VmHWM:\s+(\d+)", pathlib.Path(f"/proc/{viewer.pid}/status").read_text())[1]) / 1024.0
        tell("most memory", memory, "MiB", "<= 300")
        client.wait_for("replay", lambda m: m["scanned"] >= 1.0)
        tell("until all events of the log are on the line of time", time.monotonic() - begin, "s", "")
        client.close()
        viewer.terminate()
        viewer.wait()
        # What is exported is a part: the whole would be twice as large as the log.  Each turn beside the disk alone.
        part = min(300.0, state["duration"])
        os.sync()  # the log itself, if it was just made
        exported, written, alone = [], [], []
        for _ in range(3):
            done = subprocess.run([BIN / "twinbus", "log", "mcap", long, folder / "out.mcap", "--to", str(part), "--force"], capture_output=True, text=True)
            print(done.stdout.strip() + done.stderr.strip(), flush=True)
            speeds = re.search(r"(\d+) MB/s of log, (\d+) MB/s written", done.stdout)
            exported.append(float(speeds[1]))
            written.append(float(speeds[2]))
            megabytes = 1e-6 * (folder / "out.mcap").stat().st_size
            (folder / "out.mcap").unlink()
            alone.append(disk_alone(folder, megabytes))
        tell("the disk alone, as many bytes, median of 3", statistics.median(alone), "MB/s", "")
        tell("mcap, written, median of 3", statistics.median(written), "MB/s", "")
        tell("mcap, of the log read, median of 3", statistics.median(exported), "MB/s", ">= 200 or the disk")
        begin = time.monotonic()
        subprocess.run([BIN / "twinbus", "log", "csv", long, "STATE", folder / "out.csv", "--to", str(part)], check=True)
        csv = 1e-6 * long.stat().st_size * part / state["duration"] / (time.monotonic() - begin)
        tell("csv of STATE, of the log read", csv, "MB/s", ">= 200")
    checks.at_most(opened, 2.0, "seconds to open")
    checks.at_most(max(seeks), 100.0, "milliseconds of a seek")
    checks.at_most(memory, 300.0, "MiB")
    share = statistics.median(w / a for w, a in zip(written, alone))
    checks.that(statistics.median(exported) >= 200.0 or share >= 0.9, f"mcap: {statistics.median(exported):.0f} MB/s of log, {100 * share:.0f} % of the disk alone")
    checks.at_least(csv, 200.0, "MB/s of log, csv")


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("what", nargs="*")
    parser.add_argument("--pairs", type=int, default=10)
    parser.add_argument("--hours", type=float, default=1.0)
    parser.add_argument("--log", type=pathlib.Path)
    parser.add_argument("--csv", type=pathlib.Path)
    arguments = parser.parse_args()
    unknown = set(arguments.what) - {"page", "loop", "log"}
    if unknown:
        print(f"bench viewer: no part '{min(unknown)}'; there are page, loop, log", file=sys.stderr)
        sys.exit(2)
    what = arguments.what or ["page", "loop", "log"]
    checks = Checks()
    if "page" in what:
        page(checks)
    if "loop" in what:
        loop(checks, arguments.pairs)
    if "log" in what:
        log(checks, arguments.hours, arguments.log)
    if arguments.csv:
        arguments.csv.write_text("bench,case,unit,value\n" + "\n".join(rows) + "\n")
    checks.exit()


if __name__ == "__main__":
    main()
