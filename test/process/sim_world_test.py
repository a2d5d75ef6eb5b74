#!/usr/bin/env python3
"""What only a simulated world can do, from the command line: a push, pause, single ticks, slow motion, beginning anew.

A pause is no silence: nothing stops and nobody alarms, however long it lasts.
"""

import subprocess
import sys
import time

import harness
from harness import Bus, Checks, Stack, cli


BALANCE = 4  # mode of CONTROLLER_STATUS


def states(bus):
    return sum(1 for _ in bus.messages("STATE"))


def refused(checks, bus, *expected):
    """A reach that cannot be: nothing is asked of the planner."""
    start = len(bus.records)
    status, _, problem = cli("reach", "left", "0.35", "0.25", "0.75")
    asked = sum(1 for _ in bus.messages("ARM_GOAL", start=start))
    checks.that(status == 1 and asked == 0 and all(words in problem for words in expected), f"reach: {problem}, {asked} goals")


def robot_begins_anew(checks, name):
    """A stand-in robot behind the bridge that has fallen stands again, with its source active and no stop left."""
    bus = Bus()
    checks.that(cli("stop", "off")[0] == 0, f"{name}: stop off")
    _, lies = bus.wait_for("STATE", lambda s: 1 - 2 * (s.attitude[1] ** 2 + s.attitude[2] ** 2) < 0.5, 15.0)
    checks.that(lies is not None, f"{name}: it falls")
    time.sleep(1.0)
    said = cli("status")[1]
    checks.that("a stand-in robot: ./twinbus sim reset" in said, f"{name}: status names the way out: {said[:300]}")
    run = bus.newest("STATE")[1].run_id
    status, said, problem = cli("sim", "reset", timeout=60)
    checks.that(status == 0 and "begun anew, and the stand-in robot with it" in said, f"{name}: reset: {said}{problem}")
    time.sleep(1.5)
    state, controller = bus.newest("STATE")[1], bus.newest("CONTROLLER_STATUS")[1]
    checks.that(state.run_id != run and state.source == 2 and state.stop_kind == 0, f"{name}: a new bridge is active: {state.source} {state.stop_kind}")
    checks.that(state.attitude[0] > 0.99 and controller.mode == BALANCE, f"{name}: and balances: {state.attitude[0]:.3f}, mode {controller.mode}")
    said = cli("status")[1]
    checks.that("lies" not in said and "stopped" not in said, f"{name}: nothing is left to act on: {said[:300]}")
    bus.close()


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard")
    checks = Checks()
    with Stack("stand", "--no-viewer") as stack:
        bus = Bus()
        time.sleep(1.5)
        status, said, problem = cli("push", "CHSET", "40", "0", "0")
        checks.that(status == 2 and "did you mean CHEST?" in problem, f"a link that is misspelt: {said}{problem}")
        status, said, problem = cli("push", "CHEST", "40", "0", "0", "--robot", "table")
        checks.that(status == 1 and "the robot that runs is not table" in problem, f"a link of another robot: {said}{problem}")
        status, said, problem = cli("push", "CHEST", "40", "0", "0", "--for", "0.2")
        checks.that(status == 0 and "CHEST is pushed with 40 0 0 N" in said, f"push: {said}{problem}")
        _, pushed = bus.wait_for("TRUTH", lambda t: abs(t.push_force[0] - 40) < 0.1, 3.0, start=0)
        checks.that(pushed is not None, "the truth has the force")
        time.sleep(0.6)
        forces = [t for _, t in bus.messages("TRUTH") if t.push_force[0] > 1]
        checks.that(abs(len(forces) - 100) <= 2, f"for 0.2 s: {len(forces)} ticks")

        checks.that(cli("sim", "pause")[0] == 0, "pause")
        time.sleep(0.3)
        before = states(bus)
        time.sleep(1.5)
        checks.that(states(bus) == before, "no tick while it is paused")
        status, said, _ = cli("status")
        checks.that(status == 0, f"it is there all the same: {said[:200]}")
        for words in (("walk", "0.3", "0", "0"), ("sway",), ("pose", "CHEST=0.1"), ("mode", "walk"), ("reach", "left", "0.3", "0.2", "0.9"),
                      ("push", "CHEST", "40", "0", "0")):
            status, _, problem = cli(*words)
            checks.that(status == 1 and "is paused: ./twinbus sim go" in problem, f"{words[0]} while it is paused: {problem}")
        checks.that(cli("sim", "step", "25")[0] == 0, "25 ticks")
        time.sleep(0.8)
        checks.that(states(bus) == before + 25, f"they came: {states(bus) - before}")
        checks.that(cli("sim", "go")[0] == 0, "it goes on")
        time.sleep(1.0)
        ticks = [s.tick for _, s in bus.messages("STATE")]
        checks.that(ticks == list(range(ticks[0], ticks[0] + len(ticks))), "no tick is left out")
        checks.that(bus.newest("STATE")[1].stop_kind == 0, "and nothing has stopped the robot")
        late = [t for _, t in bus.messages("TRUTH", time.monotonic_ns() - 900_000_000) if t.push_force[0] > 1]
        checks.that(not late, f"nor is it pushed later: {len(late)} ticks")
        controller = bus.newest("CONTROLLER_STATUS")[1]
        checks.that(controller.mode == BALANCE and controller.motion == 0, f"nor does it what was asked meanwhile: {controller.mode}")

        checks.that(cli("sim", "pace", "0.2")[0] == 0, "five times slower")
        time.sleep(0.3)
        before = states(bus)
        time.sleep(2.0)
        checks.that(120 <= states(bus) - before <= 280, f"200 ticks in two seconds: {states(bus) - before}")
        heard = len(stack.lines)
        checks.that(cli("sim", "pace", "5")[0] == 0, "five times faster")
        time.sleep(8.0)  # a process and its channels are watched after five seconds
        alarms = [line for line in stack.lines[heard:] if "are missing" in line or "hears nothing" in line]
        checks.that(not alarms, f"nobody is blamed for not keeping up: {''.join(alarms)}")
        checks.that(cli("sim", "pace", "1")[0] == 0, "real time again")
        time.sleep(3.0)
        alarms = [line for line in stack.lines[heard:] if "are missing" in line or "hears nothing" in line]
        checks.that(not alarms, f"nor for what was before: {''.join(alarms)}")

        checks.that(cli("sim", "pause")[0] == 0, "pause")
        status, said, problem = cli("stop")
        checks.that(status == 0 and "stops with its next tick" in said, f"a stop in a pause is taken: {said}{problem}")
        status, _, problem = cli("clear")
        checks.that(status == 1 and "is paused" in problem, f"clear in a pause: {problem}")
        checks.that("is paused: ./twinbus sim go" in cli("status")[1], "status says that it is paused")
        checks.that(cli("sim", "go")[0] == 0, "it goes on")
        time.sleep(0.5)
        checks.that(bus.newest("STATE")[1].stop_kind != 0, "and stops")
        refused(checks, bus, "is stopped (", "clear ends that")
        checks.that(cli("clear")[0] == 0 and cli("mode", "balance")[0] == 0, "it is cleared")
        begin = time.monotonic()
        status, _, problem = cli("mode", "play")
        checks.that(status == 1 and "./twinbus motion FILE --play" in problem, f"mode play of a controller without a motion: {problem}")
        checks.at_most(time.monotonic() - begin, 2.0, "seconds until it says so")

        checks.that(cli("push", "CHEST", "900", "0", "0", "--for", "0.4")[0] == 0, "a push that nobody survives")
        checks.that(bus.wait_for("TRUTH", lambda t: t.fell, 6.0, start=0)[1] is not None, "it falls")
        checks.that(bus.wait_for("STATE", lambda s: s.stop_kind == 3, 8.0, start=0)[1] is not None, "and is let go: stop off is latched")
        time.sleep(0.3)
        source = bus.newest("SOURCE_STATUS")[1]
        checks.that(source.stop_reason == 10, f"with a reason of its own, fallen: {source.stop_reason}")
        told = [harness.text_of(e) for _, e in bus.messages("EVENT") if "the robot has fallen: " in harness.text_of(e)]
        checks.that(any("it was pushed with 900 N" in t for t in told), f"what led to it is said: {told}")
        refused(checks, bus, "has fallen: ./twinbus sim reset")
        heard = len(stack.lines)
        status, said, problem = cli("sim", "reset", timeout=60)
        checks.that(status == 0, f"reset: {said}{problem}")
        _, stands = bus.wait_for("STATE", lambda s: s.role == 2 and s.stop_kind == 0, 10.0)
        time.sleep(1.0)
        truth = bus.newest("TRUTH")[1]
        checks.that(stands is not None and not truth.fell and truth.base_position[2] > 0.5, "it stands again")
        told = [line for line in stack.lines[heard:] if " s  STATE" not in line]
        checks.that(len(told) <= 2 and any("has begun anew" in line for line in told), f"and that is said in a line: {''.join(told)}")

        for words, expected in ((("push", "CHES", "9", "0", "0"), "did you mean CHEST?"), (("sim", "paus"), "did you mean pause?"),
                                (("push", "CHEST", "9", "0"), "needs LINK FX FY FZ"), (("sim", "pace", "1000"), "X must be"), (("sim", "step", "0"), "TICKS"), (("sim", "step", "1.5"), "whole number")):
            status, _, problem = cli(*words)
            checks.that(status == 2 and expected in problem and problem.count("\n") == 1, f"{' '.join(words)}: {problem}")
        bus.close()
    client = subprocess.Popen([sys.executable, harness.ROOT / "examples/02_command_joints.py"], stdout=subprocess.DEVNULL)
    with Stack("stand", "--stack", "client_both", "--start-pose", "zero", "--no-viewer"):
        bus = Bus()
        for channel in ("STATE", "STATE_BRIDGE"):
            _, state = bus.wait_for(channel, lambda s: True, 5.0, start=0)
            checks.that(state is not None and abs(state.q[3]) < 0.1, f"{channel}: --start-pose zero has straight knees, {state and state.q[3]:.2f} rad")
        bus.close()
    client.terminate()
    client.wait()
    status, _, problem = cli("up", "stand", "--start-pose", "half_siting", "--no-viewer", "--for", "1")
    checks.that(status == 1 and "did you mean half_sitting?" in problem, f"a pose that is not there: {problem}")
    with Stack("stand", "--stack", "both", "--no-viewer"):
        time.sleep(1.0)
        checks.that(cli("switch", "bridge", "--policy", "now", timeout=40)[0] == 0, "the robot is active")
        for words in (("push", "CHEST", "40", "0", "0"), ("sim", "pause")):
            status, _, problem = cli(*words)
            checks.that(status == 1 and "not a simulator" in problem, f"{words[0]} a robot: {problem}")
        robot_begins_anew(checks, "bridge")
    with Stack("stand", "--stack", "bridge", "--no-viewer"):
        time.sleep(1.0)
        robot_begins_anew(checks, "bridge alone")
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
