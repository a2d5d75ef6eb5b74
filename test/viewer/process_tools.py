"""Processes whose lines a test waits for, and numbered checks."""
import atexit
import os
import queue
import subprocess
import sys
import threading
import time

FAR = "10.77.77.1"  # an address of this machine that is not loopback: who comes there is taken for a stranger


class Process:
    def __init__(self, *command, **options):
        options.setdefault("stdin", subprocess.DEVNULL)
        self.child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
        self.lines = queue.Queue()
        self.seen = []
        threading.Thread(target=self._read, daemon=True).start()
        atexit.register(self.end)  # a test that breaks off leaves nothing running

    def _read(self):
        for line in self.child.stdout:
            self.lines.put(line.decode(errors="replace").rstrip())

    def wait_for(self, text, seconds=30.0):
        """The next line that contains text, or None: as long as a busy machine may need for what an idle one does at once."""
        end = time.monotonic() + seconds
        while True:
            try:
                line = self.lines.get(timeout=max(0.0, end - time.monotonic()))
            except queue.Empty:
                return None
            self.seen.append(line)
            if text in line:
                return line

    def drain(self):
        lines = []
        while not self.lines.empty():
            lines.append(self.lines.get())
        return lines

    def end(self, seconds=15.0):
        """Asks it to end; its exit code, or None if it had to be killed."""
        if self.child.poll() is None:
            self.child.terminate()
        try:
            return self.child.wait(seconds)
        except subprocess.TimeoutExpired:
            self.child.kill()
            self.child.wait()
            return None


def until(holds, seconds, pause=0.2):
    """Whether holds() gives something true within that time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if holds():
            return True
        time.sleep(pause)
    return False


def console_is_clean(check, page, *known):
    """No errors in the page's console, lines that name one of the known things left out."""
    errors = [line for line in page.console if not any(word in line for word in known)]
    check(not errors, f"no errors in the console {errors[:3]}")


class Checks:
    def __init__(self):
        self.passed = self.failed = 0

    def __call__(self, ok, what):
        print(("ok      " if ok else "FAILED  ") + what, flush=True)
        if ok:
            self.passed += 1
        else:
            self.failed += 1

    def finish(self):
        print(f"{self.passed} passed, {self.failed} failed")
        sys.exit(1 if self.failed else 0)


def binary(folder, name):
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        print(f"{path} is not built: skipped")
        sys.exit(77)
    return path


def stack_with_page(check, bin_folder, runs):
    """`up stand` in runs, when its page is served: the process, and the line with the address."""
    up = Process(binary(bin_folder, "twinbus"), "up", "stand", "--no-fifo", env=dict(os.environ, TWINBUS_RUNS=runs))
    line = up.wait_for("up: viewer:", 60) or ""
    if not line:
        print(up.seen, up.drain())
        check(False, "the stack runs")
        check.finish()
    return up, line


def fake_robot_seen_from_afar(bin_folder):
    """A fake robot, with FAR as an address of this machine; without the right to add one the test is skipped."""
    if subprocess.run(["ip", "addr", "add", f"{FAR}/32", "dev", "lo"]).returncode != 0:
        print("no address can be added: skipped")
        sys.exit(77)
    fake = Process(binary(bin_folder, "fake_robot"))
    fake.wait_for("ready")
    return fake
