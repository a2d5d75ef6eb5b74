#!/usr/bin/env python3
"""An arm moves past obstacles while the source is switched: between two simulators, and to a robot behind the bridge.

The path goes on under the new source and is done, no joint jumps, and nothing touches.  The arm is proposed from its URDF, unedited.

    arm_switch_test.py [FILE.urdf ...]
"""

import os
import pathlib
import sys
import tempfile
import time

import harness
from harness import ROOT, Bus, Checks, Stack, cli

DATA = pathlib.Path(os.environ.get("TWINBUS_DATA", ROOT.parent / "shared/data")) / "robots"
SCENE = """lengths: arm
duration: 90
start_pose: half_sitting
obstacles:
  - {shape: box, size: [0.5, 0.8, 0.02], position: [0.6, 0, -0.1]}
  - {shape: cylinder, size: [0.02, 0.5], position: [0.42, 0.35, 0]}
modes:
  - {at: 0, mode: hold}
goals:
  - {at: 2, hand: right, reach: [0.5, 0.1, 0.25], speed: 0.1}
"""
PLANNER = """  planner:
    program: twinbus_planner
    arguments: ["{robot}", "{bus}"]
    restart: true
    required: false
"""
FOLLOWING, DONE = 1, 2  # arm_state
IN_COLLISION = 3        # verdict of GUARD
JUMP = 0.02             # of a joint from tick to tick, at most [rad]
STILL = 0.01            # and from its set-point where the path ends [rad]


def moves_on(checks, robot, scene, stack, targets):
    what = f"{robot.name}, {pathlib.Path(stack).stem}"
    with Stack(scene, "--robot", robot, "--stack", stack, "--no-viewer", "--for", 100) as up:
        bus = Bus()
        since = time.monotonic_ns()
        _, began = bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_state == FOLLOWING, 20)
        if not checks.that(began is not None, f"{what}: the arm moves: {''.join(up.lines[-6:])}"):
            return
        for target in targets:
            time.sleep(0.5)
            checks.that(cli("switch", target, "--policy", "now")[0] == 0, f"{what}: switched to {target}")
        time.sleep(0.5)
        _, ended = bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_state == DONE, 60)
        time.sleep(0.5)
        moving = {s.run_id for _, s in bus.messages("CONTROLLER_STATUS", since) if s.arm_state == FOLLOWING and s.arm_path_id == began.arm_path_id}
        checks.that(len(moving) >= 2, f"{what}: one path was followed under {len(moving)} sources")
        checks.that(ended is not None, f"{what}: and to its end")
        states = [s for _, s in bus.messages("STATE", since)]
        jump = max(abs(b.q[k] - a.q[k]) for a, b in zip(states, states[1:]) for k in range(b.joint_count))
        checks.at_most(jump, JUMP, f"{what}: largest step of a joint [rad]")
        _, last = bus.newest("COMMAND")
        off = max(abs(last.q[k] - states[-1].q[k]) for k in range(states[-1].joint_count))
        checks.at_most(off, STILL, f"{what}: joints from where they were sent [rad]")
        touching = [g for _, g in bus.messages("GUARD", since) if g.verdict == IN_COLLISION]
        checks.that(not touching, f"{what}: touched in {len(touching)} ticks")
        checks.that(not any("started again" in line for line in up.lines), f"{what}: no process was started again")
        print(f"{what}: {len(moving)} sources, largest step {1e3 * jump:.2f} mrad, {1e3 * off:.2f} mrad off at the end")
        bus.close()


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    files = [pathlib.Path(word) for word in sys.argv[1:]] or [DATA / "panda/panda.urdf"]
    if not files[0].is_file():
        print(f"skipped: {files[0]} is not there")
        sys.exit(harness.SKIPPED)
    checks = Checks()
    with tempfile.TemporaryDirectory() as scratch:
        scene = pathlib.Path(scratch) / "arm_moves.yaml"
        scene.write_text(SCENE)
        twosims = pathlib.Path(scratch) / "twosims_planner.yaml"
        twosims.write_text((ROOT / "config/stacks/twosims.yaml").read_text() + PLANNER)
        for file in files:
            robot = pathlib.Path(scratch) / file.stem
            _, out, err = cli("check", file, "--propose", robot, timeout=180)
            if checks.that((robot / "robot.yaml").is_file(), f"{file.name} is proposed: {out[-300:]}{err}"):
                moves_on(checks, robot, scene, twosims, ("sim", "sim"))
                moves_on(checks, robot, scene, "both", ("bridge",))
    checks.exit()


if __name__ == "__main__":
    main()
