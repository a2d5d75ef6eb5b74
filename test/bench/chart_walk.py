#!/usr/bin/env python3
"""./twinbus chart walk [CHART...] [--out DIR] [--redraw]: how the robot walks.

Charts: soles (ZMP, centre of mass and DCM among the soles, seen from above), force (normal force of the left foot against
what it was asked to carry), rigid (the same force on the robot's soft soles and with rigid contact, on Open Dynamics Engine: what
lies above 50 Hz), guard (time of the collision check while walking), twin (hrp2p walks in the simulator, and behind the hardware bridge as the
stand-in robot, with all processes of the stack and in real time: force, tilt, ZMP, joints), snapshots (both seen from the side),
speed (ZMP margin and force error against the velocity asked), cost (what foot forces are off a run with an eighth of the step,
against CPU time of the whole stack), map (largest push survived on the spot, by direction and phase, beside the bound of the
linear inverted pendulum).
Each is written as SVG, PNG and CSV to DIR (default test/charts/walk); --redraw draws from the
CSV that is there.
"""

import csv
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

import charts
import plot
import programs
import twin_figures

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHARTS = ("soles", "force", "rigid", "guard", "twin", "snapshots", "speed", "cost", "map")
SOLE = ((0.18, 0.07), (0.18, -0.07), (-0.07, -0.07), (-0.07, 0.07))  # hrp1s, in the sole frame [m]
WEIGHT = 130.8 * 9.81  # [N]
FROM, TO = 6.0, 9.0    # what is drawn of walk_forward [s]
FAST = 50.0            # [Hz]
STEPS = (0.002, 0.001, 0.0005)  # of the physics [s]
SPEEDS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7)


def twinbus():
    return programs.folder_of("twinbus", "chart walk") / "twinbus"


def table_of(*settings):
    """Rows of TRUTH and CONTROLLER_STATUS of walk_forward, by tick."""
    folder = pathlib.Path(tempfile.mkdtemp())
    words = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([twinbus(), "run", "walk_forward", "--for", str(TO + 0.5), "--log", folder / "walk.log", *words],
                   capture_output=True, check=False)
    tables = []
    for channel in ("TRUTH", "CONTROLLER_STATUS"):
        file = folder / f"{channel}.csv"
        subprocess.run([twinbus(), "log", "csv", folder / "walk.log", channel, file, "--numbers"], capture_output=True, check=True)
        with open(file, newline="") as source:
            tables.append({int(row["tick"]): row for row in csv.DictReader(source)})
    truth, status = tables
    ticks = [tick for tick in sorted(truth.keys() & status.keys()) if FROM <= 0.002 * tick < TO]
    return [(tick, truth[tick], status[tick]) for tick in ticks]


def measure_soles():
    for tick, truth, status in table_of()[::5]:
        row = {"time": f"{0.002 * tick:.3f}", "zmp_x": truth["zmp[0]"], "zmp_y": truth["zmp[1]"], "com_x": truth["com[0]"],
               "com_y": truth["com[1]"]}
        # The controller's DCM is in its ground frame: here by its distance from its own centre of mass.
        row["dcm_x"] = float(truth["com[0]"]) + float(status["dcm[0]"]) - float(status["com[0]"])
        row["dcm_y"] = float(truth["com[1]"]) + float(status["dcm[1]"]) - float(status["com[1]"])
        for foot in (0, 1):
            row |= {f"x{foot}": truth[f"foot_position[{foot}][0]"], f"y{foot}": truth[f"foot_position[{foot}][1]"],
                    f"force{foot}": truth[f"foot_force[{foot}][2]"]}
        yield row


def draw_soles(rows, folder):
    outlines = []
    for foot in (0, 1):
        stood = False
        for row in rows:
            loaded = float(row[f"force{foot}"]) > 0.5 * WEIGHT
            if loaded and not stood:
                x, y = float(row[f"x{foot}"]), float(row[f"y{foot}"])
                outlines.append([(x + dx, y + dy) for dx, dy in SOLE])
            stood = loaded
    curves = [(name, [(float(row[f"{key}_x"]), float(row[f"{key}_y"])) for row in rows])
              for name, key in (("ZMP", "zmp"), ("centre of mass", "com"), ("DCM", "dcm"))]
    return plot.write(folder / "soles.svg", plot.lines("Walking forward at 0.55 m/s, from above", "hrp1s, engine articulated; soles that stand",
                                                       "forward [m]", "left [m]", curves, outlines, alike=True))


