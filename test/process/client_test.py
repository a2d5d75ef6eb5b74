#!/usr/bin/env python3
"""A client that knows only STATE and COMMAND holds the robot while sources are switched under it (Python, C++, Java).

    client_test.py [python] [cpp] [java]     which clients; default python and cpp, and java where it is installed

TWINBUS_FULL=1: 20 switches each, otherwise 2.
"""
import math
import os
import shutil
import subprocess
import sys
import time

import harness
from harness import BIN, ROOT, Bus, Checks, Stack, cli

SWITCHES = 20 if harness.FULL else 2
LARGEST_TILT = math.radians(5)


def client_command(kind):
    if kind == 'python':
        return [sys.executable, str(ROOT / 'examples/02_command_joints.py')]
    if kind == 'cpp':
        return [str(BIN / 'example_command_joints')]
    classes = f'/usr/share/java/lcm.jar:{BIN.parent / "share/types.jar"}'
    return ['java', '-Djava.net.preferIPv4Stack=true', '-cp', classes, str(ROOT / 'examples/02_CommandJoints.java')]


def available():
    kinds = ['python', 'cpp']
    if shutil.which('javac') and (BIN.parent / 'share/types.jar').exists():
        kinds.append('java')
    return kinds


def tilt(state):
    w, x, y, z = state.attitude
    return math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y))))


def holds_through_switches(kind, checks):
    environment = dict(os.environ, LCM_DEFAULT_URL='udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304')
    client = subprocess.Popen(client_command(kind), stdout=subprocess.PIPE, text=True, env=environment)
    try:
        client.stdout.readline()  # "ready"
        with Stack('stand_python', '--stack', 'client_both', '--no-viewer'):
            bus = Bus()
            time.sleep(2.0)
            runs, target, worst = set(), 'bridge', 0.0
            for number in range(SWITCHES):
                status, out, err = cli('switch', target, '--policy', 'now', timeout=40)
                checks.that(status == 0, f'{kind}: switch {number} to {target}: {(out + err).strip()}')
                time.sleep(1.2)  # one switch a second
                states = [s for _, s in bus.messages('STATE')]
                commands = sum(1 for _ in bus.messages('COMMAND'))
                runs.update(s.run_id for s in states)
                if not checks.that(bool(states) and states[-1].stop_kind == 0, f'{kind}: not stopped after switch {number}'):
                    print('\n'.join(harness.story_of_a_stop(bus)), flush=True)
                worst = max([worst] + [tilt(s) for s in states])
                checks.at_least(commands / max(1, len(states)), 0.5, f'{kind}: commands per state')
                bus.forget()
                target = 'sim' if target == 'bridge' else 'bridge'
            checks.that(len(runs) == 2, f'{kind}: {len(runs)} sources were heard, 2 asked')
            checks.at_most(worst, LARGEST_TILT, f'{kind}: tilt')
            checks.that(client.poll() is None, f'{kind}: the client is still the same process')
            print(f'{kind}: {SWITCHES} switches, largest tilt {math.degrees(worst):.2f} degrees', flush=True)
            bus.close()
    finally:
        client.terminate()
        client.communicate()


def main():
    harness.require('twinbus', 'twinbus_simulator', 'twinbus_bridge', 'emulated_robot', 'example_command_joints')
    checks = Checks()
    for kind in sys.argv[1:] or available():
        holds_through_switches(kind, checks)
    checks.exit()


if __name__ == '__main__':
    main()
