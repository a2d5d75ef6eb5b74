#!/usr/bin/env python3
"""Arms commanded into the body (row l): the guard stops them before contact while the controller still asks, and the
robot keeps standing.  Without a guard the arms are held.
"""

import contextlib
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, ROOT, Bus, Checks, Stack, cli, text_of
from postures import Postures

LEFT_ARM = range(19, 26)  # bus joints of hrp1s
ARM_BITS = sum(1 << joint for joint in (*range(6, 13), *LEFT_ARM))
INTO = {20: -0.26, 21: -1.5, 22: -1.8}  # the left forearm through the trunk [rad]
ELBOW = 22

# A simulator that requires the guard, and a controller of the test's own.
STACK = """
about: a simulator that requires the guard, for a controller that has none
activate: simulator
processes:
  simulator:
    program: twinbus_simulator
    arguments: ["{scene}", "{robot}", "{bus}", "{pace}", "{engine}", "{settings}", "--guard-required"]
    ready: STATE_SIM
  guard:
    program: twinbus_guard
    arguments: ["{robot}", "{bus}"]
    restart: true
    required: false
"""


@contextlib.contextmanager
def hostile(what):
    child = subprocess.Popen([sys.executable, ROOT / "test/process/hostile_arm.py", what], stdout=subprocess.PIPE, text=True)
    try:
        child.stdout.readline()
        yield child
    finally:
        child.terminate()
        child.wait(5)


def judge(checks, what, bus, since, still_asking):
    """Nothing touched since then, the arm is at rest though more is asked for, and the robot stands."""
    postures = Postures(bus, since)
    nearest = min(postures.self_distance, default=0.0)
    print(f"{what}: nearest {1e3 * nearest:.1f} mm in {len(postures.rows)} postures, ZMP margin {1e3 * postures.zmp_margin:.0f} mm")
    checks.that(len(postures.rows) > 100, f"{what}: {len(postures.rows)} postures were recorded")
    checks.at_least(nearest, 0.002, f"{what}: nearest self distance [m]")
    checks.that(postures.touching == 0, f"{what}: FCL finds {postures.touching} postures touching")
    checks.that(not postures.fell, f"{what}: the robot stands")
    checks.at_least(postures.zmp_margin, 0.010, f"{what}: ZMP margin [m]")
    last = postures.rows[-1][1]
    checks.at_most(max(abs(last.qd[joint]) for joint in LEFT_ARM), 0.02, f"{what}: the arm is at rest [rad/s]")
    if still_asking:
        _, command = bus.newest("COMMAND")
        farthest = max(abs(command.q[joint] - last.q[joint]) for joint in INTO)
        checks.at_least(farthest, 0.1, f"{what}: and more is still asked for [rad]")
    return postures


def forged_path(bus, state, joints):
    """Half a metre into the trunk in 1.6 s, as no planner would send it."""
    path = harness.type_of("ARM_PATH")()
    path.planner_id, path.run_id, path.goal_id = 4711, state.run_id, random.getrandbits(40)
    path.path_id = random.getrandbits(40)
    path.piece, path.pieces, path.joint_count, path.knot_count = 0, 1, len(joints), 2
    path.joint = tuple(joints) + (0,) * (12 - len(joints))
    _, command = bus.newest("COMMAND")
    start = [command.q[joint] for joint in LEFT_ARM]
    end = [INTO.get(joint, command.q[joint]) for joint in LEFT_ARM]
    rest = (0.0,) * 12
    path.time = (0.0, 1.6, 0, 0, 0, 0)
    path.q = [start + [0.0] * 5, end + [0.0] * 5] + [rest] * 4
    path.qd = [rest] * 6
    return path


