#!/usr/bin/env python3
"""An arm that nobody has described: proposed, held, jogged by the keyboard (a joint, the hand, its turn), sent to places in other
frames and with a tool, its fingers opened and closed.  The arm is made here."""

import math
import pathlib
import re
import tempfile
import time

import harness
from gamepad_test import Keyboard
from harness import Bus, Checks, Stack, cli

POSE, POSE_GOAL, POSITION_GOAL = 3, 3, 2  # modes, kinds of arm_goal_t
BENT = "shoulder=0.5,elbow=1.0,wrist_tip=0.7"


def link(name, size, z, mass):
    x, y, h = size
    inertia = [mass / 12 * (y * y + h * h), mass / 12 * (x * x + h * h), mass / 12 * (x * x + y * y)]
    return (f"<link name='{name}'><inertial><origin xyz='0 0 {z}'/><mass value='{mass}'/><inertia ixx='{inertia[0]}' iyy='{inertia[1]}' "
            f"izz='{inertia[2]}' ixy='0' ixz='0' iyz='0'/></inertial><collision><origin xyz='0 0 {z}'/><geometry>"
            f"<box size='{x} {y} {h}'/></geometry></collision></link>")


def joint(name, kind, parent, child, xyz, axis, limit, more=""):
    return (f"<joint name='{name}' type='{kind}'><origin xyz='{xyz}'/><parent link='{parent}'/><child link='{child}'/><axis xyz='{axis}'/>"
            f"{limit}{more}</joint>")


def arm():
    """Six joints, a flange that carries nothing, two jaws of which one follows the other."""
    turn = "<limit lower='-2.6' upper='2.6' effort='90' velocity='2'/>"
    rows = [("turntable", "0 0 1", 0.12, (0.08, 0.08, 0.06), 0.03, 2.0), ("shoulder", "0 1 0", 0.10, (0.06, 0.06, 0.24), 0.14, 2.0),
            ("elbow", "0 1 0", 0.30, (0.05, 0.05, 0.08), 0.06, 1.0), ("forearm", "0 0 1", 0.13, (0.05, 0.05, 0.06), 0.05, 0.6),
            ("wrist_tip", "0 1 0", 0.12, (0.04, 0.04, 0.04), 0.04, 0.4), ("wrist_turn", "0 0 1", 0.08, (0.06, 0.12, 0.02), 0.03, 0.3)]
    text, above = "<robot name='made_arm'>" + link("stand", (0.12, 0.12, 0.12), 0.06, 5.0), "stand"
    for name, axis, z, size, middle, mass in rows:
        text += link(name + "_part", size, middle, mass) + joint(name, "revolute", above, name + "_part", f"0 0 {z}", axis, turn)
        above = name + "_part"
    text += "<link name='flange'/>" + joint("to_flange", "fixed", above, "flange", "0 0 0.04", "0 0 1", "")
    slide = "<limit lower='0' upper='0.04' effort='20' velocity='0.2'/>"
    for side, sign, more in (("left", 1, ""), ("right", -1, "<mimic joint='finger_left'/>")):
        text += link(f"jaw_{side}", (0.02, 0.01, 0.06), 0.03, 0.05)
        text += joint(f"finger_{side}", "prismatic", above, f"jaw_{side}", f"0 {0.006 * sign} 0.045", f"0 {sign} 0", slide, more)
    return text + "</robot>"


def joint_of(bus, index):
    return bus.newest("STATE")[1].q[index]


def waits_for_path_end(bus):
    bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_path_id != 0, 3)
    bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_path_id == 0, 8)


