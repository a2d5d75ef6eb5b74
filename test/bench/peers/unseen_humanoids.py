#!/usr/bin/env python3
"""Every humanoid of the example-robot-data wheel, and of the test data, through what a stranger would type.

    unseen_humanoids.py TWINBUS [--short] [NAME ...]

    twinbus check URDF --propose FOLDER
    twinbus run stand --robot FOLDER

Prints a table: what was proposed, whether the robot stands to the end of the scene, how fast, and if not, what `check`
says about it.  Exit status 0 when each robot stands, or `check` has said why it does not.  --short: 1 s instead of the
whole scene.  Without the wheel (pip install example-robot-data) only the test data is looked at.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from example_robots import wheel_folder

HUMANOID = re.compile(r"^(g1|h1|human|alex|talos_(full|reduced)|romeo|icub|bolt|jvrc|simple_humanoid|digit|cassie|asimo|valkyrie|hrp)")
DATA = pathlib.Path(os.environ.get("TWINBUS_DATA", pathlib.Path(__file__).resolve().parents[4] / "shared/data")) / "robots"


def humanoids(names):
    folders = [folder for folder in (wheel_folder(), DATA) if folder is not None and folder.is_dir()]
    files, seen = [], set()
    for folder in folders:
        for file in sorted(folder.rglob("*.urdf")):
            wanted = any(name in file.stem for name in names) if names else HUMANOID.match(file.stem)
            if wanted and file.stem not in seen:
                seen.add(file.stem)
                files.append(file)
    return files


def call(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=900)


def proposed(yaml):
    """Feet, hands and IMU, each by the link it is on."""
    feet = re.findall(r"\{frame: (\S+), at", yaml)
    hands = re.findall(r"^    frame: (\S+)$", yaml, re.M)
    imu = re.search(r"^imu: (.*)$", yaml, re.M)
    return ", ".join(feet) or "-", ", ".join(hands) or "-", imu[1] if imu else "-"


def look_at(twinbus, file, folder, short):
    """(feet, hands, IMU, stands, times real time, reason, all is well)"""
    check = call(twinbus, "check", file, "--propose", folder)
    yaml = folder / "robot.yaml"
    found = proposed(yaml.read_text()) if yaml.exists() else ("-", "-", "-")
    lines = (check.stdout + check.stderr).strip().splitlines()
    if not re.search(r"^stands: ", check.stdout, re.M):
        wanted = ("does not stand", "DOES NOT STAND", "check: ")
        why = [line for line in lines if line.startswith(wanted)]
        # What was said to be looked at comes first among the reasons.
        doubts = [line.strip() for line in lines if "is not used:" in line or "no posture" in line or "to hold half_sitting" in line]
        reason = "; ".join(why[-1:] + doubts[-1:]).replace(str(file.parent) + "/", "")
        return *found, "refused", "-", reason, bool(why)
    report = folder / "report.json"
    run = call(twinbus, "run", "stand", "--robot", folder, "--report", report, *(["--for", "1"] if short else []))
    figures = json.loads(report.read_text()) if report.exists() else {}
    failures = [line for line in run.stdout.splitlines() if line.startswith("FAILED")]
    speed = f"{figures['realtime_factor']:.1f}" if "realtime_factor" in figures else "-"
    return *found, "yes" if run.returncode == 0 else "NO", speed, "; ".join(failures) or run.stderr.strip(), run.returncode == 0


def main():
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    if not words:
        sys.exit(__doc__)
    twinbus = pathlib.Path(words[0]).resolve()
    bad = 0
    print("| robot | feet | hands | IMU | stands | times real time | reason |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for file in humanoids(words[1:]):
        with tempfile.TemporaryDirectory() as scratch:
            *row, well = look_at(twinbus, file, pathlib.Path(scratch) / "robot", "--short" in sys.argv)
        bad += not well
        print(f"| {file.stem} | " + " | ".join(str(cell) for cell in row) + " |", flush=True)
    print(f"{bad} neither stand nor are refused with a reason")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
