#!/usr/bin/env python3
"""A running stack set up anew from the page: scene, engine, posture, a push, a pair that is not checked; wrong wishes change nothing.

    setup_test.py BIN_FOLDER        in a private network namespace
"""
import glob
import json
import os
import re
import shutil
import sys
import tempfile
import time

from process_tools import Checks, stack_with_page
from web_socket import WebSocket

check = Checks()
bin_folder = sys.argv[1]
runs = tempfile.mkdtemp()
up, line = stack_with_page(check, bin_folder, runs)
port, token = re.search(r":(\d+)/#token=(\w+)", line).groups()
port = int(port)
folder = glob.glob(runs + "/*/setup")[0]


class Page(WebSocket):
    def __init__(self, given):
        super().__init__(port, "/ws" + (f"?token={given}" if given else ""), f"http://127.0.0.1:{port}", timeout=10)
        self.live = None

    def until(self, accept, seconds=20.0):
        """The next message that accept() likes."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            message = json.loads(self.receive())
            if message["type"] == "live":
                self.live = message
            if accept(message):
                return message
        return None


def runs_from(page, not_run=0):
    return page.until(lambda m: m["type"] == "live" and m["age_ms"] is not None and m["age_ms"] < 100 and m["run"] not in (0, not_run), 40)


page = Page(token)
first = runs_from(page)
check(first is not None, "it runs")

# --- refusals ---
watcher = Page("")
watcher.send(json.dumps({"do": "setup", "setup": {"scene": "sway"}}))
note = watcher.until(lambda m: m["type"] == "note")
check("watching only" in note["text"], "who watches sets up nothing")
watcher.close()
for wrong, why in (({"scene": "no_such"}, "no scene"), ({"scene": "../x"}, "must be a name"), ({"scene": "stand", "engine": "magic"}, "no engine"),
                   ({"scene": "stand", "pose": "flying"}, "no pose"), ({"scene": "stand", "joints": {"TAIL": 1}}, "no joint"),
                   ({"scene": "stand", "joints": {"WAIST_P": 99}}, "must be a number"), ({"scene": "stand", "unchecked": [["A", "CHEST"]]}, "no moving link"),
                   ({"scene": "stand", "pushes": [{"link": "CHEST", "at": 1, "impulse": [1, 2]}]}, "three numbers"),
                   ({"scene": "stand", "pushes": [{"link": "CHEST", "at": 1, "impulse": [1e9, 0, 0]}]}, "must be a number")):
    page.send(json.dumps({"do": "setup", "setup": wrong}))
    said = up.wait_for(why, 30) or ""
    check(why in said, f"{json.dumps(wrong)[:60]}: {said[said.find('not set up'):][:90]}")
check(runs_from(page)["run"] == first["run"] and not os.path.exists(folder + "/now.json"), "and the robot has not noticed")

# --- another beginning ---
wish = {"scene": "sway", "engine": "ode", "pose": "half_sitting", "joints": {"LARM_ELBOW": -1.2},
        "pushes": [{"link": "CHEST", "at": 2.0, "impulse": [15, 0, 0], "duration": 0.3}], "unchecked": [["LARM_WRIST_R", "RARM_WRIST_R"]]}
page.send(json.dumps({"do": "setup", "setup": wish}))
check(up.wait_for("set up as the page asked", 40) is not None, "set up anew")
second = runs_from(page, first["run"])
check(second is not None and second["run"] != first["run"], "another run holds STATE")
hello = None
page.send(json.dumps({"do": "hello"}))
hello = page.until(lambda m: m["type"] == "hello")
elbow = hello["joints"].index("LARM_ELBOW")
check(abs(second["q"][elbow] + 1.2) < 0.3, f"it began in the posture that was asked: elbow {second['q'][elbow]:.2f} rad")
check(page.until(lambda m: m["type"] == "status" and (m["controller"] or {}).get("motion") == "sway", 20) is not None, "in the scene that was asked: it sways")
pushed = page.until(lambda m: m["type"] == "live" and m.get("push") and m["push"][3] > 30, 20)
check(pushed is not None, "and the push comes")
check(json.load(open(folder + "/now.json")) == wish, "what holds is kept with the run")
scene = open(folder + "/scene.yaml").read()
check("CHEST" in scene and "set_on_page" in scene, "as a scene that anybody can run again")
robot = glob.glob(folder + "/*/robot.yaml")[0]
srdf = open(glob.glob(os.path.dirname(robot) + "/*.srdf")[0]).read()
check('link1="LARM_WRIST_R" link2="RARM_WRIST_R"' in srdf, "and a robot's folder whose SRDF leaves the pair out")
page.close()

check(up.end(15) is not None, "it ends")

shutil.rmtree(runs, ignore_errors=True)
check.finish()
