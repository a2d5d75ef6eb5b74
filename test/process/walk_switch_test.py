#!/usr/bin/env python3
"""The source is switched while the robot walks: simulator to simulator in mid-step, and by way of the shortest stop to a robot.

    walk_switch_test.py [engines] [robot]

`engines`: two simulators with different engines, masses and contacts, switched every 3 s of a walk.  `robot`: a
walking simulator is left for a stand-in robot with policy when-safe, which walks on until it is left for the simulator.
SWITCHES=N says how many, each way (TWINBUS_FULL=1: 50, otherwise 4 and 1).  Before every second switch of `engines` the whole
stack stands still for 20 to 150 ms, as on a machine that is late.  Every switch is judged: a stall excuses ticks without a
command and what the walk's taking up again changes, but no refused switch, no stop and no fall.
"""

import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import harness
import switch_figures
from harness import BIN, Bus, Checks, Stack, cli
from stalls import Stalls
from switch_figures import WEIGHT, foot_force
from switch_test import switch_once

SPEED = "0.3"  # [m/s]
STEP = 0.6     # [s], of hrp1s
EVERY = 3.0    # [s], between two switches
NORMAL = 8.0   # [s] of walking that is the measure of commanded accelerations
IN_AIR = 0.005  # share of the weight below which a foot is in the air
LEGS = [*range(6), *range(13, 19)]  # on the bus of hrp1s
FOR_SWITCH = 9  # STOP.reason
PERIOD_MS = 2.0
LOOPS = ("twinbus_controller", "twinbus_guard", "twinbus_simulator")
STANDS_NS = 250_000_000  # on both feet: no double support lasts so long


def count(fast, full):
    return int(os.environ.get("SWITCHES", full if harness.FULL else fast))


def two_engines():
    """The stack of two simulators, the second with the other engine as well."""
    text = (harness.ROOT / "config/stacks/twosims.yaml").read_text(encoding="utf-8")
    head, second = text.split("  second:\n")
    assert '"{engine}"' in second
    file = pathlib.Path(tempfile.mkdtemp()) / "twoengines.yaml"
    file.write_text(head + "  second:\n" + second.replace('"{engine}"', '"--engine", "ode"', 1), encoding="utf-8")
    return str(file)


