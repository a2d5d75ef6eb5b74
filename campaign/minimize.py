"""`campaign minimize OUT ID`: the fewest and smallest ingredients of a run with which it still fails in the same way.

Ingredients are the entries of a scene's lists (pushes, loose bodies, obstacles, ...), its maps that disturb (terrain, push_round,
disturbance, ground), the settings of the scene and of the task; what the robot is asked to do (modes:) stays. First they are left out in ever
smaller groups (delta debugging, Zeller 2002), then the time is cut, then the numbers of what is left are made smaller and rounder.

The result is a scene, OUT/minimal/ID.yaml, whose first lines say how to run it and what happens.
"""

import argparse
import copy
import os
import pathlib

import yaml

from command import PROGRAM, Parser
from errors import CampaignError
from report import read

LISTS = ("pushes", "goals", "walks", "pads", "footsteps", "obstacles", "bodies", "loose", "robots", "loops", "grasps")
MAPS = ("terrain", "push_round", "disturbance", "ground", "start_velocity")
KEPT = {"modes", "robot", "engine", "duration", "start_pose", "base", "criteria", "about"}
SIZES = ("impulse", "mass", "height", "slope_deg", "ramp_deg", "forward", "back", "sideways")  # zero is the smallest
SHRINKS = 6      # halvings of a number
ROUND = (1, 2, 3)  # significant digits


