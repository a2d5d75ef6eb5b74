#!/usr/bin/env python3
"""./twinbus bench planner [--robot NAME] [--csv F] [--rounds N] [--vamp DIR] [--ompl]: our planner on the problems of a robot (panda), beside VAMP.

"ours" asks what VAMP asks: its balls, its obstacles, 32 postures per radian.  "proved" plans for the exact meshes and proves
every line of the path; FCL looks at the final paths of both and of VAMP at 1,000 postures per radian.

Both are the search of the planner without the clearances that it keeps.  P8 asks the planner's process itself for the same goals:
ArmPlanner::plan with clearances, efforts and timing; what it refuses is said with its reason.  P7 is the same on hrp1s at the
table of the scene reach, goal postures included.

Another robot than Panda: robots/NAME and problems/NAME/NAME_problems.txt of $TWINBUS_DATA, which peers/vamp_problems.py makes of a VAMP
checkout for ur5, fetch and baxter; P5 to P7 are left out then, and "proved" is asked for all that VAMP solves and 3 times its time at 99 %.

DIR (or $TWINBUS_VAMP) holds checkouts of KavrakiLab/vamp, KavrakiLab/nigh, orlp/pdqsort and lemire/SIMDxorshift under the
names vamp, nigh, pdqsort, SIMDxorshift; the peer is built from them with VAMP's own flags.  Problems are those of
$TWINBUS_DATA (default ../shared/data).  Ours and the peer take turns (the campaign
test/bench/campaigns/planner.yaml); a figure of a problem is its median over the rounds
(default 5), a figure of the bench the median over the problems.  --ompl adds OMPL's RRT-Connect with
FCL on every tenth problem, on VAMP's balls beside "ours" and on the meshes beside "proved", as often as there are rounds
(minutes; libompl-dev).  It gets what ours has: steps of at most 1 rad and 32 postures per radian of every line; --range R sets
its step, 0: OMPL's own choice.  Exit status 1 if a row falls short.
"""

import collections
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

import on_campaign
import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]
PEERS = ROOT / "test/bench/peers"
VALID = {"panda": 559}  # problems with a free start and goal by VAMP's balls
ALL = {"panda": 560}  # by the meshes
# With the longest steps of its own table [rad].
VAMPS = {"panda": ("Panda", 1.0), "ur5": ("UR5", 1.5), "fetch": ("Fetch", 1.0), "baxter": ("Baxter", 0.5)}
FLAGS = ("-std=c++17 -O3 -march=native -mavx2 -fno-math-errno -fno-signed-zeros -fno-trapping-math -fno-rounding-math "
         "-ffp-contract=fast -fassociative-math -Wno-ignored-attributes").split()
rows, short_of = [], []


def build_vamp(folder, out, robot):
    """The peer program, or None with a line that says why."""
    if not folder:
        print("VAMP is absent: --vamp DIR or $TWINBUS_VAMP names its checkouts (see --help)")
        return None
    if robot not in VAMPS:
        print(f"VAMP is absent: it knows {', '.join(VAMPS)}, not {robot}")
        return None
    sources = [PEERS / "vamp_peer.cpp", folder / "SIMDxorshift/src/simdxorshift128plus.c"]
    program = out / ("vamp_peer_" + robot)
    if program.exists() and program.stat().st_mtime > sources[0].stat().st_mtime:
        return program
    clang = next((c for c in ("clang++", "clang++-14") if shutil.which(c)), None)
    flags = FLAGS + (["-fno-honor-infinities", "-fno-honor-nans", "-fapprox-func"] if clang else [])
    includes = ["-I" + str(folder / p) for p in ("vamp/src/impl", "nigh/src", "pdqsort", "SIMDxorshift/include")]
    name, step = VAMPS[robot]
    of_robot = [f"-DTWINBUS_VAMP_ROBOT={name}", f"-DTWINBUS_VAMP_RANGE={step}", f"-DTWINBUS_VAMP_HEADER=<vamp/robots/{robot}.hh>"]
    done = subprocess.run([clang or "g++", *flags, *of_robot, *includes, "-I/usr/include/eigen3", str(sources[0]), "-x", "c++",
                           "-fpermissive" if not clang else "-Wno-everything", str(sources[1]), "-o", str(program)],
                          capture_output=True, text=True)
    if done.returncode != 0:
        print("VAMP is absent: it does not build: " + (done.stderr.splitlines() or ["?"])[0])
        return None
    return program


