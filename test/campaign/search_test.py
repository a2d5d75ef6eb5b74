#!/usr/bin/env python3
"""./twinbus campaign search with a stand-in whose boundary is known: found within the tolerance, by a few runs a row."""

import math
import random
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
        drawn = search.random_rows(found, 20 * looked // 32)
        self.assertGreater(max(abs(a - edge) / edge for a, edge in zip(drawn, found.edges)), 0.03)

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


class Command(Rig):
    def test_an_unknown_setting(self):
        file = self.file("scenes: stand\nlogs: 0\nsettings: {limit: [10, 20]}\nsearch: {unknown: push, least: 1, most: 100, tolerance: 0.05}\n")
        said = self.here("search", file, "--out", "o", "--workers", 2)
        rows = self.table("o", "search.csv")
        self.assertEqual([row["limit"] for row in rows], ["10", "20"], said)
        for row in rows:
            self.assertLessEqual(float(row["largest_that_passes"]), float(row["limit"]))
            self.assertGreater(float(row["smallest_that_fails"]), float(row["limit"]))

    def test_wrong_searches(self):
        for text, said in (("search: {}", "c.yaml:2: search: wants either"), ("search: {unknown: push}", "least is missing"),
                           ("search: {unknown: push, least: 3, most: 1}", "must be above least"), ("", "has no search"),
                           ("search: {method: guess}", "is not one of")):
            self.assertIn(said, self.here("search", self.file(f"scenes: stand\n{text}\n"), "--out", "o", status=1))


if __name__ == "__main__":
    unittest.main()
