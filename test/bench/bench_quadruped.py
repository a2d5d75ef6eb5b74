#!/usr/bin/env python3
"""./twinbus bench quadruped [FILE.urdf ...] [--wheel DIR] [--seeds N] [--only WORD] [--keep DIR] [--csv F]: robots on four point feet
that the stack has never met, proposed by `check --propose` and not edited, stand, are pushed and trot with the guard on.

Without files: the four-legged descriptions in $TWINBUS_DATA/robots (default ../shared/data) and in the wheel example-robot-data,
unpacked in DIR or else fetched by `pip download` into a temporary folder.  Each stands for 10 s, is pushed by its mass times 0.5 m/s
in a direction of the seed's while it stands, and trots at 0.5 m/s (or as fast as it can) for 60 s, with noise on every sensor,
once a seed (default 3).  A trot counts when the robot does not fall, is not stopped, tilts at most 6 degrees and keeps its
velocity within 10 %.  Exit status 1 if a run fails.
"""

import json
import math
import pathlib
import sys
import tempfile

import programs
from bench_any_robot import Robot, asked, descriptions, proposed, walk_scene, write_rows

QUADRUPEDS = ("go1", "go2", "a1", "b1", "laikago", "anymal_b_simple", "anymal_c_simple", "hyq", "solo")
SPEED, PUSH = 0.5, 0.5  # [m/s]
STAND = """duration: 10
modes:
  - {{at: 0, mode: balance}}
{}criteria: {{max_tilt_deg: 6}}
"""


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

    def rows(self, seeds, scratch):
        """{what: [passed, worst tilt]}."""
        found = {}
        for what in ("stand", "push", "trot"):
            self.tilt, passed = 0.0, 0
            for seed in range(1, seeds + 1):
                push = PUSH * self.mass
                x, y = push * math.cos(2.1 * seed), push * math.sin(2.1 * seed)
                pushes = f"pushes:\n  - {{at: 2, for: 0.1, link: base, impulse: [{x:.3f}, {y:.3f}, 0]}}\n" if what == "push" else ""
                text = walk_scene(64, 60, min(SPEED, self.speed), 6, 10) if what == "trot" else STAND.format(pushes)
                failed = self.run(self.scene(what, text, scratch), seed)
                passed += not failed
                self.causes += [f"{what}: {cause}" for cause in failed]
            found[what] = [passed, self.tilt]
        return found


def main(words):
    command = asked(words, __doc__, {"--wheel": "", "--seeds": "3", "--only": "", "--keep": "", "--csv": ""})
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
            found = robot.rows(seeds, pathlib.Path(scratch))
            print(f"{robot.name:20} {robot.mass:5.1f} kg, legs {robot.leg:.2f} m, check {robot.seconds:.1f} s: "
                  + ", ".join(f"{what} {passed}/{seeds} (tilt {tilt:.2f})" for what, (passed, tilt) in found.items())
                  + f"; trots up to {robot.speed:.2f} m/s", flush=True)
            for cause in dict.fromkeys(robot.causes):
                print(f"{'':28}   {cause}", flush=True)
            for what, (passed, tilt) in found.items():
                bad += seeds - passed
                rows.append(["quadruped", robot.name, what, "degrees", f"{tilt:.3f}", passed])
    if options["--csv"]:
        write_rows(options["--csv"], ["bench", "case", "metric", "unit", "value", "passed"], rows)
    if not looked:
        print("no description with four legs was found")
    else:
        print(f"{looked} quadrupeds, {bad} of {3 * seeds * looked} runs failed")
    return 1 if bad or not looked else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
