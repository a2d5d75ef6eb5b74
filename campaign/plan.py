"""`campaign plan`: what a campaign costs on 2 to 1,000 cores, by simulation with the measured cost of giving out work.

    ./twinbus campaign plan --task 0.13 --runs 1000000 [--engine dask|workers|slurm]

One driver (and Dask's scheduler) gives out batches one after the other; a worker that asks waits its turn. Slurm divides the tasks before
anything runs: no driver, but the slowest array task ends last.
"""

import argparse
import heapq
import random

from command import Parser

# CPU of driver and scheduler for a task [s], measured with batches of 50 (doc/campaign.md), and seconds until the first task runs.
COST = {"workers": (0.00021, 0.5), "dask": (0.00094, 5.0), "slurm": (0.0, 30.0)}
BATCH_SECONDS, MOST_BATCH = 0.5, 50
SPREAD = 0.2  # of the time of a task, relative standard deviation
CORES = (2, 8, 32, 64, 128, 256, 512, 1000)


def simulate(cores, runs, task, engine, seed=1):
    """Seconds from start to end."""
    cost, start = COST[engine]
    chance = random.Random(seed)
    if engine == "slurm":
        share = [runs // cores + (i < runs % cores) for i in range(cores)]
        return start + max(n * task + SPREAD * task * n ** 0.5 * chance.gauss(0, 1) for n in share)
    size = max(1, min(MOST_BATCH, int(BATCH_SECONDS / task), runs // (2 * cores) or 1))
    free = [(start, i) for i in range(cores)]  # when each worker asks
    driver, left, end = start, runs, start
    while left > 0:
        asks, worker = heapq.heappop(free)
        batch = min(size, left)
        left -= batch
        driver = max(driver, asks) + batch * cost  # the one that gives out
        done = driver + max(0.1 * task, batch * task + SPREAD * task * batch ** 0.5 * chance.gauss(0, 1))
        end = max(end, done)
        heapq.heappush(free, (done, worker))
    return end


def plan_command(words):
    parser = Parser("plan", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--task", type=float, required=True, help="seconds of CPU of a task")
    parser.add_argument("--runs", type=int, default=1_000_000)
    parser.add_argument("--engine", choices=COST, default="dask")
    given = parser.parse_args(words)
    if not 1e-3 <= given.task <= 1e6 or not 1 <= given.runs <= 10_000_000:
        parser.error("--task within 0.001 .. 1e6, --runs within 1 .. 10000000")
    cost = COST[given.engine][0]
    print(f"{given.runs} runs of {given.task:g} s, {given.engine}; one core: {given.runs * given.task / 3600:.1f} h")
    print(f"{'cores':>6} {'hours':>9} {'core hours':>11} {'efficiency':>11}")
    for cores in CORES:
        seconds = simulate(cores, given.runs, given.task, given.engine)
        print(f"{cores:6} {seconds / 3600:9.2f} {cores * seconds / 3600:11.0f} {100 * given.runs * given.task / (cores * seconds):9.0f} %")
    if cost:
        print(f"it bends at {given.task / cost:.0f} cores: there the driver gives out {1 / cost:.0f} tasks a second, and no more")
    return 0
