"""Workers on many machines: Dask's scheduler and workers, or a Slurm array.

Dask: batches of tasks are futures; a worker that dies gets its batch run again by another, one that joins late is given work, and when
the scheduler itself goes away, what is left is given to the one that comes back at the same address.
Slurm: OUT/slurm has the tasks and the script of the array; each array task appends to a file of its own in OUT/done.
"""

import asyncio
import json
import pathlib
import queue
import shlex
import shutil
import subprocess
import sys
import time

from errors import CampaignError

WORKER = pathlib.Path(__file__).with_name("run_task.py")
BATCH_SECONDS = 0.5
MOST_BATCH = 50
WAIT = 60.0         # [s] for a scheduler that went away
POLL = 2.0          # [s] between two looks at the results of an array
LOOK = 10           # [s] without a result after which the scheduler is asked what it knows
SILENT = 600.0      # [s] without an answer of squeue
ARRAY = 1000        # array tasks at most; clusters commonly allow 1001


def import_dask():
    try:
        import dask
        import distributed
    except ImportError:
        raise CampaignError("--dask needs Dask; run: apt-get install python3-distributed "
                            "(or python3 -m pip install distributed), or leave it out: --workers N") from None
    return dask, distributed


def batch_on_worker(tasks):
    """On a worker, which has run_task.py by Dask's own upload."""
    import run_task
    return run_task.run_batch(tasks)


