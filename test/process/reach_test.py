#!/usr/bin/env python3
"""`twinbus reach` past obstacles on the real stack, measured by what only the simulator knows.

The hand is where it was sent, nothing came nearer to the obstacles than the margin, the ZMP stayed inside the soles, and
what cannot be done is refused with its reason.  A motion goes on while the source is switched.
"""

import pathlib
import re
import tempfile
import threading
import time

import harness
from harness import ROOT, Bus, Checks, Stack, cli, text_of
from postures import Postures, in_ground

MARGIN = 0.010     # of the guard in the loop [m]
TOLERANCE = 0.005  # of the hand [m]
PLACES = [("left", 0.33, 0.44, 0.90), ("left", 0.33, 0.12, 0.95), ("left", 0.33, 0.44, 0.90), ("right", 0.40, -0.30, 0.90)]


def scene_without_goals(folder):
    """The scene `reach` for hands that are sent by the test."""
    text = (ROOT / "config/scenes/reach.yaml").read_text()
    file = pathlib.Path(folder) / "reach_by_hand.yaml"
    file.write_text(re.sub(r"^goals:\n(  .*\n)+", "", text, flags=re.MULTILINE))
    return file


def goals_are_reached(checks, scene, bus):
    for number, (side, *goal) in enumerate(PLACES):
        what = f"reach {side} {goal}"
        before = time.monotonic_ns()
        status, out, err = cli("reach", side, *goal)
        if not checks.that(status == 0, f"{what}: {out}{err}"):
            if "stopped" in err:
                print("\n".join(harness.story_of_a_stop(bus)), flush=True)
            continue
        said = float(re.search(r"([0-9.]+) mm from the goal", out)[1])
        postures = Postures(bus, before, scene=scene)
        _, _, truth = postures.rows[-1]
        hand = in_ground(truth, (postures.left_hand if side == "left" else postures.right_hand)[-1])
        miss = max(abs(a - b) for a, b in zip(hand, goal))
        print(f"{what}: {1e3 * miss:.1f} mm off (said {said}), obstacles {1e3 * min(postures.obstacle_distance):.0f} mm, "
              f"itself {1e3 * min(postures.self_distance):.0f} mm, ZMP margin {1e3 * postures.zmp_margin:.0f} mm")
        checks.at_most(miss, TOLERANCE, f"{what}: the hand is there by TRUTH [m]")
        checks.at_most(abs(1e-3 * said - miss), 0.004, f"{what}: and reach said so [m]")
        checks.at_least(min(postures.obstacle_distance), MARGIN, f"{what}: distance to obstacles [m]")
        checks.that(postures.touching == 0, f"{what}: nothing touches")
        checks.at_least(postures.zmp_margin, 0.010, f"{what}: ZMP margin [m]")
        checks.that(not postures.fell, f"{what}: no fall")


def the_post_is_gone_around(checks, bus):
    events = [text_of(event) for _, event in bus.messages("EVENT")]
    checks.that(any("around an obstacle" in text for text in events), f"a path went around the post: {events[-6:]}")


def refusals(checks, bus):
    since = time.monotonic_ns()
    _, first = bus.newest("STATE")
    for words, status, sentence in (
            (("left", 0.9, 0.2, 0.9), 1, "out of reach by"),
            (("left", 0.0, 0.0, 0.9), 1, "would touch"),
            (("right", 0.50, -0.20, 0.66), 1, "would touch|out of reach by"),
            (("left", 0.4, 0.2, "nan"), 2, "Z must be a number"),
            (("left", 0.4, 0.2, 900), 2, "Z must be a number"),
            (("up", 0.4, 0.2, 0.9), 2, "say one of: left, right"),
            (("left", 0.4), 2, "X Y Z"),
            (("left", 0.4, 0.2, 0.9, "--speed", 7), 2, "speed"),
            (("left", 0.4, 0.2, 0.9, "--robot", "nobody"), 1, "nobody")):
        code, out, err = cli("reach", *words)
        text = (out + err).strip()
        checks.that(code == status and re.search(sentence, text) is not None and text.count("\n") == 0,
                    f"reach {words}: exit {code}, asked {status}: {text}")
    moved = max((abs(s.q[k] - first.q[k]) for _, s in bus.messages("STATE", since) for k in range(s.joint_count)), default=1.0)
    checks.at_most(moved, 0.002, "refused goals move nothing [rad]")


def nobody_there(checks):
    code, out, err = cli("reach", "left", 0.4, 0.2, 0.9)
    checks.that(code == 1 and "no robot is heard" in err, f"without a stack: {code} {out}{err}")


def during_a_switch(checks, scene):
    """Slowly around the post while simulator and bridge take turns; the hand arrives all the same."""
    with Stack(scene, "--stack", "both", "--no-viewer", "--for", 120):
        bus = Bus()
        time.sleep(2.0)
        checks.that(cli("reach", "left", 0.33, 0.44, 0.90)[0] == 0, "switch: to the near side first")
        before = time.monotonic_ns()
        result = []
        mover = threading.Thread(target=lambda: result.append(cli("reach", "left", 0.33, 0.12, 0.95, "--speed", 0.1)))
        mover.start()
        bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_state == 1, 10)
        time.sleep(0.8)
        switched = cli("switch", "bridge", "--policy", "now")
        mover.join(60)
        moving = [s for _, s in bus.messages("CONTROLLER_STATUS", before) if s.arm_state == 1]
        runs = {s.run_id for s in moving}
        checks.that(switched[0] == 0, f"switch: {switched}")
        checks.that(len(runs) == 2, f"switch: the arm moved under {len(runs)} sources")
        checks.that(bool(result) and result[0][0] == 0, f"switch: {result}")
        checks.that(not any(t.fell for _, t in bus.messages("TRUTH", before)), "switch: no fall")
        bus.close()


def main():
    harness.require(*harness.STACK, "posture_probe")
    checks = Checks()
    nobody_there(checks)
    with tempfile.TemporaryDirectory() as folder:
        scene = scene_without_goals(folder)
        with Stack(scene, "--no-viewer", "--for", 120):
            bus = Bus()
            time.sleep(1.5)
            goals_are_reached(checks, scene, bus)
            the_post_is_gone_around(checks, bus)
            refusals(checks, bus)
            bus.close()
        if (harness.BIN / "emulated_robot").exists():
            during_a_switch(checks, scene)
    checks.exit()


if __name__ == "__main__":
    main()