def arm_path_into_the_body(checks):
    """The controller follows a path that nobody planned; its own guard or the other one stops the arm."""
    with Stack("stand", "--no-viewer"):
        bus = Bus()
        time.sleep(1.5)
        cli("reach", "left", 0.35, 0.25, 0.80)  # also says what the planner calls the joints
        _, answer = bus.newest("ARM_PATH", look_back=1 << 30)
        if not checks.that(answer is not None and answer.pieces > 0, "the planner answers"):
            return
        joints = answer.joint[:answer.joint_count]
        time.sleep(0.5)
        _, state = bus.newest("STATE")
        before = time.monotonic_ns()
        path = forged_path(bus, state, joints)
        for _ in range(3):
            path.utime = time.time_ns() // 1000
            bus.send("ARM_PATH", path)
            time.sleep(0.02)
        time.sleep(3.5)
        judge(checks, "forged arm path", bus, before, False)
        statuses = [s for _, s in bus.messages("CONTROLLER_STATUS", before)]
        checks.that(any(s.arm_state == 1 for s in statuses), "forged arm path: it was followed at first")
        stopped = any(s.arm_state == 3 for s in statuses) or any(g.hold_mask & ARM_BITS for _, g in bus.messages("GUARD", before))
        checks.that(stopped, "forged arm path: and stopped by a guard")
        status, out, err = cli("reach", "left", 0.35, 0.25, 0.80)
        checks.that(status == 0, f"the arm can be moved away afterwards: {out}{err}")
        bus.close()


def controller_without_a_guard(checks, stack_file):
    with hostile("into"), Stack("stand", "--stack", stack_file, "--no-viewer", "--for", 60):
        bus = Bus()
        before = time.monotonic_ns()
        time.sleep(5.0)
        judge(checks, "direct commands", bus, before, True)
        guards = [g for _, g in bus.messages("GUARD", before)]
        checks.that(bool(guards) and guards[-1].hold_mask & ARM_BITS != 0, "direct commands: GUARD masks joints of the arm")
        checks.that(bool(guards) and guards[-1].hold_mask & ~ARM_BITS & 0x3FFFFFF == 0, "direct commands: and no leg")
        checks.that(any("guard holds" in text_of(e) for _, e in bus.messages("EVENT", before)),
                    "direct commands: an event says who comes too near whom")
        bus.close()


def guard_killed(checks, stack_file):
    """The gate holds the arms from 30 ms after the last report until reports come again."""
    with hostile("swing"), Stack("stand", "--stack", stack_file, "--no-viewer", "--for", 60) as stack:
        bus = Bus()
        time.sleep(3.0)
        pid = stack.pid("twinbus_guard")
        os.kill(pid, signal.SIGSTOP)  # as dead as by kill -9, until it is let go on
        at = time.monotonic_ns()
        time.sleep(1.2)
        os.kill(pid, signal.SIGCONT)
        back = time.monotonic_ns()
        time.sleep(1.5)

        def moved(since, until):
            q = [s.q[ELBOW] for _, s in bus.messages("STATE", since, until)]
            return max(q) - min(q) if q else float("nan")

        ms = 1_000_000
        checks.at_least(moved(at - 1000 * ms, at), 0.2, "guard there: the elbow swings [rad]")
        # 30 ms time-out, then braking within the joint's limits; at rest well before 0.3 s.
        checks.at_most(moved(at + 300 * ms, back), 0.01, "guard silent: the arm is held [rad]")
        checks.at_least(moved(back + 200 * ms, back + 1500 * ms), 0.2, "guard back: it swings again [rad]")
        os.kill(stack.pid("twinbus_guard"), signal.SIGKILL)
        time.sleep(2.0)
        since = time.monotonic_ns() - 1000 * ms
        checks.that(any(True for _ in bus.messages("GUARD", since)), "guard killed: `up` starts another one")
        checks.at_least(moved(since, since + 1000 * ms), 0.2, "and the arm swings again [rad]")
        postures = Postures(bus, at)
        checks.that(not postures.fell and postures.touching == 0, "guard killed: the robot stands and touches nothing")
        bus.close()


def main():
    harness.require(*harness.STACK, "posture_probe")
    checks = Checks()
    arm_path_into_the_body(checks)
    with tempfile.TemporaryDirectory() as folder:
        stack_file = pathlib.Path(folder) / "no_controller.yaml"
        stack_file.write_text(STACK)
        controller_without_a_guard(checks, stack_file)
        guard_killed(checks, stack_file)
    checks.exit()


if __name__ == "__main__":
    main()
