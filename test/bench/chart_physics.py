#!/usr/bin/env python3
"""./twinbus chart physics [CHART...] [--out DIR] [--redraw]: work against precision of every engine, and where each fails.

Charts: flight arm stand push landing slide (error against CPU time of one thread per simulated second, one curve for each
engine, method and contact law, the points are step sizes; of GAUSS8 in parts the errors it is asked for), choices_push choices_box (error
against CPU time of a driven scene with what `tune` and `fidelity: auto` choose for 10, 1 and 0.1 mm), map (which stands are stable), size (cost against the number of joints), robots
(against the number of robots), system (a standing and swaying robot with its controller: error against time for choices of the whole stack: engine, contact, step,
control rate, sensors), hyperbola (Fig. 10 of the paper: the walking pendulum, closed form beside simulation), release sway stamp walk_rough
(Figs. 12 to 15: a damped oscillation beside its linear model, the normal force of a foot on soft soles and in rigid contact, and on rough ground
with the paper's own contact force).  Each is written as SVG, PNG and CSV to DIR (default test/charts/physics); --redraw draws from the CSV
that is there.  Peers that are installed are beside ours: MuJoCo, and in flight, arm and size Bullet (its rk4 is of order 1 on a
floating base), DART and Simbody.  An engine's error is measured against a common reference where nothing touches, else against its own finest run:
contact laws differ.
"""

import math
import sys

import charts
import choices_figure
import paper_figures
import pendulum_figure
import plot
import stability_map
import whole_stack
from physics_lab import DURATION, Lab, call, error

STEPS = (2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4)
GAINS, GROUNDS = (0.3, 1.0, 3.0, 10.0), (1e5, 1e6, 1e7, 1e8)
ABOUT = {
    "flight": ("Free flight: a humanoid of 29 joints thrown, 0.5 s", "largest error of a link's centre of mass; reference RKF78, 0.25 ms"),
    "arm": ("Arm of 7 joints swinging freely, 0.5 s", "largest error of a link's centre of mass; reference RKF78, 0.25 ms"),
    "stand": ("Standing on its servos, shoved at 0.07 m/s, 0.5 s", "error against each engine's own finest run; with collision detection"),
    "push": ("Push: dropped 10 mm at 0.2 m/s forward, lands and rocks, 0.6 s", "error against each engine's own finest run; with collision detection"),
    "landing": ("Landing: dropped 50 mm straight down, 0.6 s", "error against each engine's own finest run; with collision detection"),
    "slide": ("Slide: a brick of 1 m/s brought to rest by friction, 0.4 s", "error against each engine's own finest run"),
}


def contenders(lab, chart):
    """(engine, steps, step of its own reference, another engine with its step, or None for the common one)"""
    smooth = chart in ("flight", "arm")
    both = [lab.articulated, lab.articulated2, lab.articulated3] + (lab.flight if smooth else [])
    for engine in both:
        yield engine, STEPS[:6] if smooth else STEPS[:7], None
    for engine in lab.laws if not smooth else []:
        if engine.method.startswith("articulated"):
            yield engine, STEPS[:7], (lab.finest_of(engine), 5e-5)
        else:
            yield engine, STEPS[:4], {"slide": 1e-4}.get(chart, 5e-4)
    yield lab.ode, STEPS[:4] if not smooth else STEPS[:5], None if smooth else {"slide": 1e-4}.get(chart, 5e-4)
    for version in lab.mujocos:
        methods = ("euler", "rk4") if smooth else ("implicitfast" if not version.startswith("2.") else "implicit", "euler")
        for method in methods:
            yield lab.mujoco(version, method), STEPS[1:7] if smooth else STEPS[1:8], None if smooth else 5e-5
    for peer in lab.trees if smooth else []:
        yield peer, STEPS[1:7], None


def measure(lab, chart):
    smooth = chart in ("flight", "arm")
    reference = lab.flight[2].run(chart, 2.5e-4, 1) if smooth else lab.articulated2.run(chart, 5e-5, 1)

    def point(name, engine, h, limit):
        run = engine.run(chart, h, 2) if limit else None
        if run is None:
            return {"engine": name, "step_s": h, "cpu_ms_per_s": "", "error_m": "failed"}
        return {"engine": name, "step_s": h, "cpu_ms_per_s": f"{run['cost']:.5g}", "error_m": f"{error(run, limit):.4g}"}
    for engine, steps, own in contenders(lab, chart):
        judge, step = own if isinstance(own, tuple) else (engine, own)
        limit = reference if own is None else judge.run(chart, step, 1)
        for h in steps:
            yield point(engine.label, engine, h, limit)
        print(f"{chart}: {engine.label}", flush=True)
    for engine in lab.parted if smooth else []:  # one curve, a point for each error that is named
        yield point("articulated, GAUSS8 in parts", engine, DURATION[chart], reference)


def measure_map(lab):
    def lines(engine, label, smallest):
        for cell in stability_map.cells(engine.method, smallest, "bench physics"):
            yield {"engine": label, "gain": f"{cell['gain']:g}", "ground_n_per_m": f"{cell['stiffness']:g}", "step_s": f"{cell['step']:g}",
                   "result": cell["result"]}
        print(f"map: {label}", flush=True)
    for engine in (lab.articulated, lab.articulated2):
        yield from lines(engine, engine.label, 1e-4)
    yield from lines(lab.ode, lab.ode.label, 2e-3)
    for version in lab.mujocos:  # its ground has no stiffness: its own default
        peer = lab.mujoco(version, "implicit" if version.startswith("2.") else "implicitfast")
        for gain in GAINS:
            for h in STEPS:
                yield {"engine": peer.label, "gain": f"{gain:g}", "ground_n_per_m": "own", "step_s": f"{h:g}", "result": peer.stands(gain, h)}
        print(f"map: {peer.label}", flush=True)


