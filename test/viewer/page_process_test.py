#!/usr/bin/env python3
"""The page in a real browser against a fake stack: what it shows, and that its buttons and keys reach the bus.

    page_process_test.py BIN_FOLDER [SCREENSHOT.png]        in a private network namespace
"""
import re
import sys
import time

from browser import Browser, find_browser
from process_tools import Checks, Process, binary

if not find_browser():
    print("no chromium: skipped")
    sys.exit(77)
check = Checks()
bin_folder = sys.argv[1]
fake = Process(binary(bin_folder, "fake_robot"))
fake.wait_for("ready")
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open")
address = re.search(r"http://\S+", viewer.wait_for("ready at ", 10))[0]
page = Browser(address, (1600, 900) if len(sys.argv) > 2 else (1000, 640))

text = "document.getElementById('%s').textContent"
check(page.wait_for(text % "badge-name" + " === 'SIMULATOR'"), "the badge says SIMULATOR")
check("term 1" in page.value(text % "badge-detail"), "with term and age: " + page.value(text % "badge-detail"))
check(page.wait_for(text % "health-text" + " === 'Running well: sway.'"), "it says that all is well")
check(page.wait_for("/^\\d\\d+ Hz$/.test(" + text % "rate-state" + ")"), "and the rate of STATE")
check(page.wait_for("document.querySelectorAll('#processes tbody tr').length >= 6"), "processes are listed")
check(page.wait_for(text % "mode-now" + " === 'sway'"), "the mode is shown")
check(page.wait_for("document.querySelectorAll('.source').length === 2"), "both sources are listed")
check(page.wait_for("document.querySelectorAll('.pair').length === 2"), "and the near pairs")
time.sleep(1.0)
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2])
fake.drain()
page.click("#modes [data-mode=squat]")
check(fake.wait_for("mode 42 run 1001", 3) is not None, "Squat asks for squat")
page.click(".source button")
check(fake.wait_for("source 2 run 1002", 3) is not None, "Switch asks for the other source")
page.key(" ", "Space")
check(fake.wait_for("stop 1", 3) is not None, "space stops, though a button has the focus")
check(page.wait_for("document.body.classList.contains('stopped')"), "and it is seen")
check("Stopped" in page.value(text % "health-text"), page.value(text % "health-text"))
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2].replace(".png", "_stopped.png"))
check("mode" not in " ".join(fake.drain()), "nothing else was pressed")
check(page.wait_for("!document.getElementById('clear').hidden"), "Clear appears")
page.click("#clear")
check(fake.wait_for("clear 77", 3) is not None, "Clear clears")
page.wait_for("!document.body.classList.contains('stopped')")
page.click("#stop")
check(fake.wait_for("stop", 3) is not None, "the STOP button stops")

fake.end()
check(page.wait_for(text % "badge-name" + " === 'NO SOURCE'"), "a silent source is no source")
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2].replace(".png", "_silent.png"))
viewer.end()
check(page.wait_for("document.body.classList.contains('offline')"), "and a dead viewer is said")
errors = [line for line in page.console if "WebSocket" not in line and "GPU stall" not in line]
check(not errors, f"no errors in the console {errors[:3]}")
page.end()
check.finish()
