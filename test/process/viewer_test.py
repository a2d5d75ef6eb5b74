#!/usr/bin/env python3
"""The viewer beside a real stack, as pages see it: who may act, the switch in the badge, silence shown as silence, and
that neither slow nor mad pages hold anybody up.
"""

import json
import os
import pathlib
import random
import re
import signal
import sys
import threading
import time

import harness
from harness import Bus, Checks, Stack, cli

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "viewer"))
from web_socket import WebSocket  # noqa: E402


class Page(WebSocket):
    """A page that is open: keeps the newest message of each type, in a thread of its own."""

    def __init__(self, port, token="", **options):
        super().__init__(port, "/ws" + (f"?token={token}" if token else ""), f"http://127.0.0.1:{port}", **options)
        self.newest, self.frames, self.gap, self.last = {}, 0, 0.0, time.monotonic()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        try:
            while True:
                message = json.loads(self.receive())
                self.newest[message["type"]] = message
                if message["type"] == "live":
                    now = time.monotonic()
                    self.gap, self.last, self.frames = max(self.gap, now - self.last), now, self.frames + 1
        except (OSError, ValueError):
            pass

    def ask(self, **request):
        self.newest.pop("note", None)
        self.send(json.dumps(request))

    def until(self, accept, seconds=4.0):
        """Waits until accept(live, status) holds."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            live, status = self.newest.get("live"), self.newest.get("status")
            if live and status and accept(live, status):
                return True
            time.sleep(0.02)
        return False

    def until_note(self, seconds=3.0):
        end = time.monotonic() + seconds
        while time.monotonic() < end and "note" not in self.newest:
            time.sleep(0.02)
        return self.newest.get("note", {}).get("text", "")


def acting(checks, bus, watcher, operator):
    watcher.ask(do="mode", mode="squat")
    checks.that("watching only" in watcher.until_note(), "a mode without the token is refused")
    operator.ask(do="mode", mode="sway")
    checks.that(bus.wait_for("CONTROLLER_STATUS", lambda s: s.motion == 1, 3)[1] is not None, "with it the robot sways")
    checks.that(operator.until(lambda live, status: status["controller"]["motion"] == "sway"), "and the page says so")
    watcher.ask(do="stop", kind=1)
    checks.that(bus.wait_for("STATE", lambda s: s.stop_kind != 0, 2)[1] is not None, "STOP without the token stops the robot")
    checks.that(watcher.until(lambda live, status: status["health"]["level"] == "stopped"), "and all pages see it")
    watcher.ask(do="clear")
    checks.that("watching only" in watcher.until_note(), "clear without the token is refused")
    time.sleep(0.3)
    checks.that(bus.newest("STATE")[1].stop_kind != 0, "and clears nothing")
    operator.ask(do="clear")
    checks.that(bus.wait_for("STATE", lambda s: s.stop_kind == 0, 2)[1] is not None, "with it the stop is cleared")
    operator.ask(do="mode", mode="balance")
    checks.that(operator.until(lambda live, status: status["controller"]["mode"] == "balance"), "and the robot balances")


def switching(checks, bus, operator):
    first = operator.newest["live"]
    checks.that(first["source"] == "simulator" and first["term"] == 1, "the badge says simulator, term 1")
    time.sleep(1.0)
    code, out, err = cli("switch", "bridge", "--policy", "now", timeout=40)
    checks.that(code == 0, f"switch: {out}{err}")
    checks.that(operator.until(lambda live, status: live["source"] == "robot" and live["term"] == 2, 1.0), "the badge says robot, term 2")
    base = operator.newest["live"]["base"]
    jump = max(abs(a - b) for a, b in zip(base[:3], first["base"][:3]))
    checks.at_most(jump, 0.03, "the robot does not jump in the picture [m]")
    other = next((s for s in operator.newest["status"]["sources"] if s["kind"] == "simulator"), None)
    checks.that(other is not None and other["run"] != operator.newest["live"]["run"], "the simulator is still listed")
    time.sleep(1.0)
    operator.ask(do="switch", run=other["run"])
    checks.that(operator.until(lambda live, status: live["source"] == "simulator" and live["term"] == 3, 15.0),
                f"the page's own button switches back: {operator.newest['status']['sources']}")


def crowd(checks, bus, port, operator):
    """Slow pages, mad pages and many pages: the operator's frames keep coming and no tick is held up by the viewer."""
    rng = random.Random(3)
    time.sleep(0.5)
    operator.gap = 0.0
    start, frames = time.monotonic(), operator.frames
    slow = [WebSocket(port, "/ws", f"http://127.0.0.1:{port}", small_buffer=True) for _ in range(4)]  # never read
    many = [Page(port) for _ in range(5)]
    for _ in range(60):
        page = WebSocket(port, "/ws", f"http://127.0.0.1:{port}")
        try:
            if page.status == 101:
                page.send(rng.randbytes(rng.randrange(1, 3000)), opcode=rng.choice((0, 1, 2, 3, 8, 9, 10, 15)))
                page.socket.sendall(rng.randbytes(rng.randrange(1, 200)))
        except OSError:
            pass
        page.close()
    time.sleep(2.0)
    rate = (operator.frames - frames) / (time.monotonic() - start)
    print(f"crowd: {rate:.0f} frames/s, longest gap {operator.gap:.2f} s")
    checks.at_least(rate, 20, "frames per second of the operator's page beside them")
    checks.at_most(operator.gap, 0.7, "longest pause of the operator's page [s]")
    checks.that(all(page.frames > 10 for page in many), "the other pages see something too")
    beats = [b for _, b in bus.messages("HEARTBEAT", time.monotonic_ns() - 1_000_000_000) if b.kind == 7]
    checks.at_least(len(beats), 5, "the viewer's heartbeats in the last second")
    for page in slow + many:
        page.close()


