"""Workers on this machine: ordinary processes that take batches of tasks on stdin.  No server.

A worker that dies gets its tasks run again by another; a task under which workers die again and again is a result too.
"""

import collections
import concurrent.futures
import json
import os
import pathlib
import queue
import selectors
import subprocess
import sys

import run_task

WORKER = pathlib.Path(__file__).with_name("run_task.py")
MOST_DEATHS = 5      # of workers at one task
BATCH_SECONDS = 0.25  # of work in a batch: what is sent at once
MOST_BATCH = 64


class Worker:
    def __init__(self, logs, most_logs):
        self.process = subprocess.Popen([sys.executable, str(WORKER)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True)
        self.tasks = collections.OrderedDict()
        self.rest, self.ready = b"", False
        self.write({"logs": logs, "most_logs": most_logs})

    def write(self, what):
        try:
            self.process.stdin.write(json.dumps(what).encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # its end is seen where results are read

    def give(self, tasks):
        self.tasks.update((task["id"], task) for task in tasks)
        self.write(tasks)

    def results(self):
        """What it has written; None when it has died."""
        data = os.read(self.process.stdout.fileno(), 1 << 20)
        if not data:
            return None
        *lines, self.rest = (self.rest + data).split(b"\n")
        found = [json.loads(line) for line in lines]
        self.ready = self.ready or bool(found)
        return [result for result in found if result]

    def end(self, kill=False):
        if kill:
            self.process.kill()
        try:
            self.process.stdin.close()
        except BrokenPipeError:
            pass
        self.process.wait()
        self.process.stdout.close()


def died(task):
    return {"id": task["id"], "status": "crashed", "figures": {}, "where": {"attempt": task["attempt"]},
            "failures": [f"{MOST_DEATHS} workers died at this task"]}


def run(tasks, add, count, logs=None, most_logs=0, pids=None):
    """Runs tasks on count processes; add(result) is called for each.  pids: list that follows the pids of the workers."""
    waiting = collections.deque(tasks)
    mean, known = 0.25, 0  # [s] of a task
    selector = selectors.DefaultSelector()
    workers = []

    def feed(worker):
        # So many that it need not wait, and so few that the last ones are shared.
        most = max(1, min(MOST_BATCH, int(BATCH_SECONDS / mean) if known else 1, len(waiting) // (2 * len(workers) or 1)))
        if waiting and len(worker.tasks) <= most // 2:
            worker.give([waiting.popleft() for _ in range(min(most, len(waiting)))])

    def start():
        worker = Worker(logs, most_logs)
        workers.append(worker)
        selector.register(worker.process.stdout, selectors.EVENT_READ, worker)
        if pids is not None:
            pids.append(worker.process.pid)
        feed(worker)

    try:
        for _ in range(min(count, len(waiting))):
            start()
        while waiting or any(worker.tasks for worker in workers):
            for key, _ in selector.select(1.0):
                worker = key.data
                results = worker.results()
                if results is None:
                    selector.unregister(worker.process.stdout)
                    workers.remove(worker)
                    worker.end()
                    if pids is not None:
                        pids.remove(worker.process.pid)
                    for number, task in enumerate(reversed(worker.tasks.values())):
                        again = dict(task, attempt=task.get("attempt", 1) + (worker.ready and number == len(worker.tasks) - 1))
                        if again["attempt"] > MOST_DEATHS:
                            add(died(again))
                        else:
                            waiting.appendleft(again)
                    start()
                    continue
                for result in results:
                    worker.tasks.pop(result["id"], None)
                    known = min(known + 1, 50)
                    mean += (max(1e-3, result["where"]["task_s"]) - mean) / known
                    add(result)
                feed(worker)
    except BaseException:
        for worker in workers:
            worker.end(kill=True)
        raise
    for worker in workers:
        worker.end()


class Threads:
    """For many small batches one after the other, as a search asks for: threads that start the program themselves."""

    def __init__(self, count):
        self.pool = concurrent.futures.ThreadPoolExecutor(count)
        self.runners = queue.SimpleQueue()
        self.all = [run_task.Runner() for _ in range(count)]
        for runner in self.all:
            self.runners.put(runner)

    def one(self, task):
        runner = self.runners.get()
        try:
            return runner.run(task)
        finally:
            self.runners.put(runner)

    def run(self, tasks, add):
        for result in self.pool.map(self.one, tasks):
            add(result)

    def close(self):
        self.pool.shutdown(cancel_futures=True)
        for runner in self.all:
            runner.close()
