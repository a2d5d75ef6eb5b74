"""`campaign search FILE`: where a robot begins to fail, found by looking rather than by sampling.

    search:                                     # the smallest push that fells, by direction and phase
      push: {link: CHEST, at: [2.0, 2.2], directions: 8, duration: 0.1}
      least: 1                                  # [N s]
      most: 200
      tolerance: 0.02                           # of the boundary, relative
    search: {unknown: servo.delay_ms, least: 0, most: 60, tolerance: 0.05}      # the worst delay, terrain, mass ...; settings: are its rows
    search: {method: cmaes, minimize: zmp_margin_min_mm, box: {KEY: [LEAST, MOST]}, runs: 200}     # the worst case in a box
    search: {method: importance, normal: {KEY: [MEAN, SD]}, runs: 400}          # how rare a failure is

Method bisection (default for push and unknown) takes what is larger to be worse.  --random N draws N runs as well (with bisection: N per
row), and compares what these show.  Writes search.csv, and search.html with the map.
"""

import argparse
import csv
import itertools
import math
import os
import pathlib
import random
import warnings

from command import Parser
from errors import CampaignError
from run_task import FIGURES
from spec import TaskMaker, unique

KEYS = ("push", "unknown", "least", "most", "tolerance", "method", "minimize", "box", "normal", "runs")
PUSH = "+ push"  # not the name of a setting
METHODS = ("bisection", "cmaes", "importance")
ISLAND = 0.12     # of a boundary: so far below it another run must pass
UNKNOWN = {"mirrored": 0.01, "between": 0.2, "beside": 0.22}  # how far a guess is expected to be off before any was seen: of the logarithm


class Row:
    """One unknown: the largest value that passes, the smallest that fails."""

    def __init__(self, name, axes, settings, least, most):
        self.name, self.axes, self.settings = name, axes, settings
        self.least, self.good, self.bad, self.runs = least, least, most, 0
        self.tried_good = self.tried_bad = False
        self.seen = []  # (value, whether it failed)
        self.guesses, self.guess, self.off = None, None, 0.0  # where other rows say that the boundary is, and how far off that may be

    def boundary(self):
        if self.tried_bad and self.tried_good:
            return 0.5 * (self.good + self.bad)
        return None

    def side(self):
        return "" if self.boundary() is not None else "all pass" if not self.tried_bad else "all fail"

    def note(self, value, failed):
        """What passes above something that fails does not count: the smallest that fails is looked for."""
        self.runs += 1
        self.seen.append((value, failed))
        if failed:
            self.bad, self.tried_bad = min(self.bad, value), True
        passed = [seen for seen, bad in self.seen if not bad and (seen < self.bad or not self.tried_bad)]
        if self.tried_good and not passed:
            self.guess = None  # what it led to was an island
        self.tried_good = bool(passed)
        self.good = max(passed, default=self.least)

    def below(self):
        """Where an island of passing values would show: below the boundary, unless something there was seen to pass; or None."""
        value = self.good * (1 - ISLAND)
        if value <= self.least or any(not bad and self.good * (1 - 1.25 * ISLAND) <= seen <= self.good * (1 - 0.5 * ISLAND) for seen, bad in self.seen):
            return None
        return value


