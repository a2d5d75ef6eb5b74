#!/usr/bin/env python3
"""A simulated world that waits for late commands (`up` without real-time rights): a walk outlives a controller and a simulator
that stand still, nothing is hidden, and a controller that is gone is not waited for; with --strict the clock stays hard.
"""

import os
import signal
import sys
import time

import harness
from harness import Bus, Checks, Stack, cli

WALKS = 5  # mode of CONTROLLER_STATUS
REAL_TIME, PATIENT = 1, 6  # pace of SOURCE_STATUS


def stand_still(pid, seconds):
    os.kill(pid, signal.SIGSTOP)
    time.sleep(seconds)
    os.kill(pid, signal.SIGCONT)


def source(bus):
    return bus.wait_for("SOURCE_STATUS", lambda s: s.role == 2 or s.stop_kind, 5.0)[1]


def waits(checks):
    with Stack("walk_forward", "--no-viewer", "--no-record", "--no-fifo") as stack:
        bus = Bus()
        checks.that(any("waits up to 200 ms" in line for line in stack.lines), "up says that the world waits")
        walking = bus.wait_for("CONTROLLER_STATUS", lambda c: c.mode == WALKS, 20.0)[1]
        checks.that(walking is not None, "the robot walks")
        time.sleep(1.5)
        checks.that(source(bus).pace == PATIENT, "SOURCE_STATUS says that the world waits")
        before, begin = source(bus), time.monotonic_ns()
        for program in ("twinbus_controller", "twinbus_controller", "twinbus_simulator"):
            stand_still(stack.pid(program), 0.12)
            time.sleep(0.4)
        after = source(bus)
        states = [s for _, s in bus.messages("STATE", begin)]
        checks.that(len(states) > 200, f"STATE goes on: {len(states)}")
        checks.that(after.plans_followed == before.plans_followed, "no stop plan was needed")
        checks.that(after.ticks_missed == before.ticks_missed, "no tick was missed: the clock stood still")
        ticks = sorted({s.tick for s in states})
        checks.that(ticks == list(range(ticks[0], ticks[-1] + 1)), "no tick is left out")
        checks.that(len(states) - len(ticks) >= 4, f"a STATE without an answer is repeated: {len(states) - len(ticks)}")
        checks.that(all(s.stop_kind == 0 for s in states), "nothing stops")
        checks.that(not any(t.fell for _, t in bus.messages("TRUTH", begin)), "nobody falls")
        checks.that(bus.newest("CONTROLLER_STATUS")[1].mode == WALKS, "it walks on")
        told = [harness.text_of(e) for _, e in bus.messages("EVENT", begin - 20_000_000_000)]
        checks.that(any("slower than real time: the simulated world stood still" in t for t in told), f"it is told: {told}")
        status, said, _ = cli("status")
        checks.that(status == 0 and "waits for late commands" in said, f"the table says so: {said[:300]}")

        # A balanced stop is made by the controller: it is waited for, too.
        begin = time.monotonic_ns()
        cli("stop", "balanced")
        stand_still(stack.pid("twinbus_controller"), 0.12)
        time.sleep(0.5)
        states = [s for _, s in bus.messages("STATE", begin)]
        checks.that(any(s.stop_kind == 1 for s in states), "a balanced stop is made")
        checks.that(all(s.plan_number == 0 for s in states if s.stop_kind == 1), "and needs no stop plan")
        time.sleep(3.0)
        cli("clear")
        cli("mode", "walk")
        cli("walk", "0.3", "0", "0", "--for", "3")

        os.kill(stack.pid("twinbus_controller"), signal.SIGKILL)
        led = bus.wait_for("STATE", lambda s: s.plan_number != 0, 3.0)[1]
        checks.that(led is not None, "a controller that is gone is not waited for: its stop plan is followed")
        time.sleep(3.0)
        checks.that(not any(t.fell for _, t in bus.messages("TRUTH", begin)), "nobody falls of it")
        bus.close()


def strict(checks):
    with Stack("stand", "--no-viewer", "--no-record", "--no-fifo", "--strict") as stack:
        bus = Bus()
        checks.that(not any("waits up to" in line for line in stack.lines), "--strict: up does not speak of waiting")
        checks.that(source(bus).pace == REAL_TIME, "--strict: the clock is hard")
        bus.close()
    with Stack("stand", "--no-viewer", "--no-record", "--no-fifo", "--stack", "both") as stack:
        bus = Bus()
        checks.that(source(bus).pace == REAL_TIME, "beside a robot the clock is hard")
        bus.close()


def main():
    harness.require(*harness.STACK)
    checks = Checks()
    waits(checks)
    strict(checks)
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
