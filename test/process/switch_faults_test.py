#!/usr/bin/env python3
"""Every single message of a switch is lost, doubled or late: the switch is complete or nothing happened, never two obeying.

Two simulators and a controller; the second simulator stands behind a relay (test/tools/relay.cpp) on a port of its own, so
that everything between it and the others can be lost, doubled or delayed by exactly one message.

TWINBUS_FULL=1: every message with every fault, otherwise every message with one of them.
"""

import os
import pathlib
import subprocess
import tempfile
import time

import harness
from harness import BIN, Bus, Checks, Stack, twinbus

RIGHT_PORT = 17668
RIGHT = f"udpm://{harness.GROUP}:{RIGHT_PORT}?ttl=0&recv_buf_size=4194304"
# Counted from the request on; either direction, so that it does not matter which of the two is active.
MESSAGES = ([("SOURCE_REQUEST", 1)] + [("STATE", n) for n in range(1, 13)] + [("STATE_SIM", n) for n in range(1, 9)]
            + [("COMMAND", n) for n in range(1, 13)])
FAULTS = ("drop", "double", "delay=3", "delay=30")
SWITCH, TRACK = 2, 3


def stack_file():
    """twosims, the second simulator on the other port."""
    text = (harness.ROOT / "config/stacks/twosims.yaml").read_text(encoding="utf-8")
    plain = '"model.mass_scale=1.03"'
    assert plain in text
    file = pathlib.Path(tempfile.mkdtemp()) / "apart.yaml"
    file.write_text(text.replace(plain, plain + f', "--url", "{RIGHT}"', 1), encoding="utf-8")
    return str(file)


class Relay:
    def __init__(self):
        self.process = subprocess.Popen([BIN / "relay", "--left", str(harness.PORT), "--right", str(RIGHT_PORT)], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        try:  # a relay that waits for the processor would be a fault nobody asked for
            os.sched_setscheduler(self.process.pid, os.SCHED_FIFO, os.sched_param(65))
        except OSError:
            pass
        assert self.process.stdout.readline() == "ready\n"

    def say(self, *lines):
        for line in lines:
            self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def close(self):
        self.process.terminate()
        self.process.wait()


def active(bus, since_ns):
    """Runs that published on STATE as holders since then, and the newest of them."""
    states = [(at, s) for at, s in bus.messages("STATE", since_ns)]
    return {s.run_id for _, s in states}, (states[-1][1] if states else None)


class Operator:
    def __init__(self, buses):
        self.buses = buses
        self.sequence = 0

    def clear(self, bus, nonce):
        stop = twinbus.stop_t()
        stop.utime, stop.sender_id, stop.stop_nonce = int(1e6 * time.time()), 4711, nonce
        self.sequence += 1
        stop.sequence = self.sequence
        bus.send("STOP", stop)

    def ask(self, bus, action, target, run):
        request = twinbus.source_request_t()
        request.utime = int(1e6 * time.time())
        request.sender_id = 4711
        request.run_id, request.target_run_id = run, target
        self.sequence += 1
        request.sequence = self.sequence
        request.action, request.policy = action, 1
        bus.send("SOURCE_REQUEST", request)


def two_obeying(bus, since_ns, old_run, new_run):
    """Active states of the old source behind the tick from which the new one published."""
    states = [s for _, s in bus.messages("STATE", since_ns)]
    first = next((s.tick for s in states if s.run_id == new_run), None)
    if first is None:
        return 0
    ours = [s for s in states if s.run_id == new_run]
    # A cancel (term + 2) takes the robot back: what counts is one term, one obeyed.
    top = max(s.term for s in ours)
    return sum(1 for s in states if s.run_id == old_run and s.role == 2 and s.term < top and s.tick > first + 3)


def one_case(checks, relay, operator, left, right, runs, rule):
    _, state = left.newest("STATE")
    old = state.run_id
    new = next(run for run in runs if run != old)
    # The request crosses the relay: it is said on the side where the active source is not.
    says = right if operator.first == old else left
    relay.say("clear", "rule " + rule)
    left.forget()
    begin = time.monotonic_ns()
    operator.ask(says, SWITCH, new, old)
    time.sleep(0.5)
    relay.say("clear")
    time.sleep(0.2)
    for _ in range(20):  # a busy machine may hear the request late
        holders, last = active(left, time.monotonic_ns() - 100_000_000)
        if len(holders) == 1 and last.role != 3:
            break
        time.sleep(0.1)
    done = last is not None and last.run_id == new
    checks.that(len(holders) == 1, f"{rule}: exactly one source is on STATE in the end, {len(holders)} are")
    checks.that(last is not None and last.role == 2 and last.stop_kind == 0,
                f"{rule}: it is active and not stopped (role {last.role if last else '-'}, stop {last.stop_kind if last else '-'})")
    checks.that(two_obeying(left, begin, old, new) == 0, f"{rule}: never two obeying")
    checks.that(not any(truth.fell for _, truth in left.messages("TRUTH", begin)), f"{rule}: nobody falls")
    if last is not None and last.stop_kind != 0:  # the next case begins with a robot that obeys
        _, status = left.newest("SOURCE_STATUS", lambda m: m.run_id == last.run_id)
        print(f"  stopped for reason {status.stop_reason if status else '-'}; cleared")
        operator.clear(left, last.stop_nonce)
    time.sleep(1.4)  # a source grants at most once in 1.9 s
    return done


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "relay")
    checks = Checks()
    relay = Relay()
    left, right = Bus(), Bus(RIGHT_PORT)
    try:
        with Stack("stand", "--stack", stack_file(), "--no-viewer"):
            time.sleep(1.5)
            operator = Operator((left, right))
            _, state = left.wait_for("STATE")
            _, other = left.wait_for("STATE_SIM", lambda s: s.run_id != state.run_id)
            operator.first = state.run_id
            runs = (state.run_id, other.run_id)
            operator.ask(right, TRACK, other.run_id, other.run_id)
            time.sleep(0.5)
            complete = refused = 0
            for index, (channel, number) in enumerate(MESSAGES):
                for fault in FAULTS if harness.FULL else (FAULTS[index % len(FAULTS)],):
                    done = one_case(checks, relay, operator, left, right, runs, f"{channel}:{number}:{fault}")
                    complete += done
                    refused += not done
            print(f"{complete} switches were completed, {refused} did not happen")
            checks.at_least(complete, 1, "some switches are completed in spite of the fault")
    finally:
        relay.close()
        left.close()
        right.close()
    checks.exit()


if __name__ == "__main__":
    main()
