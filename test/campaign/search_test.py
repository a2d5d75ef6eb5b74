#!/usr/bin/env python3
"""./twinbus campaign search with a stand-in whose boundary is known: found within the tolerance, by a few runs a row."""

import math
import random
import re
import unittest
import unittest.mock

from campaign_rig import Rig

import search


class Known(search.Search):
    """Rows whose boundary is a function of direction; no runs."""

    def __init__(self, boundary, directions, least=1.0, most=200.0, tolerance=0.03):
        self.runs, self.least, self.most, self.tolerance, self.keys = 0, least, most, tolerance, {}
        self.rows = [search.Row(f"{i}", {"direction_deg": 360.0 * i / directions, "at_s": 1.0}, lambda size, i=i: (i, size), least, most)
                     for i in range(directions)]
        self.edges = [boundary(math.radians(360.0 * i / directions)) for i in range(directions)]

    def fails(self, points):
        self.runs += len(points)
        return [[size >= self.edges[i]] for i, size in points]

    def failed(self, results):
        return results[0]


class Bisection(unittest.TestCase):
    def test_a_smooth_boundary_takes_few_runs_and_random_sampling_takes_twenty_times_as_many(self):
        found = Known(lambda a: 50 + 15 * math.cos(a) + 4 * math.sin(2 * a), 32)
        found.bisect(found.rows, 2)
        looked = found.runs
        for row, edge in zip(found.rows, found.edges):
            self.assertAlmostEqual(row.boundary() / edge, 1.0, delta=0.03)
        self.assertLessEqual(looked, 32 * 6)
        # 20 times as many runs, drawn: the boundary of some rows is still wrong by more than that
        drawn = [search.parted(found, each) for each in search.random_rows(found, 20 * looked // 32)]
        self.assertGreater(max(abs(a - edge) / edge for a, edge in zip(drawn, found.edges)), 0.03)

    def test_a_robot_that_falls_left_as_right_takes_three_runs_a_row_on_one_side(self):
        for batch in (1, 2):
            found = Known(lambda a: 40 - 13 * math.cos(a) + 9 * math.cos(3 * a), 16)
            found.bisect(found.rows, batch)
            self.assertLessEqual(sum(row.runs for row in found.rows[9:]), 22)
            for row, edge in zip(found.rows, found.edges):
                self.assertAlmostEqual(row.boundary() / edge, 1.0, delta=0.016)

    def test_an_island_above_the_boundary_is_not_taken_for_it(self):
        """Something passes again at 0.88, as a robot does that is pushed just so that its next step catches it."""
        for batch in (1, 3):
            found = Known(lambda a: 0.72 + 0.2 * math.cos(a), 8, 0.02, 1.6)
            fails = found.fails
            found.fails = lambda points: [[r[0] and not 0.93 < size / found.edges[i] - 0.3 < 0.99] for r, (i, size) in zip(fails(points), points)]
            found.bisect(found.rows, batch)
            for row, edge in zip(found.rows, found.edges):
                self.assertAlmostEqual(row.boundary() / edge, 1.0, delta=0.03)

    def test_rows_without_a_boundary_say_so(self):
        for edge, side in ((500.0, "all pass"), (0.1, "all fail")):
            found = Known(lambda _: edge, 3)
            found.bisect(found.rows, 2)
            self.assertEqual([row.side() for row in found.rows], [side] * 3)
            self.assertLess(found.runs, 30)

    def test_rough_boundaries(self):
        chance = random.Random(3)
        found = Known(lambda _: chance.uniform(2, 190), 40)
        found.bisect(found.rows, 3)
        for row, edge in zip(found.rows, found.edges):
            self.assertAlmostEqual(row.boundary() / edge, 1.0, delta=0.03)


class Normal(unittest.TestCase):
    def test_a_rare_failure_has_its_rate(self):
        """P(u > 3) of a normal is 0.00135: 600 draws would see none or one."""
        found = unittest.mock.Mock()
        found.keys = {"normal": unittest.mock.Mock()}
        found.keys["normal"].items = lambda: [("u", unittest.mock.Mock(entries=lambda: [unittest.mock.Mock(number=lambda: 0.0),
                                                                                        unittest.mock.Mock(number=lambda: 1.0)]))]
        found.campaign.draw_seed = 1
        found.fails = lambda points: [[{"figures": {"max_tilt_deg": float(p["u"])}}] for p in points]
        found.failed = lambda results: results[0]["figures"]["max_tilt_deg"] > 3.0
        rate, error, middle = search.importance(found, 600)
        self.assertAlmostEqual(rate, 0.00135, delta=0.0004)
        self.assertLess(error, 0.0003)
        self.assertGreater(middle["u"], 2.0)


def span(low, high):
    return unittest.mock.Mock(entries=lambda: [unittest.mock.Mock(number=lambda: low), unittest.mock.Mock(number=lambda: high)])


class Worst(unittest.TestCase):
    def test_the_worst_point_of_a_box_beats_as_many_drawn_ones(self):
        """A valley that no axis follows; its bottom is at (0.3, -1.4, 2)."""
        try:
            import cma  # noqa: F401
        except ImportError:
            self.skipTest("method cmaes needs the library cma; run: python3 -m pip install cma")
        found = unittest.mock.Mock(runs=0)
        found.keys = {"box": unittest.mock.Mock(items=lambda: [(k, span(-4.0, 4.0)) for k in "abc"]),
                      "minimize": unittest.mock.Mock(text=lambda: "zmp_margin_min_mm")}
        found.campaign.draw_seed = 1

        def fails(points):
            found.runs += len(points)
            rows = [[float(p[k]) - at for k, at in (("a", 0.3), ("b", -1.4), ("c", 2.0))] for p in points]
            return [[{"figures": {"zmp_margin_min_mm": (x + y) ** 2 + 50 * (x - y) ** 2 + 5 * z * z}}] for x, y, z in rows]
        found.fails = fails
        point, figure = search.cmaes(found, 400)
        self.assertLessEqual(found.runs, 400)
        self.assertGreater(found.runs, 380)
        self.assertLess(figure, 0.01)
        self.assertAlmostEqual(float(point["c"]), 2.0, delta=0.1)
        _, drawn = search.drawn_worst(found, 400)
        self.assertGreater(drawn, 10 * figure)


class Command(Rig):
    def test_an_unknown_setting(self):
        file = self.file("scenes: stand\nlogs: 0\nsettings: {limit: [10, 20]}\nsearch: {unknown: push, least: 1, most: 100, tolerance: 0.05}\n")
        said = self.here("search", file, "--out", "o", "--workers", 2)
        rows = self.table("o", "search.csv")
        self.assertEqual([row["limit"] for row in rows], ["10", "20"], said)
        for row in rows:
            self.assertLessEqual(float(row["largest_that_passes"]), float(row["limit"]))
            self.assertGreater(float(row["smallest_that_fails"]), float(row["limit"]))
        self.assertEqual(int(re.search(r"^(\d+) runs", said, re.MULTILINE)[1]), len(self.table("o")))
        drawn = (self.folder / "o/search.html").read_text()
        self.assertIn("where failures begin: push", drawn)
        self.assertEqual(drawn.count("<circle"), 2)

    def test_pushes_with_settings(self):
        """A push is given with each of the settings: what the program gets says so."""
        import spec
        file = self.file("scenes: stand\nlogs: 0\nsettings: {limit: [3, 4], scene.duration: [2, 3]}\n"
                         "search: {push: {link: CHEST, directions: 4}, least: 1, most: 100}\n")
        with unittest.mock.patch.dict("os.environ", self.environment):
            looked = search.Search(spec.read(file), None, None, file)
        self.assertEqual(len(looked.rows), 16)
        texts = set()
        for row in looked.rows:
            for size in (10.0, 20.0):
                task, = looked.tasks(row.settings(size))
                self.assertEqual(task["settings"], {"limit": row.axes["limit"]})
                self.assertIn(f"duration: {float(row.axes['scene.duration'])}", task["scene_text"])
                texts.add((task["scene_text"], row.axes["limit"]))
        self.assertEqual(len(texts), 32)

    def test_a_rate_with_and_without_weights(self):
        """Pushes of 16 +- 5 fell above 20: 21 %."""
        text = ("scenes: stand\nlogs: 0\nsettings: {limit: [20]}\nsearch: {method: importance, normal: {push: [%g, 5]}, runs: 120}\n")
        said = self.here("search", self.file(text % 16), "--out", "o", "--workers", 2, "--random", 20)
        found = re.search(r"rate of failures ([\d.]+) \+- ([\d.]+) from 120 runs", said)
        self.assertTrue(found, said)
        self.assertAlmostEqual(float(found[1]), 0.212, delta=0.1)
        self.assertIn("from 20 points", said)
        self.assertIn("no run failed", self.here("search", self.file(text % -80), "--out", "o", "--workers", 2))

    def test_the_worst_point(self):
        text = ("scenes: stand\nlogs: 0\nsettings: {limit: [20]}\n"
                "search: {method: cmaes, minimize: %s, box: {%spush: [0, 25]}, runs: 40}\n")
        try:
            import cma  # noqa: F401
        except ImportError:
            self.assertIn("pip install cma", self.here("search", self.file(text % ("max_tilt_deg", "")), "--out", "o", status=1))
            self.skipTest("method cmaes needs the library cma; run: python3 -m pip install cma")
        said = self.here("search", self.file(text % ("max_tilt_deg", "ms: [0, 3], ")), "--out", "o", "--random", 10)
        self.assertRegex(said, r"worst of \d+ runs: -999\.\d+ at ms=[\d.]+, push=2")
        self.assertIn("worst of 10 drawn points", said)
        self.assertIn("is no figure of a run", self.here("search", self.file(text % ("tilt", "ms: [0, 3], ")), "--out", "o", status=1))
        self.assertIn("two settings or more", self.here("search", self.file(text % ("max_tilt_deg", "")), "--out", "o", status=1))

    def test_wrong_searches(self):
        for text, said in (("search: {}", "c.yaml:2: search: wants either"), ("search: {unknown: push}", "least is missing"),
                           ("search: {unknown: push, least: 3, most: 1}", "must be above least"), ("", "has no search"),
                           ("search: {method: guess}", "is not one of"), ("search: {method: importance}", "importance wants normal"),
                           ("search: {method: importance, normal: {push: [1, 0]}}", "wants KEY: [MEAN, SD]")):
            self.assertIn(said, self.here("search", self.file(f"scenes: stand\n{text}\n"), "--out", "o", status=1))


if __name__ == "__main__":
    unittest.main()
