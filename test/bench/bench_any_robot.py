#!/usr/bin/env python3
"""./twinbus bench any_robot [FILE.urdf ...] [--wheel DIR] [--seeds N] [--only WORD] [--keep DIR] [--csv F]: humanoids that the stack
has never met, proposed by `check --propose` and not edited, stand and walk with the guard on.

Without files: the descriptions with two legs in $TWINBUS_DATA/robots (default ../shared/data) and in the wheel example-robot-data,
unpacked in DIR or else fetched by `pip download` into a temporary folder.  Each stands for 10 s and walks for 10 s at half of the
speed that `check` reports, with noise on every sensor, once a seed (default 3).  A walk counts when the robot does not fall, is
not stopped, touches nothing, tilts at most 5 degrees and keeps its velocity within 20 %, and half of the speed is at least
0.08 sqrt(g leg).  A robot that `check` refuses or says not to stand is listed with that reason.  --keep DIR leaves the proposals
there.  Exit status 1 if fewer than 90 % of those that `check` takes stand, or fewer than 80 % of those walk that it does not refuse to walk.

./twinbus bench any_robot --arms N [--base planar] [--away M] [FILE.urdf ...]: robots on a fixed base with an arm run the arm_* scenes, and N reaches each among obstacles
around the shoulder (test/bench/reach_world.cpp): reached or truly refused, and contacts by the exact meshes.  --held N: every second
goal of a hand picks a thing, the next one places it.  --base planar: proposed with a base that moves on the plane; --away M: to goals for which it
drives up to M metres along x and y, or a lift moves.  Exit status 1 if a scene fails, a goal is refused untruly or missed, or anything touches.
"""

import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import zipfile
import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
G = 9.81
NOISE = {"encoder": 1e-5, "velocity": 0.01, "attitude": 0.002, "gyro": 0.01, "force": 5, "moment": 0.5}  # of scene walk_noisy
# Folders of the two sources that hold humanoids; the rest are arms, hands, quadrupeds, wheels and rotors.
HUMANOIDS = ("talos_data", "g1", "jvrc1", "simple_humanoid", "bolt", "romeo_description", "icub_description", "human_description",
             "alexander_description", "alex_description")
ARMS = ("panda", "ur_description", "kinova_description", "xarm_description", "z1_description", "so_arm_description")


def walk_scene(duration, seconds, vx, tilt, error):
    """Walks at vx for so long; tilt [deg] and error [%] of the velocity are the most."""
    return f"""duration: {duration}
modes:
  - {{at: 0, mode: balance}}
  - {{at: 0.5, mode: walk}}
  - {{at: {seconds + 1.5}, mode: balance}}
walks:
  - {{at: 1, for: {seconds}, vx: {vx:.4f}}}
criteria: {{max_tilt_deg: {tilt}, velocity_error_percent: {error}}}
"""


