#!/usr/bin/env python3
"""Simulator on one machine, controller and guard on another, a stranger on the same cable (row n).

Three network namespaces joined by a bridge, ttl 1, each side allowing the other: the robot is balanced over the cable,
and the stranger's states, commands and stops do nothing.
"""

import json
import os
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, Checks
from namespaces import URL, Cable

SECONDS = 8
# Sends forged messages for some seconds.  The stranger can hear the cable, as anybody on it can.
STRANGER = '''
import random, sys, time
sys.path.insert(0, sys.argv[1])
import harness
from harness import Bus, twinbus
import socket
bus = Bus()
bus._sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
_, state = bus.wait_for("STATE", timeout=5)
_, command = bus.wait_for("COMMAND", timeout=5)
print("heard", state is not None and command is not None, flush=True)
sent, end = 0, time.monotonic() + float(sys.argv[2])
while time.monotonic() < end:
    _, state = bus.newest("STATE", lambda s: s.role == 2)
    command.tick, command.run_id, command.term = state.tick, state.run_id, state.term
    command.q = [q + 0.3 for q in state.q]
    bus.send("COMMAND", command)          # as the controller itself
    state.tick += 1
    state.q = [0.0] * 48
    bus.send("STATE", state)              # as the source itself
    state.run_id, state.term = random.getrandbits(52), state.term + 1
    bus.send("STATE", state)
    stop = twinbus.stop_t()
    stop.sender_id, stop.sequence, stop.kind = 5, sent, 3
    bus.send("STOP", stop)
    sent += 4
    time.sleep(0.005)
print("sent", sent, flush=True)
'''


def up_on(machine, allow, report):
    return machine.start([str(BIN / "twinbus"), "up", "stand", "--stack", "client", "--no-viewer", "--for", str(SECONDS),
                          "--url", URL, "--allow", allow, "--report", report], stderr=subprocess.STDOUT)


def status_on(machine, allow):
    done = subprocess.run(machine.command([str(BIN / "twinbus"), "status", "--json", "--url", URL, "--allow", allow]),
                          capture_output=True, text=True, timeout=20)
    return json.loads(done.stdout) if done.stdout.startswith("{") else {}


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard")
    checks = Checks()
    with Cable() as cable, tempfile.TemporaryDirectory() as folder:
        robot, desk, stranger = (cable.machine(f"10.77.0.{n}") for n in (1, 2, 3))
        report = os.path.join(folder, "report.json")
        bus = ["--url", URL, "--allow", robot.address]
        programs = [desk.start([str(BIN / "twinbus_guard"), *bus]), desk.start([str(BIN / "twinbus_controller"), *bus])]
        for program in programs:
            program.stdout.readline()  # "ready"
        up = up_on(robot, desk.address, report)
        time.sleep(2.5)
        forger = stranger.start([sys.executable, "-c", STRANGER, str(harness.ROOT / "test/process"), str(SECONDS - 4)],
                                stderr=subprocess.STDOUT, env=dict(os.environ, TWINBUS_BIN=str(BIN)))
        time.sleep(2.0)
        seen = status_on(desk, robot.address)
        said = forger.communicate(timeout=30)[0]
        out = up.communicate(timeout=60)[0]
        for program in programs:
            program.terminate()
            program.communicate(timeout=10)
        print(out, said)
        checks.that("heard True" in said and "sent" in said, f"the stranger hears the cable and speaks: {said}")
        active = [s for s in seen.get("sources", []) if s["role"] == "active"]
        if checks.that(len(active) == 1, f"the desk sees one active source: {seen}"):
            checks.that(active[0]["stop"] in ("none", ""), f"and it was not stopped: {active[0]['stop']}")
            checks.that(active[0]["commands_rejected"] < 50, f"its gate saw no forged command: {active[0]['commands_rejected']}")
            checks.at_most(abs(seen["streams"]["STATE"]["rate"] - 500), 25, "STATE at the desk, off 500 Hz by")
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        # The cable is two virtual ones and a bridge on a shared machine: a lower bar than one machine's.
        checks.at_least(figures["command_hz"], 450, "commands a second at the robot")
        checks.that(figures["fell"] is False, "nobody fell")
        checks.at_most(figures["max_tilt_deg"], 2.0, "tilt [degrees]")
    checks.exit()


if __name__ == "__main__":
    main()
