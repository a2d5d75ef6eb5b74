#!/usr/bin/env python3
"""Two of five processes are killed at random and started anew by hand, again and again: the stack is ready within 2 s of the
last start, nothing begins to move by itself, no process is left behind.

TWINBUS_FULL=1: 100 times, otherwise 4.  The seed is printed; RESTART_SEED=N repeats a run.
"""

import os
import pathlib
import random
import signal
import tempfile
import time

import harness
from harness import Bus, Checks, Stack, cli

ROUNDS = 100 if harness.FULL else 4
PROGRAMS = {"simulator": "twinbus_simulator", "bridge": "twinbus_bridge", "controller": "twinbus_controller",
            "guard": "twinbus_guard", "planner": "twinbus_planner"}


def stack_without_restarts(folder):
    text = (harness.ROOT / "config/stacks/both.yaml").read_text()
    file = folder / "by_hand.yaml"
    file.write_text(text.replace("    restart: true\n", ""))
    return file


def beats_of(bus, pids, since):
    return {m.pid for _, m in bus.messages("HEARTBEAT", since) if m.pid in pids and m.state >= 1}


def active(bus):
    """run id of the source that holds STATE now, or None."""
    at, state = bus.newest("STATE")
    return state.run_id if state is not None and time.monotonic_ns() - at < 200_000_000 else None


def one_round(stack, bus, checks, rng, number):
    bus.forget()
    time.sleep(0.3)
    holder = active(bus)
    names = rng.sample(list(PROGRAMS), 2)
    for name in names:
        os.kill(stack.pid(PROGRAMS[name]), signal.SIGKILL)
    time.sleep(0.1 + 0.3 * rng.random())
    for name in names:
        status, _, said = cli("restart", name)
        checks.that(status == 0, f"round {number}: restart {name}: {said}")
    started = time.monotonic_ns()
    pids = {stack.pid(PROGRAMS[name]) for name in PROGRAMS}
    ready = set()
    while ready < pids and time.monotonic_ns() - started < 5e9:
        time.sleep(0.02)
        ready = beats_of(bus, pids, started)
    took = 1e-9 * (time.monotonic_ns() - started)
    missing = [name for name in PROGRAMS if stack.pid(PROGRAMS[name]) not in ready]
    checks.at_most(took, 2.0, f"round {number}: {' and '.join(names)}: seconds from the last start to ready{missing or ''}")
    time.sleep(0.4)
    now = active(bus)
    checks.that(now in (None, holder), f"round {number}: nobody took STATE by himself")
    if now is None or "controller" in names:
        # A source that lost its controller is stopped until somebody clears it, or follows the stop plan until another one takes over.
        _, state = bus.newest("STATE")
        if now is not None:
            led = any(s.plan_number for _, s in bus.messages("STATE"))
            checks.that(state.stop_kind >= 2 or led, f"round {number}: without its controller the source stopped")
    return took


def go_on(bus):
    """An operator brings the stack back: clears a stop, or activates the simulator."""
    if active(bus) is None:
        time.sleep(1.0)  # sources listen first
        cli("switch", "sim")
    else:
        cli("clear")


def main():
    harness.require("twinbus", "emulated_robot", *PROGRAMS.values())
    seed = int(os.environ.get("RESTART_SEED", random.randrange(1 << 30)))
    print(f"RESTART_SEED={seed}")
    rng = random.Random(seed)
    checks = Checks()
    worst = 0.0
    with tempfile.TemporaryDirectory() as name:
        with Stack("stand", "--stack", stack_without_restarts(pathlib.Path(name)), "--no-viewer") as stack:
            bus = Bus()
            up = stack.process.pid
            for number in range(ROUNDS):
                worst = max(worst, one_round(stack, bus, checks, rng, number))
                go_on(bus)
            bus.close()
    left = [program for program in PROGRAMS.values() for stat in pathlib.Path("/proc").glob("[0-9]*/stat")
            if left_behind(stat, program, up)]
    checks.that(not left, f"no process is left behind: {left}")
    print(f"{ROUNDS} rounds, ready at the latest {worst:.2f} s after the last start")
    checks.exit()


def left_behind(stat, program, up):
    """A process of this stack that outlived it: its parent is gone or was our launcher."""
    try:
        fields = stat.read_text().rsplit(")", 1)[1].split()
        name = pathlib.Path(os.readlink(stat.parent / "exe")).name
        namespace = os.readlink(stat.parent / "ns/net")
    except (OSError, IndexError):
        return False
    return name == program and fields[0] not in "ZX" and namespace == os.readlink("/proc/self/ns/net")


if __name__ == "__main__":
    main()
