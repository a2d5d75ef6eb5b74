"""hrp2p walking in the simulator beside the stand-in robot behind the hardware bridge, drawn by chart_walk.py: what both measured
(as the paper's Fig. 13 does for the foot's force) and snapshots of both (its Figs. 16 and 17).

The walks are those of test/process/twin_walk_test.py, which says whether they are good.
"""

import csv
import functools
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import plot
import robot_drawing

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROBOT = "hrp2p"
SOURCES = {"simulator": "simulator", "robot": "stand-in robot behind the bridge"}
DEGREES = 180.0 / math.pi
PANELS = (  # name, title, unit, of SI
    ("left", "left foot, normal force", "N", 1.0), ("right", "right foot, normal force", "N", 1.0),
    ("roll", "roll of the body (IMU)", "deg", DEGREES), ("pitch", "pitch of the body (IMU)", "deg", DEGREES),
    ("zmp_y", "ZMP, to the left", "mm", 1e3), ("hip", "left hip pitch", "deg", DEGREES), ("knee", "left knee", "deg", DEGREES),
    ("ankle_torque", "left ankle pitch, torque", "N m", 1.0))
PERIOD = 0.002      # [s]
MOST_LAG = 10       # ticks that are tried
CELL = (150, 240)   # of a snapshot [px]
METRE = 138.0       # [px]
FLOOR = 0.5         # grid [m]


@functools.cache
def walked(bin_folder):
    """{chart: rows} of a walk on each source."""
    with tempfile.TemporaryDirectory() as folder:
        words = [ROOT / "test/tools/private_bus.sh", sys.executable, ROOT / "test/process/twin_walk_test.py", "--out", folder]
        done = subprocess.run(["env", f"TWINBUS_BIN={bin_folder}", *map(str, words)], capture_output=True, text=True, check=False)
        print(done.stdout.strip(), flush=True)
        if done.returncode != 0:
            raise SystemExit(f"chart walk: the robot did not walk alike on both sources; on a busy machine, try again\n{done.stderr.strip()}")
        rows = {}
        for name in ("twin", "snapshots"):
            with open(pathlib.Path(folder) / f"{name}.csv", newline="", encoding="utf-8") as source:
                rows[name] = list(csv.DictReader(source))
        return rows


def differences(rows):
    """What each quantity differs by, and by what it varies itself."""
    for name, _, unit, scale in PANELS:
        one, other = ([scale * float(row[f"{name}_{source}"]) for row in rows] for source in SOURCES)
        apart = [a - b for a, b in zip(one, other)]
        mean = sum(one) / len(one)
        yield {"quantity": name, "unit": unit, "rms_difference": f"{math.sqrt(sum(d * d for d in apart) / len(apart)):.4g}",
               "largest_difference": f"{max(map(abs, apart)):.4g}", "mean_difference": f"{sum(apart) / len(apart):.4g}",
               "rms_about_mean": f"{math.sqrt(sum((a - mean) ** 2 for a in one) / len(one)):.4g}"}


def lag_ms(rows):
    """By how much the robot's foot forces come later: the shift that leaves the least difference."""
    def left(shift):
        pairs = zip(rows[MOST_LAG:-MOST_LAG], rows[MOST_LAG + shift:])
        return sum((float(a[f"{foot}_simulator"]) - float(b[f"{foot}_robot"])) ** 2 for a, b in pairs for foot in ("left", "right"))
    return 1e3 * PERIOD * min(range(-MOST_LAG, MOST_LAG + 1), key=left)


def draw_twin(rows, folder):
    found = {row["quantity"]: row for row in differences(rows)}
    with open(folder / "twin_difference.csv", "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, found["left"].keys())
        writer.writeheader()
        writer.writerows(found.values())
    panels = []
    for name, title, unit, scale in PANELS:
        curves = [[(float(row["time"]), scale * float(row[f"{name}_{source}"])) for row in rows] for source in SOURCES]
        panels.append((f"{title} [{unit}]", f"rms difference {float(found[name]['rms_difference']):.3g} {unit}", curves))
        print(f"twin: {panels[-1][0]}: {panels[-1][1]}, largest {found[name]['largest_difference']}", flush=True)
    return plot.write(folder / "twin.svg", plot.panels(
        "hrp2p walks at 0.6 m/s: simulator and stand-in robot",
        f"the same controller, each walk on a bus of its own; time from its start; the stand-in robot's foot forces come {lag_ms(rows):.0f} ms later",
        "time [s]", list(SOURCES.values()), panels))


def snapshot(urdf, row, camera, left, ground):
    """The robot before the grid of the floor, in the cell that begins at `left`; SVG elements."""
    middle = float(row["base_x"])

    def at(point):
        right, up = camera.seen((point[0] - middle, point[1], point[2]))
        return f"{left + 0.5 * CELL[0] + METRE * right:.1f},{ground - METRE * up:.1f}"
    near = [FLOOR * k for k in range(math.floor((middle - 0.6) / FLOOR), math.ceil((middle + 0.6) / FLOOR) + 1)]
    out = [f"<polyline points='{at((x, -0.5, 0.0))} {at((x, 0.5, 0.0))}' stroke='#cfd6dd' fill='none'/>" for x in near]
    out += [f"<polyline points='{at((near[0], y, 0.0))} {at((near[-1], y, 0.0))}' stroke='#cfd6dd' fill='none'/>" for y in (-0.5, 0.0, 0.5)]
    base = (robot_drawing.of_quaternion(*(float(row[f"turn_{axis}"]) for axis in "wxyz")),
            [float(row["base_x"]) - middle, float(row["base_y"]), float(row["base_z"])])
    angles = {name: float(value) for name, value in row.items() if name.isupper()}
    for fill, shape in robot_drawing.outlines(urdf, angles, base, camera):
        corners = " ".join(f"{left + 0.5 * CELL[0] + METRE * right:.1f},{ground - METRE * up:.1f}" for right, up in shape)
        out.append(f"<polygon points='{corners}' fill='{fill}' stroke='#30343a' stroke-width='.6' stroke-linejoin='round'/>")
    return out


def draw_snapshots(rows, folder):
    urdf = xml.etree.ElementTree.parse(ROOT / f"config/robots/{ROBOT}/{ROBOT}.urdf").getroot()
    camera = robot_drawing.Camera()
    count = len(rows) // len(SOURCES)
    cells = []
    for source, name in SOURCES.items():
        own = [row for row in rows if row["source"] == source]
        cells.append((name, [(f"{float(row['time']):.2f} s", functools.partial(snapshot, urdf, row, camera)) for row in own]))
    ways = [[float(row["base_x"]) for row in rows if row["source"] == source] for source in SOURCES]
    gone = [way[-1] - way[0] for way in ways]
    words = (f"{count} instants of the same walk, half a step apart; lines on the floor every {FLOOR} m; "
             f"way between the first and the last: {gone[0]:.3f} m and {gone[1]:.3f} m")
    print(f"snapshots: {words}", flush=True)
    return plot.write(folder / "snapshots.svg", plot.film("hrp2p walks at 0.6 m/s: simulator and stand-in robot",
                                                          words, cells, CELL))
