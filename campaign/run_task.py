#!/usr/bin/env python3
"""Runs tasks of a campaign: the part that a worker needs, with nothing but the standard library and the program `twinbus`.

A task is a dict (spec.py makes them), a result another one; both are JSON.  What a result says of the run never depends on
where or when it ran; what does is under its key `where`.

    run_task.py                           reads batches of tasks from stdin, a JSON list a line; answers a result a line
    run_task.py --part TASKS K N DONE     every N-th task of a file from the K-th on, into DONE; what is in DONE is not run again
"""

import fcntl
import hashlib
import json
import os
import pathlib
import platform
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

# Figures of a report that are the same wherever the run ran on the same instruction path.
FIGURES = ("sim_time_s", "ticks", "fell", "max_tilt_deg", "zmp_margin_min_mm", "slip_max_mm", "penetration_max_mm", "self_collision_ticks",
           "sole_tilt_max_deg", "steps", "zmp_margin_p5_mm", "step_slip_max_mm", "force_rms_percent", "velocity_error_percent",
           "travel_m", "state_hash")
# What GNU libc may choose of sin, exp and their like: pinned, so that their bits are those of the path.
LIBM = {"baseline": "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX,-AVX512F", "avx2": "glibc.cpu.hwcaps=-FMA4,-AVX512F",
        "avx512": "glibc.cpu.hwcaps=-FMA4"}
LONGEST = 4000  # characters of a sentence of another program

_hashes = {}


def hash_of(path):
    """Of a file, or of all files of a folder: 16 hexadecimal digits; empty where there is nothing."""
    path = pathlib.Path(path)
    try:
        files = sorted(f for f in path.rglob("*") if f.is_file()) if path.is_dir() else [path]
        stamp = [(str(f), f.stat().st_mtime_ns, f.stat().st_size) for f in files]
        if _hashes.get(str(path), (None,))[0] != stamp:
            digest = hashlib.sha256()
            for file in files:
                data = file.read_bytes()
                digest.update(f"{file.relative_to(path) if path.is_dir() else ''} {len(data)}\n".encode() + data)
            _hashes[str(path)] = (stamp, digest.hexdigest()[:16])
        return _hashes[str(path)][1]
    except OSError:
        return ""


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8", errors="replace") as file:
            for line in file:
                if line.startswith(("model name", "Model")):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


_machine = {}


def machine():
    """What may make one machine's bits differ from another's, and its name."""
    if not _machine:
        _machine.update(host=socket.gethostname(), processor=processor(), architecture=platform.machine(),
                        libc="-".join(platform.libc_ver()), kernel=platform.release())
    return _machine


def program_of(task):
    """Where the task's program lies on this machine: where it lay on the other, or what TWINBUS_PROGRAM names (another one: beside that)."""
    named = os.environ.get("TWINBUS_PROGRAM")
    if named and "arguments" in task:
        named = str(pathlib.Path(named).with_name(pathlib.Path(task["program"]).name))
    return task["program"] if not named or hash_of(task["program"]) == task["program_hash"] else named


def program_words(task):
    """The command of a program of its own, which prints what it finds."""
    words = [program_of(task), *task["arguments"]]
    words += ["--robot", task.get("robot_path") or task["robot"]] if task["robot"] else []
    for key, value in task["settings"].items():
        words += [f"--{key}"] if value == "true" else [] if value == "false" else [f"--{key}", value]
    return words + (["--seed", str(task["seed"])] if task["seeded"] else [])


def read_object(file):
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def last_object(text):
    """Of the last line that is a JSON object: what a program of its own has found."""
    for line in reversed(text.splitlines()):
        if line.startswith("{"):
            try:
                return json.loads(line)
            except ValueError:
                continue
    return {}


