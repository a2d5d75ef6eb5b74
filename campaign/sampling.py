"""Points in a box: random, Sobol, and adaptive (where neighbours disagree).  The same seed gives the same points everywhere."""

import random

from errors import CampaignError

DIGITS = 9  # of a drawn number: what is written is what runs


def in_box(box, fractions):
    return {key: repr(float(f"{low + (high - low) * u:.{DIGITS}g}")) for (key, (low, high)), u in zip(box.items(), fractions)}


def sobol_fractions(dimensions, count, seed, skip=0):
    try:
        from scipy.stats import qmc
    except ImportError:
        raise CampaignError("sobol needs scipy; run: apt-get install python3-scipy (or draw at random)") from None
    import warnings
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a count that is no power of two is the user's choice
        engine = qmc.Sobol(dimensions, scramble=False)
        rows = engine.fast_forward(skip).random(count) if skip else engine.random(count)
    # A shift of the seed's own: scipy's scrambling may change with its version.
    shift = random.Random(seed)
    shifts = [shift.random() for _ in range(dimensions)]
    return [[(float(u) + s) % 1.0 for u, s in zip(row, shifts)] for row in rows]


def draw(how, box, count, seed):
    """count points of {key: (low, high)}, each {key: text}."""
    if how == "sobol":
        return [in_box(box, row) for row in sobol_fractions(len(box), count, seed)]
    generator = random.Random(seed)
    return [in_box(box, [generator.random() for _ in box]) for _ in range(count)]


def next_points(box, known, count, seed):
    """Where to look next: points far from what is known, and between points that passed and points that did not.

    known: [({key: text}, share of runs that failed)].  The same results give the same points, in whatever order they came.
    """
    spans = {key: high - low for key, (low, high) in box.items()}
    places = sorted(([(float(point[key]) - box[key][0]) / spans[key] for key in box], failed) for point, failed in known)
    generator = random.Random(seed)
    candidates = [[generator.random() for _ in box] for _ in range(60 * count)]
    chosen = []

    def gap(a, b):
        return sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5

    def worth(candidate):
        near = sorted((gap(candidate, place), failed) for place, failed in places)[:4]
        weights = [1.0 / (distance + 1e-9) for distance, _ in near]
        rate = sum(w * failed for w, (_, failed) in zip(weights, near)) / sum(weights) if near else 0.5
        clear = min([gap(candidate, other) for other in chosen] + [distance for distance, _ in near[:1]], default=1.0)
        return (0.05 + rate * (1.0 - rate)) * clear
    for _ in range(count):
        best = max(candidates, key=worth)
        candidates.remove(best)
        chosen.append(best)
    return [in_box(box, fractions) for fractions in chosen]
