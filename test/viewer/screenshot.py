#!/usr/bin/env python3
"""Takes the picture of the viewer in the README: a running stack, an arm on its way to the table, plots.

    screenshot.py BIN_FOLDER OUT.png [SCENE] [WIDTHxHEIGHT]      in a private network namespace
"""
import re
import subprocess
import sys
import time

from browser import Browser
from process_tools import Process, binary

bin_folder, out = sys.argv[1:3]
scene = sys.argv[3] if len(sys.argv) > 3 else "reach"
size = tuple(int(n) for n in (sys.argv[4] if len(sys.argv) > 4 else "1440x810").split("x"))
up = Process(binary(bin_folder, "twinbus"), "up", scene, "--for", "300")
address = re.search(r"http://\S+token=\w+", up.wait_for("http://", 60))[0]
page = Browser(address + "&fine=1", size)
page.wait_for("document.getElementById('health').className === 'good'", 60)
page.wait_for("twinbus.robot.model && twinbus.history.count > 200", 60)
page.key("p", "KeyP")
page.wait_for("document.querySelectorAll('.plot canvas').length === 3", 60)
page.value("twinbus.plots.preset('Legs'); twinbus.plots.clear(); "
           "twinbus.plots.add('left arm [rad]', twinbus.history.joints.filter((n) => /^LARM_(SHOULDER|ELBOW|WRIST_P)/.test(n)).map((n) => 'STATE.q.' + n)); "
           "twinbus.plots.add('ZMP, forward [m]', ['zmp_reference', 'zmp', 'dcm', 'com'].map((n) => `SHOWN.${n}.x`)); "
           "document.querySelector('#plot-box .presets .on')?.classList.remove('on')")
reach = subprocess.Popen([binary(bin_folder, "twinbus"), "reach", "left", "0.35", "0.25", "1.0"], stdout=subprocess.DEVNULL)
page.wait_for("twinbus.armPath.group.visible", 30)
time.sleep(1.5)
page.screenshot(out)
print(out, "written;", "console:", page.console)
reach.wait()
page.end()
up.end(10)
