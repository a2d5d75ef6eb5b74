#!/usr/bin/env python3
"""./twinbus bench maps [MAP...] [--quick] [--twin] [--engine E] [--csv F]: where each engine fails, how, and whether it said so.

Scenes are made worse until they fail: step to 100 ms, gains x100, ground 1e4 to 1e10 N/m a corner, friction 0 to 3, bodies to 50 m/s,
thin plates, edges, mass ratios to 1e6, stacks to 200, chains to 1000, loops in their singular posture, and a walk with late servos, a
slow loop and noise.  Ours at orders 1 and 2, ODE, and MuJoCo where its Python package is (pip install mujoco).

Engines run as they do by default; --twin: ours and ODE with a twin of half the step beside them (setting solver.twin).
MuJoCo has its own warnings.  Wrong: more than 5 mm from a converged run or a closed form (throw, plate and edge have none for places),
5 % of energy gained (or lost where nothing takes any), through or below what should stop it, diverged.  Said: the engine doubted a step
(report: doubted_steps) up to the moment at which it was wrong; in_step: one of the steps since the look before.
Maps: stand slide throw plate edge ratio stack chain loop delay rate noise (default: all; about ten minutes).  --quick: a few cells of
each, seconds.  Exit status 1 if one of our cells is wrong and did not say so, or if an engine is never right or never wrong.
"""

import dataclasses
import json
import math
import subprocess
import sys
import time

import charts
import programs
from failure_cells import ENGINES, MAPS, QUICK
from peers import mujoco_maps

WRONG = 5e-3  # [m]
PARTED = 1e-3  # references that are so far apart say nothing more [m]
FIELDS = ("map", "row", "column", "engine", "result", "said", "wrong_at_s", "said_at_s", "in_step", "error_mm", "gain_percent", "cpu_s")
HOW = {"diverges": "D", "tunnels": "T", "sinks": "S", "gains energy": "G", "loses energy": "L", "falls": "F", "slips": "P",
       "chatters": "C", "off": "O", "slow": "-", "cannot": "-", "doubted": "u", "right": ""}
OURS = ("articulated1", "articulated2")
# How a map's places are judged: settings of the common reference and its check, or of the engine's own finest run.
COMMON = {"chain": ({"engine": "rkf78", "step": 5e-4}, {"engine": "rkf78", "step": 1e-3}),
          "loop": ({"engine": "articulated3", "step": 2e-4}, {"engine": "articulated3", "step": 4e-4})}
OWN = {"articulated1": ({"engine": "articulated2", "step": 5e-4}, {"engine": "articulated2", "step": 1e-3}),
       "articulated2": ({"engine": "articulated2", "step": 5e-4}, {"engine": "articulated2", "step": 1e-3}),
       "ode": ({"engine": "ode", "step": 1e-3}, {"engine": "ode", "step": 2e-3}),
       "mujoco": ({"engine": "mujoco", "step": 5e-4}, {"engine": "mujoco", "step": 1e-3})}


class Rig:
    def __init__(self, who, twin=False):
        self.twin = twin
        folder = programs.folder_of("failure_maps", who)
        self.mujoco = mujoco_maps.loaded()
        words = [[folder / "failure_maps"]] + [[folder / "failure_maps", "mujoco"]] * bool(self.mujoco)
        self.running = [subprocess.Popen(word, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) for word in words]
        self.references = {}

    def ask(self, program, cell):
        program.stdin.write(json.dumps(cell) + "\n")
        program.stdin.flush()
        line = program.stdout.readline()
        if not line:
            raise RuntimeError(f"failure_maps ended on {cell}")
        return json.loads(line)

    def run(self, cell):
        """What became of each scene of a cell, or {"error": WHY}."""
        if cell["engine"] != "mujoco":
            return self.ask(self.running[0], cell)
        scenes = self.ask(self.running[1], {**cell, "engine": "articulated1"})
        try:
            return [mujoco_maps.run(self.mujoco, scene, cell) for scene in scenes]
        except (ValueError, self.mujoco.FatalError) as error:  # a tree that is too deep
            return {"error": str(error)}

    def reference(self, cell):
        """({time: places}, up to when it holds [0.1 ms])"""
        pair = COMMON.get(cell["map"]) or OWN[cell["engine"]]
        physics = {key: value for key, value in cell.items() if key not in ("engine", "step")}
        key = json.dumps([physics, pair[0]])
        if key not in self.references:
            fine, check = (self.run({**physics, **settings}) for settings in pair)
            at, until = {}, -1
            if isinstance(fine, list) and isinstance(check, list):
                at = fine[0]["at"]
                for when in sorted(set(at) & set(check[0]["at"]), key=int):
                    if apart(at[when], check[0]["at"][when])[0] > PARTED:
                        break
                    until = int(when)
            self.references[key] = at, until
        return self.references[key]

    def close(self):
        for program in self.running:
            program.stdin.close()
            program.wait()