def walk(seconds):
    return subprocess.Popen([BIN / "twinbus", "walk", SPEED, "0", "0", "--for", str(seconds)],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def fastest_change(bus, since_ns, until_ns=1 << 62):
    """Largest change of a leg joint's commanded velocity from one tick to the next [rad/s^2]."""
    most, where, last = 0.0, "", None
    for at, command in bus.messages("COMMAND", since_ns, until_ns):
        if last is not None and command.tick == last.tick + 1:
            change, joint = max((abs(command.qd[k] - last.qd[k]) / 0.002, k) for k in LEGS)
            if change > most:
                most, where = change, f"joint {joint}, {(at - since_ns) * 1e-6:.0f} ms on"
        last = command
    return most, where


def stand_still(stack, seconds):
    """The machine stands still: every loop of the stack at once."""
    loops = [pid for program in LOOPS for pid in stack.pids(program)]
    for pid in loops:
        os.kill(pid, signal.SIGSTOP)
    time.sleep(seconds)
    for pid in loops:
        os.kill(pid, signal.SIGCONT)


def engines(checks, stalls, rng):
    wanted, worst, hit = count(4, 50), 0.0, 0
    with Stack("walk_switch", "--stack", two_engines(), "--no-viewer") as stack:
        bus = Bus()
        time.sleep(5.0)
        bus.forget()
        time.sleep(NORMAL)
        normal, _ = fastest_change(bus, 0)
        print(f"normal walking changes commanded velocities by up to {normal:.0f} rad/s^2", flush=True)
        efforts = harness.effort_limits()
        for number in range(wanted):
            what = f"walking, switch {number}"
            began = time.monotonic_ns()
            time.sleep(EVERY - 1.0 + 0.6 * rng.random())
            planted = 0.02 + 0.13 * rng.random() if number % 2 == 1 else 0.0
            if planted > 0.0:
                stand_still(stack, planted)
            status, said, f = switch_once(bus, "sim", efforts)
            stall = max(stalls.longest_ms(began, time.monotonic_ns()), 1e3 * planted)
            if not checks.that(status == 0 and f is not None, f"{what}: {said.strip()}, the machine stood still for {stall:.1f} ms"):
                print("".join(stack.lines[-8:]) + "\n".join(harness.story_of_a_stop(bus)), flush=True)
                break
            change, where = fastest_change(bus, f.from_ns + switch_figures.BEFORE_NS - 20_000_000)
            checks.that(not f.fell, f"{what}: nobody falls")
            checks.that(not any(s.stop_kind for _, s in bus.messages("STATE", f.from_ns)), f"{what}: nothing stops")
            checks.that(f.double_ticks == 0 and f.two_obeying == 0, f"{what}: two sources at once")
            checks.at_most(f.gap_ticks, 1, f"{what}: ticks nobody published")
            checks.at_least(change, 0.2 * normal, f"{what}: the robot goes on walking, commanded acceleration [rad/s^2]")
            late = stalls.longest_ms(f.from_ns, f.to_ns)
            led = any(s.plan_number for _, s in bus.messages("STATE", f.from_ns, f.to_ns))
            if late >= PERIOD_MS or led:
                hit += 1
            else:
                checks.that(f.ticks_without_command == 0, f"{what}: {f.ticks_without_command} ticks without a command")
                checks.at_most(change, 1.5 * normal, f"{what}: commanded acceleration [rad/s^2]")
                worst = max(worst, change)
            print(f"{what}: {f.row()}, commanded acceleration {change:.0f} rad/s^2 ({where}); the machine stood still for "
                  f"{stall:.1f} ms before{f', {late:.1f} ms at the switch' if late > 0.0 else ''}{', a stop plan led' if led else ''}",
                  flush=True)
        else:
            number += 1
        checks.at_least(number, wanted, "switches while walking")
        print(f"{number} of {wanted} switches while walking, {hit} of them hit by a stall; otherwise commanded acceleration at most "
              f"{worst / max(normal, 1e-9):.2f} of normal walking", flush=True)
        bus.close()


def steps_after_stop(bus, since_ns, until_ns):
    """(steps from the stop that was asked for until both feet carried the robot for longer than any double support, and
    until they did for good: the feet come side by side before the switch)"""
    asked = next((at for at, m in bus.messages("STOP", since_ns, until_ns) if m.reason == FOR_SWITCH), None)
    if asked is None:
        return None, None
    last, stood = asked, None
    for at, state in bus.messages("STATE", asked, until_ns):
        if at - last > STANDS_NS and stood is None:
            stood = last
        if min(foot_force(state, 0), foot_force(state, 1)) < IN_AIR * WEIGHT:
            last = at
    return ((last if stood is None else stood) - asked) * 1e-9 / STEP, (last - asked) * 1e-9 / STEP


def robot(checks, stalls, rng):
    """The walking source is stopped and left, the other one walks on, and so back and forth."""
    wanted, hit, most = 2 * count(1, 50), 0, 0.0
    with Stack("stand", "--stack", "both", "--no-viewer") as stack:
        bus = Bus()
        time.sleep(1.0)
        efforts = harness.effort_limits()
        for first in ("bridge", "sim"):  # from then on the robot follows the simulator while both stand
            status, out, err = cli("switch", first, "--policy", "now", timeout=40)
            if not checks.that(status == 0, f"standing, to {first}: {out}{err}"):
                return
            time.sleep(2.5)
        for number in range(wanted):
            target = "bridge" if number % 2 == 0 else "sim"
            what = f"stop and switch {number} to the {'robot' if target == 'bridge' else 'simulator'}"
            bus.forget()
            walker = walk(30)
            time.sleep(2.6 + 1.2 * rng.random())
            since = time.monotonic_ns()
            walked = any(min(foot_force(s, 0), foot_force(s, 1)) < IN_AIR * WEIGHT
                         for _, s in bus.messages("STATE", since - 1_200_000_000, since))
            status, said, f = switch_once(bus, target, efforts, "when-safe")
            walker.terminate()
            walker.wait()
            if not checks.that(status == 0 and f is not None, f"{what}: {said.strip()}"):
                print("".join(stack.lines[-8:]) + "\n".join(harness.story_of_a_stop(bus, stalls=stalls)), flush=True)
                break
            taken, settled = steps_after_stop(bus, since, f.from_ns + switch_figures.BEFORE_NS)
            late = stalls.longest_ms(f.from_ns, f.to_ns)
            led = any(s.plan_number for _, s in bus.messages("STATE", since, f.to_ns))
            checks.that(walked, f"{what}: the robot walks before")
            checks.that(not f.fell, f"{what}: nobody falls")
            checks.that(taken is not None, f"{what}: the controller was asked to stop first")
            print(f"{what}: {taken if taken is not None else -1:.2f} steps until it stands, "
                  f"{settled if settled is not None else -1:.2f} until its feet are side by side, {f.row()}"
                  f"{f'; the machine stood still for {late:.1f} ms' if late > 0.0 else ''}{', a stop plan led' if led else ''}", flush=True)
            if late >= PERIOD_MS or led:
                hit += 1
                continue
            switch_figures.judge(f, checks, what)
            checks.at_most(taken if taken is not None else 99.0, 1.5, f"{what}: steps until it stands")
            most = max(most, taken or 0.0)
        else:
            number += 1
        checks.at_least(number, wanted, "stops, switches and walks on")
        print(f"{number} of {wanted} switches after a stop, {hit} of them hit by a stall; otherwise at most {most:.2f} steps", flush=True)
        bus.close()


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_bridge",
                    "emulated_robot")
    words = sys.argv[1:]
    seed = random.randrange(1 << 30)
    print(f"seed {seed}", flush=True)
    rng = random.Random(seed)
    checks = Checks()
    stalls = Stalls()
    if not words or "engines" in words:
        engines(checks, stalls, rng)
    if not words or "robot" in words:
        robot(checks, stalls, rng)
    stalls.close()
    checks.exit()


if __name__ == "__main__":
    main()
