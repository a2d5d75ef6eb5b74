#!/usr/bin/env python3
"""Every command in README.md is run: a reader can copy it and it does what the text says.

The word behind ```sh says how: `test` alone, `test-both` while `up --stack both` runs, `test-record` on its log, `test-client` in the background
while `test-up-client` runs.  Blocks of plain ```sh are checked to be known: they start the stack for good
or run these very tests.
"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time

import harness
from harness import Checks, Stack

# Not run here, and why.
KNOWN = {
    "./twinbus up": "never ends by itself; up_test.py runs it",
    "./twinbus test": "runs this test",
    "cmake --preset release && cmake --build --preset release && ctest --preset release": "what ./twinbus test does",
    "pip install ./python": "test/python/wheel_test.py does it in an environment of its own",
    "python3 examples/17_simulation.py": "needs that; test/python/wheel_test.py and examples_test.py run it",
    "ninja -C build/release installable": "package_test.py needs all of it",
    "cpack --config build/release/CPackConfig.cmake -B build/package": "package_test.py makes the package",
    "cmake --install build/release --prefix $HOME/twinbus": "package_test.py installs to a prefix of its own",
}


def blocks():
    text = (harness.ROOT / "README.md").read_text(encoding="utf-8")
    for kind, body in re.findall(r"^```sh ?([a-z-]*)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        yield kind, [line for line in body.splitlines() if line.strip()]


def run(command, timeout=120, folder=harness.ROOT, environment=None):
    # ./twinbus would build: hand over to the program that is under test.
    replaced = command.replace("./twinbus", str(harness.BIN / "twinbus"))
    done = subprocess.run(["bash", "-c", replaced], capture_output=True, text=True, timeout=timeout, cwd=folder,
                          stdin=subprocess.DEVNULL, env=dict(os.environ, **(environment or {})))
    return done.returncode, (done.stdout + done.stderr).strip()


def run_all(lines, checks, **how):
    for command in lines:
        status, said = run(command, **how)
        checks.that(status == 0, f"README: `{command}` ends with {status}: {said[-500:]}")
        print(f"ok `{command}`" if status == 0 else f"-- `{command}`", flush=True)


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    checks = Checks()
    by_kind = {}
    for kind, lines in blocks():
        by_kind.setdefault(kind, []).extend(lines)
    for command in by_kind.pop("", []):
        checks.that(command.split("  #")[0].strip() in KNOWN, f"README: nobody tests `{command}`")
    run_all(by_kind.pop("test", []), checks)

    os.environ["TWINBUS_RECORD"] = "1"
    with Stack("--stack", "both", "--no-viewer"):
        time.sleep(1.0)
        run_all(by_kind.pop("test-both", []), checks)

    # The log of that run, in a folder of its own.
    log = harness.newest_run_folder() / "run.log"
    with tempfile.TemporaryDirectory() as folder:
        run_all(by_kind.pop("test-record", []), checks, folder=folder, environment={"LOG": str(log)})

    # A controller of one's own goes on in the background while the stack runs.
    client = " & ".join(by_kind.pop("test-client", []))
    background = subprocess.Popen(["bash", "-c", f"exec {client}"], cwd=harness.ROOT, stdin=subprocess.DEVNULL)
    run_all(by_kind.pop("test-up-client", []), checks)
    checks.that(background.poll() is None, f"README: `{client}` goes on")
    background.send_signal(signal.SIGTERM)
    background.wait(10)
    checks.that(not by_kind, f"README: unknown kinds of blocks {sorted(by_kind)}")
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