def jogs_a_joint(checks, bus, keys):
    """Held for a second and a half, 30 keys a second; the first of the arm is the chosen one."""
    before = joint_of(bus, 0)
    begin = time.monotonic_ns()
    for _ in range(45):
        keys.press("+")
    time.sleep(1.2)
    moved = joint_of(bus, 0) - before
    checks.at_least(moved, 0.3, "+ held: the first joint moves [rad]")
    rates = [s.qd[0] for _, s in bus.messages("STATE", begin)]
    checks.at_most(max(map(abs, rates)), 0.55, "and no faster than 0.5 rad/s")
    others = max(abs(joint_of(bus, k) - q) for k, q in ((1, 0.5), (2, 1.0), (4, 0.7)))
    checks.at_most(others, 0.02, "the others stay [rad]")
    still = joint_of(bus, 0)
    time.sleep(0.5)
    checks.at_most(abs(joint_of(bus, 0) - still), 0.002, "let go, it rests [rad]")
    keys.press("]]")
    before = joint_of(bus, 2)
    for _ in range(10):
        keys.press("-")
    time.sleep(1.2)
    checks.at_least(before - joint_of(bus, 2), 0.05, "]] and -: the third joint moves the other way [rad]")
    checks.that("elbow" in keys.text, "its name is shown")
    for _ in range(150):
        keys.press("+")
    time.sleep(1.0)
    keys.read(0.3)
    why = "is at its upper limit" in keys.text or "would touch" in keys.text or "is held" in keys.text
    checks.that(why, f"held on, it stops and says why: {keys.text[-300:]}")
    there = joint_of(bus, 2)
    for _ in range(20):
        keys.press("-")
    time.sleep(1.5)
    checks.at_least(there - joint_of(bus, 2), 0.1, "and moves back again [rad]")
    touched = [g for _, g in bus.messages("GUARD", begin) if g.verdict == 3]
    checks.that(not touched, f"nothing touched in {len(touched)} ticks")


def jogs_the_hand(checks, bus, keys):
    start = len(bus.records)
    keys.press("W")
    _, goal = bus.wait_for("ARM_GOAL", lambda g: g.kind == POSITION_GOAL, 3, start)
    checks.that(goal is not None, "W: the planner is asked for a place")
    waits_for_path_end(bus)
    start = len(bus.records)
    keys.press("J")
    _, turned = bus.wait_for("ARM_GOAL", lambda g: g.kind == POSE_GOAL, 3, start)
    if not checks.that(turned is not None, "J: and for a turn"):
        return
    _, path = bus.wait_for("ARM_PATH", lambda p: p.goal_id == turned.goal_id, 5, start)
    checks.that(path is not None and path.status == 0, "J: there is a way")
    waits_for_path_end(bus)
    start = len(bus.records)
    keys.press("JJ")
    _, more = bus.wait_for("ARM_GOAL", lambda g: g.kind == POSE_GOAL and g.goal_id != turned.goal_id, 3, start)
    if checks.that(more is not None, "JJ: further"):
        dot = abs(sum(a * b for a, b in zip(turned.orientation, more.orientation)))
        angle = 2 * math.acos(min(1.0, dot))
        checks.that(0.04 < angle < 0.11, f"by a step or two of 0.05 rad: {angle:.3f}")
        checks.at_most(max(abs(a - b) for a, b in zip(turned.position, more.position)), 0.005, "on the spot [m]")
    waits_for_path_end(bus)


def reaches(checks, robot):
    where = ("--robot", robot)
    status, out, err = cli("pose", BENT, *where)
    checks.that(status == 0, f"pose: {err}")
    for words, said in ((("right", "0.35", "0.1", "0.35"), "mm from the goal"),
                        (("right", "0.35", "0.0", "0.35", "--frame", "base"), "in base, "),
                        (("right", "0.35", "-0.1", "0.35", "--frame", "world"), "in world, "),
                        (("right", "0.30", "0.05", "0.30", "0", "2.6", "0", "--tool", "0,0,0.1"), "tool at 0.30"),
                        (("right", "0.32", "0.05", "0.30", "--tool", "flange"), "tool at 0.32"),
                        (("right", "0.32", "0.0", "0.30", "--tool", "pen"), "tool at 0.32")):
        status, out, err = cli("reach", *words, *where, timeout=60)
        checks.that(status == 0 and said in out, f"reach {' '.join(words)}: {out}{err}")
    for words, why in ((("right", "0.3", "0", "0.3", "--frame", "bse"), "none of ground, base and world"),
                       (("right", "0.3", "0", "0.3", "--tool", "0,nan,0"), "is not X,Y,Z"),
                       (("right", "0.3", "0", "0.3", "--tool", "jaw_left"), "a joint is between"),
                       (("right", "nan", "0", "0.3", "--frame", "base"), "X"),
                       (("right", "900", "0", "0.3", "--frame", "world"), "more than 10 m")):
        status, out, err = cli("reach", *words, *where)
        checks.that(status != 0 and why in err and len(err.strip().splitlines()) == 1, f"reach {' '.join(words)} is refused: {out}{err}")


