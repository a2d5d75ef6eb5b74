#!/usr/bin/env python3
"""./twinbus chart guard [--out DIR] [--redraw]: what watching for self-collision takes while the robot walks (the paper's Fig. 9).

walk_forward is run and logged; then every state of it is judged by the exact check of all pairs on their meshes, by the same on the
pairs that can touch within the ranges the joints kept to, and by a tick of the guard (distances, look-ahead).  Written as SVG, PNG
and CSV to DIR (default test/charts/guard); --redraw draws from the CSV that is there.
"""

import pathlib
import subprocess
import sys
import tempfile

import charts
import chart_walk
import plot

CURVES = (("guard_us", "guard tick"), ("all_us", "exact, all pairs"), ("reduced_us", "exact, reduced list"))
PERIOD = 0.002  # [s]


def measure():
    program = chart_walk.twinbus()
    with tempfile.TemporaryDirectory() as folder:
        log, states, file = (pathlib.Path(folder) / name for name in ("walk.log", "walk.csv", "guard.csv"))
        subprocess.run([program, "run", "walk_forward", "--for", "8", "--log", log], capture_output=True, check=False)
        subprocess.run([program, "log", "csv", log, "STATE", states, "--fields", "q", "--numbers"], capture_output=True, check=True)
        subprocess.run([program.parent / "guard_walk_bench", "--states", states, "--csv", file], check=True)
        return charts.read(file)


def draw(rows, folder):
    curves, words = [], []
    for key, name in CURVES:
        values = [float(row[key]) for row in rows]
        words.append(f"{name} {sorted(values)[len(values) // 2]:.1f}")
        # Of every 20 ticks the median: what else the machine does is no part of it.
        curves.append((name, [(PERIOD * i, sorted(values[i:i + 20])[len(values[i:i + 20]) // 2]) for i in range(0, len(values), 20)]))
    words = "medians in us: " + ", ".join(words)
    print(words, flush=True)
    charts.drawn(folder / "guard.svg", plot.write(folder / "guard.svg", plot.lines("Self-collision while walking at 0.55 m/s, hrp1s", words, "time [s]", "time of a tick [us]", curves)))


if __name__ == "__main__":
    sys.exit(charts.one("chart guard", __doc__, "guard.csv", measure, draw))
