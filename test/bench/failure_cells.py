"""The cells of the maps of failures: which scenes are made worse in which way, until every engine fails.

A map has rows (words and settings) and columns (the step [ms], or what is made worse instead).  Cells go to
test/bench/maps/failure_maps.cpp, which knows the scenes.
"""

ENGINES = {"articulated1": "articulated, order 1", "articulated2": "articulated, order 2", "ode": "ODE", "mujoco": "MuJoCo"}


def power(value):
    exponent = f"{value:.0e}".split("e")
    return ("" if exponent[0] == "1" else exponent[0]) + f"1e{int(exponent[1])}" if value >= 1e4 else f"{value:g}"


def steps(*ms):
    return [(f"{h:g}", {"step": 1e-3 * h}) for h in ms]


class Map:
    def __init__(self, name, scene, about, rows, columns, column_name="step [ms]", engines=tuple(ENGINES), slow=()):
        self.name, self.about, self.rows, self.columns, self.column_name, self.engines = name, about, rows, columns, column_name, engines
        self.scene, self.slow = scene, slow

    def cells(self):
        """(row, column, cell)"""
        for row, settings in self.rows:
            for column, more in self.columns:
                yield row, column, {"map": self.scene, **settings, **more}

    def left_out(self, engine, cell):
        """What would take minutes: (engine, count from which on, smallest step)"""
        return any(engine == who and cell.get("count", 0) >= count and cell["step"] < 1e-3 * least for who, count, least in self.slow)


STAND = [(f"gain x{gain:g}, k {power(k)}", {"gain": gain, "stiffness": k, "friction": 0.8}) for gain in (1, 10, 100) for k in (1e4, 1e6, 1e8, 1e10)]
STAND += [(f"friction {mu:g}, k 1e6", {"gain": 1, "stiffness": 1e6, "friction": mu}) for mu in (0, 0.1, 3)]
SLIDE = [(f"friction {mu:g}, k {power(k)}", {"friction": mu, "stiffness": k}) for mu in (0.1, 0.8, 3) for k in (1e4, 1e6, 1e8, 1e10)]
THROW = [(f"{v:g} m/s, friction {mu:g}, k {power(k)}", {"speed": v, "stiffness": k, "friction": mu, "draws": 6})
         for v in (2, 10, 50) for mu in (0.3, 3) for k in (1e5, 1e7, 1e9)]
PLATE = [(f"{v:g} m/s{', loose' if loose else ''}, k {power(k)}", {"speed": v, "stiffness": k, "loose": loose, "draws": 6})
         for loose in (False, True) for v in (1, 5, 20, 50) for k in (1e5, 1e7, 1e9)]
EDGE = [(f"{v:g} m/s, k {power(k)}", {"speed": v, "stiffness": k, "draws": 4}) for v in (0, 2, 10, 50) for k in (1e5, 1e7)]
RATIO = [(f"1 : {ratio:g}, k {power(k)}", {"count": 2, "ratio": ratio, "stiffness": k}) for ratio in (1, 1e2, 1e4, 1e6) for k in (1e6, 1e8)]
STACK = [(f"{n} boxes", {"count": n, "ratio": 1, "stiffness": 1e6}) for n in (5, 10, 20, 50, 100, 200)]
CHAIN = [(f"{n} joints", {"count": n}) for n in (10, 30, 100, 300, 1000)]
LOOP = [(f"{n} loop{'s' * (n > 1)}", {"count": n}) for n in (1, 2, 5, 10)]


def walks(key, values, unit):
    plain = {"delay": 0, "period": 2, "noise": 0}
    return [(f"{v:g}{unit}", {**plain, key: v}) for v in values]


MAPS = [
    Map("stand", "stand", "A humanoid on its servos, pushed at 0.07 m/s, 1 s", STAND, steps(2, 5, 10, 20, 50, 100), slow=[("ode", 0, 5)]),
    Map("slide", "slide", "A flat box slides at 2 m/s until friction stops it", SLIDE, steps(1, 2, 5, 10, 20, 50, 100)),
    Map("throw", "throw", "Boxes thrown at the ground with spin", THROW, steps(1, 5, 20, 100)),
    Map("plate", "plate", "A ball of 20 mm flies at a plate of 2 mm", PLATE, steps(0.1, 1, 10, 100)),
    Map("edge", "edge", "A beam falls on a beam, edge on edge", EDGE, steps(0.1, 1, 5, 20)),
    Map("ratio", "stack", "A heavy box on a light one", RATIO, steps(1, 5, 20, 100)),
    Map("stack", "stack", "Boxes on one another, 0.5 s", STACK, steps(1, 5, 20, 50),
        slow=[("articulated1", 200, 5), ("articulated2", 100, 5), ("ode", 50, 5), ("ode", 100, 100)]),
    Map("chain", "chain", "A free chain turns in the air, 1 s", CHAIN, steps(1, 2, 5, 10, 20, 50, 100),
        slow=[("articulated2", 1000, 2), ("ode", 100, 5), ("ode", 300, 1000)]),
    Map("loop", "loop", "Four-bars fall through their singular posture, 1 s", LOOP, steps(0.5, 1, 2, 5, 10, 20, 50), slow=[("ode", 5, 1)]),
    Map("delay", "walk", "It walks: the servos come late", [("late by", {})], walks("delay", (0, 2, 4, 6, 8, 12, 16, 24), " ms"), "", ("articulated1", "articulated2", "ode")),
    Map("rate", "walk", "It walks: the period of the control loop", [("period", {})], walks("period", (1, 2, 4, 5, 8, 10, 20), " ms"), "",
        ("articulated1", "articulated2", "ode")),
    Map("noise", "walk", "It walks: noise of every sensor, of that of walk_noisy", [("noise", {})], walks("noise", (0, 1, 2, 5, 10, 20, 50), " x"), "",
        ("articulated1", "articulated2", "ode")),
]

# A few cells of each that take seconds: (map, row, column)
QUICK = [("stand", "gain x100, k 1e6", "20"), ("slide", "friction 0.8, k 1e6", "1"), ("slide", "friction 0.8, k 1e6", "50"),
         ("throw", "10 m/s, friction 0.3, k 1e7", "5"), ("plate", "50 m/s, k 1e5", "0.1"), ("plate", "50 m/s, k 1e9", "1"),
         ("edge", "2 m/s, k 1e5", "1"), ("ratio", "1 : 10000, k 1e6", "5"), ("stack", "20 boxes", "5"), ("chain", "10 joints", "2"),
         ("chain", "100 joints", "50"), ("loop", "1 loop", "2"), ("delay", "late by", "0 ms"), ("delay", "late by", "24 ms")]
