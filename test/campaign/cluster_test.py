#!/usr/bin/env python3
"""The same campaign on 1 process, 2 workers, Dask with a worker that is killed and one that joins late, Dask whose scheduler is killed,
and a Slurm array: the sorted tables are equal byte for byte, no task is lost and none is there twice.

    cluster_test.py [--tasks N] [--kills S] [--only-dask]    N tasks (200); with --kills a worker or the scheduler dies every S seconds or so

Without Dask (python3-distributed) that part is said and left out.  Slurm is one node that the test starts (slurm_node.py); without its
programs a stand-in for sbatch runs the array.
"""

import argparse
import collections
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import pathlib

import campaign_rig
import slurm_node

ROOT = campaign_rig.ROOT
SBATCH = """#!/bin/bash
# Stands in for sbatch --parsable SCRIPT: the array tasks one after the other, in the background.
script=$2; last=$(sed -n 's/^#SBATCH --array=0-//p' "$script")
(for i in $(seq 0 $last); do SLURM_ARRAY_TASK_ID=$i "$script"; done; rm -f "$0.runs") >/dev/null 2>&1 &
touch "$0.runs"; echo 17
"""
SQUEUE = '#!/bin/sh\n[ -e "$(dirname "$0")/sbatch.runs" ] && echo RUNNING\nexit 0\n'


def python_with_dask():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import distributed"], capture_output=True).returncode == 0:
            return python
    return None


class Cluster:
    """A scheduler and workers that are ordinary processes."""

    def __init__(self, python, folder, environment):
        self.python, self.folder, self.environment = python, folder, environment
        self.port = random.randint(20000, 40000)
        self.address = f"tcp://127.0.0.1:{self.port}"
        self.scheduler, self.workers = self.start_scheduler(), []

    def start(self, module, *words):
        return subprocess.Popen([self.python, "-m", f"distributed.cli.{module}", *words], cwd=self.folder, env=self.environment,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)

    def start_scheduler(self):
        return self.start("dask_scheduler", "--host", "127.0.0.1", "--port", str(self.port), "--no-dashboard")

    def add_worker(self):
        self.workers.append(self.start("dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard", "--death-timeout", "120"))

    def kill(self, process):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()

    def kill_worker(self):
        self.kill(self.workers.pop(random.randrange(len(self.workers))))

    def kill_scheduler(self):
        """All of it goes away; a new one begins at the same address."""
        self.kill(self.scheduler)
        for worker in self.workers:
            self.kill(worker)
        count, self.workers = len(self.workers), []
        self.scheduler = self.start_scheduler()
        for _ in range(count):
            self.add_worker()

    def end(self):
        for process in [*self.workers, self.scheduler]:
            self.kill(process)


def ids_of(out):
    found = collections.Counter()
    for file in (out / "done").glob("*.jsonl"):
        for line in file.read_text().splitlines():
            found[json.loads(line)["id"]] += 1
    return found