class Search:
    def __init__(self, campaign, store, run, file):
        self.campaign, self.store, self.run, self.file = campaign, store, run, file
        self.maker = TaskMaker(campaign)
        self.runs = 0
        value = campaign.search
        keys = value.keys(KEYS)
        self.value, self.keys = value, keys
        if campaign.cases:
            raise value.error("takes no cases: beside it; write them as lists of settings:, each point of which is a row")
        if campaign.program and "push" in keys:
            raise keys["push"].error("is for scenes; of a program:, use unknown: KEY")
        self.method = keys["method"].word_of(METHODS) if "method" in keys else "bisection"
        if self.method == "bisection":
            if ("push" in keys) == ("unknown" in keys):
                raise value.error("wants either push: {...} or unknown: KEY")
            for key in ("least", "most"):
                if key not in keys:
                    raise value.error(f"{key} is missing; add {key}: NUMBER")
            self.least, self.most = keys["least"].number(0), keys["most"].number()
            if not self.least < self.most:
                raise keys["most"].error(f"must be above least ({self.least:g})")
            self.tolerance = keys["tolerance"].number(1e-4, 0.5) if "tolerance" in keys else 0.02
            self.rows = self.push_rows(keys["push"]) if "push" in keys else self.unknown_rows(keys["unknown"].text())

    def push_rows(self, value):
        keys = value.keys(("link", "at", "directions", "duration", "point"), ("link",))
        times = [entry.number(0, 86400) for entry in keys["at"].entries()] if "at" in keys else [2.0]
        count = keys["directions"].number(1, 360, whole=True) if "directions" in keys else 8
        push = {"link": keys["link"].text(), "duration": keys["duration"].number(0.001, 60) if "duration" in keys else 0.1}
        keys, rows = list(self.campaign.grid), []
        for values, at, i in itertools.product(itertools.product(*self.campaign.grid.values()), times, range(count)):
            angle, given = 360.0 * i / count, dict(zip(keys, values))
            # Exact along the axes: cos(90 degrees) is no zero in binary.
            x, y = (round(f(math.radians(angle)), 12) for f in (math.cos, math.sin))

            def settings(size, given=given, at=at, x=x, y=y):
                return {**given, PUSH: dict(push, at=at, impulse=[round(size * x, 6), round(size * y, 6), 0.0])}
            name = ", ".join([f"{angle:g} degrees at {at:g} s", *(f"{k}={v}" for k, v in given.items() if len(self.campaign.grid[k]) > 1)])
            rows.append(Row(name, {"direction_deg": angle, "at_s": at, **given}, settings, self.least, self.most))
        return rows

    def unknown_rows(self, key):
        keys = list(self.campaign.grid)
        return [Row(", ".join(f"{k}={v}" for k, v in zip(keys, values) if len(self.campaign.grid[k]) > 1) or key, dict(zip(keys, values)),
                    lambda size, values=values: {**dict(zip(keys, values)), key: repr(float(f"{size:.9g}"))}, self.least, self.most)
                for values in itertools.product(*self.campaign.grid.values())]

    def tasks(self, settings):
        """Of one point: every scene, robot, controller and seed; a push is added to the pushes of the scene."""
        push = settings.pop(PUSH, None)
        if push is None:
            return unique(self.maker.product([settings]))  # a row has its own values of the grid
        tasks = []
        for scene in self.campaign.scenes:
            import yaml
            tree = yaml.safe_load(scene[1]) or {}
            tree["pushes"] = list(tree.get("pushes") or []) + [push]
            changed = (scene[0], yaml.safe_dump(tree, default_flow_style=None, sort_keys=False, width=1000), scene[2])
            self.maker.scenes.clear()  # it knows scenes by their names
            for robot in self.campaign.robots:
                for controller in self.campaign.controllers:
                    for seed in self.campaign.seeds:
                        tasks.append(self.maker.make(changed, robot, controller, settings, seed))
        self.maker.scenes.clear()
        return tasks

    def fails(self, points):
        """Of each point whether a run of it fails; all points at once."""
        groups = [self.tasks(dict(point)) for point in points]
        left = self.store.ask(list({task["id"]: task for group in groups for task in group}.values()))
        if left:
            self.run(left, self.store.add)
        found = []
        for group in groups:
            self.runs += len(group)
            results = [self.store.results.get(task["id"]) for task in group]
            for task, result in zip(group, results):
                if result is None or result["status"] == "refused":
                    raise CampaignError(f"{self.file}: {result['failures'][0] if result else self.store.unrun.get(task['id'], 'no result')}")
            found.append(results)
        return found

    def failed(self, results):
        return any(result["figures"].get("fell", result["status"] != "passed") if "push" in self.keys else result["status"] != "passed"
                   for result in results)

    def narrow(self, row):
        return row.tried_good and row.tried_bad and row.bad - row.good <= self.tolerance * row.good

    def middle(self, row):
        return math.sqrt(row.good * row.bad) if row.good > 0 else 0.5 * (row.good + row.bad)

    def next_value(self, row, like):
        """Where a row is looked at next; like: a closed row that is most like it, or None."""
        near = 0.98 * self.tolerance  # two values so far apart close a row
        if self.narrow(row):
            return row.below()
        if row.tried_good and row.tried_bad:
            return self.middle(row)
        if row.guess is not None:
            if not (row.tried_good or row.tried_bad):
                return min(max(row.guess * (1 + 0.5 * near) if row.off <= 0.5 * self.tolerance else row.guess, self.least), self.most)
            step = 1 + max(near, 1.5 * row.off) * 2 ** (row.runs - 1)
            value = row.good * step if row.tried_good else row.bad / step
            if self.least < value < self.most:
                return value
            return self.most if row.tried_good else self.least
        if not (row.tried_good or row.tried_bad) and like is not None and like.boundary() is None:
            return self.most if like.tried_good else self.least
        # An end is tried when nothing but that end is left.
        if row.bad - row.good <= self.tolerance * row.good:
            return self.most if row.tried_good else self.least
        return self.middle(row)

    def bisect(self, rows, batch):
        """One row from end to end; then rows side by side, each from where others say that it is."""
        open_rows, closed, errors = in_order(rows), [], {}
        while open_rows:
            now = open_rows[:batch if closed else 1]
            for row in now:
                if row.guesses is None:
                    row.guesses = {name: guess for name, guess in ((f.__name__, f(row, closed)) for f in GUESSES) if guess is not None}
                    offs = {name: expected(name, errors) for name in row.guesses}
                    if offs:
                        best = min(offs, key=offs.get)
                        row.guess, row.off = row.guesses[best], offs[best]
            values = [self.next_value(row, most_like(row, closed)) for row in now]
            points = [row.settings(value) for row, value in zip(now, values)]
            for row, value, results in zip(now, values, self.fails(points)):
                row.note(value, self.failed(results))
                end = (row.tried_good and row.good >= self.most) or (row.tried_bad and row.bad <= self.least)
                if end or self.narrow(row) and row.below() is None:
                    open_rows.remove(row)
                    closed.append(row)
                    if row.boundary():
                        for name, guess in row.guesses.items():
                            errors.setdefault(name, []).append(abs(math.log(guess / row.boundary())))
        return rows


