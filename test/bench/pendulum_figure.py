"""Fig. 10 of the paper on hrp1s, drawn by chart_physics.py: the hyperbolas of the linear inverted pendulum that its walk is planned by,
beside where the simulated robot's centre of mass goes.

While one foot carries and the ZMP p stays, eqs. (2), (3) of the paper have the solution

    x(t) = p + (x0 - p) cosh(w t) + v0 / w sinh(w t),    w = sqrt(g / z_c)

begun where the simulated centre of mass is when that support has begun."""

import math

import paper_figures
import plot

GRAVITY = 9.80665
CARRIES = 20.0   # a foot [N]
SETTLED = 0.06   # after a foot has left the ground and before the other lands [s]
STEPS = 6        # drawn, of the steady walk
FROM, UNTIL = 4.0, 9.0  # of walk_forward [s]


def supports(rows):
    """Lists of rows during which one foot carries: (foot, rows)."""
    found = []
    for row in rows:
        carries = [abs(float(row[f"foot_force[{foot}][2]"])) > CARRIES for foot in (0, 1)]
        if carries.count(True) != 1:
            found.append((None, []))
            continue
        foot = carries.index(True)
        if not found or found[-1][0] != foot:
            found.append((foot, []))
        found[-1][1].append(row)
    return [(foot, own) for foot, own in found if foot is not None and len(own) > 50]


def measure(lab):
    rows, _ = paper_figures.recorded(lab, "TRUTH", "com,zmp,foot_force,foot_position", "walk_forward", "--for", UNTIL)
    start, period = float(rows[0]["utime"]), 1e-6 * (float(rows[1]["utime"]) - float(rows[0]["utime"]))
    rows = [row for row in rows if 1e-6 * (float(row["utime"]) - start) > FROM]
    skip, worst = round(SETTLED / period), 0.0
    for step, (foot, own) in enumerate(supports(rows)[1:STEPS + 1]):
        own = own[skip:-skip]
        com = [[float(row[f"com[{axis}]"]) for axis in range(3)] for row in own]
        place = [float(own[0][f"foot_position[{foot}][{axis}]"]) for axis in range(3)]
        zmp = [sum(float(row[f"zmp[{axis}]"]) for row in own) / len(own) for axis in range(2)]
        omega = math.sqrt(GRAVITY / (sum(at[2] for at in com) / len(com) - place[2]))
        # The speed that the two ends of the support tell, so that noise of a difference does not grow by cosh.
        time = period * (len(own) - 1)
        speed = [omega * (com[-1][a] - zmp[a] - (com[0][a] - zmp[a]) * math.cosh(omega * time)) / math.sinh(omega * time) for a in (0, 1)]
        for i, at in enumerate(com):
            t = omega * period * i
            planned = [zmp[a] + (com[0][a] - zmp[a]) * math.cosh(t) + speed[a] / omega * math.sinh(t) for a in (0, 1)]
            worst = max(worst, math.dist(planned, at[:2]))
            yield {"step": step, "foot": ("left", "right")[foot], "time_s": f"{period * i:.3f}",
                   "x_m": f"{at[0] - place[0]:.5f}", "y_m": f"{at[1] - place[1]:.5f}",
                   "pendulum_x_m": f"{planned[0] - place[0]:.5f}", "pendulum_y_m": f"{planned[1] - place[1]:.5f}"}
    print(f"hyperbola: simulated and pendulum at most {1e3 * worst:.1f} mm apart", flush=True)


def draw(rows, folder):
    curves, worst = [], 0.0
    for foot in ("left", "right"):
        steps = dict.fromkeys(row["step"] for row in rows if row["foot"] == foot)
        for number, step in enumerate(steps):
            own = [row for row in rows if row["step"] == step]
            x, y, px, py = ([float(row[key]) for row in own] for key in ("x_m", "y_m", "pendulum_x_m", "pendulum_y_m"))
            worst = max(worst, max(math.hypot(a - c, b - d) for a, b, c, d in zip(x, y, px, py)))
            if number == 0:
                curves += [(f"simulated, {foot} foot stands", list(zip(x, y))), (f"pendulum, {foot} foot stands", list(zip(px, py)))]
    # The outline of the sole that stands.
    soles = [[(0.13, 0.07), (0.13, -0.07), (-0.1, -0.07), (-0.1, 0.07)]]
    words = f"hrp1s at 0.55 m/s from above, the foot that stands at the origin; over {len({row['step'] for row in rows})} steps at most {1e3 * worst:.1f} mm apart"
    return plot.write(folder / "hyperbola.svg", plot.lines("Fig. 10: the centre of mass beside the hyperbola of a pendulum",
                                                           words, "forward [m]", "left [m]", curves, soles))
