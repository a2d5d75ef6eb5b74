#!/usr/bin/env python3
"""./twinbus campaign with the program itself: the table, forced instruction paths, what the program refuses, a log of a failure."""

import os
import pathlib
import subprocess
import sys
import unittest

from campaign_rig import ROOT, Rig

TWINBUS = pathlib.Path(os.environ.get("TWINBUS_BIN", ROOT / "build/release/bin")) / "twinbus"


class Real(Rig):
    def setUp(self):
        super().setUp()
        self.environment["TWINBUS_PROGRAM"] = str(TWINBUS)

    def test_scenes_settings_and_seeds(self):
        file = self.file("scenes: [stand, sway]\nseeds: 1..2\nfor: 0.1\nsettings: {servo.delay_ms: [0, 4]}\n")
        self.here(file, "--out", "a", "--workers", 2)
        self.here(file, "--out", "b", "--workers", 1)
        self.assertEqual((self.folder / "a/results.csv").read_bytes(), (self.folder / "b/results.csv").read_bytes())
        rows = self.table("a")
        self.assertEqual(len(rows), 8)
        self.assertEqual({row["ticks"] for row in rows}, {"50"})
        self.assertTrue(all(len(row["state_hash"]) == 16 for row in rows))

    def test_a_forced_path_is_the_path_that_runs(self):
        hashes = {}
        for path in ("baseline", "avx2"):
            file = self.file(f"scenes: sway\nfor: 0.3\npath: {path}\n")
            said = self.here(file, "--out", path, status=None)
            if path != "baseline" and "runs path" in said:
                print(f"this machine has no {path}")
                continue
            self.assertEqual([row["path"] for row in self.table(path, "runs.csv")], [path])
            hashes[path] = self.table(path)[0]["state_hash"]
        self.assertEqual(len(hashes), len(set(hashes.values())), "one path gives the other's bits: the switch does nothing")

    def test_what_the_program_refuses_has_line_and_remedy(self):
        for text, said in (("scenes: stand\nsettings:\n  servo.dely_ms: 4\n", "c.yaml:3: settings.servo.dely_ms: run: "),
                           ("scenes: stand\nsettings:\n  servo.delay_ms: 400\n", "c.yaml:3: settings.servo.delay_ms: run: ")):
            output = self.here(self.file(text), "--out", "o", status=1)
            self.assertIn(said, output)
        words = [str(TWINBUS), "run", "stand", "--for", "0.01"]
        done = subprocess.run(words, env=dict(os.environ, TWINBUS_SIMD="sse9"), capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("use baseline, avx2 or avx512", done.stderr)

    def test_a_changed_scene_fails_and_leaves_a_log(self):
        file = self.file("scenes: push_forward\nfor: 0.4\nsettings: {scene.pushes.0.at: 0.01, scene.pushes.0.impulse.0: [1, 900]}\n")
        self.here(file, "--out", "o", status=1)
        rows = {row["scene.pushes.0.impulse.0"]: row for row in self.table("o")}
        self.assertEqual((rows["900"]["status"], rows["900"]["fell"]), ("failed", "true"), rows)
        self.assertEqual(rows["1"]["fell"], "false")
        self.assertTrue((self.folder / f"o/logs/{rows['900']['id']}.log").exists())


if __name__ == "__main__":
    if not TWINBUS.exists():
        print(f"{TWINBUS} is not built: skipped")
        sys.exit(77)
    unittest.main()