def draw_curves(chart, rows, folder):
    names = list(dict.fromkeys(row["engine"] for row in rows))
    curves = [(name, [(float(r["cpu_ms_per_s"]), float(r["error_m"])) for r in rows if r["engine"] == name and r["error_m"] != "failed"],
               not name.startswith("articulated")) for name in names]
    title, subtitle = ABOUT[chart]
    marks = ((1e-3, "1 mm"), (1e-4, "0.1 mm"))
    return plot.write(folder / f"{chart}.svg", plot.loglog(title, subtitle + "; lower left is better", "CPU time, ms per simulated second",
                                                           "error [m]", curves, marks))


def draw_map(rows, folder):
    colors = {"stable": "#2a9d5c", "shakes": "#f2b134", "sank": "#c07a3e", "fell": "#d1495b", "diverged": "#4a1622"}
    legend = [("stable", "stable"), ("shakes", "shakes"), ("sank", "sinks over 5 mm"), ("fell", "falls"), ("diverged", "diverges")]
    panels = {}
    for row in rows:
        ground = row["ground_n_per_m"]
        ground = ground if ground == "own" else f"1e{math.log10(float(ground)):.0f}"
        cell = f"{ground} x{float(row['gain']):g}", f"{1e3 * float(row['step_s']):g}"
        panels.setdefault(row["engine"], {})[cell] = row["result"]
    keys = [f"1e{math.log10(ground):.0f} x{gain:g}" for ground in GROUNDS for gain in GAINS] + [f"own x{gain:g}" for gain in GAINS]
    svg = plot.table_map("Which stands of a humanoid are stable: stiffness of the ground, gain of the servos, step", "", list(panels.items()), keys, [f"{1e3 * h:g}" for h in STEPS],
                         "ground [N/m a corner] x gain of the servos", "step [ms]", colors, legend)
    return plot.write(folder / "map.svg", svg)


def draw_size(rows, folder):
    names = list(dict.fromkeys(row["engine"] for row in rows))
    curves = [(name, [(float(r["joints"]), float(r["us_per_step"])) for r in rows if r["engine"] == name], not name.startswith("articulated"))
              for name in names]
    return plot.write(folder / "size.svg", plot.loglog("Cost of a free step against size", "chains on a floating base", "joints",
                                                       "us a step", curves))


def measure_size(lab):
    peers = [lab.articulated, lab.articulated2] + [lab.mujoco(v, "euler") for v in lab.mujocos] + lab.stepped_trees() + [lab.ode]
    for engine in peers:
        for n in (7, 14, 30, 60, 100, 200):
            if engine is lab.ode and n > 60:
                continue
            cost = engine.step_us(f"chain{n}", 1e-4, 0.2)
            if cost is not None:
                yield {"engine": engine.label, "joints": n, "us_per_step": f"{cost:.4g}"}
        print(f"size: {engine.label}", flush=True)


def measure_robots(lab):
    for order in (1, 2):
        for n in (1, 2, 4, 8, 16):
            words = call(lab.program.parent / "physics_robots", f"crowd{n}", order, 1e-3, 2e5, 0.2)[0].split()
            yield {"engine": f"articulated, order {order}", "robots": n, "us_per_step": words[words.index("step_us") + 1]}
        print(f"robots: order {order}", flush=True)


def draw_robots(rows, folder):
    names = list(dict.fromkeys(row["engine"] for row in rows))
    curves = [(name, [(float(r["robots"]), float(r["us_per_step"])) for r in rows if r["engine"] == name], False) for name in names]
    return plot.write(folder / "robots.svg", plot.loglog("Cost of a step against the number of robots", "humanoids of 29 joints standing in one world, "
                                                         "1 ms, with collision detection", "robots", "us a step", curves))


def draw_system(rows, folder):
    names = list(dict.fromkeys(row["stack"] for row in rows))
    curves = [(name, [(float(r["cpu_ms_per_s"]), float(r["error_m"])) for r in rows if r["stack"] == name and r["error_m"] != "failed"],
               name.startswith("ode")) for name in names]
    return plot.write(folder / "system.svg", plot.loglog("The whole stack: standing and swaying, 3 s", "where the base is, against order 3 at 0.25 ms of the same law; one "
                                                         "process, with controller and guard; points are steps",
                                                         "CPU time of everything, ms per simulated second", "error [m]", curves, ((1e-3, "1 mm"), (1e-4, "0.1 mm"))))


MEASURE = {"map": measure_map, "size": measure_size, "robots": measure_robots, "system": whole_stack.measure, "hyperbola": pendulum_figure.measure,
           **choices_figure.MEASURE, **paper_figures.MEASURE}
DRAW = {"map": draw_map, "size": draw_size, "robots": draw_robots, "system": draw_system, "hyperbola": pendulum_figure.draw,
        **choices_figure.DRAW, **paper_figures.DRAW}
NAMES = (*ABOUT, *MEASURE)


def main(words):
    what = charts.asked("chart physics", __doc__, words, NAMES)
    lab = None if what.redraw else Lab("chart physics")
    for name in what.names or NAMES:
        rows = charts.table(what, f"{name}.csv", lambda n=name: MEASURE.get(n, lambda lab: measure(lab, n))(lab))
        charts.drawn(what.folder / f"{name}.svg", DRAW.get(name, lambda r, f, n=name: draw_curves(n, r, f))(rows, what.folder))
    return 0


if __name__ == "__main__":
    sys.exit(charts.run(main))
