#!/usr/bin/env python3
"""The walking scenes pass by their own criteria: every scene in free run; those that the seed changes, twice (--full: 20 times).

So do those with loose bodies and grips.  --full: other robots too, among them JVRC-1 as `twinbus check --propose` describes it.
"""

import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import harness
from harness import BIN, Checks, cli

SAME_FOR_EVERY_SEED = ["walk_forward", "walk_backward", "walk_sideways", "walk_turn", "walk_diagonal", "walk_slippery",
                       "walk_carry", "walk_pad", "walk_fast", "walk_pivot", "walk_steps", "walk_slope", "walk_crawl"]
LOOSE = ["box_on_foot", "box_push", "boxes_tumble", "plate_underfoot", "carry_box", "tied_hands", "hook_on_step"]
KNOWN = ["slide_to_roll", "brick_stop", "incline", "heavy_on_light"]  # loose bodies whose way is known in closed form
BOUNCES = ["bounce", "bounce_wall"]  # the same, where engine ode damps by itself
MECHANISMS = ["four_bar", "n_four_bar", "bricard", "governor"]  # closed loops that keep their energy
STANDARD = ["pendulum", "chain_30", "top", "cradle", "stick_slip", "painleve", "dzhanibekov",
            "andrews", "table"]  # mechanisms and loose bodies whose end is known
ROBOTS = ["two_robots", "hand_in_hand"]  # a second robot; links of one robot that touch
SEEDED = ["walk_rough", "walk_noisy", "push_stand", "push_walk"]
SEEDS = range(1, 21) if harness.FULL else range(1, 3)
FIGURES = ["max_tilt_deg", "zmp_margin_min_mm", "zmp_margin_p5_mm", "step_slip_max_mm", "force_rms_percent",
           "velocity_error_percent"]


def run(checks, scene, seed, robot=None, engine=None, contact=None):
    report = os.path.join(tempfile.mkdtemp(), "report.json")
    words = ["run", scene, "--seed", seed, "--report", report]
    words += ["--robot", robot] if robot else []
    words += ["--engine", engine] if engine else []
    words += ["--set", f"contact={contact}"] if contact else []
    status, out, err = cli(*words, timeout=600)
    try:
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        line = "  ".join(f"{name} {figures[name]:.1f}" for name in FIGURES if figures.get(name) is not None)
    except (OSError, ValueError) as error:
        line = f"no report: {error}"
    print(f"{scene} seed {seed} {robot or ''} {engine or ''} {contact or ''}: exit {status}  {line}", flush=True)
    failed = [text for text in out.splitlines() if text.startswith("FAILED")]
    checks.that(status == 0, f"run {scene} --seed {seed} {robot or ''} {engine or ''} passes: {failed} {err[-300:]}")


def soft_ground(checks, robot):
    """On ground that gives way and damps, as MuJoCo's contact does, a walk is no worse: without a filter its admittances rattle."""
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        cli("run", "walk_forward", "--for", 8, "--robot", robot, "--set", "contact=soft", "--report", report, timeout=600)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
    print(f"walk_forward {robot} on soft ground:  " + "  ".join(f"{name} {figures[name]:.1f}" for name in FIGURES), flush=True)
    checks.at_most(figures["max_tilt_deg"], 2.0, f"{robot} on soft ground: tilt [degrees]")
    checks.at_most(figures["force_rms_percent"], 7.0, f"{robot} on soft ground: force error [% of the weight]")
    checks.at_most(figures["velocity_error_percent"], 10.0, f"{robot} on soft ground: velocity error [%]")
    checks.at_least(figures["zmp_margin_p5_mm"], 30.0, f"{robot} on soft ground: 5 % of the ZMP margins [mm]")


def everyday(checks, robot):
    """Forward, sideways, turn, 20 mm tiles and pushes of 0.25 m/s, with the guard on."""
    if not (BIN / "walk_case").exists() or importlib.util.find_spec("yaml") is None:
        print("left out: bench walk is a campaign of walk_case, which needs python3-yaml")
        return
    done = subprocess.run([sys.executable, harness.ROOT / "test/bench/bench_walk.py", "everyday", "--robot", robot], capture_output=True, text=True,
                          check=False)
    print(done.stdout, end="")
    checks.that(done.returncode == 0, f"{robot} walks every day: {done.stdout[-300:]}{done.stderr[-300:]}")


def jvrc1(checks):
    data = pathlib.Path(os.environ.get("TWINBUS_DATA", harness.ROOT.parent / "shared/data")) / "robots/jvrc1/jvrc1.urdf"
    if not data.is_file():
        return
    with tempfile.TemporaryDirectory() as scratch:
        folder = os.path.join(scratch, "jvrc1")
        status, out, err = cli("check", str(data), "--propose", folder, timeout=120)
        checks.that(status == 0, f"JVRC-1 is described: {out[-300:]}{err}")
        everyday(checks, folder)


def robust(checks):
    """Sensors three times as noisy as walk_noisy's, with bias, and an attitude that is estimated; --full: the whole table."""
    if importlib.util.find_spec("yaml") is None:
        print("left out: bench robust is a campaign, which needs python3-yaml")
        return
    words = ["--seeds", "3"] if harness.FULL else ["--rows", "both"]
    done = subprocess.run([sys.executable, harness.ROOT / "test/bench/bench_robust.py", *words], capture_output=True, text=True,
                          check=False)
    print(done.stdout, end="")
    checks.that(done.returncode == 0, f"a robot that is not the nominal one passes: {done.stdout[-600:]}{done.stderr[-300:]}")


def main():
    harness.require("twinbus")
    checks = Checks()
    for scene in SAME_FOR_EVERY_SEED + LOOSE + KNOWN + BOUNCES + MECHANISMS + STANDARD + ROBOTS + (["walk_start_stop"] if harness.FULL else []):
        run(checks, scene, 1)
    run(checks, "sway_rigid", 1)
    run(checks, "release", 1)
    run(checks, "reach_scan", 1)
    run(checks, "stamp", 1)
    run(checks, "walk_forward", 1, contact="hunt_crossley")
    for scene in ["stand", "walk_forward", "walk_rough", "walk_slope", "push_walk", "boxes_tumble", "plate_underfoot", "pile_bricks"]:
        run(checks, scene, 1, contact="patch")
    for robot in ["hrp1s", "hrp2p", "biped12"]:
        soft_ground(checks, robot)
    run(checks, "stand", 1, contact="patch", engine="ode")
    run(checks, "hook_on_step", 1, engine="ode")
    run(checks, "walk_slope", 1, engine="ode")
    for scene in ROBOTS:
        run(checks, scene, 1, engine="ode")
    for scene in SEEDED:
        for seed in SEEDS:
            run(checks, scene, seed)
    run(checks, "walk_turn", 1, robot="hrp2p")
    run(checks, "walk_pad", 1, robot="biped12")
    run(checks, "walk_forward", 1, robot="quad12")
    robust(checks)
    if harness.FULL:
        jvrc1(checks)
        for robot in ["hrp1s", "hrp2p", "biped12"]:
            everyday(checks, robot)
            for scene in ["walk_forward", "walk_sideways", "walk_turn", "walk_rough"]:
                run(checks, scene, 1, robot=robot)
        for scene in ["walk_forward", "push_walk", "walk_rough", "release", "stamp"] + LOOSE + KNOWN:
            run(checks, scene, 1, engine="ode")
    checks.exit()


if __name__ == "__main__":
    main()
