"""Rates of yes-or-no results, and how sure they are."""

import math

Z95 = 1.959963984540054


def wilson(hits, runs, z=Z95):
    """Interval of a rate (Wilson 1927): [least, most]; [0, 1] of no runs."""
    if runs == 0:
        return 0.0, 1.0
    rate, z2 = hits / runs, z * z
    middle = (rate + z2 / (2 * runs)) / (1 + z2 / runs)
    half = z / (1 + z2 / runs) * math.sqrt(rate * (1 - rate) / runs + z2 / (4 * runs * runs))
    return max(0.0, middle - half), min(1.0, middle + half)


class Sprt:
    """Wald's sequential test (1945) of a rate: good (at most p0) or bad (at least p1).

    alpha: risk that a version whose rate is p0 is called bad; beta: that one whose rate is p1 is called good.  Both hold whatever
    the number of runs turns out to be, and hold all the more below p0 and above p1.
    """

    def __init__(self, p0, p1, alpha, beta):
        self.p0, self.p1, self.alpha, self.beta = p0, p1, alpha, beta
        self.hit, self.miss = math.log(p1 / p0), math.log((1 - p1) / (1 - p0))
        # Not Wald's (1 - beta) / alpha and beta / (1 - alpha), which hold alpha and beta only about: these never exceed them.
        self.good, self.bad = math.log(beta), -math.log(alpha)
        self.evidence, self.runs, self.hits = 0.0, 0, 0

    def add(self, hit):
        """good, bad, or None while neither is sure."""
        self.runs += 1
        self.hits += bool(hit)
        # Counts, not a running sum: the same counts give the same bits.
        self.evidence = self.hits * self.hit + (self.runs - self.hits) * self.miss
        return "good" if self.evidence <= self.good else "bad" if self.evidence >= self.bad else None


def exact_risk(test, rate, most):
    """(P(good), P(bad), expected runs) of a Sprt that gives up after `most` runs, of a version that fails at this rate: computed, not drawn."""
    states, good, bad, expected = {0: 1.0}, 0.0, 0.0, 0.0  # states: P of so many hits while nothing is said
    for runs in range(1, most + 1):
        expected += sum(states.values())
        following = {}
        for hits, chance in states.items():
            for more, share in ((0, 1.0 - rate), (1, rate)):
                evidence = (hits + more) * test.hit + (runs - hits - more) * test.miss
                if evidence <= test.good:
                    good += chance * share
                elif evidence >= test.bad:
                    bad += chance * share
                else:
                    following[hits + more] = following.get(hits + more, 0.0) + chance * share
        states = following
        if not states:
            break
    return good, bad, expected


def binomial_at_most(hits, runs, rate):
    """P(X <= hits) of runs at rate."""
    if rate <= 0.0:
        return 1.0
    total, log_rate, log_rest = 0.0, math.log(rate), math.log1p(-rate)
    for k in range(hits + 1):
        total += math.exp(math.lgamma(runs + 1) - math.lgamma(k + 1) - math.lgamma(runs - k + 1) + k * log_rate + (runs - k) * log_rest)
    return min(1.0, total)


def fixed_size(p0, p1, alpha, beta):
    """(runs, hits): the smallest test of a fixed size with these risks; at most so many hits are called good."""
    runs, hits = 1, 0
    while True:
        # The fewest runs at which so many hits are rare enough for a bad version ...
        while binomial_at_most(hits, runs, p1) > beta:
            runs += max(1, runs // 200)
        while runs > hits + 1 and binomial_at_most(hits, runs - 1, p1) <= beta:
            runs -= 1
        if 1.0 - binomial_at_most(hits, runs, p0) <= alpha:  # ... and a good one seldom has more.
            return runs, hits
        hits += 1
