#!/usr/bin/env python3
"""Every command in README.md and in the pages that it leads to is run: a reader can copy it and it does what the text says.

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
    "ninja -C build/release installable": "package_test.py needs all of it",
    "cpack --config build/release/CPackConfig.cmake -B build/package": "package_test.py makes the package",
    "cmake --install build/release --prefix $HOME/twinbus": "package_test.py installs to a prefix of its own",
}

PAGES = ["README.md", "doc/install.md", "doc/use.md", "doc/logs.md", "doc/controllers.md", "doc/accuracy.md"]


def blocks(page):
    text = (harness.ROOT / page).read_text(encoding="utf-8")
    for kind, body in re.findall(r"^```sh ?([a-z-]*)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        yield kind, [line for line in body.splitlines() if line.strip()]


def run(command, timeout=120, folder=harness.ROOT, environment=None):
    # ./twinbus would build: hand over to the program that is under test.
    replaced = command.replace("./twinbus", str(harness.BIN / "twinbus"))
    done = subprocess.run(["bash", "-c", replaced], capture_output=True, text=True, timeout=timeout, cwd=folder,
                          stdin=subprocess.DEVNULL, env=dict(os.environ, **(environment or {})))
    return done.returncode, (done.stdout + done.stderr).strip()


def run_all(page, lines, checks, **how):
    for command in lines:
        status, said = run(command, **how)
        checks.that(status == 0, f"{page}: `{command}` ends with {status}: {said[-500:]}")
        print(f"ok {page} `{command}`" if status == 0 else f"-- {page} `{command}`", flush=True)


def run_page(page, checks):
    by_kind = {}
    for kind, lines in blocks(page):
        by_kind.setdefault(kind, []).extend(lines)
    checks.that(bool(by_kind), f"{page}: no commands")
    for command in by_kind.pop("", []):
        checks.that(command.split("  #")[0].strip() in KNOWN, f"{page}: nobody tests `{command}`")
    run_all(page, by_kind.pop("test", []), checks)

    if "test-both" in by_kind:
        with Stack("--stack", "both", "--no-viewer"):
            time.sleep(1.0)
            run_all(page, by_kind.pop("test-both"), checks)

    # The log of the newest of these runs, in a folder of its own.
    if "test-record" in by_kind:
        log = harness.newest_run_folder() / "run.log"
        with tempfile.TemporaryDirectory() as folder:
            run_all(page, by_kind.pop("test-record"), checks, folder=folder, environment={"LOG": str(log)})

    # A controller of one's own goes on in the background while the stack runs.
    if "test-client" in by_kind:
        client = " & ".join(by_kind.pop("test-client"))
        background = subprocess.Popen(["bash", "-c", f"exec {client}"], cwd=harness.ROOT, stdin=subprocess.DEVNULL)
        run_all(page, by_kind.pop("test-up-client", []), checks)
        checks.that(background.poll() is None, f"{page}: `{client}` goes on")
        background.send_signal(signal.SIGTERM)
        background.wait(10)
    checks.that(not by_kind, f"{page}: unknown kinds of blocks {sorted(by_kind)}")


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    os.environ["TWINBUS_RECORD"] = "1"
    checks = Checks()
    for page in PAGES:
        run_page(page, checks)
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
