#!/usr/bin/env python3
"""./twinbus campaign with a stand-in for the program: the table of tasks, resume, limits, deaths of workers, files that are wrong."""

import json
import os
import random
import signal
import subprocess
import threading
import time
import unittest

from campaign_rig import ROOT, Rig

import local
import rates
import sampling
import store


class Table(Rig):
    SIMPLE = "scenes: [stand, sway]\nseeds: 1..4\nfor: 2\n"

    def test_simplest_file(self):
        said = self.here(self.file(self.SIMPLE), "--out", "o", "--workers", 2)
        self.assertIn("8 of 8 tasks", said)
        rows = self.table("o")
        self.assertEqual([(row["scene"], row["seed"]) for row in rows], [(s, str(n)) for s in ("stand", "sway") for n in range(1, 5)])
        self.assertEqual(len({row["id"] for row in rows}), 8)
        self.assertNotIn("wall", "".join(rows[0]))
        self.assertTrue((self.folder / "o/report.html").exists())
        self.assertEqual({row["path"] for row in self.table("o", "runs.csv")}, {"avx2"})

    def test_the_same_table_as_parquet(self):
        try:
            from pyarrow import parquet
        except ImportError:
            self.skipTest("results.parquet needs pyarrow; run: python3 -m pip install pyarrow")
        self.here(self.file("scenes: stand\nseeds: 1..5\nsettings: {bad: [2, 3], ms: 0}\n"), "--out", "o", status=1)
        rows, found = self.table("o"), parquet.read_table(self.folder / "o/results.parquet")
        self.assertEqual(found.column_names, list(rows[0]))
        types = {field.name: str(field.type) for field in found.schema}
        self.assertEqual([types[name] for name in ("id", "seed", "bad", "fell", "max_tilt_deg", "travel_m", "state_hash")],
                         ["string", "int64", "double", "bool", "double", "double", "string"])  # no run has a travel_m
        for row, one in zip(rows, found.to_pylist()):
            self.assertEqual((row["id"], int(row["seed"]), float(row["max_tilt_deg"]), row["fell"] == "true"),
                             (one["id"], one["seed"], one["max_tilt_deg"], one["fell"]))
        before = (self.folder / "o/results.parquet").read_bytes()
        self.here(self.folder / "c.yaml", "--out", "again", "--workers", 1, status=1)
        self.assertEqual((self.folder / "again/results.parquet").read_bytes(), before)

    def test_the_table_does_not_depend_on_workers_or_order(self):
        file = self.file("scenes: stand\nseeds: 1..40\nsettings: {bad: [3, 7]}\n")
        for workers in (1, 3):
            self.here(file, "--out", f"o{workers}", "--workers", workers, status=1)
        self.assertEqual((self.folder / "o1/results.csv").read_bytes(), (self.folder / "o3/results.csv").read_bytes())

    def test_what_is_done_is_not_run_again(self):
        file = self.file(self.SIMPLE)
        self.here(file, "--out", "o")
        self.assertIn("0 of them new", self.here(file, "--out", "o"))
        # a torn line and a repeated one, as a kill leaves them
        done = self.folder / "o/done/here.jsonl"
        lines = done.read_text().splitlines(keepends=True)
        done.write_text("".join(lines[:5]) + lines[0] + lines[6][:30])
        self.assertIn("3 of them new", self.here(file, "--out", "o"))
        self.assertEqual(len(self.table("o")), 8)

    def test_another_program_is_another_task(self):
        file = self.file("scenes: stand\n")
        self.here(file, "--out", "o")
        self.fake.write_text(self.fake.read_text() + "\n")
        self.assertIn("1 of them new", self.here(file, "--out", "o"))

    def test_limits_crashes_and_refusals_are_results(self):
        file = self.file("scenes: stand\nsettings: {do: [nothing, crash, hang]}\nlimit: 0.3\n")
        # the check of the first task meets `nothing`, which writes no report
        self.assertIn("no report", self.here(file, "--out", "o", status=1))
        file = self.file("scenes: stand\nseeds: 1..2\nsettings: {do: [crash, hang]}\nlimit: 0.3\n")
        self.assertTrue(self.quick_check(file))
        self.assertEqual(sorted(row["status"] for row in self.table("o")), ["crashed", "crashed", "timeout", "timeout"])

    def quick_check(self, file):
        """Without the check of the first tasks, which would wait a minute for `hang`."""
        code = (f"import sys; sys.path.insert(0, {str(ROOT / 'campaign')!r}); import campaign; campaign.check_first = lambda *a: None; "
                f"sys.exit(campaign.main([{str(file)!r}, '--out', 'o']))")
        return subprocess.run(["python3", "-c", code], env=self.environment, cwd=self.folder, capture_output=True).returncode == 1

    def test_logs_of_failures_only(self):
        self.here(self.file("scenes: stand\nseeds: 1..9\nsettings: {bad: [2]}\nlogs: 3\n"), "--out", "o", "--workers", 1, status=1)
        failed = {row["id"] for row in self.table("o") if row["status"] == "failed"}
        logs = {log.stem for log in (self.folder / "o/logs").glob("*.log")}
        self.assertEqual(len(failed), 4)
        self.assertEqual(len(logs), 3)
        self.assertLessEqual(logs, failed)
        text = (self.folder / "o/report.html").read_text()
        self.assertTrue(all(f"replay/{name}" in text for name in failed))

    def test_a_forced_path(self):
        self.here(self.file("scenes: stand\npath: baseline\n"), "--out", "o")
        self.assertEqual(self.table("o", "runs.csv")[0]["path"], "baseline")

    def test_killed_workers_lose_nothing(self):
        tasks = [{"id": f"{i:016x}", "scene": "stand", "scene_hash": "s", "scene_text": "", "robot": "hrp1s", "settings": {}, "seed": i,
                  "for": 1.0, "program": str(self.fake), "program_hash": __import__("run_task").hash_of(self.fake)} for i in range(300)]
        pids, came, over = [], [], threading.Event()

        def kill():
            chance = random.Random(1)
            while not over.wait(0.4):
                try:
                    os.kill(chance.choice(pids), signal.SIGKILL)
                except (IndexError, ProcessLookupError):
                    pass
        os.environ.pop("TWINBUS_PROGRAM", None)
        killer = threading.Thread(target=kill)
        killer.start()
        try:
            local.run(tasks, came.append, 3, pids=pids)
        finally:
            over.set()
            killer.join()
        ids = [result["id"] for result in came]
        self.assertEqual(set(ids), {task["id"] for task in tasks})
        self.assertTrue(all(result["status"] == "passed" for result in came))

    def test_a_killed_campaign_goes_on(self):
        file = self.file("scenes: stand\nseeds: 1..150\n")
        for _ in range(2):
            process = subprocess.Popen(self.words(file, "--out", "o"), env=self.environment, cwd=self.folder, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            while process.poll() is None and not any((self.folder / "o").glob("done/*.jsonl")):
                time.sleep(0.02)
            time.sleep(0.3)
            process.kill()
            process.wait()
        self.campaign(file, "--out", "o")
        self.assertEqual([int(row["seed"]) for row in self.table("o")], list(range(1, 151)))


class Programs(Rig):
    """Tasks that are no `twinbus run`: a program's arguments, and the JSON object that it prints last."""

    def setUp(self):
        super().setUp()
        prober = self.folder / "prober"
        prober.write_text("""#!/bin/sh
# prober FILE [--deep] [--hard N] --seed N: fails where N divides the seed
file=$1 hard=0 deep=0; shift
while [ $# -gt 0 ]; do case $1 in --deep) deep=1 ;; --hard) hard=$2; shift ;; --seed) seed=$2; shift ;; *) echo "no option $1" >&2; exit 2 ;; esac; shift; done
echo "looks at $file"
status=0; [ "$hard" != 0 ] && [ $((seed % hard)) = 0 ] && status=1
echo '{"found": "'$(cat $file)'", "deep": '$deep', "depth": '$((seed * 2))', "failures": ["too hard"], "times": {"plan_us": 12.5}}'
exit $status
""")
        prober.chmod(0o755)
        self.data = self.folder / "data"
        self.data.write_text("gold")
        self.text = f"program: prober\narguments: [{self.data}]\nseeds: 1..6\ncases:\n  easy: {{}}\n  hard: {{settings: {{hard: 3, deep: true}}}}\n"

    def test_figures_times_and_failures(self):
        said = self.here(self.file(self.text + "output: true\n"), "--out", "o", "--workers", 2, status=1)
        self.assertIn("10 passed, 2 failed", said)
        rows = self.table("o")
        self.assertEqual([(row["case"], row["seed"]) for row in rows], [(c, str(n)) for c in ("easy", "hard") for n in range(1, 7)])
        self.assertEqual([row["seed"] for row in rows if row["status"] == "failed"], ["3", "6"])
        self.assertEqual({row["found"] for row in rows}, {"gold"})
        self.assertEqual([row["deep"] for row in rows], ["0"] * 6 + ["1"] * 6)
        self.assertNotIn("plan_us", rows[0])
        self.assertEqual(self.table("o", "runs.csv")[0]["plan_us"], "12.5")
        self.assertIn("looks at", (self.folder / "o/done/here.jsonl").read_text())
        text = (self.folder / "o/report.html").read_text()
        self.assertIn("prober", text)
        self.assertNotIn("replay/", text)
        name = rows[8]["id"]
        self.assertIn("no run of a scene", self.here("view", "o", name, status=1))
        self.assertIn("no ingredients", self.here("minimize", "o", name, status=1))

    def test_repeats_take_turns(self):
        file = self.file(self.text.replace("seeds: 1..6", "seeds: 1").replace("hard: 3, ", "") + "repeats: 3\noutput: true\n")
        self.here(file, "--out", "o", "--workers", 1)
        self.assertEqual([(row["case"], row["repeat"]) for row in self.table("o")], [(c, n) for c in ("easy", "hard") for n in "123"])
        names = {row["id"]: row["case"] for row in self.table("o")}
        done = [json.loads(line)["id"] for line in (self.folder / "o/done/here.jsonl").read_text().splitlines()]
        self.assertEqual([names[name] for name in done], ["easy", "hard"] * 3)

    def test_a_file_that_changes_is_another_task(self):
        file = self.file(self.text)
        self.here(file, "--out", "o", status=1)
        self.assertIn("0 of them new", self.here(file, "--out", "o", status=1))
        self.data.write_text("lead")
        self.assertIn("12 of them new", self.here(file, "--out", "o", status=1))
        self.assertEqual({row["found"] for row in self.table("o")}, {"lead"})

    def test_wrong_ones(self):
        for text, said in (("program: nobody\n", "is no program"), ("program: prober\nscenes: stand\n", "and this one has a program"),
                           ("program: prober\ncases: {}\n", "is empty"), ("scenes: stand\nrepeats: 2\n", "repeat to the last bit"),
                            ("scenes: stand\ncases: {a: {program: x}}\n", "is for campaigns of a program"),
                           ("program: prober\ncases: {a: {robot: nobody}}\n", "there is no robot"), ("cases: {a: {}}\n", "scenes is missing")):
            self.assertIn(said, self.here(self.file(text), "--out", "o", status=1))
        self.here(self.file(f"program: prober\narguments: [{self.data}, --wrong, x]\n"), "--out", "w", status=1)
        row, = self.table("w")
        self.assertEqual((row["status"], row["failures"]), ("refused", "no option --wrong"))


class Cases(Rig):
    def test_combinations_that_are_no_grid(self):
        robot = self.folder / "mine"
        robot.mkdir()
        (robot / "robot.yaml").write_text("x")
        file = self.file("scenes: [stand, sway]\ncases:\n  nominal: {}\n  bad: {settings: {bad: 1, ms: 2}}\n  other: {robot: mine}\n")
        self.here(file, "--out", "o", status=1)
        rows = self.table("o")
        self.assertEqual([(row["scene"], row["case"], row["status"]) for row in rows if row["robot"] == "hrp1s"],
                         [(scene, *each) for scene in ("stand", "sway") for each in (("bad", "failed"), ("nominal", "passed"))])
        self.assertEqual([row["case"] for row in rows if row["robot"] != "hrp1s"], ["other", "other"])


class Report(Rig):
    def test_rates_by_scene_and_setting(self):
        self.here(self.file("scenes: [stand, sway]\nseeds: 1..8\nlogs: 0\nsettings: {bad: [1, 2, 100], ms: [0, 1]}\n"), "--out", "o", status=1)
        text = (self.folder / "o/report.html").read_text()
        # at ms=0 and at ms=1: 8 of 8, 4 of 8 and 0 of 8 seeds, and 24 of 48 runs of a scene
        for words in ("stand: 16 of 16", "sway: 8 of 16", "stand: 0 of 16", "stand: 12 of 24", "8 of 16 did not pass", "36.39 .. 63.61 %"):
            self.assertIn(words, text)


class Output(Rig):
    def test_a_reader_that_leaves_gets_no_traceback(self):
        for words in (["--help"], ["search", "--help"]):
            read, write = os.pipe()
            os.close(read)
            done = subprocess.run(self.words(*words), stdout=write, stderr=subprocess.PIPE, text=True, env=self.environment)
            os.close(write)
            self.assertEqual(done.stderr, "", words)


class Files(Rig):
    def test_wrong_arguments_are_one_line_with_the_remedy(self):
        for words, said in ((("x.yaml", "--jobs", "x"), "campaign: argument --jobs"), (("plan", "--task"), "campaign plan: argument --task"),
                            (("--out",), "campaign: argument --out"), (("gate",), "campaign gate: ")):
            done = subprocess.run(self.words(*words), capture_output=True, text=True, env=self.environment)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertTrue(done.stderr.startswith(said) and done.stderr.count("\n") == 1 and "--help" in done.stderr, done.stderr)

    def test_wrong_files_name_line_field_and_remedy(self):
        for text, said in (
                ("", "is empty"),
                ("scenes: [stand\n", "mend the YAML"),
                ("scenes: [stand]\nseed: 3\n", "c.yaml:2: seed: unknown key; is seeds meant?"),
                ("seeds: 3\n", "scenes is missing"),
                ("scenes: [stnd]\n", "c.yaml:1: scenes[0]: there is no scene 'stnd'; use"),
                ("scenes: [../../etc/passwd]\n", "there is no scene"),
                ("scenes: stand\nseeds: 4..1\n", "c.yaml:2: seeds: 4..1 runs backwards"),
                ("scenes: stand\nseeds: 1..999999999\n", "is longer than"),
                ("scenes: stand\nfor: .nan\n", "c.yaml:2: for: '.nan' is no number"),
                ("scenes: stand\nfor: 1e99\n", "is not within"),
                ("scenes: stand\nrobots: [nobody]\n", "there is no robot 'nobody'"),
                ("scenes: stand\nsettings:\n  a: {random: [2, 1]}\n", "c.yaml:3: settings.a.random: wants [LEAST, MOST]"),
                ("scenes: stand\nsettings:\n  a: {random: [1, 2]}\n  b: {sobol: [1, 2]}\n", "draw all settings the same way"),
                ("scenes: stand\nsettings:\n  a: {grid: {from: 0, to: 1}}\n", "count is missing"),
                ("scenes: stand\nsettings: {bda: 3}\n", "c.yaml:2: settings.bda: run: no setting 'bda'"),
                ("scenes: stand\nsettings: {scene.pushes.0.at: 3}\n", "c.yaml:2: settings.scene.pushes.0.at: stand: the scene has no 'pushes'"),
                ("scenes: &a [stand]\nrobots: *a\n", "aliases"),
                ("scenes: stand\nscenes: sway\n", "stands here twice"),
                ("scenes: stand\npath: sse9\n", "is not one of"),
                ("scenes: stand\ncontrollers: {old: {program: nowhere}}\n", "is no program"),
                ("scenes: stand\nseeds: 1..100000\nsettings: {a: {grid: {from: 0, to: 1, count: 1000}}}\n", "tasks, 2000000 at most"),
                ("a: " + "[" * 3000 + "\n", "")):
            with self.subTest(text=text[:60]):
                output = self.here(self.file(text), "--out", "o", status=1)
                self.assertIn(said, output)
                self.assertNotIn("Traceback", output)
                self.assertLess(len(output.splitlines()), 4)
        self.assertIn("No such file", self.here("nowhere.yaml", status=1))

    def test_random_bytes(self):
        chance = random.Random(7)
        good = b"scenes: [stand]\nseeds: 1..4\nsettings: {bad: [2, 3], push: {random: [1, 2]}}\nfor: 2\n"
        import spec
        from errors import CampaignError
        os.environ.update({key: self.environment[key] for key in ("TWINBUS_PROGRAM", "TWINBUS_CONFIG")})
        path = self.folder / "f.yaml"
        for _ in range(400):
            data = bytearray(good)
            for _ in range(chance.randint(1, 6)):
                data[chance.randrange(len(data))] = chance.choice(b"[]{}:,#*&!|>'\"%@`\n\t 09azAZ.-\x00\xff")
            path.write_bytes(data)
            try:
                spec.read(path)
            except CampaignError:
                pass


class Numbers(unittest.TestCase):
    def test_wilson(self):
        low, high = rates.wilson(0, 10)
        self.assertEqual(low, 0.0)
        self.assertAlmostEqual(high, 0.2775, 4)
        low, high = rates.wilson(50, 100)
        self.assertAlmostEqual(low, 0.4038, 4)
        self.assertAlmostEqual(high, 0.5962, 4)

    def test_draws_are_the_same_everywhere(self):
        box = {"a": (0.0, 1.0), "b": (-5.0, 5.0)}
        points = sampling.draw("random", box, 3, 1)
        self.assertEqual(points[0], {"a": "0.134364244", "b": "3.47433737"})
        self.assertEqual(sampling.draw("random", box, 3, 1), points)

    def test_adaptive_points_crowd_at_the_edge(self):
        box = {"a": (0.0, 1.0)}
        known = [({"a": str(x / 10)}, float(x > 4)) for x in range(11)]
        points = [float(p["a"]) for p in sampling.next_points(box, known, 6, 1)]
        self.assertGreaterEqual(sum(0.35 <= p <= 0.55 for p in points), 3, points)

    def test_rows_sort_by_number(self):
        tasks = [{"scene": "s", "robot": "r", "controller": "c", "varied": {"k": k}, "seed": 1, "id": k} for k in ("10", "9", "1e1", "x")]
        self.assertEqual([task["id"] for task in sorted(tasks, key=store.sort_key)], ["9", "10", "1e1", "x"])


if __name__ == "__main__":
    unittest.main()
