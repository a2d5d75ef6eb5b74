#!/usr/bin/env python3
"""The sheet that sets a run up anew, in a browser: what holds, what is changed, and what it asks for.

    setup_sheet_test.py BIN_FOLDER [SCREENSHOT.png]        in a private network namespace
"""
import json
import os
import re
import shutil
import sys
import tempfile

from browser import Browser, find_browser
from pictures import compare
from process_tools import Checks, Process, binary

if not find_browser():
    print("no chromium: skipped")
    sys.exit(77)
check = Checks()
bin_folder = sys.argv[1]
run = tempfile.mkdtemp()
folder = run + "/setup"
os.mkdir(folder)
with open(folder + "/now.json", "w") as file:
    json.dump({"scene": "sway", "engine": "ode", "pose": "half_sitting", "joints": {"LARM_ELBOW": -1.2},
               "pushes": [{"link": "CHEST", "at": 2, "impulse": [15, 0, 0]}], "unchecked": [["LARM_WRIST_R", "RARM_WRIST_R"]]}, file)
fake = Process(binary(bin_folder, "fake_robot"))
fake.wait_for("ready")
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open", "--run-folder", run)
browser = Browser(re.search(r"http://\S+", viewer.wait_for("ready at ", 40))[0], (1200, 900))
check(browser.wait_for("globalThis.twinbus?.figures.first", 60), "the page draws the robot")
browser.key("s", "KeyS")
check(browser.wait_for("document.querySelectorAll('#setup .joint').length > 20", 60), "S opens the sheet")
check(browser.value("twinbus.setup.scene.value + twinbus.setup.engine.value") == "swayode", "with what holds")
check(browser.value("document.querySelectorAll('#setup .pair-out').length") == 1, "the pair that is left out, too")

def press(selector):
    browser.value(f"document.querySelector('{selector}').scrollIntoView({{ block: 'center' }})")
    browser.click(selector)

press("#setup .pair-out .close")
check(browser.wait_for("document.querySelectorAll('#setup .pair-out').length === 0", 40), "it is taken back with a click")
press("#leave-out")
check(browser.wait_for("document.querySelectorAll('#setup .pair-out').length === 1", 40), "and another one left out")
press("#add-push")
check(browser.wait_for("document.querySelectorAll('#setup .push').length === 2", 40), "a push is added")
browser.value("twinbus.setup.scene.value = 'stand'; twinbus.setup.engine.value = ''; twinbus.setup.show()")
browser.value("(s => { s.value = -0.4; s.oninput(); })(document.querySelector('#setup .joint input[title=RARM_ELBOW]'))")
check(browser.wait_for("twinbus.other.model?.visible", 40), "a ghost shows the posture")
browser.settle(0.5)
if len(sys.argv) > 2:
    browser.screenshot(sys.argv[2])
else:
    compare(browser.screenshot(), "setup", check)
press("#start-anew")
check(browser.wait_for("document.getElementById('toast').textContent.startsWith('Starting anew')", 40), "Start anew is answered")
asked = json.load(open(folder + "/wish.json"))
check(asked["scene"] == "stand" and abs(asked["joints"]["RARM_ELBOW"] + 0.4) < 1e-3 and len(asked["pushes"]) == 2 and len(asked["unchecked"]) == 1, f"and is asked: {str(asked)[:80]}")
errors = [text for text in browser.console if "GPU stall" not in text]
check(not errors, f"no errors in the console {errors[:3]}")
browser.end()
viewer.end()
fake.end()
shutil.rmtree(run, ignore_errors=True)
check.finish()
