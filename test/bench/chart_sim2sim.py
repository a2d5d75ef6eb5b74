#!/usr/bin/env python3
"""./twinbus chart sim2sim [--out DIR] [--redraw]: one controller in every engine, how far they part (./twinbus bench sim2sim).

hrp1s sways and walks, and the G1 of $TWINBUS_DATA on the folder that `check --propose` writes, where it is there.  Written as SVG, PNG and CSV to
DIR (default test/charts/sim2sim); --redraw draws from the CSV that is there.
"""

import math
import pathlib
import subprocess
import sys
import tempfile

import bench_sim2sim
import charts
import plot

MEAN = 8  # rows, of speed: about a stride of 0.8 s


def measure():
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "sim2sim.csv"
        bench_sim2sim.main(["--csv", str(file)])  # a fall is in the curves
        return charts.read(file)


def mean(values):
    return [sum(values[max(0, k - MEAN + 1):k + 1]) / (k - max(0, k - MEAN + 1) + 1) for k in range(len(values))]


def draw(rows, folder):
    panels, worlds = [], list(dict.fromkeys(row["world"] for row in rows))
    for controller in dict.fromkeys(row["controller"] for row in rows):
        of = {world: [row for row in rows if (row["controller"], row["world"]) == (controller, world)] for world in worlds}
        first = of[worlds[0]]

        def curves(value, of=of):
            return [[(float(row["time"]), y) for row, y in zip(of[world], value(of[world]))] for world in worlds]

        def from_first(key, factor, first=first):
            return lambda these: [factor * (float(row[key]) - float(base[key])) for row, base in zip(these, first)]
        panels += [
            (f"{controller}: base, from {worlds[0]} [mm]", "", curves(
                lambda these, first=first: [1e3 * math.hypot(float(row["x"]) - float(base["x"]), float(row["y"]) - float(base["y"]))
                                            for row, base in zip(these, first)])),
            ("speed, mean of a stride [m/s]", "", curves(lambda these: mean([float(row["speed"]) for row in these]))),
            ("creep of loaded soles, both [mm]", "", curves(lambda these: [1e3 * float(row["creep"]) for row in these])),
            ("force of the left foot, from it [% of weight]", "", curves(from_first("force", 100.0)))]
    charts.drawn(folder / "sim2sim.svg", plot.write(folder / "sim2sim.svg", plot.panels(
        "One controller in every engine", "engines articulated (contact spring_damper; hunt_crossley, patch, soft), ode and mujoco", "time [s]", [world.split("/")[-1] for world in worlds], panels, high=84)))


if __name__ == "__main__":
    sys.exit(charts.one("chart sim2sim", __doc__, "sim2sim.csv", measure, draw))
