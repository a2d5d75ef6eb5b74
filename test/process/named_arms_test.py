#!/usr/bin/env python3
"""A robot with three arms that are neither left nor right, made here: each is sent, given something to hold, emptied and stepped to by
its name (reach, attach, release, grip, the keyboard, the page, Python); names that it does not have are refused with those that it has.

    named_arms_test.py [SCREENSHOT.png]
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import time

import harness
from arm_test import joint, link
from gamepad_test import Keyboard
from harness import Bus, Checks, Stack, cli

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "viewer"))
from browser import Browser, find_browser  # noqa: E402

ARMS = {"east": (0.12, 0.0, 0.0), "north": (0.0, 0.12, 1.5708), "west": (-0.12, 0.0, 3.1416)}  # where each is, and where it looks
POSITION_GOAL, THIRD, SLIDE = 2, 3, 9
NAMES = "east, north, west"


def beam(name, length, mass):
    i = mass * length * length / 12
    return (f"<link name='{name}'><inertial><origin xyz='{length / 2} 0 0'/><mass value='{mass}'/><inertia ixx='0.002' iyy='{i}' izz='{i}' ixy='0' "
            f"ixz='0' iyz='0'/></inertial><collision><origin xyz='{length / 2} 0 0'/><geometry><box size='{length} 0.05 0.05'/></geometry></collision></link>")


def write_robot(folder):
    folder.mkdir()
    turn = "<limit lower='-1.4' upper='1.4' effort='90' velocity='2'/>"
    text, hands, joints = "<robot name='three_arms'>" + link("post", (0.12, 0.12, 0.9), 0.45, 20.0), "", []
    for name, (x, y, yaw) in ARMS.items():
        text += link(f"{name}_turret", (0.05, 0.05, 0.05), 0.0, 1.0) + beam(f"{name}_upper", 0.28, 0.8) + beam(f"{name}_lower", 0.26, 0.5)
        place = f"{x} {y} 0.8' rpy='0 0 {yaw}"
        text += joint(f"{name}_turn", "revolute", "post", f"{name}_turret", place, "0 0 1", turn)
        text += joint(f"{name}_pitch", "revolute", f"{name}_turret", f"{name}_upper", "0.04 0 0", "0 1 0", turn)
        text += joint(f"{name}_elbow", "revolute", f"{name}_upper", f"{name}_lower", "0.32 0 0", "0 1 0", turn)
        hands += f"  {name}: {{frame: {name}_lower, at: [0.25, 0, 0], joints: [{name}_turn, {name}_pitch, {name}_elbow]}}\n"
        joints += [f"{name}_turn", f"{name}_pitch", f"{name}_elbow"]
    text += link("north_jaw", (0.01, 0.05, 0.05), 0.0, 0.1)
    text += joint("north_slide", "prismatic", "north_lower", "north_jaw", "0.27 0 0", "1 0 0", "<limit lower='0' upper='0.05' effort='20' velocity='0.2'/>")
    (folder / "three_arms.urdf").write_text(text + "</robot>")
    (folder / "three_arms.srdf").write_text("<robot name='three_arms'><group_state name='half_sitting' group='all'/>" + "".join(
        f"<disable_collisions link1='{a}' link2='{b}'/>" for name in ARMS for a, b in (("post", f"{name}_turret"), ("post", f"{name}_upper"),
                                                                                      (f"{name}_turret", f"{name}_upper"), (f"{name}_upper", f"{name}_lower")))
        + "<disable_collisions link1='north_lower' link2='north_jaw'/></robot>")
    (folder / "robot.yaml").write_text("urdf: three_arms.urdf\nsrdf: three_arms.srdf\nbase: fixed\nhands:\n" + hands +
                                       "grippers:\n  north: {joints: [north_slide], open: [0.05], closed: [0]}\n"
                                       f"servos:\n  - {{joints: [{', '.join(joints)}], kp: 3000, kd: 60}}\n"
                                       "  - {joints: [north_slide], kp: 2000, kd: 60}\n")


def reaches(checks, where):
    for name, at in (("west", ("-0.62", "0.1", "0.7")), ("north", ("0.1", "0.62", "0.7"))):
        status, out, err = cli("reach", name, *at, *where, timeout=60)
        checks.that(status == 0 and "mm from the goal" in out, f"reach {name}: {out}{err}")


def holds(checks, bus, where):
    start = len(bus.records)
    status, out, err = cli("attach", "north", "box", "0.05", "0.05", "0.05", "0.1", "0", "0", "--for", "1", *where, timeout=30)
    checks.that(status == 0 and "arm north holds a box" in out and "arm north is empty" in out, f"attach north: {out}{err}")
    _, held = bus.wait_for("HELD", lambda piece: piece.count == 1, 1, start)
    checks.that(held is not None and (held.piece, held.pieces) == (3, 8), "HELD tells it of the fourth arm")
    status, out, err = cli("release", "west", *where)
    checks.that(status == 0 and "arm west is empty" in out, f"release west: {out}{err}")
    # Held before its arm, it is what the guard keeps from the others.
    status, out, err = cli("grip", "open", "--side", "north", *where)
    checks.that(status == 0 and "at 1.00 of the opening" in out, f"grip open: {out}{err}")
    checks.at_most(abs(bus.newest("STATE")[1].q[SLIDE] - 0.05), 0.002, "the jaw of the north is open [m]")


def obeys_python(checks, bus):
    start = len(bus.records)
    done = subprocess.run([sys.executable, pathlib.Path(__file__).parent / "python_arms.py"], capture_output=True, text=True, timeout=60)
    said = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    checks.that(done.returncode == 0, f"python_arms.py: {done.stdout}{done.stderr}")
    for what in ("reach west", "attach north", "release north", "grip north"):
        checks.that(said.get(what) == "done", f"Python, {what}: {said.get(what)}")
    for what, why in (("reach far", "no path for arm west: the hand cannot get there, by 2."), ("grip west", "there is one on: north"),
                      ("south", f"no arm called south; there are: {NAMES}"), ("north alone", "there are: left, right (of another name: give robot"),
                      ("ninth", "arm 9: 1 left, 2 right, 3 to 8"), ("left", "not a goal for this robot"), ("cone", "shape: box, sphere, cylinder"), ("edges", "size of a box: 3 numbers")):
        checks.that(why in said.get(what, ""), f"Python, {what} is refused: {said.get(what)}")
    _, goal = bus.wait_for("ARM_GOAL", lambda g: g.kind == POSITION_GOAL, 1, start)
    checks.that(goal is not None and goal.side == THIRD + 2, "Arm.reach sends the west")
    _, held = bus.wait_for("HELD", lambda piece: piece.count == 1, 1, start)
    checks.that(held is not None and (held.piece, held.pieces) == (3, 8) and abs(held.size[0][0] - 0.03) < 1e-6, "Arm.attach tells of the fourth arm")
    _, held = bus.wait_for("HELD", lambda piece: piece.piece == 3 and piece.count == 0, 1, start)
    checks.that(held is not None, "Arm.release tells that it is empty")
    time.sleep(1.0)
    checks.at_most(abs(bus.newest("STATE")[1].q[SLIDE] - 0.01), 0.002, "Arm.grip closes the jaw of the north to a fifth [m]")


def is_refused(checks, where):
    for words, why in ((("attach", "nroth", "sphere", "0.03"), f"no arm called nroth (did you mean north?); say one of: {NAMES}"),
                       (("release", "south", *()), f"say one of: {NAMES}"), (("reach", "up", "0", "0", "1"), f"say one of: {NAMES}"),
                       (("grip", "open", "--side", "up"), f"say one of: {NAMES}"),
                       (("grip", "open", "--side", "west"), "there is one on: north")):
        status, out, err = cli(*words, *where)
        checks.that(status != 0 and why in err and len(err.strip().splitlines()) == 1, f"{' '.join(words)} is refused: {out}{err}")


def is_stepped_to(checks, bus, where):
    keys = Keyboard(*where)
    for number, name in enumerate(ARMS):
        goal = keys.press_for("W", bus, "ARM_GOAL", lambda g, side=THIRD + number: g.kind == POSITION_GOAL and g.side == side)
        checks.that(goal is not None, f"W moves {name}")
        keys.read(0.3)
        checks.that(f"arm {name}" in keys.text, f"its name is shown: {keys.text[-200:]}")
        keys.press("h")
    keys.press("q")
    keys.close()


def is_dragged(checks, bus, line, picture):
    page = Browser(re.search(r"http://\S+", line)[0], (1280, 900))
    checks.that(page.wait_for("globalThis.twinbus?.figures.first", 60), "the page draws the robot")
    checks.that(page.wait_for("[...document.querySelectorAll('#reach button')].map((b) => b.textContent).join() === 'East …,North …,West …'"), "a button for each arm")
    start = len(bus.records)
    page.click("#reach [data-side=west]")
    checks.that(page.wait_for("twinbus.target.ball.visible && twinbus.target.ball.position.x < -0.2"), "a handle appears at the west")
    page.settle(0.3)
    if picture:
        page.screenshot(picture)
    page.value("(t => { t.handles.dispatchEvent({ type: 'dragging-changed', value: true }); t.ball.position.z -= 0.05;"
               " t.handles.dispatchEvent({ type: 'dragging-changed', value: false }); })(twinbus.target)")
    _, goal = bus.wait_for("ARM_GOAL", lambda g: g.kind == POSITION_GOAL, 5, start)
    checks.that(goal is not None and goal.side == THIRD + 2, "let go, its place is the west's goal")
    checks.that(not page.console, f"nothing on the console: {page.console[:3]}")
    page.end()


def main():
    harness.require(*harness.STACK, "twinbus_gamepad", "twinbus_planner")
    harness.CHANNEL_TYPES.setdefault("GAMEPAD", "gamepad_t")
    harness.CHANNEL_TYPES.setdefault("HELD", "obstacles_t")
    checks = Checks()
    looks = find_browser() is not None
    with tempfile.TemporaryDirectory() as scratch:
        robot = pathlib.Path(scratch) / "three_arms"
        write_robot(robot)
        where = ("--robot", robot)
        status, out, err = cli("check", robot, timeout=60)
        checks.that(status == 0 and "north gripper: north_slide 0.000 closed, 0.050 open" in out, f"check: {out[-600:]}{err}")
        with Stack("arm", *where, *(() if looks else ("--no-viewer",)), "--for", 200) as stack:
            bus = Bus()
            time.sleep(1.0)
            reaches(checks, where)
            holds(checks, bus, where)
            is_refused(checks, where)
            obeys_python(checks, bus)
            is_stepped_to(checks, bus, where)
            if looks:
                is_dragged(checks, bus, next(line for line in stack.lines if "http://" in line), sys.argv[1] if len(sys.argv) > 1 else "")
            bus.close()
    checks.exit()


if __name__ == "__main__":
    main()
