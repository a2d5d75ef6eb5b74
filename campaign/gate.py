"""`campaign gate FILE`: is the rate of failures below p?  Sequential (Wald), or two versions pair by pair on equal seeds.

    gate: {rate: 0.05}                              # below 5 %, with alpha = beta = 0.05
    gate: {rate: 0.05, good: 0.02, alpha: 0.01, beta: 0.05, event: fall, most: 5000}
    gate: {versions: [before, ours], worse: 2}      # names of controllers: does the second fail less than twice as often?

Runs are judged in the order of their seeds, so the decision does not depend on who ran them or when.
"""

import argparse
import os
import pathlib
import random
import statistics

from command import Parser
from errors import CampaignError
from rates import Sprt, exact_risk, fixed_size, wilson

KEYS = ("rate", "good", "alpha", "beta", "event", "most", "versions", "worse")


class Asked:
    """The gate of a file.  Throws CampaignError."""

    def __init__(self, value, campaign=None):
        keys = value.keys(KEYS)

        def number(key, default, least, most, whole=False):
            return keys[key].number(least, most, whole) if key in keys else default
        self.alpha, self.beta = number("alpha", 0.05, 1e-6, 0.5), number("beta", 0.05, 1e-6, 0.5)
        self.event = keys["event"].word_of(("failure", "fall")) if "event" in keys else "failure"
        self.versions = None
        if ("rate" in keys) == ("versions" in keys):
            raise value.error("wants either rate: P, or versions: [BEFORE, NOW]")
        if "versions" in keys:
            names = [entry.text() for entry in keys["versions"].entries()]
            if len(names) != 2 or not set(names) <= set(campaign.controllers):
                raise keys["versions"].error(f"wants two names of controllers: ({', '.join(campaign.controllers)})")
            self.versions = names
            odds = number("worse", 2.0, 1.05, 1000.0)
            # Of runs in which just one of the two fails: how often is it the second?
            self.p0, self.p1 = 0.5, odds / (1.0 + odds)
        else:
            self.p1 = keys["rate"].number(1e-6, 0.9)
            self.p0 = number("good", 0.5 * self.p1, 1e-7, 0.9)
            if not self.p0 < self.p1:
                raise keys["good"].error(f"is the rate of a version that must pass: below rate ({self.p1:g})")
        self.fixed, self.allowed = fixed_size(self.p0, self.p1, self.alpha, self.beta)
        self.most = number("most", 20 * self.fixed if self.versions else 5 * self.fixed, 1, 10_000_000, whole=True)

    def test(self):
        return Sprt(self.p0, self.p1, self.alpha, self.beta)


def is_event(result, event):
    if result["status"] == "refused":
        raise CampaignError(f"run {result['id']} was refused: {result['failures'][0]}")
    return bool(result["figures"].get("fell")) if event == "fall" else result["status"] != "passed"


def sequence(campaign, maker):
    """Tasks without end: every scene, robot, controller and setting with seed 1, then with seed 2, ..."""
    campaign.seeds = [1]
    while True:
        yield list(maker.product([{}]))
        campaign.seeds = [campaign.seeds[0] + 1]


def gate_command(words):
    parser = Parser("gate", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--out")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--dask")
    parser.add_argument("--simulate", type=float, metavar="RATE", help="no runs: a version that fails at this rate, many times over")
    parser.add_argument("--repeats", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1, help="of the simulation")
    given = parser.parse_args(words)
    import spec
    from store import Store
    campaign = spec.read(given.file)
    if campaign.gate is None:
        raise CampaignError(f"{given.file}: has no gate; add gate: {{rate: 0.05}}")
    if campaign.drawn:
        raise CampaignError(f"{given.file}: a gate takes grids only; let the scene's own randomness vary with the seed")
    asked = Asked(campaign.gate, campaign)
    if given.simulate is not None:
        return simulate(asked, given.simulate, max(1, given.repeats), given.seed)
    print(f"calls a version good whose {'share of differing pairs' if asked.versions else f'rate of {asked.event}s'} is {asked.p0:g}, but for "
          f"alpha {asked.alpha:g}; calls one bad whose is {asked.p1:g}, but for beta {asked.beta:g}; a fixed size would take {asked.fixed} "
          f"{'differing pairs' if asked.versions else 'runs'}")
    out = given.out or pathlib.Path(given.file).resolve().parent / "campaigns" / pathlib.Path(given.file).stem
    store = Store(out)
    try:
        return decide(asked, campaign, spec.TaskMaker(campaign), store, given)
    finally:
        store.write_tables()
        store.close()


