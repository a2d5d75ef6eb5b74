#!/usr/bin/env python3
"""Takes the picture of two logs on one line of time in the README.

    replay_screenshot.py BIN_FOLDER OUT.png LOG OTHER [SECONDS] [WIDTHxHEIGHT]
"""
import re
import sys
import time

from browser import Browser
from process_tools import Process, binary

bin_folder, out, log, other = sys.argv[1:5]
at = float(sys.argv[5]) if len(sys.argv) > 5 else 3.0
size = tuple(int(n) for n in (sys.argv[6] if len(sys.argv) > 6 else "1440x810").split("x"))
viewer = Process(binary(bin_folder, "twinbus_log_viewer"), log, other, "--port", "0", "--no-open")
address = re.search(r"http://\S+", viewer.wait_for("ready at ", 30))[0]
page = Browser(address + "&fine=1", size)
page.wait_for("globalThis.twinbus?.figures.first", 60)
page.value("twinbus.plots.seconds.value = 5")
page.value(f"twinbus.timeline.seek({at})")
page.key("p", "KeyP")
page.wait_for(f"twinbus.history.count > 50 && Math.abs(twinbus.timeline.state.position - {at}) < 0.01", 60)
page.value("twinbus.plots.preset('Two logs')")
page.wait_for("twinbus.plots.plots.length === 3 && twinbus.plots.plots.every((plot) => plot.chart)", 60)
page.wait_for("!document.body.classList.contains('offline') && document.getElementById('health').className !== 'bad'", 30)
time.sleep(3.0)
page.screenshot(out)
print(out, "written;", "console:", page.console)
page.end()
viewer.end()
