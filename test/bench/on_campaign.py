"""Benches that are campaigns: what runs, with which seeds and settings, stands in a file of test/bench/campaigns; ./twinbus campaign runs it."""

import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys

import programs

ROOT = pathlib.Path(__file__).resolve().parents[2]


def yaml_or_exit():
    """PyYAML, imported by what runs: --help of a bench answers where it is not installed."""
    try:
        import yaml
    except ImportError:
        sys.exit("bench: campaigns need python3-yaml; run: apt-get install python3-yaml")
    return yaml


def read(name):
    """The campaign NAME.yaml as a dict, for a bench that is given other seeds or rows."""
    return yaml_or_exit().safe_load((ROOT / "test/bench/campaigns" / f"{name}.yaml").read_text(encoding="utf-8"))


def environment(who):
    return dict(os.environ, TWINBUS_PROGRAM=str(programs.folder_of("twinbus", who) / "twinbus"))


def table(file):
    with open(file, newline="", encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def start(what, name, campaign, folder, who, *options):
    """The folder with what came out; ends with a sentence where nothing did."""
    file, out = pathlib.Path(folder) / f"{name}.yaml", pathlib.Path(folder) / name
    shutil.rmtree(out, ignore_errors=True)
    file.write_text(yaml_or_exit().safe_dump(campaign, sort_keys=False), encoding="utf-8")
    done = subprocess.run([sys.executable, ROOT / "campaign/campaign.py", *what, file, "--out", out, *options], env=environment(who),
                          stdout=subprocess.PIPE, text=True)
    if not (out / "results.csv").exists() or done.returncode not in (0, 1):
        sys.exit(f"{who}: its campaign ended early: {(done.stdout.splitlines() or ['see above'])[-1]}")
    return out


def run(name, campaign, folder, who, *options):
    """Rows of results.csv in the order of the file, each with its times of runs.csv."""
    out = start([], name, campaign, folder, who, *options)
    runs = {row["id"]: row for row in table(out / "runs.csv")}
    rows = [{**runs[row["id"]], **row} for row in table(out / "results.csv")]
    refused = [row for row in rows if row["status"] == "refused"]
    if refused or not rows:
        sys.exit(f"{who}: {refused[0]['failures'] if refused else 'nothing ran'}")
    return rows


def outputs(folder, name):
    """{id of a task: what it printed} of a campaign with output: true."""
    found = {}
    for file in sorted((pathlib.Path(folder) / name / "done").glob("*.jsonl")):
        for line in file.read_text(encoding="utf-8").splitlines():
            result = json.loads(line)
            found[result["id"]] = result.get("output", "")
    return found


def search(name, campaign, folder, who, *options):
    """Rows of search.csv."""
    out = start(["search"], name, campaign, folder, who, *options)
    if not (out / "search.csv").exists():
        sys.exit(f"{who}: its search found nothing")
    return table(out / "search.csv")
