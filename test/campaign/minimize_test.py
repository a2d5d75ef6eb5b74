#!/usr/bin/env python3
"""./twinbus campaign minimize on 20 planted failures: each small scene fails again, and has at most a fifth of the ingredients.

    minimize_test.py              the failures are judged by a rule, without the program
    minimize_test.py --real N     N of them by the program: pushes that fell a standing robot among harmless ones
"""

import os
import pathlib
import random
import sys
import unittest

from campaign_rig import ROOT, Rig

import local
import minimize
import run_task
import yaml

PLANTED = 20
LINKS = ("CHEST", "WAIST_R")


def planted(number):
    """(scene, rule): 14 ingredients, one or two of which fell the robot; the rule says of a scene whether it falls."""
    chance = random.Random(number)
    least = chance.uniform(70, 90)
    x = chance.choice((-1, 1))
    two = number % 2 == 1
    causes = [{"link": "CHEST", "impulse": [x * round(c, 1), 0, 0], "at": 0.2, "duration": 0.1}
              for c in ((0.62 * 1.3 * least,) * 2 if two else (1.4 * least,))]
    pushes = [{"link": chance.choice(LINKS), "impulse": [0, round(chance.uniform(-2, 2), 2), round(chance.uniform(0, 2), 2)],
               "at": round(chance.uniform(0.1, 0.6), 2), "duration": 0.1} for _ in range(7 - len(causes))]
    for cause in causes:
        pushes.insert(chance.randrange(len(pushes) + 1), cause)
    scene = {"about": "planted", "duration": 2.0, "modes": [{"at": 0, "mode": "balance"}], "pushes": pushes,
             "bodies": [{"link": "CHEST", "mass": 0.2}, {"link": "CHEST", "shift": [0.001, 0, 0]}],
             "obstacles": [{"shape": "box", "size": [0.1, 0.1, 0.1], "position": [3 + i, 3, 0.1]} for i in range(2)],
             "ground": {"friction": 0.7}, "settings": {"sensor.noise.force": 0.5, "model.mass_scale": 1.01, "servo.kd_scale": 0.99}}

    def rule(changed):
        return abs(sum(push["impulse"][0] for push in changed.get("pushes", []) if abs(push["impulse"][0]) > 3)) >= least
    return scene, rule


def task_of(scene, number):
    return {"id": f"{number:016x}", "scene": "planted", "scene_text": yaml.safe_dump(scene), "robot": "hrp1s", "settings": {}, "seed": 1 + number,
            "for": 2.0, "program": "none", "program_hash": "", "guard": True}


def by_rule(rule):
    def run(tasks, add):
        for task in tasks:
            fell = rule(yaml.safe_load(task["scene_text"])) and task["for"] > 0.5
            add({"id": task["id"], "status": "failed" if fell else "passed", "figures": {"fell": fell}, "failures": []})
    return run


def reduce(number, run, task):
    small = minimize.Minimizer(task, {"figures": {"fell": True}, "status": "failed", "failures": ["the robot fell"]}, run)
    small.reduce(2)
    return small


class Planted(unittest.TestCase):
    def test_by_a_rule(self):
        for number in range(PLANTED):
            scene, rule = planted(number)
            small = reduce(number, by_rule(rule), task_of(scene, number))
            kept, all_of = small.count
            with self.subTest(number=number):
                self.assertTrue(rule(small.scene), small.scene)
                self.assertLessEqual(kept, all_of / 5, small.scene)
                self.assertLess(small.duration, 1.0)
                self.assertEqual(small.seed, 1)
                # smallest: a twentieth less does not fell
                lighter = yaml.safe_load(yaml.safe_dump(small.scene))
                for push in lighter["pushes"]:
                    push["impulse"][0] *= 0.9
                self.assertFalse(rule(lighter))

    def test_what_does_not_fail_again_is_said(self):
        scene, _ = planted(0)
        with self.assertRaisesRegex(Exception, "does not fail in the same way"):
            reduce(0, by_rule(lambda _: False), task_of(scene, 0))
        with self.assertRaisesRegex(Exception, "its modes alone do it"):
            reduce(0, by_rule(lambda _: True), task_of(scene, 0))


class Command(Rig):
    def test_a_scene_with_its_line(self):
        scene, _ = planted(0)
        self.fake.write_text(self.fake.read_text().replace("passed=true fail", "grep -q 'impulse: .1[0-9][0-9]\\|impulse: .-1[0-9][0-9]' \"$scene\" && push=1 limit=0\npassed=true fail"))
        (self.folder / "p.yaml").write_text(yaml.safe_dump(scene, default_flow_style=None, width=1000))
        self.here(self.file("scenes: p.yaml\nfor: 2\nlogs: 0\n"), "--out", "o", status=1)
        said = self.here("minimize", "o", "--workers", 1)
        self.assertIn("# ./twinbus run o/minimal/", said)
        small = yaml.safe_load(next((self.folder / "o/minimal").glob("*.yaml")).read_text())
        self.assertEqual(len(small["pushes"]), 1)
        self.assertNotIn("obstacles", small)
        self.assertIn("is not there", self.here("minimize", "o", "nobody", status=1))


def real(count):
    program = pathlib.Path(os.environ.get("TWINBUS_PROGRAM") or pathlib.Path(os.environ.get("TWINBUS_BIN", ROOT / "build/release/bin")) / "twinbus")
    bad, pool = 0, local.Threads(2)
    for number in range(count):
        scene, _ = planted(number)
        task = dict(task_of(scene, number), program=str(program), program_hash=run_task.hash_of(program))

        try:
            small = reduce(number, pool.run, task)
        except minimize.CampaignError as error:
            bad += 1
            print(f"{number}: {error}", flush=True)
            continue
        kept, all_of = small.count
        again = [run_task.run_batch([small.make(small.scene)])[0] for _ in range(3)]
        fails = sum(small.same(result) for result in again)
        bad += fails < 3 or kept > all_of / 5
        print(f"{number}: {kept} of {all_of} ingredients, for {small.duration:g} s, {small.runs} runs, fails {fails} of 3 times: "
              f"{small.scene.get('pushes')}", flush=True)
    pool.close()
    print(f"{count - bad} of {count} hold")
    return bad


if __name__ == "__main__":
    if sys.argv[1:2] == ["--real"]:
        sys.exit(1 if real(int(sys.argv[2])) else 0)
    unittest.main()
