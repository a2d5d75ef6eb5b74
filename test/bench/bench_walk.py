#!/usr/bin/env python3
"""./twinbus bench walk [stop|push|pattern|everyday|time]... [--robot R] [--phases N] [--speed V] [--push V] [--guard] [--engine E]

How walking holds: stops in every phase, pushes by direction and phase (a map: . held, x fell), the two references that a robot walks by,
what every robot must do, time of a tick.  Without words: all of it.  --push: the same change of velocity [m/s] in every direction.
The cases are those of the campaigns test/bench/campaigns/walk_*.yaml; test/bench/walk_case.cpp runs one.  Exit status 1 when a robot fell, a
stop took more than 1.5 steps, or the guard (--guard) asked for a stop.
"""

import argparse
import subprocess
import sys
import tempfile

import on_campaign
import programs

WORDS = ("stop", "push", "pattern", "everyday", "time")
DIRECTIONS = ("forward", "left", "back", "right")
EVERYDAY_PUSH = 0.25  # [m/s]


class Bench:
    def __init__(self, given, folder):
        self.given, self.folder, self.bad = given, folder, 0

    def rows(self, name, change=None, **settings):
        """Of a campaign with these settings beside its own."""
        campaign = on_campaign.read(name)
        campaign["robots"] = self.given.robot
        for key, value in {"engine": self.given.engine, "guard": "true" if self.given.guard else None, **settings}.items():
            if value is not None:
                campaign["settings"][key] = value
        if change:
            change(campaign)
        rows = on_campaign.run(name, campaign, self.folder, "bench walk")
        self.bad += sum(row["status"] != "passed" for row in rows)
        return rows

    def phases(self, otherwise):
        count = max(1, self.given.phases or otherwise)
        return [round(i / count, 6) for i in range(count)]

    def stop(self):
        rows = self.rows("walk_stop", phase=self.phases(100), speed=self.given.speed)
        steps = [float(row["steps"]) for row in rows]
        print(f"stop at {self.given.speed:.2f} m/s in {len(rows)} phases: {sum(row['held'] == 'false' for row in rows)} falls, "
              f"{sum(row['late'] == 'true' for row in rows)} took more than 1.5 steps, mean {sum(steps) / len(steps):.2f}, most {max(steps):.2f} steps; "
              f"effort {max(float(row['effort_percent']) for row in rows):.0f} % of the limits, ZMP margin "
              f"{min(float(row['zmp_margin_mm']) for row in rows):.1f} mm")

    def push(self, name="nominal", phases=12, pattern=None):
        def sized(campaign):
            for case in campaign["cases"].values():
                for key, value in case["settings"].items():
                    case["settings"][key] = value if not self.given.push else self.given.push if value > 0 else -self.given.push

        def size(rows, direction):
            return max(abs(float(row[key])) for row in rows if row["case"] == direction for key in ("x", "y") if row.get(key))
        walking = self.rows("walk_push", sized, phase=self.phases(phases), pattern=pattern)
        standing = self.rows("walk_standing", sized, pattern=pattern)
        print(f"{name:22}", end="")
        for direction in DIRECTIONS:
            row = sorted((row for row in walking if row["case"] == direction), key=lambda row: float(row["phase"]))
            held = "".join("." if each["held"] == "true" else "x" for each in row)
            stood = next(each for each in standing if each["case"] == direction)
            print(f"  {direction} {size(walking, direction):.2f}: {held.count('.')} of {len(held)} {held} standing {size(standing, direction):.2f}: "
                  f"{'holds' if stood['held'] == 'true' else 'FALLS'}", end="")
        print(flush=True)

    def pattern(self):
        def walk(campaign):
            del campaign["seeds"]
            campaign["settings"].pop("guard") if not self.given.guard else None
            campaign["cases"] = {name: {"settings": {"pattern": name, "speed": self.given.speed}} for name in ("closed_form", "preview")}
        rows = {row["case"]: row for row in self.rows("walk_everyday", walk)}
        for name, row in rows.items():
            print(f"pattern {name:11} walks {self.given.speed:.2f} m/s: {'holds' if row['held'] == 'true' else 'FALLS'}, "
                  f"tilt {float(row['tilt_deg']):.2f} degrees, ZMP margin {float(row['zmp_margin_mm']):.1f} mm")
            self.push(name, 6, name)

    def everyday(self):
        def pushed(campaign):
            for case in campaign["cases"].values():
                case["settings"] = {key: EVERYDAY_PUSH if value > 0 else -EVERYDAY_PUSH for key, value in case["settings"].items()}
        seen, order = set(), list(on_campaign.read("walk_everyday")["cases"])
        for row in sorted(self.rows("walk_everyday"), key=lambda row: (order.index(row["case"]), int(row["seed"]))):
            if row["case"] in seen and not row["case"].startswith("tiles"):
                continue
            seen.add(row["case"])
            says = "holds" if row["held"] == "true" else "the guard STOPS it" if row["guard_stops"] == "true" else "FALLS"
            print(f"{self.given.robot}, guard on, {row['case']}: {says}, tilt {float(row['tilt_deg']):.2f} degrees, "
                  f"ZMP margin {float(row['zmp_margin_mm']):.1f} mm")
        rows = self.rows("walk_push", pushed, phase=[round(i / 6, 6) for i in range(6)], guard="true")
        print(f"{self.given.robot}, guard on, pushes of {EVERYDAY_PUSH:.2f} m/s: {sum(row['held'] == 'true' for row in rows)} of {len(rows)} held")

    def time(self):
        program = programs.folder_of("walk_case", "bench walk") / "walk_case"
        for guard in ([], ["--guard"]):
            subprocess.run([program, "time", "--robot", self.given.robot, "--speed", str(self.given.speed), *guard], check=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.strip())
    parser.add_argument("words", nargs="*", metavar="WORD")
    parser.add_argument("--robot", default="hrp1s")
    parser.add_argument("--phases", type=int)
    parser.add_argument("--speed", type=float, default=0.5)
    parser.add_argument("--push", type=float)
    parser.add_argument("--guard", action="store_true")
    parser.add_argument("--engine")
    given = parser.parse_args()
    if unknown := [word for word in given.words if word not in WORDS]:
        sys.exit(f"bench walk: no part '{unknown[0]}'; there are {', '.join(WORDS)}")
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(given, folder)
        for word in WORDS:
            if word in (given.words or WORDS):
                getattr(bench, word)()
    return 1 if bench.bad else 0


if __name__ == "__main__":
    sys.exit(main())