def batches(tasks, seconds):
    """So many tasks at once that a batch takes about half a second."""
    size = max(1, min(MOST_BATCH, int(BATCH_SECONDS / max(seconds, 1e-3)), len(tasks) // 8 or 1))
    return [tasks[i:i + size] for i in range(0, len(tasks), size)]


def connect(address, dask, distributed):
    """A client of `local:N`, which starts its own processes, or of a scheduler that is there.  Throws CampaignError."""
    # A worker may be killed often before its batch counts as lost: deaths say nothing of the task.
    dask.config.set({"distributed.scheduler.allowed-failures": 100, "distributed.worker.daemon": False})
    if address.startswith("local:"):
        count = address.partition(":")[2]
        if not count.isdigit() or not 1 <= int(count) <= 1024:
            raise CampaignError(f"--dask {address}: wants local:N with N within 1 .. 1024, or tcp://HOST:8786")
        cluster = distributed.LocalCluster(n_workers=int(count), threads_per_worker=1, dashboard_address=None, silence_logs=50)
        return distributed.Client(cluster), cluster
    try:
        client = distributed.Client(address, timeout=10)
    except (OSError, ValueError) as error:
        raise CampaignError(f"--dask {address}: no scheduler answers ({str(error).splitlines()[0][:200]}); start one with dask-scheduler, and "
                            f"workers with dask-worker {address}") from None
    return client, None


def run_dask(tasks, add, address):
    """Runs tasks on the workers of a scheduler; add(result) is called for each."""
    import logging
    dask, distributed = import_dask()
    for name in ("distributed", "asyncio", "tornado"):  # pages about sockets that closed
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    left = {task["id"]: task for task in tasks}
    lost_at = None
    while left:
        try:
            client, cluster = connect(address, dask, distributed)
        except CampaignError:
            if lost_at is None or time.monotonic() - lost_at > WAIT:
                raise
            time.sleep(1.0)
            continue
        before = len(left)
        try:
            one_connection(client, distributed, left, add)
            return
        except (OSError, distributed.CancelledError, distributed.scheduler.KilledWorker, asyncio.TimeoutError, RuntimeError) as error:
            if lost_at is None or len(left) < before:
                lost_at = time.monotonic()
            if time.monotonic() - lost_at > WAIT:
                raise CampaignError(f"the Dask scheduler at {address} went away ({type(error).__name__}) with {len(left)} tasks left; start it "
                                    "again and give the same command: it goes on where this one stopped") from None
            print(f"campaign: the scheduler at {address} went away; waits {WAIT:g} s for it", file=sys.stderr)
        finally:
            try:
                client.close(timeout=2)
                if cluster is not None:
                    cluster.close(timeout=5)
            except Exception:  # of a scheduler that is dead: nothing is left to close
                pass


def one_connection(client, distributed, left, add):
    # Also to workers that join later.  By value, so that a worker needs no checkout.
    client.register_worker_plugin(distributed.diagnostics.plugin.UploadFile(str(WORKER)), "run_task")
    import cloudpickle
    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    waiting = list(left.values())
    # The first batch says how long a task takes.
    first = waiting[:max(1, min(8, len(waiting) // 8))]
    rest = waiting[len(first):]
    mean = None
    came, open_futures = queue.SimpleQueue(), {}

    def submit(batch):
        future = client.submit(batch_on_worker, batch, pure=False, retries=5)
        open_futures[future.key] = future
        future.add_done_callback(came.put)
    for task in first:
        submit([task])
    quiet = 0
    while open_futures:
        try:
            future = came.get(timeout=1.0)
        except queue.Empty:
            quiet += 1
            # as_completed() waits for ever for futures that a scheduler took with it.
            if client.status != "running" or (quiet % LOOK == 0 and not knows_any(client, list(open_futures))):
                raise OSError("the scheduler has gone") from None
            continue
        quiet = 0
        open_futures.pop(future.key, None)
        for result in future.result(timeout=30):  # throws what the batch threw, or that it was cancelled
            if left.pop(result["id"], None) is not None:
                add(result)
                mean = result["where"]["task_s"] if mean is None else 0.9 * mean + 0.1 * result["where"]["task_s"]
        if rest and mean is not None:
            # All of them: what the scheduler has, late workers find.
            for batch in batches(rest, mean):
                submit(batch)
            rest = []
    if left:
        raise RuntimeError("batches were lost")


def knows_any(client, keys):
    """Whether the scheduler has any of our batches: one that began anew has none."""
    def look(keys, dask_scheduler=None):
        return any(key in dask_scheduler.tasks for key in keys)
    return client.run_on_scheduler(look, keys=keys)


def write_array(store, tasks, jobs):
    """OUT/slurm/tasks.jsonl and OUT/slurm/array.sh: the script's path."""
    folder = (store.out / "slurm").resolve()
    folder.mkdir(exist_ok=True)
    (folder / "log").mkdir(exist_ok=True)
    with open(folder / "tasks.jsonl", "w", encoding="utf-8") as file:
        for task in tasks:
            file.write(json.dumps(task) + "\n")
    count = max(1, min(jobs, ARRAY, len(tasks)))
    limit = max(task["limit"] for task in tasks) * (len(tasks) / count + 1)
    done = (store.out / "done").resolve()
    script = folder / "array.sh"
    script.write_text(f"""#!/bin/bash
# {len(tasks)} tasks in {count} array tasks; every one needs this folder, the program and python3.
#SBATCH --job-name=twinbus-campaign
#SBATCH --array=0-{count - 1}
#SBATCH --cpus-per-task=1
#SBATCH --time={max(1, int(min(limit, 86400 * 7) / 60) + 1)}
#SBATCH --requeue
#SBATCH --output={folder}/log/%a.log
exec python3 {shlex.quote(str(WORKER))} --part {shlex.quote(str(folder / 'tasks.jsonl'))} "$SLURM_ARRAY_TASK_ID" {count} \\
  {shlex.quote(str(done))}/slurm-"$SLURM_ARRAY_TASK_ID".jsonl
""", encoding="utf-8")
    script.chmod(0o755)
    return script, count


def run_slurm(store, tasks, add, jobs):
    """Writes the array, submits it, and follows its results until the array has ended.  Throws CampaignError."""
    script, count = write_array(store, tasks, jobs)
    if not shutil.which("sbatch"):
        raise CampaignError(f"this machine has no sbatch; {script} is written: submit it where there is one (sbatch {script}), and give this "
                            "command again to gather the results")
    done = subprocess.run(["sbatch", "--parsable", str(script)], capture_output=True, text=True)
    if done.returncode != 0:
        raise CampaignError(f"sbatch refused {script}: {(done.stderr.strip().splitlines() or ['no sentence'])[-1]}")
    job = done.stdout.strip().split(";")[0]
    store.written_elsewhere = True
    print(f"job {job}: {len(tasks)} tasks in {count} array tasks", file=sys.stderr)
    follow(store, {task["id"] for task in tasks}, add, job)


def follow(store, wanted, add, job):
    read, silent = {}, [None]
    while wanted:
        for file in sorted((store.out / "done").glob("slurm-*.jsonl")):
            with open(file, "rb") as lines:
                lines.seek(read.get(file, 0))
                data = lines.read()
            whole = data.rfind(b"\n") + 1
            read[file] = read.get(file, 0) + whole
            for line in data[:whole].splitlines():
                try:
                    result = json.loads(line)
                except ValueError:
                    continue
                if result["id"] in wanted:
                    wanted.discard(result["id"])
                    add(result)
        if not wanted:
            return
        if ended(job, silent):
            if read.get("last"):
                raise CampaignError(f"job {job} has ended and {len(wanted)} tasks have no result; its sentences are in {store.out}/slurm/log; "
                                    "give the same command again for what is left")
            read["last"] = 1  # one more look: the end may be newer than the files that were read
        time.sleep(POLL)


def ended(job, silent):
    """Whether Slurm knows nothing more of a job.  silent: [since when squeue does not answer, or None].  Throws CampaignError."""
    said = subprocess.run(["squeue", "-h", "-j", job, "-o", "%T"], capture_output=True, text=True)
    if said.returncode == 0 or "Invalid job id" in said.stderr:
        silent[0] = None
        return not said.stdout.strip()
    # A controller that restarts answers nothing for a while; the array goes on.
    silent[0] = silent[0] or time.monotonic()
    if time.monotonic() - silent[0] > SILENT:
        raise CampaignError(f"squeue has not answered for {SILENT / 60:g} min ({(said.stderr.strip().splitlines() or ['no sentence'])[-1][:200]}); "
                            f"job {job} may go on: give the same command again when it answers")
    return False
