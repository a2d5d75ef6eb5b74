#!/usr/bin/env python3
"""./twinbus campaign gate: risks held, runs saved, the same decision whatever the workers, two versions pair by pair."""

import random
import re
import statistics
import unittest

from campaign_rig import Rig

import rates


def repeats(rate, count, p0=0.05, p1=0.1, alpha=0.05, beta=0.05, seed=1):
    """(how often good, how often bad, runs of each)."""
    generator, said, runs = random.Random(seed), [], []
    for _ in range(count):
        test, decision = rates.Sprt(p0, p1, alpha, beta), None
        while decision is None:
            decision = test.add(generator.random() < rate)
        said.append(decision)
        runs.append(test.runs)
    return said.count("good"), said.count("bad"), runs


class Risks(unittest.TestCase):
    def test_alpha_and_beta_hold_and_half_of_the_runs_are_saved(self):
        fixed, _ = rates.fixed_size(0.05, 0.1, 0.05, 0.05)
        _, bad, runs = repeats(0.05, 1000)
        self.assertLessEqual(bad, 50)
        self.assertLessEqual(statistics.median(runs), 0.5 * fixed)
        good, _, runs = repeats(0.1, 1000)
        self.assertLessEqual(good, 50)
        self.assertLessEqual(statistics.median(runs), 0.5 * fixed)

    def test_computed_risks_hold_and_are_those_of_repeats(self):
        for alpha, beta in ((0.05, 0.05), (0.01, 0.1)):
            test = rates.Sprt(0.05, 0.1, alpha, beta)
            fixed, _ = rates.fixed_size(0.05, 0.1, alpha, beta)
            good, bad, runs = rates.exact_risk(test, 0.05, 5 * fixed)
            self.assertLessEqual(1 - good, alpha)
            wrong, _, _ = rates.exact_risk(test, 0.1, 5 * fixed)
            self.assertLessEqual(wrong, beta)
            _, drawn, lengths = repeats(0.05, 2000, alpha=alpha, beta=beta)
            least, most = rates.wilson(drawn, 2000, 3.3)
            self.assertTrue(least <= bad <= most, (least, bad, most))
            self.assertAlmostEqual(statistics.mean(lengths) / runs, 1.0, delta=0.1)

    def test_the_fixed_size_is_that_of_exact_binomials(self):
        runs, hits = rates.fixed_size(0.05, 0.1, 0.05, 0.05)
        self.assertEqual((runs, hits), (298, 21))
        self.assertLessEqual(rates.binomial_at_most(hits, runs, 0.1), 0.05)
        self.assertLessEqual(1 - rates.binomial_at_most(hits, runs, 0.05), 0.05)
        self.assertAlmostEqual(rates.binomial_at_most(1, 3, 0.5), 0.5)


class Gate(Rig):
    def test_good_and_bad_versions(self):
        for bad, said, status in ((90, "PASSES", 0), (4, "FAILS", 1)):
            file = self.file(f"scenes: stand\nlogs: 0\nsettings: {{bad: [{bad}]}}\ngate: {{rate: 0.1, good: 0.05}}\n")
            lines = [self.here("gate", file, "--out", f"o{bad}{workers}", "--workers", workers, status=status) for workers in (1, 3)]
            self.assertIn(said, lines[0])
            self.assertEqual(*lines)  # decided by the order of seeds
            self.assertRegex(lines[0], r"alpha 0.05.*beta 0.05")

    def test_two_versions_on_equal_seeds(self):
        worse = self.folder / "worse"
        worse.write_text(self.fake.read_text().replace("bad=0 push", "bad=3 push"))
        worse.chmod(0o755)
        text = ("scenes: stand\nlogs: 0\ncontrollers: {before: {}, now: {program: %s}}\ngate: {versions: [before, now], most: 60}\n")
        said = self.here("gate", self.file(text % "worse"), "--out", "a", status=1)
        self.assertIn("now is worse", said)
        self.assertLess(int(re.search(r"(\d+) pairs", said)[1]), 40)
        same = self.folder / "same"
        same.write_text(self.fake.read_text() + "\n")
        same.chmod(0o755)
        self.assertIn("no difference", self.here("gate", self.file(text % "same"), "--out", "b"))

    def test_the_simulation_judges_itself(self):
        file = self.file("scenes: stand\ngate: {rate: 0.1}\n")
        for rate, name in ((0.05, "alpha"), (0.02, "alpha"), (0.1, "beta"), (0.3, "beta")):
            said = self.here("gate", file, "--simulate", rate, "--seed", 3)
            self.assertRegex(said, rf"wrong \d+ of 200: [\d.]+ % \(95 %: [\d.]+ .. [\d.]+ %\), {name} 5 % (held|is not contradicted); "
                                   r"computed without draws: [\d.]+ %, held")
        self.assertIn("either answer is right", self.here("gate", file, "--simulate", 0.07))

    def test_wrong_gates(self):
        for text, said in (("gate: {}", "c.yaml:2: gate: wants either"), ("gate: {rate: 2}", "c.yaml:2: gate.rate: 2 is not within"),
                           ("gate: {rate: 0.1, good: 0.2}", "must pass: below rate"), ("", "has no gate"),
                           ("gate: {versions: [a, b]}", "wants two names of controllers")):
            self.assertIn(said, self.here("gate", self.file(f"scenes: stand\n{text}\n"), "--out", "o", status=1))


if __name__ == "__main__":
    unittest.main()
