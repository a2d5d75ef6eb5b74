#!/usr/bin/env python3
"""A few cells of the maps of failures: right and wrong ones, how they fail, and that the engine says so of each that is wrong."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench_maps  # noqa: E402
from failure_cells import MAPS  # noqa: E402

KNOWN = {map_.name: map_ for map_ in MAPS}


class Cells(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = bench_maps.Rig("cells_test", twin=True)

    @classmethod
    def tearDownClass(cls):
        cls.rig.close()

    def line(self, name, row, column, engine):
        cell = next(cell for r, c, cell in KNOWN[name].cells() if (r, c) == (row, column))
        return bench_maps.measure(self.rig, KNOWN[name], engine, row, column, cell)

    def expect(self, name, row, column, engine, result, said=""):
        line = self.line(name, row, column, engine)
        self.assertEqual(line["result"], result, line)
        self.assertTrue(line["said"].startswith(said), line)
        self.assertEqual(line["in_step"] != "", bench_maps.is_wrong(line), line)

    def test_a_fine_step_slides_right_and_a_coarse_one_says_that_it_does_not(self):
        self.expect("slide", "friction 0.8, k 1e6", "1", "articulated1", "right")
        self.expect("slide", "friction 0.8, k 1e6", "50", "articulated1", "slips", "said: step_too_coarse")
        self.expect("slide", "friction 0.8, k 1e6", "10", "articulated2", "right")

    def test_without_its_twin_the_coarse_step_says_it_too(self):
        cell = {"map": "slide", "engine": "articulated1", "friction": 0.8, "stiffness": 1e6, "step": 0.05}
        verdict = bench_maps.judged(self.rig, cell, self.rig.run(cell)[0])
        self.assertEqual(verdict.how, "slips")
        self.assertTrue(verdict.in_step and not verdict.is_silent(), verdict)
        self.assertGreater(verdict.error, 5e-3)

    def test_a_soft_plate_lets_a_ball_through_and_a_stiff_one_does_not(self):
        for engine in ("articulated1", "articulated2"):
            self.expect("plate", "50 m/s, k 1e5", "1", engine, "tunnels", "said: ")
            self.expect("plate", "20 m/s, k 1e9", "1", engine, "doubted", "step_too_coarse")  # held back; how far it bounces depends on the step
        self.expect("plate", "50 m/s, k 1e9", "1", "ode", "tunnels", "said: ")

    def test_a_chain_that_diverges_was_doubted_before_it_was_wrong(self):
        for engine in ("articulated1", "articulated2"):
            self.expect("chain", "30 joints", "50", engine, "diverges", "said: ")

    def test_a_cell_that_is_no_cell_says_why(self):
        self.assertIn("'friction'", self.rig.run({"map": "slide", "engine": "ode", "step": 0.01, "stiffness": 1e6})["error"])
        self.assertIn("no map 'jump'", self.rig.run({"map": "jump", "engine": "ode", "step": 0.01})["error"])
        self.assertIn("no engine 'odd'", self.rig.run({"map": "slide", "engine": "odd", "step": 0.01, "stiffness": 1e6, "friction": 0.8})["error"])

    def test_every_cell_of_every_map_has_its_own_place(self):
        for map_ in MAPS:
            places = [(row, column) for row, column, _ in map_.cells()]
            self.assertEqual(len(places), len(set(places)), map_.name)
        for name, row, column in bench_maps.QUICK:
            self.assertIn((row, column), [(r, c) for r, c, _ in KNOWN[name].cells()], name)


if __name__ == "__main__":
    unittest.main()
