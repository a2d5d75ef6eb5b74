#!/usr/bin/env python3
"""./twinbus campaign compare: equal runs, runs of another path, and runs that must be equal and are not."""

import json
import unittest

from campaign_rig import Rig


class Compare(Rig):
    def test_paths_and_machines(self):
        for path in ("avx2", "baseline"):
            self.here(self.file(f"scenes: [stand, sway]\nseeds: 1..2\npath: {path}\n"), "--out", path)
        self.here(self.file("scenes: [stand, sway]\nseeds: 1..3\npath: avx2\n"), "--out", "other")
        self.assertIn("one machine and program: 4 of 4 runs are equal", self.here("compare", "avx2", "other"))
        self.assertIn("path: avx2 / baseline: 4 of 4", self.here("compare", "avx2", "baseline"))
        # another bit on another processor
        done = self.folder / "other/done/here.jsonl"
        results = [json.loads(line) for line in done.read_text().splitlines()]
        for result in results:
            result["where"]["processor"] = "another"
        results[0]["figures"]["max_tilt_deg"] *= 1.5
        done.write_text("".join(json.dumps(result) + "\n" for result in results))
        said = self.here("compare", "avx2", "other", status=1)
        self.assertIn("/ another: 3 of 4 runs are equal; largest difference 33 % in max_tilt_deg", said)
        self.assertIn("THEY MUST BE", said)
        self.assertEqual(sum(row["equal"] == "false" for row in self.table("avx2", "compare.csv")), 1)
        # a path may differ, and then it is listed
        done = self.folder / "baseline/done/here.jsonl"
        done.write_text(done.read_text().replace("hash1", "hash7"))
        self.assertIn("path: avx2 / baseline: 2 of 4", self.here("compare", "avx2", "baseline"))
        self.assertIn("no run is in both", self.here("compare", "avx2", self.empty(), status=1))

    def empty(self):
        self.here(self.file("scenes: squat\n"), "--out", "squat")
        return "squat"


if __name__ == "__main__":
    unittest.main()
