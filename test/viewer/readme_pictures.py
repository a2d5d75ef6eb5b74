#!/usr/bin/env python3
"""Takes the pictures of the README: live view, plots, two logs on one line of time; each of few colours, so that it is small.

    test/tools/private_bus.sh python3 test/viewer/readme_pictures.py BIN_FOLDER [live plots replay]

They go to viewer_log/screenshot.png, plots.png and replay.png.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from browser import Browser
from pictures import with_few_colours
from process_tools import Process, binary

bin_folder = sys.argv[1]
wanted = sys.argv[2:] or ["live", "plots", "replay"]
folder = pathlib.Path(__file__).resolve().parents[2] / "viewer_log"
size = (1440, 810)


def keep(page, name):
    page.value("document.getElementById('late') && (document.getElementById('late').style.display = 'none')")  # of this machine
    data = with_few_colours(page.screenshot())
    (folder / name).write_bytes(data)
    print(f"{folder / name}: {len(data) // 1000} kB; console: {page.console}")


# The robot above the panel with the plots.
above = "; twinbus.stage.camera.position.set(4.1, 2.2, 1.5); twinbus.stage.controls.target.set(0, 0, 0.2)"


def stack(scene, quality="&fine=1"):
    up = Process(binary(bin_folder, "twinbus"), "up", scene, "--for", "300", "--no-record")
    address = re.search(r"http://\S+token=\w+", up.wait_for("http://", 90))[0]
    page = Browser(address + quality, size)
    page.wait_for("twinbus.robot.model && twinbus.history.count > 30", 90)
    return up, page


if "live" in wanted:
    up, page = stack("walk_rough")
    page.value("twinbus.stage.camera.position.copy(twinbus.stage.controls.target).add({ x: 3.1, y: -1.7, z: 0.9 })")
    # Its own walk may be over before a picture of this quality is drawn.
    walk = subprocess.Popen([binary(bin_folder, "twinbus"), "walk", "0.1", "0", "0", "--for", "25"], stdout=subprocess.DEVNULL)
    page.wait_for("twinbus.robot.model.position.x > 0.9 && twinbus.stage.shapes.steps.children.filter((part) => part.visible).length > 8", 60)
    keep(page, "screenshot.png")
    walk.terminate()
    page.end()
    up.end(10)
if "plots" in wanted:
    up, page = stack("stand", "")  # fewer pictures would mean fewer points in the curves
    page.value("twinbus.stage.fine = true; twinbus.stage.pixels = 1; twinbus.stage.resize()" + above)
    page.key("p", "KeyP")
    page.wait_for("document.querySelectorAll('.plot canvas').length === 3", 60)
    page.value("twinbus.plots.clear(); "
               "twinbus.plots.add('left arm [rad]', twinbus.history.joints.filter((n) => /^LARM_(SHOULDER|ELBOW|WRIST_P)/.test(n)).map((n) => 'STATE.q.' + n)); "
               "twinbus.plots.add('ZMP, forward [m]', ['zmp_reference', 'zmp', 'dcm', 'com'].map((n) => `SHOWN.${n}.x`)); "
               "document.querySelector('#plot-box .presets .on')?.classList.remove('on')")
    reach = subprocess.Popen([binary(bin_folder, "twinbus"), "reach", "left", "0.35", "0.25", "1.0"], stdout=subprocess.DEVNULL)
    page.wait_for("twinbus.armPath.group.visible", 60)
    time.sleep(2.0)
    keep(page, "plots.png")
    reach.wait()
    page.end()
    up.end(10)
if "replay" in wanted:
    with tempfile.TemporaryDirectory() as logs:
        for name, words in (("nominal.log", []), ("heavier.log", ["--set", "model.mass_scale=1.05"])):
            subprocess.run([binary(bin_folder, "twinbus"), "run", "push_forward", "--for", "8", "--log", f"{logs}/{name}", *words], stdout=subprocess.DEVNULL, check=False)
        viewer = Process(binary(bin_folder, "twinbus_log_viewer"), f"{logs}/nominal.log", f"{logs}/heavier.log", "--port", "0", "--no-open")
        page = Browser(re.search(r"http://\S+", viewer.wait_for("ready at ", 30))[0] + "&fine=1", size)
        page.wait_for("globalThis.twinbus?.figures.first", 60)
        page.value("twinbus.plots.seconds.value = 5; twinbus.timeline.seek(2.9)" + above)
        page.key("p", "KeyP")
        page.wait_for("twinbus.history.count > 50 && Math.abs(twinbus.timeline.state.position - 2.9) < 0.01", 60)
        page.value("twinbus.plots.preset('Two logs')")
        page.wait_for("twinbus.plots.plots.length === 3 && twinbus.plots.plots.every((plot) => plot.chart)", 60)
        page.wait_for("document.getElementById('health').className === 'good'", 30)
        time.sleep(3.0)
        keep(page, "replay.png")
        page.end()
        viewer.end()
