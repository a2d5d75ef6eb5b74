#!/usr/bin/env python3
"""./twinbus bench pushes [--robot R] [--set KEY=VALUE] [--guard] [--csv F]: the largest push a standing robot survives, by direction.

With the balance controller and with the posture held, as the campaign test/bench/campaigns/pushes.yaml has it: a search to 3 %.  One of
these runs: ./twinbus run stand with that push among its pushes.
"""

import argparse
import csv
import sys
import tempfile

import on_campaign

NAMES = ("forward", "forward left", "left", "back left", "back", "back right", "right", "forward right")


def main():
    parser = argparse.ArgumentParser(usage=__doc__.strip().replace("%", "%%"))
    parser.add_argument("--robot", default="hrp1s")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--guard", action="store_true")
    parser.add_argument("--csv")
    given = parser.parse_args()
    campaign = on_campaign.read("pushes")
    campaign["robots"] = given.robot
    if given.guard:
        del campaign["controllers"]
    for each in given.set:
        key, equal, value = each.partition("=")
        if not equal:
            sys.exit(f"bench pushes: --set wants KEY=VALUE, not '{each}'")
        campaign["settings"][key] = value
    with tempfile.TemporaryDirectory() as folder:
        rows = on_campaign.search("pushes", campaign, folder, "bench pushes")
    found = {(float(row["direction_deg"]), row["scene.modes.0.mode"]): float(row["largest_that_passes"] or 0.0) for row in rows}
    print(f"largest push at the {campaign['search']['push']['link']} within 0.1 s, {given.robot} standing [N s]")
    print(f"{'direction':14} {'balance':>8} {'without':>8}")
    lines = []
    for number, name in enumerate(NAMES):
        held, without = found[45.0 * number, "balance"], found[45.0 * number, "hold"]
        print(f"{name:14} {held:8.1f} {without:8.1f}")
        lines.append(["push", name, "largest", "N s", held, "", "", "", "without", without, held / without if without > 0.0 else 0])
    if given.csv:
        with open(given.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([["bench", "case", "metric", "unit", "median", "p99", "p999", "max", "peer", "peer_median", "ratio"], *lines])


if __name__ == "__main__":
    main()
