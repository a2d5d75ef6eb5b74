"""The folder of a campaign: what is done, and the tables.

    OUT/tasks.jsonl      every task that was asked for
    OUT/done/*.jsonl     results, appended by whoever ran them; a line is whole or it is not there
    OUT/logs/ID.log      of failures
    OUT/results.csv, results.parquet, runs.csv, report.html
"""

import csv
import fcntl
import json
import os
import pathlib

from errors import CampaignError
from run_task import FIGURES, whole_lines

WHERE = ("host", "processor", "architecture", "path", "libc", "kernel", "started", "run_s", "task_s", "pid", "attempt")
# How a column of results.parquet is typed; settings are numbers where all their values are.
TEXTS = {"id", "scene", "robot", "controller", "status", "failures", "state_hash"}
WHOLE = {"seed", "ticks", "self_collision_ticks", "steps"}
TRUTHS = {"fell"}


class Store:
    """One driver at a time: a second one is refused.  Throws CampaignError."""

    def __init__(self, out):
        self.out = pathlib.Path(out)
        try:
            (self.out / "done").mkdir(parents=True, exist_ok=True)
            self.lock = open(self.out / "lock", "w", encoding="utf-8")
        except OSError as error:
            raise CampaignError(f"{self.out}: {error.strerror}; name a folder that can be written: --out FOLDER") from None
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise CampaignError(f"{self.out}: another campaign writes there; wait for it, end it, or name another --out") from None
        self.results, self.tasks, self.unrun = {}, {}, {}
        self.written_elsewhere = False  # who runs a task appends its result himself
        self.read_done()
        self.file = open(self.out / "done" / "here.jsonl", "a", encoding="utf-8")

    def close(self):
        self.file.close()
        self.lock.close()

    def read_done(self):
        """Takes in what others have appended since."""
        for file in sorted((self.out / "done").glob("*.jsonl")):
            for result in whole_lines(file):
                if not result.get("again"):
                    self.results.setdefault(result["id"], result)

    def ask(self, tasks):
        """Remembers tasks; those without a result."""
        new = [task for task in tasks if task["id"] not in self.tasks]
        self.tasks.update({task["id"]: task for task in new})
        return [task for task in tasks if task["id"] not in self.results]

    def add(self, result):
        """A result has come; False when it was known (a worker died after it had sent it)."""
        if result["id"] in self.results:
            return False
        if result.get("again"):
            self.unrun[result["id"]] = result["failures"][0]
            return True
        self.unrun.pop(result["id"], None)
        if not self.written_elsewhere:
            self.file.write(json.dumps(result) + "\n")
            self.file.flush()
        self.results[result["id"]] = result
        return True

    def done(self):
        """[(task, result)] of what was asked for, sorted by what they are."""
        pairs = [(task, self.results[name]) for name, task in self.tasks.items() if name in self.results]
        return sorted(pairs, key=lambda pair: sort_key(pair[0]))

    def write_tables(self):
        """results.csv, runs.csv, tasks.jsonl and, where pyarrow is there, results.parquet.  False without pyarrow."""
        pairs = self.done()
        settings = sorted({key for task in self.tasks.values() for key in task["varied"]})
        figures, times = figures_of(pairs)
        names = ["id", "scene", "robot", "controller", *settings, "seed", "for_s", "status", "failures", *figures]
        rows = [results_row(task, result, settings, figures) for task, result in pairs]
        self.write_csv("results.csv", names, rows)
        self.write_csv("runs.csv", ["id", "program", *WHERE, *times],
                       [[task["id"], task["program_hash"], *(result["where"].get(key, "") for key in WHERE),
                         *(result["where"].get("times", {}).get(key, "") for key in times)] for task, result in pairs])
        with replacing(self.out / "tasks.jsonl") as file:
            for task in sorted(self.tasks.values(), key=sort_key):
                file.write(json.dumps(task) + "\n")
        return write_parquet(self.out / "results.parquet", names, rows)

    def write_csv(self, name, names, rows):
        with replacing(self.out / name) as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(names)
            writer.writerows([cell(value) for value in row] for row in rows)


class replacing:
    """A file that is there whole or as it was before."""

    def __init__(self, path):
        self.path, self.part = path, path.with_name(path.name + ".part")

    def __enter__(self):
        self.file = open(self.part, "w", encoding="utf-8", newline="")
        return self.file

    def __exit__(self, kind, *_):
        self.file.close()
        if kind is None:
            os.replace(self.part, self.path)


def number_or_text(text):
    try:
        return (0, float(text), "")
    except ValueError:
        return (1, 0.0, text)


def sort_key(task):
    return (task["scene"], task["robot"], task["controller"],
            [(key, number_or_text(task["varied"][key])) for key in sorted(task["varied"])], task["seed"], task["id"])


def figures_of(pairs):
    """The columns of results.csv, and those of runs.csv that are times: what programs of their own print has names of its own."""
    if not any("arguments" in task for task, _ in pairs):
        return FIGURES, ()
    return (sorted({key for _, result in pairs for key in result["figures"]}),
            sorted({key for _, result in pairs for key in result["where"].get("times", {})}))


def results_row(task, result, settings, figures_there=FIGURES):
    figures = result["figures"]
    return [task["id"], task["scene"], task["robot"], task["controller"], *(task["varied"].get(key) for key in settings), task["seed"],
            task["for"], result["status"], "; ".join(result["failures"]), *(figures.get(key) for key in figures_there)]


def cell(value):
    return "" if value is None else str(value).lower() if isinstance(value, bool) else value


def write_parquet(path, names, rows):
    """The same table, typed: the type of a column that is no setting does not depend on what is in it."""
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError:
        return False
    columns = {}
    for i, name in enumerate(names):
        values = [row[i] for row in rows]
        if name in TEXTS or name not in ("for_s", *WHOLE, *TRUTHS, *FIGURES) and not all(is_number(value) for value in values):
            columns[name] = pyarrow.array([None if value is None else str(value) for value in values], pyarrow.string())
        elif name in TRUTHS:
            columns[name] = pyarrow.array([None if value is None else bool(value) for value in values], pyarrow.bool_())
        elif name in WHOLE:
            columns[name] = pyarrow.array([None if value is None else int(value) for value in values], pyarrow.int64())
        else:
            columns[name] = pyarrow.array([None if value is None else float(value) for value in values], pyarrow.float64())
    part = path.with_name(path.name + ".part")
    parquet.write_table(pyarrow.table(columns), part)
    os.replace(part, path)
    return True


def is_number(value):
    return value is None or number_or_text(value)[0] == 0
