#!/usr/bin/env python3
"""./twinbus campaign plan: few cores are used whole, many are held up by the driver just where its cost says."""

import unittest

import campaign_rig  # noqa: F401  the path to campaign/
import plan


class Plan(unittest.TestCase):
    def test_few_cores_are_busy_and_many_wait_for_the_driver(self):
        runs, task = 20000, 0.1
        for engine in ("workers", "dask", "slurm"):
            ideal = plan.COST[engine][1] + runs * task / 8
            self.assertAlmostEqual(plan.simulate(8, runs, task, engine) / ideal, 1.0, delta=0.03)
        cost, start = plan.COST["dask"]
        self.assertAlmostEqual(plan.simulate(1000, runs, task, "dask"), start + runs * cost, delta=2.0)
        self.assertLess(plan.simulate(1000, runs, task, "slurm"), plan.simulate(1000, runs, task, "dask") + 30)

    def test_every_run_is_done(self):
        self.assertGreater(plan.simulate(3, 1, 5.0, "workers"), 4.0)


if __name__ == "__main__":
    unittest.main()