class Runner:
    """A folder of its own for reports and shipped scenes; removed by close()."""

    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="twinbus-campaign-"))
        self.machine = machine()

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def scene_file(self, task):
        """The scene as the task ships it; one that names files beside it is used where it lies."""
        beside = task.get("scene_path")
        if beside:
            return beside
        file = self.folder / task["scene_hash"] / f"{task['scene']}.yaml"
        if not file.exists():
            file.parent.mkdir(exist_ok=True)
            file.write_text(task["scene_text"], encoding="utf-8")
        return str(file)

    def refusal(self, task):
        """Why this worker cannot run it; empty when it can."""
        if hash_of(program_of(task)) != task["program_hash"]:
            return (f"worker {self.machine['host']}: {program_of(task)} is not the program of this campaign ({task['program_hash']}); install that "
                    "one there and name it with TWINBUS_PROGRAM")
        if task.get("scene_path") and hash_of(task["scene_path"]) != task["scene_hash"]:
            return f"worker {self.machine['host']}: {task['scene_path']} is missing or another one; give workers the same folder"
        if task.get("robot_path") and hash_of(task["robot_path"]) != task["robot_hash"]:
            return f"worker {self.machine['host']}: {task['robot_path']} is missing or another one; give workers the same folder"
        for path, digest in task.get("files", {}).items():
            if hash_of(path) != digest:
                return f"worker {self.machine['host']}: {path} is missing or another one; give workers the same files"
        return ""

    def words(self, task, report):
        if "arguments" in task:
            return program_words(task)
        words = [program_of(task), "run", self.scene_file(task), "--seed", str(task["seed"]),
                 "--report", str(report), "--robot", task.get("robot_path") or task["robot"]]
        if task.get("for") is not None:
            words += ["--for", repr(task["for"])]
        if not task.get("guard", True):
            words.append("--no-guard")
        for key, value in task["settings"].items():
            words += ["--set", f"{key}={value}"]
        return words

    def run(self, task, logs=None, most_logs=0):
        """The result of one task.  logs: folder for the log of a failure, of which there are at most most_logs."""
        began, clock = time.time(), time.monotonic()
        report = self.folder / "report.json"
        result = {"id": task["id"], "status": "refused", "failures": [], "figures": {}}
        where = dict(self.machine, path="", started=began, pid=os.getpid(), attempt=task.get("attempt", 1))
        sentence = self.refusal(task)
        if sentence:
            result["failures"] = [sentence]
            result["again"] = True  # another worker may have what is missing here
        else:
            report.unlink(missing_ok=True)
            result["status"], result["failures"], figures = self.start(task, self.words(task, report), report)
            if "arguments" in task:
                where["times"] = {key: value for key, value in figures.pop("times", {}).items() if isinstance(value, (int, float))}
                result["figures"] = {key: value for key, value in figures.items() if isinstance(value, (bool, int, float, str))}
                if task.get("output"):
                    result["output"] = self.output
            else:
                result["figures"] = {key: figures[key] for key in FIGURES if figures.get(key) is not None}
            where["path"] = figures.get("simd", "")
            where["architecture"] = figures.get("architecture", where["architecture"])  # under emulation the program's own
            if figures and task.get("simd", "any") != "any" and where["path"] != task["simd"]:
                result.update(status="refused", again=True, figures={}, failures=[
                    f"worker {self.machine['host']}: runs path {where['path']}, and the campaign asks for {task['simd']}; "
                    "use a machine that has it, or ask for a lower path"])
        where["run_s"] = round(time.monotonic() - clock, 6)
        if result["status"] == "failed" and logs and most_logs > 0 and "arguments" not in task:
            self.keep_log(task, pathlib.Path(logs), most_logs)
        where["task_s"] = round(time.monotonic() - clock, 6)
        result["where"] = where
        return result

    def start(self, task, words, report):
        environment = dict(os.environ)
        if task.get("simd", "any") != "any":
            environment["TWINBUS_SIMD"] = task["simd"]
            if task["simd"] in LIBM:
                environment["GLIBC_TUNABLES"] = LIBM[task["simd"]]
        try:
            process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       start_new_session=True, env=environment)
        except OSError as error:
            return "refused", [f"cannot start {words[0]}: {error.strerror}"], {}
        try:
            printed, complaints = process.communicate(timeout=task.get("limit", 600.0))
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return "timeout", [f"did not end within its limit of {task.get('limit', 600.0):g} s"], {}
        except BaseException:
            os.killpg(process.pid, signal.SIGKILL)
            raise
        self.output = printed.decode("utf-8", "replace") if "arguments" in task else ""
        figures = last_object(self.output) if "arguments" in task else read_object(report)
        said = complaints.decode("utf-8", "replace").strip().splitlines()
        if process.returncode < 0:
            return "crashed", [f"ended by signal {-process.returncode}"], {}
        if process.returncode not in (0, 1) or not (figures or task.get("output")):
            return "refused", [(said or ["no report and no sentence"])[-1][:LONGEST]], {}
        return ("passed" if process.returncode == 0 else "failed"), figures.get("failures", []), figures

    def keep_log(self, task, folder, most):
        """The same run once more, recorded: equal runs are equal to the last bit, and only failures pay for a log."""
        try:
            folder.mkdir(parents=True, exist_ok=True)
            if len(list(folder.glob("*.log"))) >= most:
                return
            part = folder / f"{task['id']}.part"
            part.unlink(missing_ok=True)  # of a campaign that was ended
            self.start(task, self.words(task, self.folder / "again.json") + ["--log", str(part)], self.folder / "again.json")
            part.rename(folder / f"{task['id']}.log")
        except OSError as error:
            print(f"campaign: no log of {task['id']}: {error}", file=sys.stderr)


