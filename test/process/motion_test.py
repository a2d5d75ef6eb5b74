#!/usr/bin/env python3
"""./twinbus motion FILE --play on a running stack: from walking to the motion and back to walking; what fails its check is not
sent; a stop ends it; a scene plays it; the log of it re-runs to the same bits."""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

import harness
from harness import BIN, Bus, Checks, Stack, cli

STAND = {"RARM_SHOULDER_R": -0.1595, "RARM_ELBOW": -0.6363, "LARM_SHOULDER_R": 0.1595, "LLEG_HIP_P": -0.571, "LLEG_KNEE": 1.2644,
         "LLEG_ANKLE_P": -0.6925, "RLEG_HIP_P": -0.571, "RLEG_KNEE": 1.2644, "RLEG_ANKLE_P": -0.6925}
PLAYED = 3  # CONTROLLER_STATUS.motion


def wave(t):
    return 0.5 * (1.0 - math.cos(math.pi * t))


def write(file, seconds, arm=0.8, knee=0.3, rate=50):
    """Waves of both arms and knees, each two seconds long."""
    with open(file, "w", newline="") as out:
        table = csv.writer(out)
        table.writerow(["time", *STAND])
        for i in range(int(seconds * rate) + 1):
            w, q = wave(i / rate), dict(STAND)
            q["RARM_SHOULDER_R"] -= arm * w
            q["LARM_SHOULDER_R"] += arm * w
            q["RARM_ELBOW"] -= 0.5 * w
            for side in "LR":
                q[f"{side}LEG_HIP_P"] -= 0.46 * knee * w
                q[f"{side}LEG_KNEE"] += knee * w
                q[f"{side}LEG_ANKLE_P"] -= 0.54 * knee * w
            table.writerow([i / rate, *q.values()])
    return file


def refused(checks, folder):
    """Before anything is sent, with tick, joint, value and limit."""
    status, out, err = cli("motion", write(folder / "wild.csv", 2.0, arm=2.5), "--play")
    checks.that(status == 1 and "position" in out and "RARM_SHOULDER_R" in out and "refused" in out, f"a wild one: {status} {out}{err}")
    (folder / "short.csv").write_text("time,RARM_ELBOW\n0,0\n0.1\n")
    for words, what in ((["motion", folder / "short.csv"], "short.csv:3: has 1 columns"), (["motion", folder / "none.csv"], "cannot be read")):
        status, out, err = cli(*words)
        checks.that(status == 1 and what in err and len(err.strip().splitlines()) == 1, f"{what}: {status} {out}{err}")
    status, out, err = cli("motion", folder / "good.csv", "--play", "--as-recorded")
    checks.that(status == 2, f"legs as recorded are not played: {status} {err}")


def from_walking_and_back(checks, bus, folder):
    walker = threading.Thread(target=cli, args=("walk", "0.25", "0", "0", "--for", "30"))
    walker.start()
    checks.that(bus.wait_for("CONTROLLER_STATUS", lambda s: s.mode == 5, 10.0) is not None, "it walks")
    time.sleep(3.0)
    before = bus.newest("TRUTH")[1].base_position[0]
    player = subprocess.Popen([BIN / "twinbus", "motion", str(folder / "good.csv"), "--play"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    checks.that(bus.wait_for("CONTROLLER_STATUS", lambda s: s.motion == PLAYED, 15.0) is not None, "it plays, once it stands")
    said = player.communicate(timeout=60)[0]
    walker.join(40)
    checks.that(player.returncode == 0 and "motion: done" in said, f"played to its end: {player.returncode} {said}")
    status, out, err = cli("walk", "0.25", "0", "0", "--for", "4")
    checks.that(status == 0, f"and walks again: {status} {out}{err}")
    player = subprocess.Popen([BIN / "twinbus", "motion", str(folder / "good.csv"), "--play"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    bus.wait_for("CONTROLLER_STATUS", lambda s: s.motion == PLAYED, 15.0)
    time.sleep(3.0)
    status, out, err = cli("walk", "0.25", "0", "0", "--for", "4")
    checks.that(status == 0, f"asked in the motion, it ends that and walks: {status} {out}{err}")
    said = player.communicate(timeout=60)[0]
    checks.that(player.returncode == 1 and "something else was asked" in said, f"the player says so: {player.returncode} {said}")
    truth = bus.newest("TRUTH")[1]
    checks.at_least(truth.base_position[0] - before, 1.0, "metres walked since")
    checks.that(not truth.fell, "it stands")


def stopped(checks, bus, folder):
    checks.that(cli("mode", "balance")[0] == 0, "balance")
    player = subprocess.Popen([BIN / "twinbus", "motion", str(folder / "good.csv"), "--play"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    bus.wait_for("CONTROLLER_STATUS", lambda s: s.motion == PLAYED, 15.0)
    time.sleep(3.0)
    checks.that(cli("stop")[0] == 0 and cli("clear")[0] == 0, "a stop in the motion, and a clear")
    said = player.communicate(timeout=60)[0]
    checks.that(player.returncode == 1, f"the player says that it ended: {player.returncode} {said}")
    time.sleep(1.0)
    checks.that(not bus.newest("TRUTH")[1].fell, "it stands after the stop")


def scene(checks, folder):
    (folder / "play.yaml").write_text("duration: 12\nmodes:\n  - {at: 0, mode: balance}\nmotions:\n  - {at: 1, file: good.csv}\n"
                                      "criteria: {max_tilt_deg: 5, zmp_margin_min_mm: 15, slip_max_mm: 3}\n")
    status, out, err = cli("run", folder / "play.yaml")
    checks.that(status == 0 and "passed" in out, f"run: {status} {out[-600:]}{err}")
    (folder / "wild.yaml").write_text("duration: 3\nmotions:\n  - {at: 1, file: wild.csv}\n")
    status, out, err = cli("run", folder / "wild.yaml")
    checks.that(status == 1 and "is refused" in err and "RARM_SHOULDER_R" in err, f"run refuses: {status} {err}")


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_recorder")
    os.environ["TWINBUS_RECORD"] = "1"
    checks = Checks()
    folder = pathlib.Path(tempfile.mkdtemp())
    write(folder / "good.csv", 6.0)
    refused(checks, folder)
    scene(checks, folder)
    with Stack("stand", "--no-viewer"):
        bus = Bus()
        bus.wait_for("CONTROLLER_STATUS", lambda s: s.mode == 4)
        from_walking_and_back(checks, bus, folder)
        stopped(checks, bus, folder)
        bus.close()
    status, out, err = cli("log", "rerun", harness.newest_run_folder() / "run.log", timeout=300)
    checks.that(status == 0, f"the same bits again: {status} {out[-600:]}{err}")
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
