#!/usr/bin/env python3
"""kill -9 of every process at random instants (row i): doc/protocol.md says what must happen, and it does.

TWINBUS_FULL=1 repeats each 20 times, otherwise once.  The seed is printed; KILL_SEED=N repeats a run.
"""

import os
import random
import signal
import tempfile
import time

import harness
from harness import Bus, Checks, Stack

REPEAT = 20 if harness.FULL else 1
COMMAND_TIMEOUT = 7  # reason of a stop
NAMES = ("controller", "active source", "standby", "guard", "planner", "viewer")


def settle(rng):
    time.sleep(0.6 + 0.4 * rng.random())


def falls(bus, since):
    return any(truth.fell for _, truth in bus.messages("TRUTH", since))


def controller(bus, stack, checks, rng):
    """The source follows the stop plan, of a robot that stands or moves; the controller that is started anew balances where it has
    ended."""
    before = time.monotonic_ns()
    os.kill(stack.pid("twinbus_controller"), signal.SIGKILL)
    _, led = bus.wait_for("STATE", lambda s: s.plan_number != 0, 1.0)
    checks.that(led is not None, "controller killed: the stop plan is followed")
    _, after = bus.wait_for("STATE", lambda s: s.plan_number == 0, 4.0)
    checks.that(after is not None and after.stop_kind == 0, "controller killed: another one takes the robot over, nothing latches")
    time.sleep(0.5)
    checks.that(not falls(bus, before), "controller killed: nobody falls")


def controller_for_good(bus, stack, checks, rng):
    """Nobody comes back: the source holds the standing robot by its plan, stops 1.12 to 1.16 s after the last command, and stays
    stopped."""
    time.sleep(3.0)  # until it has found its place
    before = time.monotonic_ns()
    os.kill(stack.pid("twinbus_controller"), signal.SIGKILL)
    at, state = bus.wait_for("STATE", lambda s: s.stop_kind >= 2, 4.0)
    if not checks.that(state is not None, "controller killed for good: the source stops"):
        return
    last_at, last = list(bus.messages("COMMAND", before - 1_000_000_000, at))[-1]
    # In ticks of 2 ms, which no late reading here blurs.  The plan is of one of the last commands, and says to stay for 0.16 s
    # and a second; one or two of them may have been lost.
    checks.that(1040 <= 2 * (state.tick - last.tick) <= 1170, "controller killed for good: STATE shows the stop "
                f"{2 * (state.tick - last.tick)} ms of ticks after the last command (1120 to 1170; 1040 where plans were lost)")
    _, status = bus.wait_for("SOURCE_STATUS", lambda s: s.stop_kind >= 2, 1.0)
    checks.that(status is not None and status.stop_reason == COMMAND_TIMEOUT, "controller killed for good: its reason is the command timeout")
    time.sleep(0.5)
    checks.that(not falls(bus, before), "controller killed for good: nobody falls")
    harness.cli("restart", "controller")
    time.sleep(1.0)
    _, state = bus.newest("STATE")
    checks.that(state.stop_kind >= 2, "controller killed for good: the stop stays although a new controller is there")


def active_source(bus, stack, checks, rng, standby_kind="STATE_BRIDGE"):
    """The standby does not start moving; nobody takes over by himself; the controller falls silent."""
    before = time.monotonic_ns()
    os.kill(stack.pid("twinbus_simulator"), signal.SIGKILL)
    time.sleep(0.3)
    since = time.monotonic_ns()
    time.sleep(0.4)
    states = [s for _, s in bus.messages("STATE", since)]
    checks.that(not states, f"active source killed: STATE falls silent, {len(states)} came")
    commands = list(bus.messages("COMMAND", since))
    checks.that(not commands, f"active source killed: COMMAND falls silent, {len(commands)} came")
    taken = [s for _, s in bus.messages(standby_kind, since) if s.role == 2]
    checks.that(not taken, "active source killed: the standby stays standby")
    checks.that(before > 0, "")


def kill(bus, stack, checks, program, what, wait=0.6):
    """Nothing happens to the active one; gives when it was [ns]."""
    before = time.monotonic_ns()
    os.kill(stack.pid(program), signal.SIGKILL)
    time.sleep(wait)
    unharmed(bus, checks, f"{what} killed", before)
    return before


