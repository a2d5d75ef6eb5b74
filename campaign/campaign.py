#!/usr/bin/env python3
"""./twinbus campaign: thousands of seeded runs, on this machine or on many."""

import os
import pathlib
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from command import NAME, Parser  # noqa: E402

USAGE = """usage: ./twinbus campaign FILE.yaml [OPTION...]     run what is not done yet, write tables and report
       ./twinbus campaign report OUT [--serve]       the report again; --serve opens failing runs in the viewer
       ./twinbus campaign view OUT ID                one run in the viewer (recorded now if there is no log of it)
       ./twinbus campaign search FILE.yaml           where failures begin: bisection, CMA-ES, importance sampling
       ./twinbus campaign minimize OUT [ID]          the smallest scene that fails as a run did
       ./twinbus campaign compare OUT OUT...         the same runs on different machines: which differ, by what
       ./twinbus campaign plan --task S --runs N     what N runs of S seconds cost on 2 to 1,000 cores
       ./twinbus campaign gate FILE.yaml             passes or fails a version by as few runs as its risks allow

  --out FOLDER       tables, logs and what is done; default: campaigns/NAME beside the file
  --workers N        processes on this machine; default: its processors
  --dask ADDRESS     on the workers of a Dask scheduler (tcp://HOST:8786), or local:N, which starts N
  --slurm            writes a Slurm array, submits it and gathers its results; --jobs N: so many array tasks
  --limit S          time limit of a task; default: limit: of the file, 600
Exit status: 0 all passed, 1 some did not or none ran, 2 wrong arguments.  doc/campaign.md shows the file.""".replace("./twinbus campaign", NAME)


def arguments(words):
    parser = Parser(add_help=False)
    parser.add_argument("file")
    parser.add_argument("--out")
    parser.add_argument("--workers", type=int)
    parser.add_argument("--limit", type=float)
    parser.add_argument("--dask")
    parser.add_argument("--slurm", action="store_true")
    parser.add_argument("--jobs", type=int, default=64)
    return parser.parse_args(words)


def check_first(maker, campaign, tasks):
    """One short run of each scene with the settings of its first and last task: what the program refuses is said with the
    line of the file, before thousands are refused."""
    import run_task
    from errors import CampaignError
    if campaign.program:
        return
    runner = run_task.Runner()
    try:
        groups = {}
        for task in tasks:
            ends = groups.setdefault((task["scene"], task["robot"], task["controller"]), [task, task])
            ends[1] = task
        for first, last in groups.values():
            for task in ([first] if first is last else [first, last]):
                status, failures, _ = runner.start(dict(task, limit=60.0), runner.words(dict(task, **{"for": 0.01}), runner.folder / "r.json"),
                                                   runner.folder / "r.json")
                if status != "refused":
                    continue
                for key, value in campaign.lines.items():
                    if key in failures[0] or key.rpartition(".")[2] in failures[0] and key.startswith("scene."):
                        raise value.error(failures[0])
                raise CampaignError(f"{campaign.file}: scene {task['scene']}, robot {task['robot']}: {failures[0]}")
    finally:
        runner.close()


def run_all(store, tasks, engine):
    """Runs what has no result."""
    from progress import Progress
    left = store.ask(tasks)
    progress = Progress(len(tasks), len(tasks) - len(left))

    def add(result):
        if store.add(result):
            progress.add(result)
    try:
        if left:
            engine(left, add)
    finally:
        progress.end()


def adaptive_rounds(store, campaign, maker, engine):
    import sampling
    per_round = max(1, campaign.draws // campaign.rounds)
    for number in range(1, campaign.rounds):
        known = {}
        for task, result in store.done():
            point = tuple((key, task["varied"][key]) for key in campaign.drawn)
            known.setdefault(point, []).append(result["status"] != "passed")
        points = sampling.next_points(campaign.drawn, [(dict(p), sum(v) / len(v)) for p, v in sorted(known.items())], per_round,
                                      campaign.draw_seed + number)
        from spec import unique
        run_all(store, unique(maker.product(points)), engine)


def run_command(words):
    import cluster
    import local
    import report
    import spec
    from store import Store
    given = arguments(words)
    campaign = spec.read(given.file)
    if given.limit is not None:
        campaign.limit = given.limit
    maker = spec.TaskMaker(campaign)
    tasks = maker.first()
    check_first(maker, campaign, tasks)
    out = pathlib.Path(given.out) if given.out else pathlib.Path(given.file).resolve().parent / "campaigns" / pathlib.Path(given.file).stem
    store = Store(out)
    began, before = time.monotonic(), len(store.results)

    def engine(left, add):
        if given.dask:
            return cluster.run_dask(left, add, given.dask)
        if given.slurm:
            return cluster.run_slurm(store, left, add, given.jobs)
        count = given.workers if given.workers is not None else os.cpu_count() or 1
        return local.run(left, add, max(1, count), str(store.out / "logs"), campaign.logs)
    try:
        run_all(store, tasks, engine)
        if campaign.how == "adaptive" and campaign.drawn:
            adaptive_rounds(store, campaign, maker, engine)
    finally:
        parquet = store.write_tables()
        report.write(store.out, store.done(), campaign)
        store.close()
    return say_end(store, parquet, time.monotonic() - began, len(store.results) - before)


def say_end(store, parquet, seconds, ran):
    from report import counts
    pairs = store.done()
    total = counts(result for _, result in pairs)
    print(f"{len(pairs)} of {len(store.tasks)} tasks have a result, {ran} of them new in {seconds:.1f} s: "
          + ", ".join(f"{number} {name}" for name, number in total.items() if number))
    for name, sentence in list(store.unrun.items())[:1]:
        print(f"{len(store.unrun)} tasks were not run ({name}: {sentence})")
    if not parquet:
        print("no results.parquet: pyarrow is not installed; run: python3 -m pip install pyarrow")
    print(f"{store.out / 'results.csv'}\n{store.out / 'report.html'}   (replays open by: {NAME} report {store.out} --serve)")
    return 0 if len(pairs) == len(store.tasks) and total["passed"] == len(pairs) else 1


def commands():
    import report
    found = {"report": report.report_command, "view": report.view_command}
    for name, module, function in (("compare", "compare", "compare_command"), ("search", "search", "search_command"),
                                   ("minimize", "minimize", "minimize_command"), ("gate", "gate", "gate_command"),
                                   ("plan", "plan", "plan_command")):
        if pathlib.Path(__file__).with_name(f"{module}.py").exists():
            found[name] = lambda words, m=module, f=function: getattr(__import__(m), f)(words)
    return found


def main(words):
    if not words or words[0] in ("--help", "-h"):
        print(USAGE)
        return 0 if words else 2
    try:
        import yaml  # noqa: F401
    except ImportError:
        print("campaign: needs python3-yaml; run: apt-get install python3-yaml", file=sys.stderr)
        return 1
    from errors import CampaignError
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        command = commands().get(words[0])
        return command(words[1:]) if command else run_command(words)
    except CampaignError as error:
        print(f"campaign: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("campaign: interrupted; the same command goes on where this one stopped", file=sys.stderr)
        return 130


def main_that_may_be_left(words):
    """For `campaign ... | head`: who reads no further has what he wanted."""
    try:
        try:
            return main(words)
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter flushes once more
        return 141


if __name__ == "__main__":
    sys.exit(main_that_may_be_left(sys.argv[1:]))