class Minimizer:
    def __init__(self, task, result, run):
        self.task, self.run_tasks, self.runs = task, run, 0
        text = task.get("scene_text")
        if text is None:
            raise CampaignError(f"{task['id']}: its scene names files beside it; minimize a scene without mesh files")
        self.scene = yaml.safe_load(text) or {}
        settings = {**(self.scene.pop("settings", None) or {}), **task["settings"]}
        if settings:
            self.scene["settings"] = settings
        self.fell = bool(result["figures"].get("fell"))
        self.status = result["status"]
        self.failure = [sentence.split(",")[0][:40] for sentence in result["failures"]]
        self.seed = task["seed"]
        self.duration = task["for"] or float(self.scene.get("duration", 10))
        self.known = {}

    def ingredients(self):
        """Ways into the scene, each to one thing that can be left out."""
        found = []
        for key, value in self.scene.items():
            if key in LISTS and isinstance(value, list):
                found += [(key, i) for i in range(len(value))]
            elif key in MAPS:
                found.append((key,))
            elif key == "settings":
                found += [(key, name) for name in value]
            elif key not in KEPT:
                found.append((key,))
        return found

    def without(self, gone):
        scene = copy.deepcopy(self.scene)
        for way in sorted(gone, key=str, reverse=True):
            if len(way) == 1:
                scene.pop(way[0], None)
        for key in {way[0] for way in gone if len(way) == 2}:
            if isinstance(scene[key], list):
                scene[key] = [value for i, value in enumerate(scene[key]) if (key, i) not in gone]
            else:
                scene[key] = {name: value for name, value in scene[key].items() if (key, name) not in gone}
            if not scene[key]:
                del scene[key]
        return scene

    def make(self, scene, duration=None, seed=None):
        text = yaml.safe_dump(scene, default_flow_style=None, sort_keys=False, width=1000)
        import hashlib
        name = hashlib.sha256(f"{text} {duration} {seed}".encode()).hexdigest()[:16]
        return dict(self.task, id=name, scene="minimal", scene_text=text, scene_hash=name, settings={}, varied={},
                    seed=self.seed if seed is None else seed, **{"for": duration or self.duration})

    def fails(self, scenes, duration=None, seed=None):
        """Of each scene whether it fails as the run did."""
        tasks = [self.make(scene, duration, seed) for scene in scenes]
        left = list({task["id"]: task for task in tasks if task["id"] not in self.known}.values())
        if left:
            self.runs += len(left)
            self.run_tasks(left, lambda result: self.known.__setitem__(result["id"], result))
        return [self.same(self.known[task["id"]]) for task in tasks]

    def same(self, result):
        if result["status"] != self.status:
            return False
        if self.fell or self.status != "failed":
            return bool(result["figures"].get("fell")) == self.fell
        return any(sentence.startswith(start) for sentence in result["failures"] for start in self.failure)

    def leave_out(self, batch):
        """Delta debugging over the ingredients."""
        kept, parts = self.ingredients(), 2
        if kept and self.fails([self.without(kept)])[0]:
            raise CampaignError(f"{self.task['id']}: the scene fails with every ingredient left out: its modes alone do it")
        everything = list(kept)
        while len(kept) >= 2:
            size = max(1, len(kept) // parts)
            groups = [kept[i:i + size] for i in range(0, len(kept), size)]
            tried = [part for part in groups] + ([[i for i in kept if i not in part] for part in groups] if len(groups) > 2 else [])
            found = None
            for i in range(0, len(tried), batch):
                some = tried[i:i + batch]
                fails = self.fails([self.without([x for x in everything if x not in part]) for part in some])
                found = next((part for part, bad in zip(some, fails) if bad), None)
                if found:
                    break
            if found:
                parts = 2 if found in groups else max(parts - 1, 2)
                kept = found
            elif parts >= len(kept):
                break
            else:
                parts = min(len(kept), 2 * parts)
        self.count = (len(kept), len(everything))
        self.scene = self.without([x for x in everything if x not in kept])

    def cut_time(self):
        """The shortest time in which it fails, within a tenth."""
        low, high = 0.0, self.duration
        for _ in range(5):
            if high - low <= 0.1 * high:
                break
            middle = float(f"{0.5 * (low + high):.3g}")
            if self.fails([self.scene], duration=middle)[0]:
                high = middle
            else:
                low = middle
        self.duration = high
        self.scene["duration"] = high

    def numbers(self):
        """Ways to the numbers that may become smaller."""
        found = []

        def look(value, way):
            if isinstance(value, bool):
                return
            if isinstance(value, (int, float)):
                named = [word for word in way if isinstance(word, str)][-1]
                if value and (named in SIZES or way[0] in ("settings", "disturbance")):
                    found.append(way)
            elif isinstance(value, dict):
                for key, child in value.items():
                    look(child, way + (key,))
            elif isinstance(value, list):
                for i, child in enumerate(value):
                    look(child, way + (i,))
        for key in (*LISTS, *MAPS, "settings"):
            if key in self.scene:
                look(self.scene[key], (key,))
        return found

    def with_number(self, way, number):
        scene = copy.deepcopy(self.scene)
        node = scene
        for word in way[:-1]:
            node = node[word]
        node[way[-1]] = number
        return scene

    def shrink_numbers(self):
        for way in self.numbers():
            node = self.scene
            for word in way:
                node = node[word]
            value = float(node)
            neutral = 1.0 if str(way[-1]).endswith("_scale") else 0.0
            low, high = neutral, value  # high fails
            if self.fails([self.with_number(way, neutral)])[0]:
                self.scene = self.with_number(way, neutral)
                continue
            for _ in range(SHRINKS):
                middle = 0.5 * (low + high)
                if abs(high - low) <= 0.05 * abs(high - neutral):
                    break
                if self.fails([self.with_number(way, middle)])[0]:
                    high = middle
                else:
                    low = middle
            for digits in ROUND:  # rounded away from neutral: towards what fails
                rounded = float(f"{high + 0.02 * (high - neutral):.{digits}g}")
                if abs(rounded - neutral) <= abs(value - neutral) and self.fails([self.with_number(way, rounded)])[0]:
                    high = rounded
                    break
            self.scene = self.with_number(way, int(high) if float(high).is_integer() and isinstance(node, int) else high)

    def plain_seed(self):
        if self.seed != 1 and self.fails([self.scene], seed=1)[0]:
            self.seed = 1

    def reduce(self, batch):
        if not self.fails([self.scene])[0]:
            raise CampaignError(f"{self.task['id']}: run again it does not fail in the same way; is it the same program?")
        self.leave_out(batch)
        self.cut_time()
        self.shrink_numbers()
        self.plain_seed()
        if not all(self.fails([self.scene])):
            raise CampaignError(f"{self.task['id']}: the small scene does not fail; please report this")

    def text(self, path):
        robot = self.task.get("robot_path") or self.task["robot"]
        self.scene.setdefault("robot", robot)
        self.scene["about"] = f"Smallest scene that fails as run {self.task['id']} of {self.task['scene']} did."
        guard = "" if self.task.get("guard", True) else " --no-guard"
        order = ["about", *(key for key in self.scene if key != "about")]
        return (f"# {PROGRAM} run {path} --seed {self.seed}{guard}   # {'falls' if self.fell else 'fails'}: exit status 1\n"
                + yaml.safe_dump({key: self.scene[key] for key in order}, default_flow_style=None, sort_keys=False, width=120))


def minimize_command(words):
    parser = Parser("minimize", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("id", nargs="?", help="default: the worst run that failed")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args(words)
    import local
    import report
    pairs, _ = read(given.out)
    failed = [pair for pair in sorted(pairs, key=report.badness) if pair[1]["status"] in ("failed", "crashed", "timeout")]
    if given.id is None:
        if not failed:
            raise CampaignError(f"{given.out}: no run failed")
        given.id = failed[0][0]["id"]
    found = [pair for pair in failed if pair[0]["id"] == given.id]
    if not found:
        raise CampaignError(f"{given.out}: run {given.id} is not there or did not fail; ids are in results.csv")
    if "arguments" in found[0][0]:
        raise CampaignError(f"{given.id}: is no run of a scene but of {found[0][0]['program']}, which has no ingredients")
    pool = local.Threads(max(1, given.workers))
    try:
        small = Minimizer(*found[0], pool.run)
        small.reduce(max(1, given.workers))
    finally:
        pool.close()
    path = pathlib.Path(given.out) / "minimal" / f"{given.id}.yaml"
    path.parent.mkdir(exist_ok=True)
    text = small.text(path)
    path.write_text(text, encoding="utf-8")
    kept, all_of = small.count
    print(f"{all_of} ingredients, {kept} of them are left; {small.runs} runs\n\n{text}\n{path}")
    return 0