def apart(a, b):
    """The largest distance of two lists of places, and its horizontal part [m]."""
    worst = (0.0, 0.0)
    for i in range(0, len(a), 3):
        d = [x - y for x, y in zip(a[i:i + 3], b[i:i + 3])]
        if not math.hypot(*d) <= worst[0]:
            worst = math.hypot(*d), math.hypot(d[0], d[1])
    return worst


def slid(cell, when):
    """Where the sliding box should be: x = v t - mu g t^2 / 2 until it stands."""
    speed, slowing = 2.0, cell["friction"] * 9.81
    t = min(1e-4 * when, speed / slowing)
    return speed * t - 0.5 * slowing * t * t


def error_at(rig, cell, when, places):
    """Largest distance from where everything should be, and its horizontal part [m]; None: nobody knows."""
    if cell["map"] == "slide":
        off = math.hypot(places[0] - slid(cell, int(when)), places[1])
        return off, off
    if cell["map"] == "stack" and cell["count"] > 2:  # straight up; how far its springs are pressed is no failure
        off = max(math.hypot(*places[i:i + 2]) for i in range(0, len(places), 3))
        return off, off
    at, until = rig.reference(cell)
    return apart(places, at[when]) if int(when) <= until and when in at else None


@dataclasses.dataclass
class Verdict:
    """Of one scene; times in s, None: never."""
    how: str
    said: str
    said_at: float | None
    error: float  # [m]
    wrong_at: float | None = None
    in_step: bool = False  # doubted in a step since the look before it was wrong

    def is_silent(self):
        return self.wrong_at is not None and (self.said_at is None or self.said_at > self.wrong_at + 1e-9)


def judged(rig, cell, found):
    """The Verdict on a scene of a cell."""
    events, error, before = [], 0.0, 0.0  # (when, how, since when a doubt is of that step)
    name, h = cell["map"], cell["step"]
    for when in sorted(found["at"], key=int):
        off, now = error_at(rig, cell, when, found["at"][when]), 1e-4 * int(when)
        if off is None:
            continue
        error = max(error, off[0]) if off[0] == off[0] else math.inf
        if not off[0] <= WRONG:
            events.append((now, "slips" if name in ("slide", "stand", "stack") and off[1] > 0.7 * off[0] else "off", before))
        before = now
    for key, how in (("energy_at", "gains energy" if found["gain"] > 0.05 else "loses energy"),
                     ("through_at", "tunnels" if name in ("plate", "edge") else "sinks")):
        if found[key] is not None:
            events.append((found[key], how, found[key] - h))
    said_at = found["said_at"]
    if found["status"] == "diverged":
        events.append((found["ended"], "diverges", -math.inf))
        said_at = events[-1][0] if said_at is None else said_at
    if found["status"] == "ok" and name in ("stand", "stack"):
        if found["upright"] < 0.9:
            events.append((math.inf, "falls", 0.0))
        elif events and found["speed"] > 0.5:
            events.append((math.inf, "chatters", 0.0))
    if not events:
        how = "slow" if found["status"] == "slow" else "doubted" if said_at is not None else "right"
        return Verdict(how, found.get("said", ""), said_at, error)
    first, kind, since = min(events, key=lambda event: event[0])
    in_step = kind == "diverges" or any(a <= first + 1e-9 and b > since - 1e-9 for a, b in found["doubts_at"])
    how = min((event[1] for event in events), key=list(HOW).index)
    return Verdict(how, found.get("said", "diverged"), said_at, error, first, in_step)


def measure(rig, map_, engine, row, column, cell):
    """A row of the table."""
    line = dict.fromkeys(FIELDS, "")
    line.update({"map": map_.name, "row": row, "column": column, "engine": engine, "result": "cannot"})
    if map_.left_out(engine, cell):
        return {**line, "result": "slow"}
    begun = time.monotonic()
    cell = {**cell, "engine": engine}
    found = rig.run({**cell, "twin": rig.twin})
    line["cpu_s"] = f"{time.monotonic() - begun:.2f}"
    if isinstance(found, dict):
        if "held" in found:  # a walk: the robot may fall, whatever the engine
            return {**line, "result": "right" if found["held"] else "falls", "said": "walk"}
        return {**line, "said": found["error"].splitlines()[0][:60]}
    every = [judged(rig, cell, scene) for scene in found]
    wrong = [verdict for verdict in every if verdict.wrong_at is not None]
    silent = [verdict for verdict in wrong if verdict.is_silent()]
    worst = min(silent or wrong or every, key=lambda verdict: list(HOW).index(verdict.how))
    line.update({"result": worst.how, "said_at_s": "" if worst.said_at is None else f"{worst.said_at:g}",
                 "error_mm": f"{1e3 * max(verdict.error for verdict in every):.3g}" if any(scene["at"] for scene in found) else "",
                 "gain_percent": f"{100 * max(scene['gain'] for scene in found):.3g}"})
    if wrong:
        state = "silent" if any(verdict.said_at is None for verdict in silent) else "late" if silent else "said"
        line.update({"said": f"{state}: {worst.said}" if worst.said_at is not None else state, "wrong_at_s": f"{worst.wrong_at:g}",
                     "in_step": "yes" if all(verdict.in_step for verdict in wrong) else "no"})
    elif worst.said_at is not None:
        line["said"] = worst.said
    return line