def trace(*words):
    """Rows of walk_trace_bench: a walk tick by tick."""
    done = subprocess.run([twinbus().parent / "walk_trace_bench", *words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"chart walk: {done.stderr.strip()}")
    return list(csv.DictReader(done.stdout.splitlines()))


def measure_force():
    for row in trace():
        yield {"time": row["time"], "measured": row["left"], "asked": row["left_asked"]}


def draw_force(rows, folder):
    missed = [float(row["measured"]) - float(row["asked"]) for row in rows]
    words = f"rms of the difference {100.0 * math.sqrt(sum(m * m for m in missed) / len(missed)) / WEIGHT:.1f} % of the weight"
    print(words, flush=True)
    curves = [(name, [(float(row["time"]), float(row[key])) for row in rows]) for name, key in (("measured", "measured"), ("asked", "asked"))]
    return plot.write(folder / "force.svg", plot.lines("Normal force of the left foot, walking at 0.55 m/s", f"hrp1s, engine articulated; {words}",
                                                       "time [s]", "force [N]", curves))


def measure_rigid():
    soft, rigid = trace("--for", "1.5", "--engine", "ode"), trace("--for", "1.5", "--engine", "ode", "--set", "contact=rigid")
    for a, b in zip(soft, rigid):
        yield {"time": a["time"], "soft": a["left"], "rigid": b["left"]}


def above(values, hertz, period):
    """Root mean square of what is faster than that, of one-pole high passes, share of the weight."""
    share = 1.0 / (1.0 + 2.0 * math.pi * hertz * period)
    slow, square = values[0], 0.0
    for value in values:
        slow += (1.0 - share) * (value - slow)
        square += (value - slow) ** 2
    return math.sqrt(square / len(values)) / WEIGHT


def draw_rigid(rows, folder):
    curves, words = [], []
    for key, name in (("rigid", "rigid contact"), ("soft", "the robot's soles")):
        values = [float(row[key]) for row in rows]
        curves.append((name, [(float(row["time"]), value) for row, value in zip(rows, values)]))
        words.append(f"{name}: {100.0 * above(values, FAST, 0.002):.2f} %")
    print("; ".join(words), flush=True)
    return plot.write(folder / "rigid.svg", plot.lines("Normal force of the left foot, walking at 0.55 m/s, engine ode",
                                                       f"above {FAST:.0f} Hz, of the weight: {'; '.join(words)}", "time [s]", "force [N]", curves))


def measure_guard():
    for row in trace("--guard"):
        yield {"time": row["time"], "guard_us": row["guard_us"]}


def draw_guard(rows, folder):
    values = sorted(float(row["guard_us"]) for row in rows)
    words = f"median {values[len(values) // 2]:.0f} us, 99 % {values[len(values) * 99 // 100]:.0f} us"
    print(words, flush=True)
    return plot.write(folder / "guard.svg", plot.lines("Collision check of all pairs on their meshes while walking at 0.55 m/s",
                                                       f"hrp1s, every tick; {words}", "time [s]", "CPU time of a check [us]",
                                                       [("guard", [(float(row["time"]), float(row["guard_us"])) for row in rows])]))


def measure_twin():
    return twin_figures.walked(twinbus().parent)["twin"]


def measure_snapshots():
    return twin_figures.walked(twinbus().parent)["snapshots"]


draw_twin, draw_snapshots = twin_figures.draw_twin, twin_figures.draw_snapshots


def measure_speed():
    scene = (ROOT / "config/scenes/walk_forward.yaml").read_text(encoding="utf-8")
    folder = pathlib.Path(tempfile.mkdtemp())
    for speed in SPEEDS:
        file, report = folder / "walk.yaml", folder / "report.json"
        file.write_text(scene.replace("vx: 0.55", f"vx: {speed}"), encoding="utf-8")
        subprocess.run([twinbus(), "run", file, "--report", report], capture_output=True, check=False)
        figures = json.loads(report.read_text())
        yield {"speed": speed, "margin_mm": figures["zmp_margin_min_mm"], "force_percent": figures["force_rms_percent"],
               "velocity_error_percent": figures["velocity_error_percent"]}
        print(f"speed: {speed} m/s", flush=True)


def draw_speed(rows, folder):
    names = (("ZMP margin, least [mm]", "margin_mm"), ("normal force error [% of weight]", "force_percent"),
             ("velocity error [%]", "velocity_error_percent"))
    curves = [(name, [(float(row["speed"]), float(row[key])) for row in rows]) for name, key in names]
    return plot.write(folder / "speed.svg", plot.lines("Walking forward, by the velocity asked", "hrp1s, engine articulated, 11 s each",
                                                       "velocity asked [m/s]", "mm or %", curves))


def measure_cost():
    scene = (ROOT / "config/scenes/walk_forward.yaml").read_text(encoding="utf-8")
    folder = pathlib.Path(tempfile.mkdtemp())
    for order in (1, 2, 3):
        for step in STEPS:
            file, report = folder / "walk.yaml", folder / "report.json"
            file.write_text(f"step: {step}\n{scene}", encoding="utf-8")
            words = [twinbus(), "run", file, "--set", f"solver.order={order}", "--no-guard", "--for", "8"]
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run(words, capture_output=True, check=False)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([*words, "--reference", "--report", report], capture_output=True, check=False)
            figures = json.loads(report.read_text())
            yield {"order": order, "step_ms": 1e3 * step, "error_n": figures["foot_force_rms_error_n"],
                   "cpu_s_per_s": (after.ru_utime - before.ru_utime) / figures["sim_time_s"]}
            print(f"cost: order {order}, step {step} s", flush=True)


def draw_cost(rows, folder):
    curves = [(f"order {order}", [(float(row["cpu_s_per_s"]), float(row["error_n"])) for row in rows if row["order"] == str(order)],
               False) for order in (1, 2, 3)]
    return plot.write(folder / "cost.svg", plot.loglog(
        "Walking at 0.55 m/s: error against CPU time of the whole stack", "hrp1s, engine articulated; steps of 2, 1 and 0.5 ms from the left",
        "CPU time, start included [s per simulated second]", "foot force against an eighth of the step, rms [N]", curves))


def measure_map():
    done = subprocess.run([sys.executable, ROOT / "test/bench/bench_walk_map.py"], capture_output=True, text=True, check=True)
    yield from csv.DictReader(done.stdout.splitlines())


def draw_map(rows, folder):
    """Seen from above, the robot faces right: weakest and strongest phase, and the bound of the weakest."""
    directions = sorted({float(row["direction_deg"]) for row in rows})

    def around(pick, key):
        found = []
        for direction in directions + directions[:1]:
            size = pick(float(row[key]) for row in rows if float(row["direction_deg"]) == direction)
            angle = math.radians(direction)
            found.append((size * math.cos(angle), size * math.sin(angle)))
        return found
    shares = [min(1.0, float(row["survived"]) / float(row["bound"])) for row in rows if float(row["bound"]) > 0.0]
    words = f"of the bound, which knows no arms and trunk, {100.0 * sum(shares) / len(shares):.0f} % is reached on average, {100.0 * min(shares):.0f} % at least"
    print(words, flush=True)
    curves = [("weakest phase: falls beyond", around(min, "survived")), ("strongest phase: falls beyond", around(max, "survived")),
              ("bound, weakest phase", around(min, "bound"))]
    return plot.write(folder / "map.svg", plot.lines("Pushes survived while walking on the spot, 0.1 s long", f"hrp1s, facing right; {words}",
                                                     "change of velocity forward [m/s]", "left [m/s]", curves, alike=True))


def main(words):
    what = charts.asked("chart walk", __doc__, words, CHARTS)
    for name in what.names or CHARTS:
        rows = charts.table(what, f"{name}.csv", globals()[f"measure_{name}"])
        charts.drawn(what.folder / f"{name}.svg", globals()[f"draw_{name}"](rows, what.folder))
    return 0


if __name__ == "__main__":
    sys.exit(charts.run(main))
