#!/usr/bin/env python3
"""./twinbus bench robust [--rows A,B] [--scenes A,B] [--seeds N] [--csv F]: the walking scenes on a robot that is not the nominal one.

Every row changes what the controller does not know (mass, trunk, soles, delay, sensors) or takes the attitude from gyro and
accelerometer (`attitude: estimated`); every scene is run by `./twinbus run` and judged by its own criteria.  Exit status 1
when one failed.
"""

import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ["walk_forward", "push_stand", "push_walk"]
FIGURES = {"tilt [deg]": "max_tilt_deg", "margin [mm]": "zmp_margin_min_mm", "slip [mm]": "step_slip_max_mm",
           "force [%]": "force_rms_percent", "velocity [%]": "velocity_error_percent"}
# Three times the noise of walk_noisy, and what a calibration leaves; the attitude's counts only where the IMU's own is used.
NOISE = {"sensor.noise.encoder": 3e-5, "sensor.noise.velocity": 0.03, "sensor.noise.attitude": 0.006,
         "sensor.noise.gyro": 0.03, "sensor.noise.accel": 0.15, "sensor.noise.force": 15, "sensor.noise.moment": 1.5,
         "sensor.bias.roll": 0.003, "sensor.bias.pitch": 0.003, "sensor.bias.gyro": 0.005, "sensor.bias.accel": 0.03,
         "sensor.bias.force": 5}


class Row:
    def __init__(self, settings=None, trunk=None, estimated=False):
        self.settings, self.trunk, self.estimated = settings or {}, trunk, estimated


ROWS = {
    "nominal": Row(),
    "mass x1.1": Row({"model.mass_scale": 1.1}),
    "mass x0.9": Row({"model.mass_scale": 0.9}),
    "trunk 20 mm forward": Row(trunk=(0.02, 0, 0)),
    "trunk 20 mm back": Row(trunk=(-0.02, 0, 0)),
    "trunk 20 mm left": Row(trunk=(0, 0.02, 0)),
    "soles x1.1": Row({"contact.stiffness_scale": 1.1}),
    "soles x0.9": Row({"contact.stiffness_scale": 0.9}),
    "delay 4 ticks": Row({"servo.delay_ms": 8}),
    "noise x3 and bias": Row(NOISE),
    "attitude estimated": Row(estimated=True),
    "both": Row(NOISE, estimated=True),
}
TRUNK = "WAIST_R"  # of hrp1s: its heaviest link


def twinbus():
    return programs.folder_of("twinbus", "bench robust") / "twinbus"


def robot_that_estimates(folder):
    """A copy of hrp1s whose robot.yaml asks for it."""
    copy = pathlib.Path(folder) / "hrp1s"
    shutil.copytree(ROOT / "config/robots/hrp1s", copy)
    file = copy / "robot.yaml"
    text = file.read_text(encoding="utf-8")
    assert text.count("walking:\n  {") == 1
    file.write_text(text.replace("walking:\n  {", "walking:\n  {attitude: estimated, "), encoding="utf-8")
    return copy


def scene_with(scene, trunk, folder):
    """The scene, on a robot whose trunk's centre of mass is elsewhere."""
    if trunk is None:
        return scene
    text = (ROOT / f"config/scenes/{scene}.yaml").read_text(encoding="utf-8")
    assert "\nbodies:" not in text
    file = pathlib.Path(folder) / f"{scene}_{'_'.join(map(str, trunk))}.yaml"
    file.write_text(f"{text}\nbodies:\n  - {{link: {TRUNK}, shift: [{', '.join(map(str, trunk))}]}}\n", encoding="utf-8")
    return file


def run(name, scene, seed, written, folder, robot):
    """(name, scene, seed, whether it passed, figures, what failed)."""
    row = ROWS[name]
    report = tempfile.mktemp(suffix=".json", dir=folder)
    words = [twinbus(), "run", written, "--seed", str(seed), "--report", report]
    words += ["--robot", robot] if row.estimated else []
    for key, value in row.settings.items():
        words += ["--set", f"{key}={value}"]
    done = subprocess.run(words, capture_output=True, text=True, check=False, cwd=ROOT)
    try:
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
    except (OSError, ValueError):
        figures = {}
    failed = [line.removeprefix("FAILED: ") for line in done.stdout.splitlines() if line.startswith("FAILED")]
    return name, scene, seed, done.returncode == 0, figures, failed or done.stderr.splitlines()[-1:]


def main():
    parser = argparse.ArgumentParser(usage=__doc__.strip())
    parser.add_argument("--rows", default=",".join(ROWS))
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--csv")
    given = parser.parse_args()
    rows, scenes = given.rows.split(","), given.scenes.split(",")
    if unknown := [name for name in rows if name not in ROWS]:
        sys.exit(f"bench robust: no row {unknown[0]!r}; there are: {', '.join(ROWS)}")
    bad, lines = 0, []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        robot = robot_that_estimates(folder)
        # Written before any runs: many read the same one.
        written = {(name, scene): scene_with(scene, ROWS[name].trunk, folder) for name in rows for scene in scenes}
        jobs = [(name, scene, seed) for name in rows for scene in scenes for seed in range(1, given.seeds + 1)]
        print(f"{'':20} {'scene':13} seed {'':6}" + "".join(f"{title:>14}" for title in FIGURES))
        for name, scene, seed, passed, figures, failed in pool.map(lambda job: run(*job, written[job[:2]], folder, robot), jobs):
            bad += not passed
            values = [figures.get(key) for key in FIGURES.values()]
            text = "".join(f"{'' if value is None else f'{value:.1f}':>14}" for value in values)
            print(f"{name:20} {scene:13} {seed:4} {'passes' if passed else 'FAILS '}{text}", flush=True)
            for line in failed if not passed else []:
                print(f"    {line}")
            lines += [["robust", f"{name}, {scene}, seed {seed}", *title.rstrip("]").split(" ["), value]
                      for title, value in zip(FIGURES, values) if value is not None]
    if given.csv:
        with open(given.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([["bench", "case", "metric", "unit", "median"], *lines])
    print(f"{len(jobs) - bad} of {len(jobs)} pass")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