def run_batch(tasks, logs=None, most_logs=0):
    """The results of several tasks: what a Dask worker is asked for."""
    runner = Runner()
    try:
        return [runner.run(task, logs, most_logs) for task in tasks]
    finally:
        runner.close()


def serve():
    """Until stdin ends.  The first line says where logs go."""
    runner = Runner()
    try:
        asked = json.loads(sys.stdin.readline() or "{}")
        print("{}", flush=True)  # ready: from here on a death is the task's
        for line in sys.stdin:
            for task in json.loads(line):
                sys.stdout.write(json.dumps(runner.run(task, asked.get("logs"), asked.get("most_logs", 0))) + "\n")
                sys.stdout.flush()
    except (BrokenPipeError, KeyboardInterrupt):
        pass
    finally:
        runner.close()


def whole_lines(path):
    """The JSON lines of a file; a last line that a killed writer left torn is cut off."""
    try:
        with open(path, "rb+") as file:
            data = file.read()
            end = data.rfind(b"\n") + 1
            if end < len(data):
                file.truncate(end)
    except FileNotFoundError:
        return []
    found = []
    for line in data[:end].splitlines():
        try:
            found.append(json.loads(line))
        except ValueError:
            continue  # a bad block of a disk: that task runs again
    return found


def run_part(tasks, index, count, done):
    """One task of a Slurm array: its share of the file."""
    pathlib.Path(done).parent.mkdir(parents=True, exist_ok=True)
    with open(f"{done}.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # a requeued array task waits for its former self
        known = {result["id"] for result in whole_lines(done) if not result.get("again")}
        runner = Runner()
        try:
            with open(tasks, encoding="utf-8") as lines, open(done, "a", encoding="utf-8") as out:
                for number, line in enumerate(lines):
                    if number % count != index:
                        continue
                    task = json.loads(line)
                    if task["id"] not in known:
                        out.write(json.dumps(runner.run(task)) + "\n")
                        out.flush()
        finally:
            runner.close()


if __name__ == "__main__":
    if sys.argv[1:2] == ["--part"]:
        run_part(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), sys.argv[5])
    else:
        serve()