def expected(name, errors):
    """How far off the next guess of a kind will be."""
    last = errors.get(name, [])[-4:]
    return sum(last) / len(last) if last else UNKNOWN[name]


def turn(a, b):
    """Between two directions [deg], 0 .. 180."""
    apart = abs(a - b) % 360
    return min(apart, 360 - apart)


def in_order(rows):
    """0, 45, 90 .. 180, then -45, -90 ...: what a guess needs comes first."""
    directions = [float(row.axes.get("direction_deg", 0)) % 360 for row in rows]
    return [row for _, _, row in sorted(zip(directions, range(len(rows)), rows), key=lambda each: (each[0] > 180, turn(each[0], 0)))]


def most_like(row, closed):
    def distance(other):
        return (turn(float(row.axes.get("direction_deg", 0)), float(other.axes.get("direction_deg", 0)))
                + 100 * sum(row.axes[k] != other.axes.get(k) for k in row.axes if k != "direction_deg"))
    return min(closed, key=distance, default=None)


def with_boundary(closed):
    return [other for other in closed if other.boundary()]


def mirrored(row, closed):
    """Left as right: robots are built so."""
    if "direction_deg" not in row.axes:
        return None
    found = [other for other in with_boundary(closed) if turn(row.axes["direction_deg"], -other.axes["direction_deg"]) < 1e-6
             and all(row.axes[k] == other.axes[k] for k in row.axes if k != "direction_deg")]
    return found[0].boundary() if found else None


