#!/usr/bin/env python3
"""./twinbus bench reach [--robot NAME_OR_DIR] [--held] [--count N] [--seed N] [--speed S]: a robot reaches among random obstacles.

hrp1s unless told balances meanwhile; with --held every second goal of a hand picks something, the next one places it.
N goals (200), ten in each world: the tasks of the campaign test/bench/campaigns/reach.yaml, whose program is test/bench/reach_world.cpp.
Exit status 1 when a goal was neither reached nor truly refused, anything touched, or the robot fell; reach_world --seed N --trace shows
every goal of a world.
"""

import argparse
import sys
import tempfile

import on_campaign

GOALS = 10


def main():
    parser = argparse.ArgumentParser(usage=__doc__.strip())
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1, help="of the first world")
    parser.add_argument("--speed", type=float, default=0.4)
    parser.add_argument("--robot", default="hrp1s")
    parser.add_argument("--held", action="store_true")
    given = parser.parse_args()
    campaign = on_campaign.read("reach")
    campaign["arguments"] += ["--robot", given.robot] + ["--held"] * given.held
    worlds = max(1, -(-given.count // GOALS))
    campaign.update(seeds=f"{given.seed}..{given.seed + worlds - 1}", settings={"speed": given.speed})
    with tempfile.TemporaryDirectory() as folder:
        rows = on_campaign.run("reach", campaign, folder, "bench reach")
    for row in rows:
        if row["status"] != "passed" or row["failures"]:
            print(f"world {row['seed']}: {row['failures'] or row['status']}")

    def total(key):
        return sum(int(row[key] or 0) for row in rows)

    def worst(key, pick=max):
        return pick(float(row[key] or 0.0) for row in rows)
    print(f"{total('asked')} goals: {total('reached')} reached ({worst('miss_mm'):.1f} mm, {worst('angle_rad'):.3f} rad off at most), "
          f"{total('refused_truly')} refused truly, {total('missed')} untruly or missed, {total('given_up')} given up on the way; "
          f"{total('contacts')} with a contact, {total('falls')} falls; nearest {worst('nearest_mm', min):.1f} mm, "
          f"ZMP margin {worst('zmp_margin_mm', min):.0f} mm; planned in {sorted(float(row['plan_ms'] or 0.0) for row in rows)[len(rows) // 2]:.1f} ms")
    return 0 if all(row["status"] == "passed" for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
