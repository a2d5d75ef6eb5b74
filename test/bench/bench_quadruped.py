#!/usr/bin/env python3
"""./twinbus bench quadruped [FILE.urdf ...] [--wheel DIR] [--seeds N] [--only WORD] [--switch N] [--keep DIR] [--csv F]: robots on
four point feet that the stack has never met, proposed by `check --propose` and not edited, stand, are pushed, trot and crawl with the guard on.

Without files: the four-legged descriptions in $TWINBUS_DATA/robots (default ../shared/data) and in the wheel example-robot-data,
unpacked in DIR or else fetched by `pip download` into a temporary folder.  Each stands for 10 s, is pushed by its mass times 0.5 m/s
in a direction of the seed's while it stands, and trots at 0.5 m/s (or as fast as it can) for 60 s, with noise on every sensor,
once a seed (default 3).  A trot counts when the robot does not fall, is not stopped, tilts at most 6 degrees and keeps its
velocity within 10 %.  Then, with `gait: crawl` written into its robot.yaml, it crawls for 30 s at 0.05 sqrt(g leg): tilt at most
3 degrees, velocity within 10 %, and at every tick the zero-moment point at least 3 mm inside what the loaded feet span, which takes
three of them.  Exit status 1 if a run fails.

--switch N: instead, each goes live from one simulator to another engine, heavier and on softer ground, and back, N times with each of
seven kinds of lateness, standing and then in phases of the trot (walk_switch_bench).  Limits are those of two legs: no fall, no STATE
without an answer, standing steps of 5 % of a joint's torque limit and 10 % of the weight, trotting 1.5 times the commanded accelerations
of the trot itself.
"""

import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

import programs
from bench_any_robot import G, Robot, asked, descriptions, proposed, walk_scene, write_rows

QUADRUPEDS = ("go1", "go2", "a1", "b1", "laikago", "anymal_b_simple", "anymal_c_simple", "hyq", "solo")
SPEED, PUSH = 0.5, 0.5  # [m/s]
CRAWL, MARGIN = 0.05, 3.0  # of sqrt(g leg); [mm]
WHAT = ("stand", "push", "trot", "crawl")
STAND = """duration: 10
modes:
  - {{at: 0, mode: balance}}
{}criteria: {{max_tilt_deg: 6}}
"""


def changed(text, old, new):
    """With `old` replaced once; a text without it would be judged as another."""
    if text.count(old) != 1:
        sys.exit(f"bench quadruped: {old!r} stands {text.count(old)} times in a text that should have it once")
    return text.replace(old, new)