def run(program, *words, given=None):
    done = subprocess.run([str(w) for w in (program, *words)], capture_output=True, text=True, check=True, input=given)
    return done.stdout


def measure(name, scratch, data, problems, rounds=1, peer=None):
    """{case: [what it printed, by round]} of a campaign, whose cases take turns on one worker."""
    campaign = on_campaign.read(name)
    if rounds > 1:
        campaign["repeats"] = rounds
    else:
        campaign.pop("repeats", None)
    if peer:
        campaign["cases"]["VAMP"] = {"program": str(peer), "arguments": ["PROBLEMS", "3"]}
    places = {"ROBOTS": str((data / "robots").resolve()), "PROBLEMS": str(problems.resolve())}
    for case in campaign["cases"].values():
        case["arguments"] = [places.get(word, word) for word in case["arguments"]]
    rows = on_campaign.run(name, campaign, scratch, "bench planner", "--workers", "1")
    if failed := [row for row in rows if row["status"] != "passed"]:
        sys.exit(f"bench planner: {failed[0]['case']} {failed[0]['status']}: {failed[0]['failures']}")
    printed = on_campaign.outputs(scratch, name)
    found = {}
    for row in sorted(rows, key=lambda row: int(row.get("repeat") or 1)):
        found.setdefault(row["case"], []).append(printed[row["id"]])
    return found


def touching_of(folder, data, problems, paths):
    """How many final paths hit the meshes."""
    return int(run(folder / "planner_oracle", data / "robots", problems, given=paths).split()[-1])


def as_process(folder, data, problems):
    """The same goals answered by ArmPlanner: prints the figures and why goals were refused."""
    done = subprocess.run([str(folder / "planner_cases"), "planner", str(data / "robots"), str(problems), "1"], capture_output=True, text=True, check=True)
    found, asked = table(done.stdout)
    reasons = collections.Counter(re.sub(r"\S+ touches", "a link touches", re.sub(r"\S+ would touch .*?:", "a link would touch something:", line.split(" us: ", 1)[1]))
                                  for line in done.stderr.splitlines() if " us: " in line)
    if found:
        times = [us for us, _, _ in found.values()]
        print(f"process  {len(found)} of {asked} goals answered with a timed motion that keeps clearances: median {statistics.median(times):.0f} us, "
              f"99 % {slow(times):.0f} us")
    for reason, count in reasons.most_common(5):
        print(f"         {count} refused: {reason}")
    hits = touching_of(folder, data, problems, done.stdout)
    at_most("P8 motions of the process that hit (FCL, 1000/rad)", 0, hits, len(found))
    unfound = sum(count for reason, count in reasons.items() if "no way" in reason)
    at_most("P8 goals it would take but finds no way to, share", 0.01, unfound / max(1, len(found) + unfound), unfound)


def table(text):
    """{(set, number): (plan us, shorten us, cost)} of the solved ones, and how many were asked."""
    found, asked = {}, 0
    for line in text.splitlines():
        words = line.split()
        asked += 1
        if float(words[4]) > 0:
            found[words[0], int(words[1])] = tuple(float(w) for w in words[2:5])
    return found, asked


def medians(rounds):
    """Of each problem over the rounds."""
    return {key: tuple(statistics.median(r[key][k] for r in rounds) for k in range(3)) for key in rounds[0]}


def column(table, k):
    return [v[0] + v[1] if k == "total" else v[k] for v in table.values()]


