#!/usr/bin/env python3
"""./twinbus bench robust [--rows A,B] [--scenes A,B] [--seeds N] [--csv F]: the walking scenes on a robot that is not the nominal one.

Every row changes what the controller does not know (mass, trunk, soles, delay, sensors) or takes the attitude from gyro and
accelerometer (`attitude: estimated`); every scene is run by `./twinbus run` and judged by its own criteria.  The rows are the cases of
the campaign test/bench/campaigns/robust.yaml.  Exit status 1 when one failed.
"""

import argparse
import csv
import pathlib
import shutil
import sys
import tempfile

import on_campaign

FIGURES = {"tilt [deg]": "max_tilt_deg", "margin [mm]": "zmp_margin_min_mm", "slip [mm]": "step_slip_max_mm",
           "force [%]": "force_rms_percent", "velocity [%]": "velocity_error_percent"}


def robot_that_estimates(folder):
    """A copy of hrp1s whose robot.yaml asks for it."""
    copy = pathlib.Path(folder) / "estimates"
    shutil.copytree(on_campaign.ROOT / "config/robots/hrp1s", copy)
    file = copy / "robot.yaml"
    text = file.read_text(encoding="utf-8")
    assert text.count("walking:\n  {") == 1
    file.write_text(text.replace("walking:\n  {", "walking:\n  {attitude: estimated, "), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(usage=__doc__.strip())
    parser.add_argument("--rows", help="cases of the campaign; all where none is given")
    parser.add_argument("--scenes", help="scenes; those of the campaign where none is given")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--csv")
    given = parser.parse_args()
    campaign = on_campaign.read("robust")
    names = given.rows.split(",") if given.rows else list(campaign["cases"])
    campaign["scenes"] = given.scenes.split(",") if given.scenes else campaign["scenes"]
    if unknown := [name for name in names if name not in campaign["cases"]]:
        sys.exit(f"bench robust: no row {unknown[0]!r}; there are: {', '.join(campaign['cases'])}")
    campaign["cases"] = {name: campaign["cases"][name] for name in names}
    campaign["seeds"] = f"1..{max(1, given.seeds)}"
    with tempfile.TemporaryDirectory() as folder:
        robot_that_estimates(folder)
        rows = on_campaign.run("robust", campaign, folder, "bench robust")
    order = {key: number for number, key in enumerate([*names, *campaign["scenes"]])}
    rows.sort(key=lambda row: (order[row["case"]], order[row["scene"]], int(row["seed"])))
    bad, lines = 0, []
    print(f"{'':20} {'scene':13} seed {'':6}" + "".join(f"{title:>14}" for title in FIGURES))
    for row in rows:
        passed = row["status"] == "passed"
        bad += not passed
        text = "".join(f"{row[key] and f'{float(row[key]):.1f}':>14}" for key in FIGURES.values())
        print(f"{row['case']:20} {row['scene']:13} {row['seed']:>4} {'passes' if passed else 'FAILS '}{text}")
        if not passed:
            print(f"    {row['failures'] or row['status']}")
        lines += [["robust", f"{row['case']}, {row['scene']}, seed {row['seed']}", *title.rstrip("]").split(" ["), row[key]]
                  for title, key in FIGURES.items() if row[key]]
    if given.csv:
        with open(given.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([["bench", "case", "metric", "unit", "median"], *lines])
    print(f"{len(rows) - bad} of {len(rows)} pass")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
