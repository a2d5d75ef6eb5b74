"""Figs. 12, 13, 14 and 15 of the paper on hrp1s, drawn by chart_physics.py: a damped oscillation beside its linear model, the normal
force of a foot on soft soles and in rigid contact, and on rough ground with the paper's own contact force."""

import csv
import json
import math
import pathlib
import subprocess
import tempfile

import plot
from chart_walk import FAST, above

RELEASED, SHOWN = 3.0, 2.5  # [s], of scene release
ANKLE = 17  # LLEG_ANKLE_P on the bus of hrp1s
CONTACTS = (("articulated", "spring_damper", "soft soles"), ("articulated", "hunt_crossley", "hunt_crossley"), ("articulated", "patch", "patch"),
            ("ode", "spring_damper", "soft soles, ode"), ("ode", "rigid", "rigid contact, ode"))


def recorded(lab, channel, fields, *words):
    """(rows of a channel, report) of a run."""
    program = pathlib.Path(lab.bin) / "twinbus"
    if not program.exists():
        raise SystemExit("chart physics: twinbus is not built; run ./twinbus once")
    with tempfile.TemporaryDirectory() as scratch:
        log, report = pathlib.Path(scratch) / "run.log", pathlib.Path(scratch) / "report.json"
        # A run that its scene's criteria fail is shown too.
        subprocess.run([str(w) for w in (program, "run", *words, "--log", log, "--report", report)], capture_output=True, check=False)
        table = subprocess.run([str(w) for w in (program, "log", "csv", log, channel, "--fields", fields, "--numbers")], capture_output=True,
                               text=True, check=True)
        return list(csv.DictReader(table.stdout.splitlines())), json.loads(report.read_text())


def measure_release(lab):
    for engine in ("articulated", "ode"):
        rows, report = recorded(lab, "STATE", "tau", "release", "--engine", engine)
        rest = float(rows[-1][f"tau[{ANKLE}]"])
        start = min(range(len(rows)), key=lambda i: abs(1e-6 * float(rows[i]["utime"]) - float(rows[0]["utime"]) * 1e-6 - RELEASED))
        after = [float(row[f"tau[{ANKLE}]"]) - rest for row in rows[start:]]
        for i, torque in enumerate(after[:int(SHOWN / 0.002)]):
            yield {"engine": engine, "time": f"{0.002 * i:.3f}", "torque_nm": f"{torque:.5g}", "period_s": report["swing_period_s"],
                   "decay_per_s": report["swing_decay_per_s"], "linear_period_s": report["linear_period_s"],
                   "linear_decay_per_s": report["linear_decay_per_s"]}
        print(f"release: {engine}", flush=True)


def draw_release(rows, folder):
    curves, words = [], []
    for engine in dict.fromkeys(row["engine"] for row in rows):
        own = [row for row in rows if row["engine"] == engine]
        curves.append((engine, [(float(r["time"]), float(r["torque_nm"])) for r in own]))
        words.append(f"{engine} {float(own[0]['period_s']):.4f} s, {float(own[0]['decay_per_s']):.3f} /s")
    own = rows[0]
    period, decay = float(own["linear_period_s"]), float(own["linear_decay_per_s"])
    words.append(f"linear model {period:.4f} s, {decay:.3f} /s")
    first = curves[0][1]
    top_time, top = max(first[len(first) // 20:], key=lambda at: at[1])  # the first swing back
    model = [(t, top * math.exp(-decay * (t - top_time)) * math.cos(2.0 * math.pi * (t - top_time) / period)) for t, _ in first
             if t >= top_time]
    curves.append(("linear model", model))
    return plot.write(folder / "release.svg", plot.lines("Pushed out of its posture and let go: torque of the left ankle's pitch",
                                                         "; ".join(words), "time since the release [s]", "torque, from that at rest [N m]",
                                                         curves))


def measure_feet(lab, scene, begin, end, contacts=CONTACTS):
    for engine, contact, name in contacts:
        rows, _ = recorded(lab, "TRUTH", "foot_force", scene, "--engine", engine, "--set", f"contact={contact}", "--for", end)
        start = float(rows[0]["utime"])
        for row in rows:
            time = 1e-6 * (float(row["utime"]) - start)
            if time >= begin:
                yield {"contact": name, "time": f"{time:.3f}", "force_n": f"{float(row['foot_force[0][2]']):.5g}"}
        print(f"{scene}: {name}", flush=True)


def draw_feet(rows, folder, scene, title):
    curves = []
    for name in dict.fromkeys(row["contact"] for row in rows):
        own = [(float(r["time"]), float(r["force_n"])) for r in rows if r["contact"] == name]
        curves.append((f"{name}, {100.0 * above([force for _, force in own], FAST, 0.002):.2f} %", own))
    curves.sort(key=lambda curve: "rigid" not in curve[0])  # the others on top of it
    return plot.write(folder / f"{scene}.svg", plot.lines(title, f"in %: what of it is above {FAST:.0f} Hz, of the weight", "time [s]",
                                                          "force [N]", curves))


ROUGH = (("articulated", "spring_damper", "springs at the corners"), ("articulated", "patch", "the paper's section 3.3 (patch)"))


MEASURE = {"release": measure_release, "sway": lambda lab: measure_feet(lab, "sway", 2.0, 5.0),
           "stamp": lambda lab: measure_feet(lab, "stamp", 1.0, 4.0), "walk_rough": lambda lab: measure_feet(lab, "walk_rough", 4.0, 8.0, ROUGH)}
DRAW = {"release": draw_release, "sway": lambda rows, folder: draw_feet(rows, folder, "sway", "Normal force of the left foot, swaying"),
        "stamp": lambda rows, folder: draw_feet(rows, folder, "stamp", "Normal force of the left foot, stepping on the spot"),
        "walk_rough": lambda rows, folder: draw_feet(rows, folder, "walk_rough", "Fig. 15: normal force of the left foot on tiles of 30 mm")}
