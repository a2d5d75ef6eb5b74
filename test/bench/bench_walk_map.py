#!/usr/bin/env python3
"""./twinbus bench walk_map [--robot R] [--directions N] [--phases N] [--tolerance T]: pushes survived on the spot, by direction and phase.

Prints CSV.  survived: the largest change of velocity [m/s] over a push of 0.1 s, found to T (0.05) by the search of the campaign
test/bench/campaigns/walk_map.yaml, 1.6 m/s at most.  bound: what the robot's pendulum could survive (test/bench/walk_bound.cpp says how).
"""

import argparse
import math
import tempfile

import on_campaign

HARDEST, EASIEST = 1.6, 0.02  # [m/s]
WATCHED = 3.5                 # [s] after the push


def bound_along(bounds, degrees):
    """Of a push in that direction: the first axis that is lost."""
    x, y = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    of_x, of_y = float(bounds["forward" if x > 0 else "back"]), float(bounds["left" if y > 0 else "right"])
    return min(of_x / abs(x) if abs(x) > 1e-9 else 10 * HARDEST, of_y / abs(y) if abs(y) > 1e-9 else 10 * HARDEST)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.strip())
    parser.add_argument("--robot", default="hrp1s")
    parser.add_argument("--directions", type=int, default=8)
    parser.add_argument("--phases", type=int, default=6)
    parser.add_argument("--tolerance", type=float, default=0.05)
    given = parser.parse_args()
    phases = [round(i / max(1, given.phases), 6) for i in range(max(1, given.phases))]
    with tempfile.TemporaryDirectory() as folder:
        first, second = on_campaign.read("walk_bounds"), on_campaign.read("walk_map")
        first.update(robots=given.robot, settings={"phase": phases})
        bounds = {float(row["phase"]): row for row in on_campaign.run("walk_bounds", first, folder, "bench walk_map")}
        mass, times = float(bounds[0.0]["mass_kg"]), [float(bounds[phase]["time_s"]) for phase in phases]
        push = dict(second["search"]["push"], link=bounds[0.0]["link"], at=times, directions=max(1, given.directions))
        second.update(robots=given.robot, **{"for": max(times) + WATCHED})
        second["search"] = dict(second["search"], push=push, least=EASIEST * mass, most=HARDEST * mass, tolerance=given.tolerance)
        rows = on_campaign.search("walk_map", second, folder, "bench walk_map")
    print("direction_deg,phase,survived,bound")
    phase_at = dict(zip(times, phases))
    for row in sorted(rows, key=lambda row: (float(row["at_s"]), float(row["direction_deg"]))):
        phase, degrees = phase_at[float(row["at_s"])], float(row["direction_deg"])
        print(f"{degrees:.0f},{phase:.3f},{float(row['largest_that_passes'] or 0.0) / mass:.3f},{bound_along(bounds[phase], degrees):.3f}")


if __name__ == "__main__":
    main()
