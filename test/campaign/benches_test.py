#!/usr/bin/env python3
"""Benches that are campaigns, each with few runs: bench pushes, walk, walk_map, reach and the map of stands; bench robust is tested by walk_scenes_test.py."""

import csv
import subprocess
import sys
import unittest

from campaign_rig import ROOT


def bench(name, *words):
    done = subprocess.run([sys.executable, ROOT / f"test/bench/bench_{name}.py", *words], capture_output=True, text=True, cwd=ROOT)
    return done.returncode, done.stdout, done.stderr


class Benches(unittest.TestCase):
    def test_pushes(self):
        status, out, said = bench("pushes")
        self.assertEqual(status, 0, said)
        rows = {line[:14].strip(): [float(word) for word in line[14:].split()] for line in out.splitlines()[2:]}
        self.assertEqual(len(rows), 8, out)
        for left, right in (("left", "right"), ("back left", "back right"), ("forward left", "forward right")):
            self.assertAlmostEqual(rows[left][0] / rows[right][0], 1.0, delta=0.06, msg=out)
        self.assertTrue(all(30 < size < 70 for row in rows.values() for size in row), out)

    def test_a_map_of_walking(self):
        status, out, said = bench("walk_map", "--directions", "4", "--phases", "1")
        self.assertEqual(status, 0, said)
        rows = list(csv.DictReader(out.splitlines()))
        self.assertEqual([row["direction_deg"] for row in rows], ["0", "90", "180", "270"])
        for row in rows:  # arms and trunk, which the bound does not know, win a tenth of it
            self.assertTrue(0.3 < float(row["survived"]) <= min(1.6, 1.25 * float(row["bound"])), row)

    def test_a_walk(self):
        status, out, said = bench("walk", "stop", "push", "everyday", "--phases", "2")
        self.assertEqual(status, 0, out + said)
        lines = out.splitlines()
        self.assertIn("in 2 phases: 0 falls, 0 took more than 1.5 steps", lines[0])
        self.assertEqual(lines[1].count("2 of 2 .. standing"), 4, out)
        self.assertEqual(sum("tiles of 20 mm: holds" in line for line in lines), 3, out)
        self.assertIn("24 of 24 held", lines[-1])
        status, out, said = bench("walk", "push", "--phases", "1", "--push", "3")
        self.assertEqual((status, out.count("0 of 1 x standing 3.00: FALLS")), (1, 4), out + said)

    def test_a_map_of_stands(self):
        sys.path.insert(0, str(ROOT / "test/bench"))
        import stability_map
        cells = stability_map.cells("ode", 5e-3, "benches_test")
        self.assertEqual(len(cells), 4 * 4 * 3)
        self.assertEqual({cell["result"] for cell in cells}, {"stable"})
        self.assertEqual([cell["step"] for cell in cells[:3]], [0.02, 0.01, 0.005])

    def test_reach(self):
        status, out, said = bench("reach", "--count", "20", "--seed", "3")
        self.assertEqual(status, 0, out + said)
        self.assertIn("20 goals: 20 reached", out)


if __name__ == "__main__":
    if not (ROOT / "build").is_dir() or subprocess.run([sys.executable, "-c", "import sys; sys.path.insert(0, 'test/bench'); import programs; "
                                                        "programs.folder_of('reach_world', 'benches_test')"], cwd=ROOT).returncode:
        print("skipped: bench programs are not built; run ./twinbus bench")
        sys.exit(77)
    unittest.main()
