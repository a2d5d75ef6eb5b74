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
import math
import os
import pathlib
import random
import warnings

from errors import CampaignError
from run_task import FIGURES
from spec import IN_SCENE, TaskMaker

KEYS = ("push", "unknown", "least", "most", "tolerance", "method", "minimize", "box", "normal", "runs")
PUSH = "+ push"  # not the name of a setting
METHODS = ("bisection", "cmaes", "importance")
WARM = 1.25  # a neighbour's boundary is looked for within this factor of it


class Row:
    """One unknown: the largest value that passes, the smallest that fails."""

    def __init__(self, name, axes, settings, least, most):
        self.name, self.axes, self.settings = name, axes, settings
        self.good, self.bad, self.runs = least, most, 0
        self.tried_good = self.tried_bad = False

    def boundary(self):
        if self.tried_bad and self.tried_good:
            return 0.5 * (self.good + self.bad)
        return None

    def side(self):
        return "" if self.boundary() is not None else "all pass" if not self.tried_bad else "all fail"

    def note(self, value, failed):
        self.runs += 1
        if failed:
            self.bad, self.tried_bad = min(self.bad, value), True
        else:
            self.good, self.tried_good = max(self.good, value), True


class Search:
    def __init__(self, campaign, store, run, file):
        self.campaign, self.store, self.run, self.file = campaign, store, run, file
        self.maker = TaskMaker(campaign)
        self.runs = 0
        value = campaign.search
        keys = value.keys(KEYS)
        self.value, self.keys = value, keys
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
        rows = []
        for at in times:
            for i in range(count):
                angle = 360.0 * i / count
                # Exact along the axes: cos(90 degrees) is no zero in binary.
                x, y = (round(f(math.radians(angle)), 12) for f in (math.cos, math.sin))

                def settings(size, at=at, x=x, y=y):
                    return {PUSH: dict(push, at=at, impulse=[round(size * x, 6), round(size * y, 6), 0.0])}
                rows.append(Row(f"{angle:g} degrees at {at:g} s", {"direction_deg": angle, "at_s": at}, settings, self.least, self.most))
        return rows

    def unknown_rows(self, key):
        import itertools
        keys = list(self.campaign.grid)
        return [Row(", ".join(f"{k}={v}" for k, v in zip(keys, values)) or key, dict(zip(keys, values)),
                    lambda size, values=values: {**dict(zip(keys, values)), key: repr(float(f"{size:.9g}"))}, self.least, self.most)
                for values in itertools.product(*self.campaign.grid.values())]

    def tasks(self, settings):
        """Of one point: every scene, robot, controller and seed; a push is added to the pushes of the scene."""
        push = settings.pop(PUSH, None)
        if push is None:
            return list(self.maker.product([settings]))
        tasks = []
        for scene in self.campaign.scenes:
            import yaml
            tree = yaml.safe_load(scene[1]) or {}
            tree["pushes"] = list(tree.get("pushes") or []) + [push]
            changed = (scene[0], yaml.safe_dump(tree, default_flow_style=None, sort_keys=False, width=1000), scene[2])
            self.maker.scenes.pop((scene[0], ()), None)
            for robot in self.campaign.robots:
                for controller in self.campaign.controllers:
                    for seed in self.campaign.seeds:
                        tasks.append(self.maker.make(changed, robot, controller, settings, seed))
            self.maker.scenes.pop((scene[0], ()), None)
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

    def next_value(self, row, near):
        """Where a row is looked at next; near: the boundary of a neighbour."""
        if row.tried_good and row.tried_bad:
            return math.sqrt(row.good * row.bad) if row.good > 0 else 0.5 * (row.good + row.bad)
        if near is not None and not (row.tried_good or row.tried_bad):
            return min(max(near, self.least), self.most)
        if near is not None and row.tried_good != row.tried_bad:
            value = row.good * WARM ** (2 ** (row.runs - 1)) if row.tried_good else row.bad / WARM ** (2 ** (row.runs - 1))
            if self.least < value < self.most:
                return value
        if not (row.tried_good or row.tried_bad) and self.least > 0:
            return math.sqrt(self.least * self.most)
        if not row.tried_bad:
            return self.most
        return self.least

    def bisect(self, rows, batch):
        """Rows side by side: those whose neighbours are known begin there."""
        open_rows, closed = list(rows), []
        while open_rows:
            # The first rows alone, then the rest, warm.
            now = open_rows[:batch]
            values = [self.next_value(row, nearest(row, closed)) for row in now]
            points = [row.settings(value) for row, value in zip(now, values)]
            for row, value, results in zip(now, values, self.fails(points)):
                row.note(value, self.failed(results))
                end = (row.tried_good and row.good >= self.most) or (row.tried_bad and row.bad <= self.least)
                if end or self.narrow(row):
                    open_rows.remove(row)
                    closed.append(row)
        return rows


