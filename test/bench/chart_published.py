#!/usr/bin/env python3
"""./twinbus chart published [TEST...] [--data DIR] [--out DIR] [--redraw]: error against cost of SimBenchmark's tests (./twinbus bench published).

DIR of --data as `bench published` takes it.  Written as SVG, PNG and CSV to DIR of --out (default test/charts/published); --redraw draws
from the CSV that is there.
"""

import csv
import pathlib
import sys
import tempfile

import bench_published as bench
import charts
import plot

FINEST = "places of links after 2 s, against each engine's finest step"
ABOUT = {"stand": ("ANYmal stands on its servos", FINEST), "drop": ("ANYmal thrown up and let fall", "mean of the squared error of energy"),
         "momentum": ("A ball flies into ANYmal", "mean of the squared error of momentum"), "atlas": ("Atlas dropped by 5 cm", FINEST),
         "balls": ("216 balls fall into a heap", "mean over the run of the sum of squared depths"),
         "rolling": ("A box pulled from under 25 balls", "mean of the squared error of velocities"),
         "bouncing": ("49 balls that bounce for ever", "mean of the squared error of energy")}
LEAST = 1e-16  # what is better is drawn there


def measure(test, data):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "published.csv"
        bench.main([test, "--csv", str(file), *(["--data", data] if data else [])])  # what falls short is in the curves
        return list(csv.DictReader(open(file, newline=""))) if file.exists() else []


def draw(test, rows, folder):
    names = list(dict.fromkeys(row["engine"] for row in rows))
    curves = [(name, [(float(r["cpu_s"]), max(LEAST, float(r["error"]))) for r in rows if r["engine"] == name], name.startswith("MuJoCo"))
              for name in names]
    return plot.write(folder / f"{test}.svg", plot.loglog(ABOUT[test][0], f"{ABOUT[test][1]}; lower left is better; points are steps", f"CPU time of {bench.SECONDS[test]:g} s simulated [s]",
                                                          f"error [{bench.UNIT[test]}]", curves))


def main(words):
    what = charts.asked("chart published", __doc__, words, bench.TESTS, ("--data",))
    for test in what.names or bench.TESTS:
        if what.redraw and not (what.folder / f"{test}.csv").exists():
            continue
        rows = charts.read(what.folder / f"{test}.csv") if what.redraw else measure(test, what.options.get("--data"))
        if not rows:
            continue
        if not what.redraw:
            charts.write(what.folder / f"{test}.csv", rows)
        charts.drawn(what.folder / f"{test}.svg", draw(test, rows, what.folder))
    return 0


if __name__ == "__main__":
    sys.exit(charts.run(main))