def silence(checks, stack, operator):
    for pid in stack.pids("twinbus_bridge") + stack.pids("twinbus_simulator"):
        os.kill(pid, signal.SIGSTOP)
    checks.that(operator.until(lambda live, status: (live["age_ms"] or 0) > 500 and status["health"]["level"] == "bad"),
                f"a silent stack is shown as silent: {operator.newest['status']['health']}")
    for pid in stack.pids("twinbus_bridge") + stack.pids("twinbus_simulator"):
        os.kill(pid, signal.SIGCONT)


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_bridge", "emulated_robot",
                    "twinbus_viewer")
    checks = Checks()
    with Stack("stand", "--stack", "both", "--for", 120) as stack:
        bus = Bus()
        end = time.monotonic() + 20
        found = None
        while found is None and time.monotonic() < end:
            found = re.search(r"http://127\.0\.0\.1:(\d+)/#token=([0-9a-f]+)", "".join(stack.lines))
            time.sleep(0.05)
        if not checks.that(found is not None, f"`up` prints the viewer's address: {stack.lines}"):
            checks.exit()
        port, token = int(found[1]), found[2]
        watcher, operator = Page(port), Page(port, token)
        operator.ask(do="hello")
        checks.that(operator.until(lambda live, status: live["age_ms"] is not None and live["age_ms"] < 100), "the stack is seen live")
        checks.that(operator.until(lambda live, status: "hello" in operator.newest), "the viewer answers hello")
        checks.that(operator.newest.get("hello", {}).get("trusted") is True, "the operator's page is trusted")
        checks.that(operator.until(lambda live, status: abs(status["state_hz"] - 500) < 40 and abs(status["guard_hz"] - 500) < 40, 8),
                    f"rates are those of the stack: {operator.newest['status']['state_hz']:.0f} Hz")
        acting(checks, bus, watcher, operator)
        switching(checks, bus, operator)
        crowd(checks, bus, port, operator)
        silence(checks, stack, operator)
        bus.close()
    checks.exit()


if __name__ == "__main__":
    main()