def slow(values):
    """The 99th percentile."""
    return sorted(values)[len(values) * 99 // 100]


def at_most(quantity, asked, value, mine, peer="", theirs=""):
    good = value <= asked
    print(f"{quantity:46s} <= {asked:<8g} {value:8.3f}{'' if good else '   SHORT'}")
    rows.append((quantity, mine, peer, theirs, value))
    if not good:
        short_of.append(quantity)


def main():
    words, csv, rounds, ompl, reach, robot = sys.argv[1:], None, 5, False, 1.0, "panda"
    vamp = os.environ.get("TWINBUS_VAMP")
    data = pathlib.Path(os.environ.get("TWINBUS_DATA", ROOT.parent / "shared/data"))
    while words:
        word = words.pop(0)
        if word in ("--help", "-h"):
            print(__doc__)
            return 0
        if word == "--ompl":
            ompl = True
        elif word in ("--csv", "--range", "--robot", "--rounds", "--vamp") and words:
            value = words.pop(0)
            robot = value if word == "--robot" else robot
            csv = value if word == "--csv" else csv
            vamp = value if word == "--vamp" else vamp
            try:
                reach = float(value) if word == "--range" else reach
                rounds = int(value) if word == "--rounds" else rounds
            except ValueError:
                rounds = 0
            if rounds < 1 or not 0.0 <= reach < 1e9:
                print(f"bench planner: {word} takes a number{' of 1 or more' if word == '--rounds' else ''}, not '{value}'", file=sys.stderr)
                return 2
        else:
            print(f"bench planner: no option '{word}'; there are --csv --ompl --range --robot --rounds --vamp", file=sys.stderr)
            return 2
    problems = data / "problems" / robot / f"{robot}_problems.txt"
    if not problems.exists():
        print(f"bench planner: {problems} is not there; $TWINBUS_DATA names the folder of data", file=sys.stderr)
        return 1
    folder = programs.folder_of("planner_cases", "bench planner")
    peer = build_vamp(pathlib.Path(vamp) if vamp else None, folder, robot)
    with tempfile.TemporaryDirectory() as scratch:
        texts = measure("planner", scratch, data, problems, rounds, peer)
        robots = measure("planner_robots", scratch, data, problems) if robot == "panda" else {}
    ours, proved, theirs = ([table(text)[0] for text in texts.get(case, [])] for case in ("ours", "proved", "VAMP"))
    text_of_proved = texts["proved"][0]  # every round gives the same paths
    touching = touching_of(folder, data, problems, text_of_proved)
    peer_touching = touching_of(folder, data, problems, texts["VAMP"][0]) if peer else 0
    mine = medians(ours)
    certain = medians(proved)
    tables = [("ours", mine), ("proved", certain)] + ([("VAMP", medians(theirs))] if peer else [])
    print(f"{'':8s} {'solved':>7s} {'plan us':>16s} {'simplify us':>16s} {'total us':>16s} {'cost rad':>14s}   median / mean")
    for name, figures in tables:
        cells = []
        for k, digits in ((0, 1), (1, 1), ("total", 1), (2, 3)):
            values = column(figures, k)
            cells.append(f"{statistics.median(values):.{digits}f} / {statistics.mean(values):.{digits}f}")
        print(f"{name:8s} {len(figures):7d} {cells[0]:>16s} {cells[1]:>16s} {cells[2]:>16s} {cells[3]:>14s}")
    solved_by_peer = {key for r in theirs for key in r}
    valid = VALID[robot] - len(mine) if robot in VALID else len(solved_by_peer - set(mine))
    at_most("P1 problems not solved", 0, valid, len(mine))
    if peer:
        other = tables[2][1]
        for quantity, asked, k, how in (("P1 median plan / VAMP's", 0.6, 0, statistics.median),
                                        ("P1 median plan + simplify / VAMP's", 0.5, "total", statistics.median),
                                        ("P1 median cost / VAMP's", 1.0, 2, statistics.median),
                                        ("P1 mean cost / VAMP's", 1.0, 2, statistics.mean)):
            a, b = how(column(mine, k)), how(column(other, k))
            at_most(quantity, asked, a / b, a, "VAMP", b)
    unsolved = ALL[robot] - len(certain) if robot in ALL else len(solved_by_peer - set(certain))
    at_most("P2 problems not solved, exact meshes, proved", 0, unsolved, len(certain))
    at_most("P2 final paths that hit the meshes (FCL, 1000/rad)", 0, touching, touching, "VAMP" if peer else "",
            peer_touching if peer else "")
    if peer:
        print(f"{'':8s} VAMP's final paths that hit the meshes: {peer_touching} of {len(theirs[0])}")
        a, b = statistics.median(column(certain, "total")), statistics.median(column(other, "total"))
        at_most("P2 median total / VAMP's unproved total", 1.2, a / b, a, "VAMP", b)
        a, b = slow(column(certain, "total")), slow(column(other, "total"))
        at_most("P2 99 % total / VAMP's unproved total", 3, a / b, a, "VAMP", b)
    as_process(folder, data, problems)
    if ompl:
        built = subprocess.run(["cmake", "--build", str(folder.parent), "--target", "ompl_peer"], capture_output=True)
        if built.returncode == 0:
            for geometry, name, same, gate in (("balls", "ours", mine, True), ("meshes", "proved", certain, False)):
                found, asked = table(run(folder / "ompl_peer", geometry, data / "robots", problems, 2, rounds, reach))
                both = [key for key in found if key in same]
                step = f"steps of at most {reach:g} rad" if reach > 0 else "steps as OMPL chooses"
                print(f"OMPL     RRT-Connect and FCL on the {geometry}: {len(found)} of {asked} solved in 2 s; {rounds} rounds, {step}, "
                      "32 postures per radian; this peer is built with -O3, OMPL and FCL are the system's")
                for name_of, figures in (("OMPL", found), (name, {key: same[key] for key in both})):
                    print(f"{name_of:8s} plan {statistics.median(column(figures, 0)):.1f} us, total {statistics.median(column(figures, 'total')):.1f} us, "
                          f"cost {statistics.median(column(figures, 2)):.3f} rad")
                for quantity, k in (("plan", 0), ("total", "total")):
                    a = statistics.median(column({key: same[key] for key in both}, k))
                    b = statistics.median(column({key: found[key] for key in both}, k))
                    short = gate and not b >= 500 * a
                    rows.append((f"P3 OMPL's {quantity} / {name}, {geometry}", a, "OMPL+FCL", b, b / a))
                    print(f"P3 OMPL's median {quantity} / {name:30s} {'>= 500' if gate else '':9s}{b / a:8.0f}{'   SHORT' if short else ''}")
                    if short:
                        short_of.append("P3 " + quantity)
        else:
            print("OMPL is absent: apt install libompl-dev, and build again")
    for line in robots["humanoid"][0].splitlines() if robots else ():
        words = line.split()
        case = dict(zip(words[1::2], words[2::2]))
        print(line)
        at_most(f"P5 {words[0]} not solved", 0, int(case["asked"]) - int(case["solved"]), case["solved"])
        at_most(f"P5 {words[0]} median ms", 1, 1e-3 * float(case["median_us"]), case["median_us"])
        at_most(f"P5 {words[0]} 99th percentile ms", 20, 1e-3 * float(case["p99_us"]), case["p99_us"])
        at_most(f"P5 {words[0]} paths that differ", 0, 1 - int(case["same"]), case["hash"])
    if robots:
        line = robots["arm"][0]
        case = dict(zip(line.split()[1::2], line.split()[2::2]))
        print(line.strip())
        at_most("P7 ArmPlanner::plan, median ms", 100, 1e-3 * float(case["median_us"]), case["median_us"])
        at_most("P7 plans that differ", 0, 1 - int(case["same"]), case["hash"])
        line = run(folder / "planner_timing", data / "robots", given=text_of_proved)
        case = dict(zip(line.split()[0::2], line.split()[1::2]))
        print(line.strip())
        at_most("P6 timing, median us", 200, float(case["median_us"]), case["median_us"])
        at_most("P6 paths over a limit at 1 kHz", 0, int(case["over_limits"]), case["over_limits"])
        at_most("P6 (duration - time to full push) / jerkless optimum", 1.05, float(case["longer_median"]), case["longer_median"])
    if csv:
        with open(csv, "a") as file:
            for quantity, value, name, theirs_value, ratio in rows:
                file.write(f"planner,{robot},{quantity},,{value},,,,{name},{theirs_value},{ratio}\n")
    return 1 if short_of else 0


if __name__ == "__main__":
    sys.exit(main())