def grips(checks, bus, robot):
    jaw = 6
    for word, place in (("open", 0.04), ("close", 0.0), ("0.5", 0.02)):
        status, out, err = cli("grip", word, "--robot", robot)
        checks.that(status == 0 and "of the opening" in out, f"grip {word}: {out}{err}")
        time.sleep(0.3)
        checks.at_most(abs(joint_of(bus, jaw) - place), 0.001, f"grip {word}: the jaw is there [m]")
    for words, why in ((("nan",), "open, close, or a number"), (("2",), "open, close, or a number"), (("open", "--side", "up"), "say one of: right")):
        status, _, err = cli("grip", *words, "--robot", robot)
        checks.that(status != 0 and why in err, f"grip {' '.join(words)} is refused: {err}")
    status, _, err = cli("grip", "open", "--robot", "hrp1s")
    checks.that(status != 0 and "has no gripper" in err, f"a robot without one: {err}")


def main():
    harness.require(*harness.STACK, "twinbus_gamepad", "twinbus_planner")
    harness.CHANNEL_TYPES.setdefault("GAMEPAD", "gamepad_t")
    checks = Checks()
    with tempfile.TemporaryDirectory() as scratch:
        urdf, robot = pathlib.Path(scratch) / "made_arm.urdf", pathlib.Path(scratch) / "robot"
        urdf.write_text(arm())
        weak = pathlib.Path(scratch) / "weak.urdf"
        weak.write_text(arm().replace("effort='90'", "effort='0'"))
        status, out, err = cli("check", weak, timeout=120)
        told = "DOES NOT HOLD" in out and re.search(r"joint turntable and 5 others have an effort limit of 0: no motor .*let --mend guess it", out)
        checks.that(status == 1 and told, f"an arm without efforts is not called one: {out[-900:]}{err}")
        status, out, err = cli("check", weak, "--mend", timeout=120)
        checks.that(status == 0 and "arm_hold" in out, f"with guessed ones it is: {out[-900:]}{err}")
        status, out, err = cli("check", urdf, "--propose", robot, timeout=120)
        checks.that(status == 0 and "right gripper: finger_left 0.000 closed, 0.040 open" in out, f"proposed: {out[-800:]}{err}")
        checks.that("no pair of arms: its one arm is called right" in out and "no hands" not in out, f"one arm has a hand: {out[-800:]}")
        gains = re.findall(r"^ +\d+  \S+ .* (\S+) +(\S+)$", out, re.M)
        checks.that(len(gains) > 5 and all(float(kp) > 0.0 and float(kd) > 0.0 for kp, kd in gains) and "kp and kd are proposed" in out, f"the table shows the proposed gains: {out[:1500]}")
        with open(robot / "robot.yaml", "a", encoding="utf-8") as file:
            file.write("\ntools:\n  pen: {frame: flange, at: [0, 0, 0.05]}\n")
        for scene in ("arm", "arm_reach"):
            status, out, err = cli("run", scene, "--robot", robot, timeout=120)
            checks.that(status == 0 and "passed" in out, f"run {scene}: {out[-500:]}{err}")
        with Stack("arm", "--robot", robot, "--no-viewer", "--for", 200):
            bus = Bus()
            time.sleep(1.0)
            status, _, err = cli("pose", BENT, "--robot", robot)
            checks.that(status == 0, f"pose: {err}")
            keys = Keyboard("--robot", robot)
            jogs_a_joint(checks, bus, keys)
            cli("pose", BENT, "--robot", robot)
            jogs_the_hand(checks, bus, keys)
            keys.press("q")
            keys.close()
            reaches(checks, robot)
            grips(checks, bus, robot)
            status, out, err = cli("pose", "wrist_turn=2.4", "--duration", "0.3")
            checks.that(status == 0 and "in the pose" in out,
                        f"a pose of the robot that runs, which takes longer than was asked, is waited for: {out}{err}")
            bus.close()
    checks.exit()


if __name__ == "__main__":
    main()