def standby(bus, stack, checks, rng):
    kill(bus, stack, checks, "twinbus_bridge", "standby")


def stand_in(bus, stack, checks, rng):
    """The robot that only stands by is gone, and its bridge with it or not: the active source and the launcher go on."""
    kill(bus, stack, checks, "emulated_robot", "robot of the standby")
    time.sleep(1.0)
    checks.that(stack.process.poll() is None, "robot of the standby killed: the stack goes on")


def guard(bus, stack, checks, rng):
    """The arms are masked until a guard is back; the legs keep balance."""
    before = kill(bus, stack, checks, "twinbus_guard", "guard", wait=0.8)
    gap = [at for at, _ in bus.messages("GUARD", before - 100_000_000)]
    silence = max((b - a for a, b in zip(gap, gap[1:])), default=0)
    print(f"  guard silent for {1e-6 * silence:.0f} ms, then back")


def planner(bus, stack, checks, rng):
    kill(bus, stack, checks, "twinbus_planner", "planner")


def viewer(bus, stack, checks, rng):
    kill(bus, stack, checks, "twinbus_viewer", "viewer")


def unharmed(bus, checks, what, since):
    """STATE and COMMAND go on, nobody falls, nothing stops."""
    now = time.monotonic_ns()
    states = [s for _, s in bus.messages("STATE", since, now)]
    ticks = {s.tick for s in states}
    answered = {c.tick for _, c in bus.messages("COMMAND", since, now)}
    missing = len(ticks) - len(ticks & answered)
    # By their numbers: the newest may not have been read here yet.
    checks.that(len(states) > 0.8 * (now - since) / 2e6, f"{what}: STATE goes on, {len(states)} states")
    lost = max(ticks, default=0) - min(ticks, default=0) + 1 - len(ticks)
    checks.that(lost <= 2 + 0.01 * len(ticks), f"{what}: {lost} of {len(ticks)} ticks without a STATE")
    checks.that(missing <= 2 + 0.01 * len(ticks), f"{what}: {missing} of {len(ticks)} ticks without a command")
    checks.that(not falls(bus, since), f"{what}: nobody falls")
    checks.that(states and states[-1].stop_kind == 0 and states[-1].role == 2, f"{what}: the source stays active")


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    seed = int(os.environ.get("KILL_SEED", random.randrange(1 << 30)))
    print(f"KILL_SEED={seed}")
    rng = random.Random(seed)
    checks = Checks()
    with_viewer = (harness.BIN / "twinbus_viewer").exists()
    # Those that the stack survives share one stack; the others need a fresh one each time.
    for name, case in (("guard", guard), ("planner", planner), ("viewer", viewer)):
        if name == "viewer" and not with_viewer:
            continue
        done = 0
        while done < REPEAT:
            words = ["sway", "--stack", "both"] + ([] if name == "viewer" else ["--no-viewer"])
            with Stack(*words) as stack:
                bus = Bus()
                for _ in range(min(4, REPEAT - done)):  # `up` starts a process again at most 5 times
                    settle(rng)
                    bus.forget()
                    time.sleep(0.1)
                    case(bus, stack, checks, rng)
                    done += 1
                bus.close()
        print(f"{name}: {done} kills", flush=True)
    by_hand = tempfile.NamedTemporaryFile("w", suffix=".yaml")  # nothing is started anew by itself
    by_hand.write((harness.ROOT / "config/stacks/both.yaml").read_text().replace("    restart: true\n", ""))
    by_hand.flush()
    for name, scene, file, case in (("controller", "stand", "both", controller), ("controller in motion", "sway", "both", controller),
                                    ("controller for good", "stand", by_hand.name, controller_for_good),
                                    ("standby", "sway", "both", standby), ("robot of the standby", "sway", "both", stand_in),
                                    ("active source", "sway", "both", active_source)):
        for _ in range(REPEAT):
            with Stack(scene, "--stack", file, "--no-viewer") as stack:
                bus = Bus()
                settle(rng)
                case(bus, stack, checks, rng)
                bus.close()
        print(f"{name}: {REPEAT} kills", flush=True)
    checks.exit()


if __name__ == "__main__":
    main()