def unpacked(folder):
    """The wheel's robots folder."""
    if not folder:
        folder = pathlib.Path(tempfile.gettempdir()) / "example-robot-data"
        if not folder.exists():
            folder.mkdir()
            subprocess.run([sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", str(folder), "example-robot-data"], check=True)
            for wheel in folder.glob("*.whl"):
                zipfile.ZipFile(wheel).extractall(folder)
    return next(pathlib.Path(folder).glob("**/example-robot-data/robots"), None)


def descriptions(wheel, wanted=HUMANOIDS):
    data = pathlib.Path(os.environ.get("TWINBUS_DATA", ROOT.parent / "shared/data")) / "robots"
    folders = [data] if data.exists() else []
    try:
        folders += [f for f in [unpacked(wheel)] if f]
    except (subprocess.CalledProcessError, OSError) as error:
        print(f"the wheel example-robot-data is absent: {error}")
    found, seen = [], set()
    for folder in folders:
        for file in sorted(folder.glob("**/*.urdf")):
            top = file.relative_to(folder).parts[0]
            if not any(top == name or top == name + "_description" for name in wanted) or "arm" in file.stem or "_spherized" in file.stem or "_collision" in file.stem:
                continue
            text = file.read_bytes()
            if hash(text) not in seen:
                found.append(file)
            seen.add(hash(text))
    return found


def refusal(said):
    """What check says of a file: the first of its faults, each a line."""
    lines = said.strip().splitlines() or ["?"]
    faults = [line for line in lines if line.startswith("check: ")] or lines[-1:]
    more = sum(line.startswith("  ") for line in lines)
    return faults[0] + (f" (and {more} more)" if more else "")


class Robot:
    def __init__(self, file, folder, binary, env):
        self.file, self.folder, self.binary, self.env = file, folder, binary, env
        self.name = file.stem
        self.stood = self.walked = 0
        self.speed = self.leg = float("nan")
        self.refused, self.no_walk, self.causes, self.tilt, self.report = "", "", [], 0.0, {}

    def twinbus(self, *words):
        return subprocess.run([self.binary, *map(str, words)], capture_output=True, text=True, env=self.env)

    def propose(self):
        begun = time.monotonic()
        done = self.twinbus("check", self.file, "--propose", self.folder, "--json")
        self.seconds = time.monotonic() - begun
        try:
            report = json.loads(done.stdout)
        except ValueError:
            self.refused = refusal(done.stderr)
            return
        trial = report["trial"]
        self.refused = trial["refusal"] or ("" if trial["stood"] else trial["cannot_balance"] or "; ".join(trial["weak"]))
        self.no_walk = trial["cannot_balance"]
        walk = trial.get("walk") or {}
        self.leg = walk.get("leg_m") or float("nan")
        self.speed = walk.get("fastest_m_s") or 0.0
        if walk.get("why_not"):
            self.causes.append("check: " + walk["why_not"])
        if self.no_walk and not self.refused:
            self.causes.append("check refuses to walk it: " + self.no_walk)

    def run(self, scene, seed):
        with tempfile.NamedTemporaryFile(suffix=".json") as file:
            noise = [w for key, value in NOISE.items() for w in ("--set", f"sensor.noise.{key}={value}")]
            done = self.twinbus("run", scene, "--robot", self.folder, "--seed", seed, "--report", file.name, *noise)
            failed = [line[8:] for line in done.stdout.splitlines() if line.startswith("FAILED: ")]
            self.report = {}
            try:
                self.report = json.load(open(file.name))
                self.tilt = max(self.tilt, self.report["max_tilt_deg"])
            except (ValueError, KeyError):
                failed.append((done.stderr.strip().splitlines() or ["no report"])[-1])
        return failed

    def try_all(self, seeds, folder):
        for seed in range(1, seeds + 1):
            failed = self.run("stand", seed)
            self.stood += not failed
            self.causes += ["stand: " + cause for cause in failed]
        if not self.speed > 0.0:
            return
        scene = folder / (self.name + "_walk.yaml")
        scene.write_text(walk_scene(13.5, 10, 0.5 * self.speed, 5, 20))
        self.tilt = 0.0
        for seed in range(1, seeds + 1):
            failed = self.run(scene, seed)
            self.walked += not failed
            self.causes += ["walk: " + cause for cause in failed]

    def share(self):
        return 0.5 * self.speed / math.sqrt(G * self.leg) if self.speed > 0.0 else 0.0


def reaches(robot, count, held, away):
    """Of reach_world, ten goals a world: {figure: sum, or the worst}."""
    found = {}
    for seed in range(1, (count + 9) // 10 + 1):
        done = subprocess.run([pathlib.Path(robot.binary).parent / "reach_world", "--robot", robot.folder, "--seed", str(seed), "--goals", "10", "--speed", "0.7",
                               *(["--held"] if held else []), "--away", away], capture_output=True, text=True, env=robot.env)
        try:
            world = json.loads(done.stdout.splitlines()[-1])
        except (IndexError, ValueError):
            world = {"failures": [f"1 times: {(done.stderr.strip().splitlines() or ['?'])[-1]}"], "broken": 1}
        for key in ("asked", "reached", "refused_truly", "missed", "given_up", "contacts", "broken"):
            found[key] = found.get(key, 0) + world.get(key, 0)
        found["plan_ms"] = found.get("plan_ms", []) + [world.get("plan_ms", 0.0)]
        found["failures"] = found.get("failures", []) + [f"world {seed}: {cause}" for cause in world["failures"] if "no way found" not in cause]
    return found


def arms(files, count, held, base, away, keep, binary):
    failed = looked = 0
    for number, file in enumerate(files):
        robot = Robot(file, keep / f"{number:02d}_{file.stem}", binary, dict(os.environ))
        done = robot.twinbus("check", file, "--propose", robot.folder, "--json", *(["--base", base] if base else []))
        try:
            trial = json.loads(done.stdout)["trial"]
        except ValueError:
            print(f"{robot.name:28} refused: {refusal(done.stderr)}", flush=True)
            continue
        if not trial["cannot_balance"].startswith("its base is fixed"):
            continue
        looked += 1
        said = []
        for scene in ("arm_hold", "arm_reach", "arm_scan", "arm_pick"):
            done = robot.twinbus("run", scene, "--robot", robot.folder)
            causes = [line[8:] for line in done.stdout.splitlines() if line.startswith("FAILED: ")] or done.stderr.strip().splitlines()[-1:]
            paths, goals = done.stdout.count("arm path of"), done.stdout.count("planner: ")
            said.append(f"{scene} {'passed' if done.returncode == 0 else 'FAILED (' + '; '.join(causes) + ')'}" + (f", {paths} of {goals} goals" if goals else ""))
            failed += done.returncode != 0
        found = reaches(robot, count, held, away)
        failed += found["missed"] + found["given_up"] + found["contacts"] + found["broken"]
        print(f"{robot.name:28} {'; '.join(said)}; {found['asked']} {'picks and places' if held else 'reaches'}: {found['reached']} reached, "
              f"{found['refused_truly']} refused truly, {found['missed']} untruly or missed, {found['given_up']} given up, {found['contacts']} with a contact; "
              f"planned in {sorted(found['plan_ms'])[len(found['plan_ms']) // 2]:.1f} ms", flush=True)
        for cause in found["failures"]:
            print(f"{'':28}   {cause}", flush=True)
    return 1 if failed or not looked else 0


def asked(words, about, defaults):
    """(options, files) of a command line, or None after --help.  defaults: of every option."""
    options, files, words = dict(defaults), [], list(words)
    while words:
        word = words.pop(0)
        if word in ("--help", "-h"):
            print(about)
            return None
        if word in options and words:
            options[word] = words.pop(0)
        else:
            files.append(pathlib.Path(word))
    return options, files


def proposed(kind, files, keep, binary):
    """A robot of each file, proposed; those that are refused are printed."""
    keep.mkdir(parents=True, exist_ok=True)
    for number, file in enumerate(files):
        robot = kind(file, keep / f"{number:02d}_{file.stem}", binary, dict(os.environ))
        robot.propose()
        if robot.refused:
            print(f"{robot.name:28} refused: {robot.refused}", flush=True)
        else:
            yield robot


def write_rows(file, columns, rows):
    with open(file, "w", newline="") as stream:
        csv.writer(stream).writerows([columns, *rows])


def main(words):
    command = asked(words, __doc__, {"--wheel": "", "--arms": "", "--held": "", "--base": "", "--away": "0", "--seeds": "3", "--only": "", "--keep": "", "--csv": ""})
    if command is None:
        return 0
    options, files = command
    seeds = int(options["--seeds"])
    binary = str(programs.folder_of("twinbus", "bench any_robot") / "twinbus")
    files = [f for f in files or descriptions(options["--wheel"], ARMS if options["--arms"] or options["--held"] else HUMANOIDS) if options["--only"] in str(f)]
    if options["--arms"] or options["--held"]:
        with tempfile.TemporaryDirectory() as scratch:
            keep = pathlib.Path(options["--keep"] or scratch)
            keep.mkdir(parents=True, exist_ok=True)
            return arms(files, int(options["--arms"] or options["--held"]), bool(options["--held"]), options["--base"], options["--away"], keep, binary)
    stand = walk = legs = walkers = 0
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for robot in proposed(Robot, files, pathlib.Path(options["--keep"] or scratch), binary):
            legs += 1
            robot.try_all(seeds, pathlib.Path(scratch))
            walkers += not robot.no_walk
            stood, walked = robot.stood == seeds, robot.walked == seeds and robot.share() >= 0.08
            stand, walk = stand + stood, walk + walked
            print(f"{robot.name:28} stands {robot.stood}/{seeds}  walks {robot.walked}/{seeds} at {0.5 * robot.speed:.3f} m/s = "
                  f"{robot.share():.3f} sqrt(g l), l {robot.leg:.2f} m, tilt {robot.tilt:.1f}; check {robot.seconds:.1f} s", flush=True)
            for cause in dict.fromkeys(robot.causes):
                print(f"{'':28}   {cause}", flush=True)
            rows.append(["any_robot", robot.name, "half speed", "m/s", f"{0.5 * robot.speed:.4f}", robot.stood, robot.walked])
    if not legs:
        print("no description with two legs was found")
        return 1
    good = stand >= 0.9 * legs and walk >= 0.8 * walkers
    print(f"{legs} that check takes: {stand} stand (asked {math.ceil(0.9 * legs)}); {walkers} that it does not refuse to walk: {walk} walk "
          f"(asked {math.ceil(0.8 * walkers)})")
    if options["--csv"]:
        write_rows(options["--csv"], ["bench", "case", "metric", "unit", "value", "stood", "walked"], rows)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