def between(row, closed):
    """Between the directions on both sides."""
    if "direction_deg" not in row.axes:
        return None
    same = [other for other in with_boundary(closed) if all(row.axes[k] == other.axes[k] for k in row.axes if k != "direction_deg")]
    sides = [((other.axes["direction_deg"] - row.axes["direction_deg"]) % 360, other) for other in same]
    if len(sides) < 2:
        return None
    (before, left), (after, right) = max(sides, key=lambda s: s[0]), min(sides, key=lambda s: s[0])
    share = (360 - before) / (360 - before + after)
    return math.exp((1 - share) * math.log(left.boundary()) + share * math.log(right.boundary()))


def beside(row, closed):
    """As the row that is most like it."""
    found = most_like(row, with_boundary(closed))
    return found.boundary() if found else None


GUESSES = (mirrored, between, beside)


def random_rows(search, count, seed=1):
    """Drawing instead: of each row, count values spread evenly over least .. most, and whether each fails."""
    chance, found = random.Random(seed), []
    for row in search.rows:
        values = [float(f"{chance.uniform(search.least, search.most):.6g}") for _ in range(count)]
        found.append(list(zip(values, [search.failed(results) for results in search.fails([row.settings(value) for value in values])])))
    return found


def parted(search, drawn):
    """The boundary that draws show: where the two kinds of runs part."""
    bad = min([v for v, failed in drawn if failed], default=search.most)
    good = max([v for v, failed in drawn if not failed and v < bad], default=search.least)
    return 0.5 * (good + bad)