class Quadruped(Robot):
    def propose(self):
        super().propose()
        if not self.refused and not self.speed > 0.0 and self.causes:
            self.refused = self.causes[0]
        described = self.twinbus("check", self.folder, "--json")
        self.mass = json.loads(described.stdout)["mass_kg"] if described.stdout.startswith("{") else float("nan")

    def scene(self, name, text, scratch):
        file = scratch / f"{self.name}_{name}.yaml"
        file.write_text(f"robot: {self.folder}\n" + text)
        return file

    def crawled(self, text, seed, scratch):
        """What fails of a crawl."""
        walks, folder = self.folder, scratch / f"{self.name}_crawls"
        if not folder.exists():
            shutil.copytree(walks, folder)
            said = (folder / "robot.yaml").read_text()
            (folder / "robot.yaml").write_text(changed(said, "walking: {", "walking: {gait: crawl, "))
        self.folder = folder
        try:
            failed = self.run(self.scene("crawl", text, scratch), seed)
        finally:
            self.folder = walks
        self.margin = min(self.margin, self.report.get("zmp_margin_min_mm") or 0.0)
        return failed

    def rows(self, seeds, scratch):
        """{what: [passed, worst tilt]}."""
        found, self.margin = {}, math.inf
        for what in WHAT:
            self.tilt, passed = 0.0, 0
            for seed in range(1, seeds + 1):
                push = PUSH * self.mass
                x, y = push * math.cos(2.1 * seed), push * math.sin(2.1 * seed)
                pushes = f"pushes:\n  - {{at: 2, for: 0.1, link: base, impulse: [{x:.3f}, {y:.3f}, 0]}}\n" if what == "push" else ""
                text = STAND.format(pushes)
                if what == "trot":
                    text = walk_scene(64, 60, min(SPEED, self.speed), 6, 10)
                elif what == "crawl":
                    text = walk_scene(36, 30, CRAWL * math.sqrt(G * self.leg), 3, 10)
                    text = changed(text, "criteria: {", f"criteria: {{zmp_margin_min_mm: {MARGIN}, ")
                failed = self.crawled(text, seed, scratch) if what == "crawl" else self.run(self.scene(what, text, scratch), seed)
                passed += not failed
                self.causes += [f"{what}: {cause}" for cause in failed]
            found[what] = [passed, self.tilt]
        return found


    def switched(self, count):
        """What walk_switch_bench says of it, standing and trotting: [(what, passed, its last lines)]."""
        found = []
        for what, words in (("stand", ["--stand"]), ("trot", ["--speed", f"{min(SPEED, self.speed):.3f}"])):
            done = subprocess.run([pathlib.Path(self.binary).parent / "walk_switch_bench", "--engines", "--robot", self.folder, "--count", str(count), *words],
                                  capture_output=True, text=True, env=self.env)
            found.append((what, done.returncode == 0, done.stdout.splitlines() or done.stderr.splitlines()))
        return found


def main(words):
    command = asked(words, __doc__, {"--wheel": "", "--seeds": "3", "--only": "", "--switch": "", "--keep": "", "--csv": ""})
    if command is None:
        return 0
    options, files = command
    seeds = int(options["--seeds"])
    binary = str(programs.folder_of("twinbus", "bench quadruped") / "twinbus")
    files = [f for f in files or descriptions(options["--wheel"], QUADRUPEDS) if options["--only"] in str(f)]
    rows, bad, looked = [], 0, 0
    with tempfile.TemporaryDirectory() as scratch:
        for robot in proposed(Quadruped, files, pathlib.Path(options["--keep"] or scratch).absolute(), binary):
            looked += 1
            if options["--switch"]:
                for what, passed, lines in robot.switched(int(options["--switch"])):
                    bad += not passed
                    print(f"{robot.name:20} {robot.mass:5.1f} kg, {what}: {'passed' if passed else 'FAILED'}", flush=True)
                    for line in lines:
                        print(f"{'':24}{line}", flush=True)
                    rows.append(["quadruped", robot.name, f"switched: {what}", "", "", int(passed)])
                continue
            found = robot.rows(seeds, pathlib.Path(scratch))
            print(f"{robot.name:20} {robot.mass:5.1f} kg, legs {robot.leg:.2f} m, check {robot.seconds:.1f} s: "
                  + ", ".join(f"{what} {passed}/{seeds} (tilt {tilt:.2f})" for what, (passed, tilt) in found.items())
                  + f"; trots up to {robot.speed:.2f} m/s, crawls with a ZMP margin of {robot.margin:.1f} mm", flush=True)
            for cause in dict.fromkeys(robot.causes):
                print(f"{'':28}   {cause}", flush=True)
            for what, (passed, tilt) in found.items():
                bad += seeds - passed
                rows.append(["quadruped", robot.name, what, "degrees", f"{tilt:.3f}", passed])
    if options["--csv"]:
        write_rows(options["--csv"], ["bench", "case", "metric", "unit", "value", "passed"], rows)
    if not looked:
        print("no description with four legs was found")
    elif options["--switch"]:
        print(f"{looked} quadrupeds, {bad} of {2 * looked} kinds of switches failed")
    else:
        print(f"{looked} quadrupeds, {bad} of {len(WHAT) * seeds * looked} runs failed")
    return 1 if bad or not looked else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