class Drill:
    def __init__(self, tasks, kills):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="twinbus-cluster-"))
        shutil.copy(pathlib.Path(__file__).with_name("fake_twinbus.sh"), self.folder / "twinbus")
        self.environment = dict(os.environ, TWINBUS_PROGRAM=str(self.folder / "twinbus"), TWINBUS_CONFIG=str(ROOT / "config"))
        self.tasks, self.kills = tasks, kills
        (self.folder / "c.yaml").write_text(f"scenes: stand\nseeds: 1..{tasks // 2}\nlogs: 0\nsettings: {{bad: [7, 11]}}\n")
        self.bad = 0

    def campaign(self, out, *words, python=sys.executable, environment=None):
        with open(self.folder / "said", "w", encoding="utf-8") as said:  # a pipe that nobody reads would hold it when it is full
            return subprocess.Popen([python, str(campaign_rig.PROGRAM), "c.yaml", "--out", out, *words], cwd=self.folder,
                                    env=environment or self.environment, stdout=said, stderr=said)

    def end(self, process, out, what, began):
        process.wait()
        said = (self.folder / "said").read_text(encoding="utf-8")
        table, first = self.folder / out / "results.csv", self.folder / "one/results.csv"
        counts = ids_of(self.folder / out)
        rows = len(table.read_text().splitlines()) - 1 if table.exists() else 0
        equal = table.exists() and table.read_bytes() == first.read_bytes()
        twice = sum(count > 1 for count in counts.values())
        good = equal and rows == self.tasks and len(counts) == self.tasks and twice == 0
        self.bad += not good
        print(f"{'ok' if good else 'FAILED'} {what}: {rows} of {self.tasks} rows, {self.tasks - len(counts)} lost, {twice} double, table "
              f"{'equal' if equal else 'DIFFERS'}, {time.monotonic() - began:.0f} s" + ("" if good else f"\n{said[-2000:]}"), flush=True)

    def local(self):
        for out, workers in (("one", 1), ("two", 2))[:1 if self.kills else 2]:
            began = time.monotonic()
            self.end(self.campaign(out, "--workers", str(workers)), out, f"{workers} worker processes", began)

    def wait_for(self, out, count, process):
        while process.poll() is None:
            done = self.folder / out / "done/here.jsonl"
            if done.exists() and len(done.read_bytes().splitlines()) >= count:
                return
            time.sleep(0.02)

    def dask(self, python):
        cluster = Cluster(python, self.folder, self.environment)
        try:
            cluster.add_worker()
            cluster.add_worker()
            began = time.monotonic()
            if not self.kills:
                process = self.campaign("dask", "--dask", cluster.address, python=python)
                self.wait_for("dask", 1, process)
                cluster.kill_worker()
                cluster.add_worker()
                self.end(process, "dask", "2 Dask workers, one killed, one joined late", began)
            began = time.monotonic()
            process = self.campaign("scheduler", "--dask", cluster.address, python=python)
            if self.kills:
                self.kill_at_random(cluster, process)
            else:
                self.wait_for("scheduler", 1, process)
                cluster.kill_scheduler()
            self.end(process, "scheduler", f"Dask scheduler {'and workers killed at random' if self.kills else 'killed'}", began)
        finally:
            cluster.end()

    def kill_at_random(self, cluster, process):
        chance, kills = random.Random(1), collections.Counter()
        while process.poll() is None:
            time.sleep(self.kills * (0.5 + chance.random()))
            if process.poll() is not None:
                break
            if chance.random() < 0.2:
                kills["scheduler"] += 1
                cluster.kill_scheduler()
            else:
                kills["worker"] += 1
                cluster.kill_worker()
                cluster.add_worker()
        print("killed: " + ", ".join(f"{count} times a {name}" for name, count in kills.items()), flush=True)

    def slurm(self):
        """A Slurm of our own, one node, where its programs are; TWINBUS_SLURM=node: or it fails; =cluster: that of this machine."""
        wanted, missing = os.environ.get("TWINBUS_SLURM", ""), slurm_node.missing()
        began = time.monotonic()
        if wanted == "cluster":
            self.end(self.campaign("slurm", "--slurm", "--jobs", "3"), "slurm", "Slurm of this machine", began)
            return
        node, why = None, f"no {missing[0]}: apt-get install slurmctld slurmd slurm-client munge" if missing else ""
        try:
            if not missing:
                node = slurm_node.Node(self.folder / "node")
        except OSError as error:
            why = str(error)
        if node is None:
            print(f"{'FAILED' if wanted == 'node' else 'no'} Slurm of one node: {why}", flush=True)
            self.bad += wanted == "node"
            self.slurm_stand_in()
            return
        try:
            began = time.monotonic()
            process = self.campaign("slurm", "--slurm", "--jobs", "3", environment=node.environment(self.environment))
            again = None
            while process.poll() is None and again is None:
                time.sleep(0.05)
                if any((self.folder / "slurm/done").glob("slurm-*.jsonl")):
                    again = node.requeue_one()
            if again:
                node.restart_controller(3.0)
            self.end(process, "slurm", f"Slurm of one node, 3 array tasks, {f'{again} requeued, the controller restarted' if again else 'none requeued'}", began)
        finally:
            node.end()

    def slurm_stand_in(self):
        environment, fakes, began = dict(self.environment), self.folder / "fakes", time.monotonic()
        fakes.mkdir()
        for name, text in (("sbatch", SBATCH), ("squeue", SQUEUE)):
            (fakes / name).write_text(text)
            (fakes / name).chmod(0o755)
        environment["PATH"] = f"{fakes}:{environment['PATH']}"
        self.end(self.campaign("slurm", "--slurm", "--jobs", "3", environment=environment), "slurm",
                 "Slurm array by a stand-in for sbatch", began)

    def embedded_kills(self):
        """Workers and the campaign itself are killed; the same command goes on."""
        chance, began, starts = random.Random(2), time.monotonic(), 0
        while True:
            starts += 1
            process = self.campaign("killed", "--workers", "2")
            over = threading.Event()

            def killer():
                while not over.wait(self.kills * (0.5 + chance.random())):
                    workers = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split()
                    victim = process.pid if chance.random() < 0.2 or not workers else int(chance.choice(workers))
                    try:
                        os.kill(victim, signal.SIGKILL)
                    except ProcessLookupError:
                        pass
            thread = threading.Thread(target=killer)
            thread.start()
            while process.poll() is None:
                time.sleep(0.05)
            over.set()
            thread.join()
            if process.returncode != -signal.SIGKILL:
                break
        self.end(process, "killed", f"2 worker processes, they and the campaign killed at random, started {starts} times", began)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tasks", type=int, default=200)
    parser.add_argument("--kills", type=float, default=0.0)
    parser.add_argument("--only-dask", action="store_true")
    given = parser.parse_args()
    drill = Drill(given.tasks, given.kills)
    try:
        drill.local()
        if given.kills and not given.only_dask:
            drill.embedded_kills()
        elif not given.only_dask:
            drill.slurm()
        python = python_with_dask()
        if python is None:
            print("no Dask: left out; run: apt-get install python3-distributed")
        else:
            drill.dask(python)
    finally:
        shutil.rmtree(drill.folder, ignore_errors=True)
    return 1 if drill.bad else 0


if __name__ == "__main__":
    sys.exit(main())
