#!/usr/bin/env python3
"""The lines of the Dockerfile, run without Docker in roots of their own; then the container's page as a browser outside sees it.

    dockerfile_test.py BASE BUILT ENTER...       clean_root.sh calls it

BASE is a root of the image in FROM; BUILT one in which the clone is built, taken for the first stage (whose COPY and build
are no work there); `ENTER ROOT NETWORK COMMAND...` runs a command in a root.  Shown: every line runs, the image has what its
command needs, FIFO priority and locked memory are used where granted and said where not, and from another address there is
the page, and the robot with the token only.
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
base, built, *ENTER = sys.argv[1:]
NEAR, FAR, PORT = "10.88.0.1", "10.88.0.2", 8040  # of who looks, and of the container
failures = []


def check(ok, what):
    print(("ok      " if ok else "FAILED  ") + what, flush=True)
    if not ok:
        failures.append(what)


def run(*words, **options):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, stdin=subprocess.DEVNULL, **options)


def lines():
    """(INSTRUCTION, rest) of the Dockerfile."""
    text = re.sub(r"\\\n", " ", (ROOT / "Dockerfile").read_text())
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            word, rest = line.split(None, 1)
            yield word, rest


def copy(source, target):
    if source.is_dir():
        shutil.copytree(source, target, symlinks=True, dirs_exist_ok=True)
    else:
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, target)


def build_image(folder):
    """Runs the lines; gives root, environment and command of the last stage."""
    stages, root, environment, entry, command = {}, None, {}, [], []
    for word, rest in lines():
        if word == "FROM":
            image, _, name = rest.partition(" AS ")
            check(re.fullmatch(r"debian:trixie(-slim)?", image.strip()) is not None, f"FROM {image.strip()}: the root of this stage")
            if name:
                root = stages[name.strip()] = pathlib.Path(built)
            else:
                root = folder / "image"
                subprocess.run(["cp", "-a", "--reflink=auto", base, root], check=True)
                (root / "twinbus").mkdir()
            environment = {}
        elif word == "RUN":
            start = time.monotonic()
            done = run(*ENTER, root, "shared", "/bin/sh", "-c", rest)
            check(done.returncode == 0, f"RUN {rest[:60]}  ({time.monotonic() - start:.0f} s)")
            if done.returncode != 0:
                sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
        elif word == "COPY" and rest.startswith("--from="):
            stage, source, target = re.fullmatch(r"--from=(\S+) (\S+) (\S+)", rest).groups()
            copy(stages[stage] / source.lstrip("/"), root / "twinbus" / target)
        elif word == "ENV":
            name, _, value = rest.partition("=")
            environment[name] = value
        elif word == "ENTRYPOINT":
            entry = json.loads(rest)
        elif word == "CMD":
            command = json.loads(rest)
        else:
            check((word, rest) in {("WORKDIR", "/twinbus"), ("COPY", ". ."), ("EXPOSE", "8040")}, f"{word} {rest}: known here")
    (root / ".dockerenv").touch()
    return root, environment, entry, command


def start(root, environment, command, rights, network):
    words = ["env", *(f"{name}={value}" for name, value in environment.items()), *command]
    if not rights:  # what Docker gives when nothing is asked for
        words = ["setpriv", "--bounding-set", "-sys_nice,-ipc_lock,-sys_resource", "--inh-caps", "-sys_nice,-ipc_lock,-sys_resource",
                 "prlimit", "--rtprio=0", "--memlock=65536", *words]
    return subprocess.Popen([*ENTER, str(root), network, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            stdin=subprocess.DEVNULL, start_new_session=True)


def wait_for(process, expression, seconds=60):
    said = []
    end = time.monotonic() + seconds
    for line in process.stdout:
        said.append(line)
        found = re.search(expression, line)
        if found:
            return found, said
        if time.monotonic() > end:
            break
    sys.exit(f"{expression} does not come:\n" + "".join(said[-30:]))


ASK = """import http.client, sys
connection = http.client.HTTPConnection(sys.argv[1], timeout=5)
connection.request("GET", sys.argv[2], headers={"Host": sys.argv[3]})
print(connection.getresponse().status)"""


def status(networks, path, host):
    """HTTP status of the page for a browser on the other machine, which came through a forwarded port."""
    done = run("ip", "netns", "exec", networks[0], sys.executable, "-c", ASK, f"{FAR}:{PORT}", path, host)
    return int(done.stdout or 0)


def two_machines():
    """Networks of who looks and of the container, joined by a cable; nothing else hears them."""
    near, far = networks = [f"twinbus-{os.getpid()}-{who}" for who in ("near", "far")]
    for line in (f"netns add {near}", f"netns add {far}", f"-n {near} link add cable type veth peer name eth0 netns {far}",
                 f"-n {near} addr add {NEAR}/30 dev cable", f"-n {near} link set cable up", f"-n {far} addr add {FAR}/30 dev eth0",
                 f"-n {far} link set eth0 up", f"-n {far} link set lo up", f"-n {far} route add default via {NEAR}"):
        subprocess.run(["ip", *line.split()], check=True)
    return networks


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended before its end"))  # and what was started with it
    folder = pathlib.Path(built).parent / (pathlib.Path(built).name + "-image")
    subprocess.run(["rm", "-rf", "--one-file-system", folder], check=True)
    folder.mkdir()
    root, environment, entry, command = build_image(folder)
    size = int(run("du", "-sm", root).stdout.split()[0])
    print(f"the image has {size} MB")
    try:
        networks = two_machines()
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"this machine joins no two networks: its page is not looked at from outside ({error})")
        sys.exit(1 if failures else 0)
    try:
        container(root, environment, entry, command, networks)
    finally:
        for network in networks:
            run("ip", "netns", "delete", network)
    subprocess.run(["rm", "-rf", "--one-file-system", folder], check=True)
    sys.exit(1 if failures else 0)


def container(root, environment, entry, command, networks):
    for rights in (True, False):
        stack = start(root, environment, [*entry, *command], rights, networks[1])
        try:
            real_time, _ = wait_for(stack, r"(WITH(OUT)? FIFO|run with FIFO).*")
            wanted = "locked memory" if rights else "WITHOUT FIFO"
            check(wanted in real_time.group(0), f"{'with' if rights else 'without'} the rights it says: {real_time.group(0)[:70]}")
            shown, _ = wait_for(stack, r"from a phone: http://([^/]+)/#token=(\w+)")
            at, token = shown.groups()
            check(at == environment["TWINBUS_VIEWER_AT"], f"the address told is that of the published port: {at}")
            check(status(networks, "/", at) == 200, "from outside there is the page")
            check(status(networks, "/robot.urdf", at) == 403, "and no robot without the token")
            check(status(networks, f"/robot.urdf?token={token}", at) == 200, "and with it the robot")
            check(status(networks, "/", "evil.example:8040") == 403, "under no other name")
        finally:
            os.killpg(stack.pid, signal.SIGKILL)  # unshare, and with it all that is in its namespaces
            stack.wait()
            time.sleep(1.0)
    said = run(*ENTER, root, networks[1], "setpriv", "--bounding-set", "-sys_nice,-ipc_lock,-sys_resource", "prlimit", "--rtprio=0",
               *entry, "doctor", "--rt").stdout
    check("--cap-add SYS_NICE" in said, "doctor says how docker gives FIFO priority")


main()
