#!/usr/bin/env python3
"""./twinbus bench sim2sim, a few steps of hrp1s: every world is compared, soft contact creeps and rubber does not, and where MuJoCo is
installed soft contact is nearer to it than rubber."""
import csv
import pathlib
import sys
import tempfile

import harness
from harness import Checks

SECONDS = 6.0


def main():
    harness.require("twinbus")
    checks = Checks()
    sys.path.insert(0, str(harness.ROOT / "test/bench"))
    import bench_sim2sim as bench  # pylint: disable=import-outside-toplevel
    ours = bench.Ours(str(harness.BIN / "twinbus"), "hrp1s", "hrp1s", "walk_forward", SECONDS, 130.8 * bench.G)
    tracks = bench.measured(ours, ["articulated", "articulated/soft", "articulated/nonsense", "ode", "mujoco"])
    checks.that("articulated/nonsense" not in tracks, "a world that is none is left out")
    checks.that({"articulated", "articulated/soft", "ode"} <= tracks.keys(), f"worlds: {list(tracks)}")
    for world, track in tracks.items():
        last = track.samples[-1]
        checks.that(not track.fell, f"{world}: it does not fall")
        checks.that(last.time > SECONDS - 0.1 and 1.5 < last.x < 3.0, f"{world}: {last.x:.2f} m in {last.time:.1f} s")
    creep = {world: track.samples[-1].creep for world, track in tracks.items()}
    print({world: f"{1e3 * value:.1f} mm" for world, value in creep.items()}, flush=True)
    checks.that(creep["articulated/soft"] > 3.0 * creep["articulated"], f"soft contact creeps: {creep}")
    checks.that(bench.apart("place", tracks["articulated"], tracks["articulated"]) == 0.0, "a world is not apart from itself")
    shares = bench.compared("hrp1s", tracks)
    checks.that(bool(shares) == ("mujoco" in tracks), "the share of MuJoCo's contact is said where there is MuJoCo")
    if shares:
        checks.that(shares["creep"] > 0.5, f"most of the creep of MuJoCo is its contact: {shares}")
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "sim2sim.csv"
        status = bench.main(["--robot", "hrp1s", "--scene", "stand", "--seconds", "1", "--worlds", "articulated,ode", "--csv", str(file)])
        with open(file, newline="", encoding="utf-8") as source:
            rows = list(csv.DictReader(source))
        checks.that(status == 0 and {row["world"] for row in rows} == {"articulated", "ode"}, f"table: {status}, {len(rows)} rows")
    checks.exit()


if __name__ == "__main__":
    main()