def nearest(row, closed):
    """The boundary of the closed row that is most like it."""
    known = [other for other in closed if other.boundary() is not None]
    if not known:
        return None

    def distance(other):
        turn = abs(float(row.axes.get("direction_deg", 0)) - float(other.axes.get("direction_deg", 0))) % 360
        return min(turn, 360 - turn) + 100 * sum(row.axes[k] != other.axes.get(k) for k in row.axes if k != "direction_deg")
    return min(known, key=distance).boundary()


def random_rows(search, count):
    """The same boundary by drawing: per row count runs evenly over least .. most; where the two kinds of runs part."""
    chance, found = random.Random(1), []
    for row in search.rows:
        values = [float(f"{chance.uniform(search.least, search.most):.6g}") for _ in range(count)]
        fails = [search.failed(results) for results in search.fails([row.settings(value) for value in values])]
        good = max([v for v, bad in zip(values, fails) if not bad], default=search.least)
        bad = min([v for v, bad in zip(values, fails) if bad], default=search.most)
        found.append(0.5 * (good + bad))
    return found


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
    for number, at in enumerate(sorted({row.axes["at_s"] for row in rows})):
        dots = []
        for row in rows:
            if row.axes["at_s"] == at and row.boundary() is not None:
                angle, radius = math.radians(row.axes["direction_deg"]), 200 * row.boundary() / most
                dots.append(f"{middle - radius * math.sin(angle):.1f},{middle + 20 - radius * math.cos(angle):.1f}")
        color = colors[number % len(colors)]
        out.append(f"<polygon points='{' '.join(dots)}' fill='none' stroke='{color}' stroke-width='2'/>"
                   f"<text x='8' y='{40 + 16 * number}' fill='{color}'>at {at:g} s</text>")
    return "".join(out) + f"<text x='{middle}' y='{size + 24}' text-anchor='middle'>up: forward, left: left; smallest push that fells [N s]</text></svg>"


def write(out, search):
    with open(out / "search.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        axes = list(search.rows[0].axes)
        writer.writerow([*axes, "largest_that_passes", "smallest_that_fails", "note"])
        for row in search.rows:
            writer.writerow([*(row.axes[key] for key in axes), f"{row.good:.6g}" if row.tried_good else "",
                             f"{row.bad:.6g}" if row.tried_bad else "", row.side()])
    if "push" in search.keys:
        (out / "search.html").write_text("<!doctype html><meta charset='utf-8'><title>Search</title>" + rose(search.rows, "felling push")
                                         + "\n", encoding="utf-8")


def search_command(words):
    parser = argparse.ArgumentParser(prog="./twinbus campaign search", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
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
        drawn = random_rows(search, given.random)
        apart = [abs(a - row.boundary()) / row.boundary() for a, row in zip(drawn, search.rows) if row.boundary()]
        print(f"random sampling: {search.runs - looked} runs, {(search.runs - looked) / looked:.1f} times as many; boundaries apart by at most "
              f"{100 * max(apart, default=0):.1f} %, {sum(a <= 0.03 for a in apart)} of {len(apart)} within 3 %")
    return 0
