#!/usr/bin/env python3
"""./twinbus chart planner [CHART...] [--out DIR] [--vamp DIR] [--redraw]: planning time against what it buys.

Charts: cost (length of the path against the time to plan and shorten it, a dot per problem), meshes (share of the final paths
that hit the exact meshes, by FCL at 1,000 postures per radian, against the median time, a dot per set of problems).
Planners: ours asking what VAMP asks, ours with every line proved, and VAMP where it is present (see bench planner --help).
Written as SVG, PNG and CSV to DIR (default test/charts/planner); --redraw draws from the CSV that is there.
"""

import os
import pathlib
import statistics
import sys

import bench_planner
import charts
import plot
import programs

CHARTS = ("cost", "meshes")
ROUNDS = 3


def measure(vamp):
    data = pathlib.Path(os.environ.get("TWINBUS_DATA", bench_planner.ROOT.parent / "shared/data"))
    problems, folder = data / "problems/panda/panda_problems.txt", programs.folder_of("planner_cases", "chart planner")
    if not problems.exists():
        sys.exit(f"chart planner: {problems} is not there; $TWINBUS_DATA names the folder of data")
    peer = bench_planner.build_vamp(pathlib.Path(vamp) if vamp else None, folder)
    planners = [("ours, VAMP's spheres", [folder / "planner_cases", "as_vamp", data / "robots", problems, ROUNDS]),
                ("ours, every line proved", [folder / "planner_cases", "certain", data / "robots", problems, ROUNDS])]
    if peer:
        planners.append(("VAMP", [peer, problems, ROUNDS]))
    for name, words in planners:
        text = bench_planner.run(*words)
        found, asked = bench_planner.table(text)
        said = bench_planner.run(folder / "planner_oracle", data / "robots", problems, given=text).splitlines()
        touching = {tuple(line.split()[:2]) for line in said[:-1]}
        print(f"{name}: {len(found)} of {asked} solved, {len(touching)} paths hit the meshes", flush=True)
        for (group, number), (plan, shorten, cost) in found.items():
            yield {"planner": name, "set": group, "number": number, "us": f"{plan + shorten:.3f}", "cost": f"{cost:.5f}",
                   "hits": int((group, str(number)) in touching)}


def clouds_of(rows, points_of):
    names = list(dict.fromkeys(row["planner"] for row in rows))
    return [(name, points_of([row for row in rows if row["planner"] == name])) for name in names]


def medians(rows):
    parts = []
    for name in dict.fromkeys(row["planner"] for row in rows):
        own = [row for row in rows if row["planner"] == name]
        us, cost = (statistics.median(float(row[key]) for row in own) for key in ("us", "cost"))
        parts.append(f"{name} {us:.0f} us, {cost:.2f} rad")
    return "medians: " + "; ".join(parts)


def draw_cost(rows, folder):
    clouds = clouds_of(rows, lambda own: [(float(row["us"]), float(row["cost"])) for row in own])
    return plot.write(folder / "cost.svg", plot.scatter("Panda among obstacles: time and length of the path", medians(rows),
                                                        "plan and shorten [us]", "length in joint space [rad]", clouds, size=2.2))


def draw_meshes(rows, folder):
    def points_of(own):
        for group in sorted({row["set"] for row in own}):
            these = [row for row in own if row["set"] == group]
            yield (statistics.median(float(row["us"]) for row in these), 100.0 * statistics.mean(int(row["hits"]) for row in these))
    shares = [f"{name} {sum(int(row['hits']) for row in rows if row['planner'] == name)} of "
              f"{sum(row['planner'] == name for row in rows)}" for name in dict.fromkeys(row["planner"] for row in rows)]
    clouds = clouds_of(rows, lambda own: list(points_of(own)))
    return plot.write(folder / "meshes.svg", plot.scatter("Final paths that hit the exact meshes, per set of problems", "; ".join(shares),
                                                          "median plan and shorten [us]", "paths that hit [%]", clouds, size=5))


def main(words):
    what = charts.asked("chart planner", __doc__, words, CHARTS, ["--vamp"])
    rows = charts.table(what, "paths.csv", lambda: measure(what.options.get("--vamp", os.environ.get("TWINBUS_VAMP"))))
    for name in what.names or CHARTS:
        charts.drawn(what.folder / f"{name}.svg", globals()[f"draw_{name}"](rows, what.folder))
    return 0


if __name__ == "__main__":
    sys.exit(charts.run(main))
