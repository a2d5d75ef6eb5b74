#!/usr/bin/env python3
"""Engine mujoco beside ours and beside the hardware bridge, on the bus: our controller stands, sways and squats while it is switched
from the one to the other.  A switch to the bridge is judged as those of our own engine are (switch_test.py).  One to MuJoCo is judged by
ticks and balance: its ground is not shifted below a sole until the contact forces of the robot go on, as that of our engines is (World::
set_corner_offset), and in the middle of a sway a foot then feels up to 18 % of the weight from tick to tick.

Skipped (exit status 77) where MuJoCo is not installed; what is said then is checked all the same.
"""

import math
import random
import sys
import time

import harness
from harness import Bus, Checks, Stack, cli
from stalls import Stalls
from switch_figures import judge, judge_continuity
from switch_test import Row

SWITCHES = 6
TO_BRIDGE_AND_BACK = 20 if harness.FULL else 4
LARGEST_TILT = math.radians(3.0)


def tilt(state):
    w, x, y, z = state.attitude
    return math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y))))


def is_there(checks):
    """Whether run finds MuJoCo; if not, its sentence."""
    status, out, err = cli("run", "stand", "--for", "1", "--engine", "mujoco")
    said = out + err
    if "no library of MuJoCo is found" in said:
        checks.that(status == 1 and "pip install mujoco" in said and "TWINBUS_MUJOCO" in said, f"the remedy is said: {said.strip()}")
        return False
    checks.that(status == 0, f"run stand --engine mujoco: {said.strip()}")
    status, out, err = cli("run", "stand", "--for", "1", "--engine", "mujoco", "--set", "contact=patch")
    checks.that(status == 1 and "contact patch" in err, f"a contact that it does not know is refused: {err.strip()}")
    return True


def switched(checks, scene):
    with Stack(scene, "--stack", "mujoco", "--no-viewer"):
        bus = Bus()
        time.sleep(2.0)
        runs, worst = set(), 0.0
        for number in range(SWITCHES):
            status, out, err = cli("switch", "sim", "--policy", "now", timeout=40)
            checks.that(status == 0, f"{scene}: switch {number}: {(out + err).strip()}")
            time.sleep(1.0)
            states = [state for _, state in bus.messages("STATE")]
            if not checks.that(bool(states) and states[-1].stop_kind == 0, f"{scene}: not stopped after switch {number}"):
                print("\n".join(harness.story_of_a_stop(bus)), flush=True)
            runs.update(state.run_id for state in states)
            worst = max([worst] + [tilt(state) for state in states])
            bus.forget()
        checks.that(len(runs) == 2, f"{scene}: {len(runs)} simulators were heard, 2 asked")
        checks.at_most(worst, LARGEST_TILT, f"{scene}: tilt")
        print(f"{scene}: {SWITCHES} switches, largest tilt {math.degrees(worst):.2f} degrees", flush=True)
        bus.close()


def beside_the_bridge(checks, motion, stalls):
    all_figures = []
    Row(checks, motion, TO_BRIDGE_AND_BACK, all_figures, random.Random(1), stalls, twosims=False, engine="mujoco",
        judge_of=lambda target: judge if target == "bridge" else judge_continuity).run()
    checks.at_least(len(all_figures), TO_BRIDGE_AND_BACK, f"{motion}: switches between mujoco and the bridge")


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    checks = Checks()
    if not is_there(checks):
        print("skipped: MuJoCo is not installed (pip install mujoco, or TWINBUS_MUJOCO)")
        if checks.failed:
            checks.exit()
        sys.exit(77)
    for scene in ("stand", "sway"):
        switched(checks, scene)
    stalls = Stalls()
    for motion in ("sway", "squat"):
        beside_the_bridge(checks, motion, stalls)
    stalls.close()
    checks.exit()


if __name__ == "__main__":
    main()