def measured(who, maps, engines, quick=False, twin=False):
    """Every line, with progress on the standard error."""
    rig = Rig(who, twin)
    if rig.mujoco is None and "mujoco" in engines:
        print("MuJoCo: not installed, left out (pip install mujoco)")
    for map_ in maps:
        for engine in map_.engines:
            if engine not in engines or (engine == "mujoco" and rig.mujoco is None):
                continue
            chosen = [each for each in map_.cells() if not quick or (map_.name, each[0], each[1]) in QUICK]
            for number, (row, column, cell) in enumerate(chosen):
                if sys.stderr.isatty():
                    print(f"\r{map_.name} {ENGINES[engine]}: {number + 1} of {len(chosen)}   ", end="", file=sys.stderr)
                yield measure(rig, map_, engine, row, column, cell)
            if sys.stderr.isatty():
                print("\r" + 60 * " ", end="\r", file=sys.stderr)
    rig.close()


def is_wrong(line):
    return line["result"] not in ("right", "doubted", "slow", "cannot")


def is_silent(line):
    return line["engine"] in OURS and line["said"].startswith(("silent", "late"))


def total(name, lines):
    wrong = [line for line in lines if is_wrong(line) and line["said"] != "walk"]
    print(f"{name}: {len(lines)} cells, {len(wrong)} wrong, of these {sum(line['said'] in ('', 'silent') for line in wrong)} unsaid, "
          f"{sum(line['said'].startswith('late') for line in wrong)} said late, {sum(line['in_step'] == 'yes' for line in wrong)} said in that step; "
          f"{sum(line['result'] == 'doubted' for line in lines)} right but doubted; {sum(line['result'] == 'falls' and line['said'] == 'walk' for line in lines)} "
          f"walks fell; {sum(line['result'] in ('slow', 'cannot') for line in lines)} left out")


def summary(lines):
    """Prints a row for each map and engine; True: none of ours was silently wrong."""
    print(f"{'map':8s} {'engine':22s} {'cells':>6s} {'right':>6s} {'doubted':>8s} {'wrong':>6s} {'unsaid':>7s}  how")
    for name, engine in dict.fromkeys((line["map"], line["engine"]) for line in lines):
        own = [line for line in lines if (line["map"], line["engine"]) == (name, engine)]
        wrong = [line for line in own if is_wrong(line)]
        how = {word: sum(line["result"] == word for line in own) for word in HOW if word not in ("right", "doubted")}
        print(f"{name:8s} {ENGINES[engine]:22s} {len(own):6d} {sum(line['result'] == 'right' for line in own):6d} "
              f"{sum(line['result'] == 'doubted' for line in own):8d} {len(wrong):6d} "
              f"{sum(line['said'].startswith(('silent', 'late')) for line in own):7d}  "
              + ", ".join(f"{count} {word}" for word, count in how.items() if count))
    for engine in dict.fromkeys(line["engine"] for line in lines):
        total(ENGINES[engine], [line for line in lines if line["engine"] == engine])
    total("ours together", [line for line in lines if line["engine"] in OURS])
    unsaid = [line for line in lines if is_silent(line)]
    for line in unsaid:
        print(f"not said: {line['map']}, {line['row']}, {line['column']}, {ENGINES[line['engine']]}: {line['result']} "
              f"(off {line['error_mm'] or 0} mm, gains {line['gain_percent'] or 0} %), {line['said']}")
    return not unsaid


def main(words):
    if "--help" in words or "-h" in words:
        print(__doc__.strip())
        return 0
    known = {map_.name: map_ for map_ in MAPS}
    quick, twin, file, names, engines = False, False, None, [], []
    while words:
        word = words.pop(0)
        if word == "--quick":
            quick = True
        elif word == "--twin":
            twin = True
        elif word == "--csv" and words:
            file = words.pop(0)
        elif word == "--engine" and words and words[0] in ENGINES:
            engines.append(words.pop(0))
        elif word in known:
            names.append(word)
        else:
            print(f"bench maps: no map or option '{word}'; there are {' '.join(known)} --quick --twin --csv --engine ({' '.join(ENGINES)})", file=sys.stderr)
            return 2
    lines = list(measured("bench maps", [known[name] for name in names or known], engines or list(ENGINES), quick, twin))
    good = summary(lines)
    if file:
        charts.write(file, lines, FIELDS)
    if not quick and not names and not engines:
        for engine in dict.fromkeys(line["engine"] for line in lines):
            own = [is_wrong(line) for line in lines if line["engine"] == engine and line["result"] not in ("slow", "cannot")]
            good = good and any(own) and not all(own)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
