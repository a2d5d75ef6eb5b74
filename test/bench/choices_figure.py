"""Error against cost of a driven scene, and where on it lies what `tune` and `fidelity: auto` choose for an error; drawn by chart_physics.py."""

import csv
import pathlib
import subprocess
import tempfile

import plot

ASKED = (10.0, 1.0, 0.1)  # [mm]
SCENES = {"choices_push": ("push_forward", 3.0, "Pushed forward, 3 s"), "choices_box": ("box_push", 4.0, "A box pushed along a table, 4 s")}


def ladder(program, scene, seconds, error, *more):
    """The rows of `tune`."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "ladder.csv"
        words = [program, "tune", scene, "--for", seconds, "--error", f"{error}mm", "--csv", table, *more]
        subprocess.run([str(word) for word in words], capture_output=True, check=False)  # 1: nothing holds the error
        with open(table, newline="") as source:
            return list(csv.DictReader(source))


def row_of(name, asked, row):
    return {"run": name, "asked_mm": f"{asked:g}", "order": row["order"], "step_s": row["step_s"], "physics_ms_per_s": f"{float(row['physics_ms_per_s']):.4g}",
            "error_m": f"{float(row['error_m']):.4g}", "held_joints": row["held_joints"]}


def measure(lab, name):
    scene, seconds, _ = SCENES[name]
    program = pathlib.Path(lab.bin) / "twinbus"
    if not program.exists():
        raise SystemExit(f"chart physics {name}: twinbus is not built; run ./twinbus once")
    every = ladder(program, scene, seconds, min(ASKED), "--all")
    for row in every[:-1]:  # the yardstick is the last
        yield row_of(f"order {row['order']}", 0.0, row)
    for label, more in (("tune", ()), ("fidelity: auto", ("--fidelity", "auto"))):
        for asked in ASKED:
            chosen = [row for row in ladder(program, scene, seconds, asked, *more) if row["chosen"] == "1"]
            for row in chosen:
                yield row_of(label, asked, row)
            print(f"{name}: {label}, {asked:g} mm{'' if chosen else ': nothing holds it'}", flush=True)


def draw(rows, folder, name):
    def points(run):
        own = [(float(row["physics_ms_per_s"]), float(row["error_m"])) for row in rows if row["run"] == run]
        return own if run in ("tune", "fidelity: auto") else sorted(own)
    curves = [(run, points(run), False) for run in dict.fromkeys(row["run"] for row in rows) if run.startswith("order")]
    choices = [(f"{run.replace(':', '')}: {', '.join(row['asked_mm'] for row in rows if row['run'] == run)} mm", points(run))
               for run in ("tune", "fidelity: auto") if points(run)]
    marks = tuple((1e-3 * asked, f"{asked:g} mm") for asked in ASKED)
    return plot.write(folder / f"{name}.svg", plot.loglog(SCENES[name][2] + ": what is chosen for an error",
                                                          "largest distance of a link or body from the yardstick, against CPU time of the physics; lower left is better",
                                                          "CPU time of the physics, ms per simulated second", "error [m]", curves, marks, choices))


MEASURE = {name: lambda lab, name=name: measure(lab, name) for name in SCENES}
DRAW = {name: lambda rows, folder, name=name: draw(rows, folder, name) for name in SCENES}