def compare_with_drawn(search, looked, count):
    """Draws of the search's own cost, of 20 times as much, and all: how far their boundaries are from the search's."""
    drawn = random_rows(search, count, search.campaign.draw_seed)
    rows, per_row = len(search.rows), (search.runs - looked) // len(search.rows)
    cost = max(1, per_row // count)  # runs of a point: seeds, robots
    counts = sorted({round(times * looked / rows / cost) for times in (1, 20)} | {count})
    for number in (n for n in counts if 0 < n <= count):
        apart = [abs(parted(search, each[:number]) - row.boundary()) / row.boundary() for each, row in zip(drawn, search.rows) if row.boundary()]
        print(f"drawn: {number * cost * rows} runs, {number * cost * rows / looked:.1f} times as many: boundaries apart by at most "
              f"{100 * max(apart, default=0):.1f} %, {sum(a <= 0.03 for a in apart)} of {len(apart)} within 3 %")


def importance(search, number_of_runs):
    """Rate of failures under independent normal settings: draws are moved to where it fails (cross entropy), and weighted back."""
    normal = {key: tuple(entry.number() for entry in value.entries()) for key, value in search.keys["normal"].items()}
    if any(len(pair) != 2 or pair[1] <= 0 for pair in normal.values()):
        raise search.keys["normal"].error("wants KEY: [MEAN, SD]")
    figure = search.keys["minimize"].text() if "minimize" in search.keys else "max_tilt_deg"
    sign = 1 if figure == "max_tilt_deg" else -1
    chance, keys = random.Random(search.campaign.draw_seed), list(normal)
    mean, spread = [0.0] * len(keys), [1.0] * len(keys)
    rounds = 4
    per_round = max(10, number_of_runs // (rounds + 2))
    for number in range(rounds + 1):
        count = per_round if number < rounds else number_of_runs - rounds * per_round
        draws = [[m + s * chance.gauss(0, 1) for m, s in zip(mean, spread)] for _ in range(count)]
        points = [{k: repr(float(f"{normal[k][0] + normal[k][1] * u:.9g}")) for k, u in zip(keys, draw)} for draw in draws]
        results = search.fails(points)
        failed = [search.failed(each) for each in results]
        weights = [math.exp(sum(-0.5 * u * u + 0.5 * ((u - m) / s) ** 2 + math.log(s) for u, m, s in zip(draw, mean, spread)))
                   for draw in draws]
        if number == rounds:
            break
        scores = [max((sign * (r["figures"].get(figure) or 0.0) for r in each), default=0.0) + 1e6 * bad for each, bad in zip(results, failed)]
        # The worst tenth, or all that fail where these are more.
        edge = sorted(scores)[-max(5, count // 10)]
        best = [(draw, w) for draw, w, score, bad in zip(draws, weights, scores, failed) if bad or score >= edge]
        if sum(failed) >= count // 10:
            best = [(draw, w) for draw, w, bad in zip(draws, weights, failed) if bad]
        total = sum(w for _, w in best)
        mean = [sum(w * draw[i] for draw, w in best) / total for i in range(len(keys))]
        # Never narrower than what is asked about: what a narrow draw does not see has a weight without bound.
        spread = [max(1.0, math.sqrt(sum(w * (draw[i] - mean[i]) ** 2 for draw, w in best) / total)) for i in range(len(keys))]
    rate, error = mean_and_error([w if bad else 0.0 for w, bad in zip(weights, failed)])
    return rate, error, {k: normal[k][0] + normal[k][1] * m for k, m in zip(keys, mean)}


def mean_and_error(terms):
    mean = sum(terms) / len(terms)
    return mean, math.sqrt(max(0.0, sum(t * t for t in terms) / len(terms) - mean * mean) / len(terms))


def plain_rate(search, count):
    """The same rate by draws that all count alike: (rate, error)."""
    normal = {key: tuple(entry.number() for entry in value.entries()) for key, value in search.keys["normal"].items()}
    chance = random.Random(search.campaign.draw_seed + 1)
    points = [{k: repr(float(f"{chance.gauss(*pair):.9g}")) for k, pair in normal.items()} for _ in range(count)]
    return mean_and_error([float(search.failed(each)) for each in search.fails(points)])


def import_cma():
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that there is nothing to draw with
            import cma
    except ImportError:
        raise CampaignError("method cmaes needs the library cma; run: python3 -m pip install cma (or take method importance)") from None
    return cma


class Box:
    """What cmaes is asked: the point of a box whose figure is smallest."""

    def __init__(self, search):
        self.search = search
        if "box" not in search.keys or "minimize" not in search.keys:
            raise search.value.error("cmaes wants box: {KEY: [LEAST, MOST]} and minimize: FIGURE")
        self.box = {key: tuple(entry.number() for entry in value.entries()) for key, value in search.keys["box"].items()}
        if any(len(pair) != 2 or not pair[0] < pair[1] for pair in self.box.values()):
            raise search.keys["box"].error("wants KEY: [LEAST, MOST]")
        if len(self.box) < 2:
            raise search.keys["box"].error("wants two settings or more, which cma needs; of one setting, unknown: finds the boundary")
        self.figure = search.keys["minimize"].text()
        if self.figure not in FIGURES:
            raise search.keys["minimize"].error(f"is no figure of a run; use one of {', '.join(FIGURES)}")

    def figures(self, draws):
        """Of points within 0..1 (points, figures): the worst over the seeds; a fall is worse than any figure."""
        points = [{k: repr(float(f"{low + (high - low) * u:.9g}")) for (k, (low, high)), u in zip(self.box.items(), draw)} for draw in draws]
        return points, [min((r["figures"].get(self.figure) or 0.0) - 1000.0 * bool(r["figures"].get("fell")) for r in each)
                        for each in self.search.fails(points)]


def cmaes(search, number_of_runs):
    """The worst point of a box: (point, figure)."""
    cma, box = import_cma(), Box(search)
    best = (None, math.inf)
    strategy = cma.CMAEvolutionStrategy([0.5] * len(box.box), 0.25, {"bounds": [0, 1], "seed": 1 + search.campaign.draw_seed, "verbose": -9})
    while not strategy.stop():
        draws, before = strategy.ask(), search.runs
        points, figures = box.figures(draws)
        strategy.tell(draws, figures)
        best = min([best, *zip(points, figures)], key=lambda pair: pair[1])
        if 2 * search.runs - before > number_of_runs:  # another generation would be too many
            break
    return best


def drawn_worst(search, count):
    """The same by drawing: the worst of count points spread evenly over the box."""
    box, chance = Box(search), random.Random(search.campaign.draw_seed)
    return min(zip(*box.figures([[chance.random() for _ in box.box] for _ in range(count)])), key=lambda pair: pair[1])


def rose(rows, title):
    """Boundaries of pushes by direction, one line per time: SVG."""
    size, middle = 520, 260
    most = max((row.boundary() or 0.0 for row in rows), default=0.0) or 1.0
    colors = ("#1f6fb4", "#d1495b", "#2a9d5c", "#8a4fbf", "#e08a1e", "#0f8b8d")
    out = [f"<svg xmlns='http://www.w3.org/2000/svg' width='{size}' height='{size + 30}' font-family='DejaVu Sans' font-size='12'>",
           f"<text x='{middle}' y='18' text-anchor='middle'>{title}</text>"]
    for k in (1, 2, 3, 4):
        out.append(f"<circle cx='{middle}' cy='{middle + 20}' r='{50 * k}' fill='none' stroke='#ddd'/>"
                   f"<text x='{middle + 3}' y='{middle + 16 - 50 * k}' fill='#777'>{most * k / 4:.3g}</text>")
    groups = {}
    for row in rows:
        others = [f"{key}={value}" for key, value in row.axes.items()
                  if key not in ("direction_deg", "at_s") and len({other.axes[key] for other in rows}) > 1]
        groups.setdefault(", ".join([f"at {row.axes['at_s']:g} s", *others]), []).append(row)
    for number, (name, group) in enumerate(groups.items()):
        dots = []
        for row in group:
            if row.boundary() is not None:
                angle, radius = math.radians(row.axes["direction_deg"]), 200 * row.boundary() / most
                dots.append(f"{middle - radius * math.sin(angle):.1f},{middle + 20 - radius * math.cos(angle):.1f}")
        color = colors[number % len(colors)]
        out.append(f"<polygon points='{' '.join(dots)}' fill='none' stroke='{color}' stroke-width='2'/>"
                   f"<text x='8' y='{40 + 16 * number}' fill='{color}'>{name}</text>")
    return "".join(out) + f"<text x='{middle}' y='{size + 24}' text-anchor='middle'>up: forward, left: left; smallest push that fells [N s]</text></svg>"


def curves(rows, key):
    """Boundaries of an unknown over the first setting of the rows that is a number, a line for each combination of the others: SVG, or ""."""
    from report import BOTTOM, HEIGHT, LEFT, LINES, RIGHT, TOP, WIDTH, apart, esc, frame, scale
    from store import number_or_text
    axes = [name for name in rows[0].axes if len({row.axes[name] for row in rows}) > 1 and all(number_or_text(row.axes[name])[0] == 0 for row in rows)]
    found = [row for row in rows if row.boundary() is not None]
    if not axes or len(found) < 2:
        return ""
    xs, ys = sorted({float(row.axes[axes[0]]) for row in found}), [row.boundary() for row in found]
    low, high = min(ys), max(ys)
    margin = 0.1 * (high - low or abs(high) or 1.0)
    px, py = scale(xs[0], xs[-1], LEFT + 12, WIDTH - RIGHT - 12), scale(low - margin, high + margin, HEIGHT - BOTTOM, TOP)
    out = frame(f"where failures begin: {key}", axes[0], key, apart([(x, f"{x:.4g}") for x in xs], px), [low + (high - low) * i / 4 for i in range(5)], px, py)
    lines = {}
    for row in found:
        lines.setdefault(", ".join(f"{k}={v}" for k, v in row.axes.items()
                                   if k != axes[0] and len({other.axes[k] for other in rows}) > 1), []).append(row)
    for number, (name, group) in enumerate(sorted(lines.items())):
        color = LINES[number % len(LINES)]
        dots = sorted((px(float(row.axes[axes[0]])), py(row.boundary())) for row in group)
        out.append(f"<polyline points='{' '.join(f'{x:.1f},{y:.1f}' for x, y in dots)}' fill='none' stroke='{color}' stroke-width='2'/>")
        out += [f"<circle cx='{x:.1f}' cy='{y:.1f}' r='4' fill='{color}'/>" for x, y in dots]
        out.append(f"<text x='{WIDTH - RIGHT - 8}' y='{TOP + 16 + 14 * number}' font-size='11' text-anchor='end' fill='{color}'>{esc(name)}</text>")
    return "".join(out + ["</svg>"])


def write(out, search):
    with open(out / "search.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        axes = list(search.rows[0].axes)
        writer.writerow([*axes, "largest_that_passes", "smallest_that_fails", "note"])
        for row in search.rows:
            writer.writerow([*(row.axes[key] for key in axes), f"{row.good:.6g}" if row.tried_good else "",
                             f"{row.bad:.6g}" if row.tried_bad else "", row.side()])
    drawn = rose(search.rows, "felling push") if "push" in search.keys else curves(search.rows, search.keys["unknown"].text())
    if drawn:
        (out / "search.html").write_text(f"<!doctype html><meta charset='utf-8'><title>Search</title>{drawn}\n", encoding="utf-8")


def search_command(words):
    parser = Parser("search", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--out")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--dask")
    parser.add_argument("--random", type=int, default=0, metavar="N", help="also N random runs (bisection: per row), and how far what they show is")
    given = parser.parse_args(words)
    import cluster
    import local
    import spec
    from store import Store
    campaign = spec.read(given.file)
    if campaign.search is None:
        raise CampaignError(f"{given.file}: has no search; add search: {{unknown: KEY, least: 0, most: 1}}")
    store = Store(given.out or pathlib.Path(given.file).resolve().parent / "campaigns" / pathlib.Path(given.file).stem)

    def run(left, add):
        if given.dask:
            return cluster.run_dask(left, add, given.dask)
        return pool.run(left, add)
    pool = local.Threads(max(1, given.workers))
    try:
        search = Search(campaign, store, run, given.file)
        return say(search, store, given)
    finally:
        pool.close()
        store.write_tables()
        store.close()


def say(search, store, given):
    most_runs = search.keys["runs"].number(10, 1e7, whole=True) if "runs" in search.keys else 200
    if search.method == "cmaes":
        point, figure = cmaes(search, most_runs)
        print(f"worst of {search.runs} runs: {figure:.6g} at {', '.join(f'{k}={v}' for k, v in point.items())}")
        if given.random:
            point, figure = drawn_worst(search, given.random)
            print(f"worst of {given.random} drawn points: {figure:.6g} at {', '.join(f'{k}={v}' for k, v in point.items())}")
        return 0
    if search.method == "importance":
        if "normal" not in search.keys:
            raise search.value.error("importance wants normal: {KEY: [MEAN, SD]}")
        rate, error, middle = importance(search, most_runs)
        if rate == 0.0:
            print(f"no run failed of {search.runs}, drawn about " + ", ".join(f"{k}={v:.4g}" for k, v in middle.items())
                  + ": give more runs:, or minimize: a figure that shrinks towards failure")
            return 0
        print(f"rate of failures {rate:.3g} +- {error:.2g} from {search.runs} runs; they fail about "
              + ", ".join(f"{k}={v:.4g}" for k, v in middle.items()))
        if 0 < rate < 1 and error > 0:
            print(f"drawing without weights would take {(1 - rate) * rate / error ** 2:.0f} runs for that error")
        if given.random:
            rate, error = plain_rate(search, given.random)
            print(f"drawn without weights: rate {rate:.3g} +- {error:.2g} from {given.random} points")
        return 0
    search.bisect(search.rows, max(1, given.workers))
    for row in search.rows:
        print(f"{row.name:28} " + (f"{row.boundary():.4g} (passes {row.good:.4g}, fails {row.bad:.4g}; {row.runs} runs)" if row.boundary() is not None
                                   else row.side()))
    write(store.out, search)
    looked = search.runs
    print(f"{looked} runs\n{store.out / 'search.csv'}")
    if given.random:
        compare_with_drawn(search, looked, given.random)
    return 0