def decide(asked, campaign, maker, store, given):
    import campaign as command
    import cluster
    import local
    test, tasks, judged, pairs, said = asked.test(), sequence(campaign, maker), 0, 0, None
    first = True

    def engine(left, add):
        if given.dask:
            return cluster.run_dask(left, add, given.dask)
        return local.run(left, add, max(1, given.workers), str(store.out / "logs"), campaign.logs)
    while said is None and judged < asked.most:
        batch, groups = [], []
        while len(batch) < max(2, 4 * given.workers):  # what is run beyond the decision is lost
            groups.append(next(tasks))
            batch += groups[-1]
        if first:
            command.check_first(maker, campaign, groups[0])
            first = False
        left = store.ask(batch)
        if left:
            engine(left, store.add)
        for task in (task for group in groups for task in paired(group, asked.versions)):
            if said is not None or judged >= asked.most:
                break
            judged += 1
            hits = [is_event(result_of(store, one), asked.event) for one in task]
            if asked.versions is None:
                said = test.add(hits[0])
            elif hits[0] != hits[1]:
                pairs += 1
                said = test.add(hits[1])
    return conclude(asked, test, said, judged)


def result_of(store, task):
    if task["id"] not in store.results:
        raise CampaignError(store.unrun.get(task["id"], f"run {task['id']} has no result"))
    return store.results[task["id"]]


def paired(group, versions):
    """Each judged thing: one task, or the two of the versions on the same seed."""
    if versions is None:
        return [(task,) for task in group]
    found = {}
    for task in group:
        if task["controller"] in versions:
            key = (task["scene"], task["robot"], tuple(task["varied"].items()))
            found.setdefault(key, {})[task["controller"]] = task
    return [(pair[versions[0]], pair[versions[1]]) for pair in found.values()]


def conclude(asked, test, said, judged):
    if asked.versions:
        before, now = asked.versions
        counts = f"{judged} pairs, {test.runs} differ: {now} alone fails in {test.hits}, {before} alone in {test.runs - test.hits}"
        if test.runs == 0:
            print(f"{counts}\nno difference: the rates differ by less than {100 * wilson(0, judged)[1]:.2f} % (95 %)")
            return 0
        print(counts)
        sentence = {"good": f"PASSES: {now} is not worse", "bad": f"FAILS: {now} is worse"}
    else:
        least, most = wilson(test.hits, test.runs)
        print(f"{test.runs} runs, {test.hits} {asked.event}s: rate {100 * test.hits / test.runs:.2f} % (95 %: {100 * least:.2f} .. {100 * most:.2f} %)")
        sentence = {"good": f"PASSES: the rate is below {asked.p1:g}", "bad": f"FAILS: the rate is above {asked.p0:g}"}
    print(sentence.get(said, f"UNDECIDED after {judged}; the rate lies between {asked.p0:g} and {asked.p1:g}: raise most:, or part them"))
    if said:
        print(f"a fixed size would have taken {asked.fixed}: {100 * (1 - test.runs / asked.fixed):.0f} % saved")
    return 0 if said == "good" else 1


def simulate(asked, rate, repeats, seed=1):
    """Bernoulli runs at a known rate: how often is the gate wrong, and how many runs does it take?"""
    generator = random.Random(seed)
    said, runs = [], []
    for _ in range(repeats):
        test, decision = asked.test(), None
        while decision is None and test.runs < asked.most:
            decision = test.add(generator.random() < rate)
        said.append(decision)
        runs.append(test.runs)
    saved = 1 - statistics.median(runs) / asked.fixed
    print(f"rate {rate:g}, {repeats} repeats: called good {said.count('good')}, bad {said.count('bad')}, undecided {said.count(None)}; "
          f"runs: median {statistics.median(runs):g}, largest {max(runs)}, a fixed size takes {asked.fixed}: {100 * saved:.0f} % saved")
    good, bad, _ = exact_risk(asked.test(), rate, asked.most)
    if asked.p0 < rate < asked.p1:
        print(f"between {asked.p0:g} and {asked.p1:g} either answer is right; computed: good {100 * good:.2f} %, bad {100 * bad:.2f} %")
        return 0
    name, allowed = ("alpha", asked.alpha) if rate <= asked.p0 else ("beta", asked.beta)
    wrong, exact = (repeats - said.count("good"), 1 - good) if name == "alpha" else (said.count("good"), good)
    least, most = wilson(wrong, repeats)
    held = least <= allowed
    print(f"wrong {wrong} of {repeats}: {100 * wrong / repeats:.2f} % (95 %: {100 * least:.2f} .. {100 * most:.2f} %), {name} {100 * allowed:g} % "
          f"{'held' if most <= allowed else 'is not contradicted' if held else 'EXCEEDED'}; computed without draws: {100 * exact:.2f} %, "
          f"{'held' if exact <= allowed else 'EXCEEDED'}")
    return 0 if held and exact <= allowed else 1
