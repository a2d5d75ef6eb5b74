#!/usr/bin/env python3
"""The page in a real browser against a fake stack: what it shows, and that its buttons and keys reach the bus.

    page_process_test.py BIN_FOLDER [SCREENSHOT.png [--all]]        in a private network namespace
"""
import re
import sys
import time

from browser import Browser, find_browser
from process_tools import Checks, Process, binary, console_is_clean

if not find_browser():
    print("no chromium: skipped")
    sys.exit(77)
check = Checks()
bin_folder = sys.argv[1]
fake = Process(binary(bin_folder, "fake_robot"))
fake.wait_for("ready")
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open")
address = re.search(r"http://\S+", viewer.wait_for("ready at ", 10))[0]
size = (1600, 900) if len(sys.argv) > 2 else (1200, 720)
page = Browser(address, size)
pictures = sys.argv[2] if len(sys.argv) > 2 else None


def picture(name):
    if pictures:
        page.screenshot(pictures.replace(".png", f"_{name}.png"))


text = "document.getElementById('%s').textContent"
check(page.wait_for(text % "badge-name" + " === 'SIMULATOR'", 40), "the badge says SIMULATOR")
check("term 1" in page.value(text % "badge-detail"), "with term and age: " + page.value(text % "badge-detail"))
check(page.wait_for(text % "health-text" + " === 'Running well: sway.'"), "it says that all is well")
check(page.wait_for("/^\\d\\d+ Hz$/.test(" + text % "rate-state" + ")"), "and the rate of STATE")
check(page.wait_for("document.querySelectorAll('#processes tbody tr').length >= 6"), "processes are listed")
check(page.wait_for(text % "mode-now" + " === 'sway'"), "the mode is shown")
check(page.wait_for("document.querySelectorAll('.source').length === 2"), "both sources are listed")
check(page.wait_for("document.querySelectorAll('.pair').length === 2"), "and the near pairs")
page.settle(1.0)
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2])

# --- the bar at the top may have any height: nothing lies under it, and messages can be read ---
UNDER = """(() => { const edge = document.querySelector('header').getBoundingClientRect().bottom;
  return [...document.querySelectorAll('aside h2, #setup, #parts, #past, #eye')].filter((e) => { const r = e.getBoundingClientRect();
    return r.height > 0 && getComputedStyle(e).visibility !== 'hidden' && r.top < edge; }).map((e) => e.id || e.textContent); })()"""
LINES = """(e => { const r = e.getBoundingClientRect(); const line = parseFloat(getComputedStyle(e).lineHeight);
  const seen = document.elementFromPoint(r.x + 20, r.bottom - 4);
  return seen && e.parentElement.contains(seen) ? Math.min(r.height, innerHeight - r.top) / line : 0; })(document.getElementById('events'))"""
for width, height in ((1280, 720), (1440, 810)):
    page.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
    for bar in (0, 60):
        page.value(f"document.getElementById('health').style.paddingBottom = '{8 + bar}px'")
        for letter, code in (("", ""), ("q", "KeyQ"), ("s", "KeyS"), ("l", "KeyL")):
            if letter:
                page.key(letter, code)
            page.settle()
            under, lines = page.value(UNDER), page.value(LINES)
            check(under == [] and lines >= 3.0, f"at {width}x{height}, the bar {bar} px higher, {letter or 'no'} key: nothing under the bar {under}, {lines:.1f} lines of messages")
            if letter:
                page.key(letter, code)
    page.value("document.getElementById('health').style.paddingBottom = ''")
    page.settle()
    check(page.value("(r => r.bottom <= document.getElementById('right').getBoundingClientRect().bottom)(document.querySelector('#processes tr:last-child').getBoundingClientRect())"),
          f"at {width}x{height}: the last process is seen")
page.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False)
page.settle()
fake.drain()
page.click("#modes [data-mode=squat]")
check(fake.wait_for("mode 42 run 1001") is not None, "Squat asks for squat")
page.click(".source button")
check(fake.wait_for("source 4 run 1002") is not None, "Switch asks the other source to follow")
check(fake.wait_for("source 2 run 1002") is not None, "and then to take over")

# --- looking closer ---
page.key("g", "KeyG")
page.key("j", "KeyJ")
check(page.wait_for("twinbus.commanded.model?.visible && twinbus.standby.model?.visible"), "two ghosts are shown")
check(page.value("Math.abs(twinbus.standby.joints[1].angle - twinbus.robot.joints[1].angle - 0.03) < 0.02"), "each in its own posture")
page.key("g", "KeyG")
page.key("j", "KeyJ")
page.key("?", "Slash")
check(page.value("!document.getElementById('keys').hidden && document.querySelectorAll('#keys kbd').length > 10"), "? shows the keys")
picture("keys")
page.key("?", "Slash")
page.key("t", "KeyT")
check(page.value("document.body.classList.contains('light')"), "T is light")
time.sleep(0.5 if pictures else 0)
picture("light")
page.key("t", "KeyT")

# --- plots ---
page.key("p", "KeyP")
check(page.wait_for("document.querySelectorAll('.plot canvas').length === 3"), "P opens three plots of the ZMP")
check(page.value("twinbus.history.columns.size") > 150, f"of {page.value('twinbus.history.columns.size')} numbers that are kept")
if "--all" in sys.argv:  # longer than every change can wait for
    check(page.wait_for("twinbus.plots.plots[0].chart.data[1].filter((v) => v !== null).length > 4"), "with curves in them")
    time.sleep(3.0 if pictures else 0)
    picture("plots")
    page.click("#plot-box .presets button:nth-child(4)")
    check(page.wait_for("twinbus.plots.plots[0]?.names.length === 6"), "the tracking error of the six worst joints")
    check(page.value("twinbus.plots.plots[0].names.includes('TRACKING.q.' + twinbus.history.joints[0])"), "the one that is wrong among them")
    page.click("#plot-box input")
    page.type("knee tau")
    check(page.wait_for("document.querySelectorAll('.found li').length === 4"), "a number is found by typing")
    check("STATE.tau.LLEG_KNEE" in page.value("document.querySelector('.found').textContent"), "by its name")
    page.click(".found li")
    check(page.wait_for("twinbus.plots.plots.length === 2 && twinbus.plots.plots[1].names[0].includes('tau')"), "and plotted")
    page.value("twinbus.plots.csv()")
    lines = page.value("twinbus.plots.lastCsv").splitlines()
    check(lines[0].startswith("time_s,TRACKING.q.") and len(lines) > 4, f"CSV of {len(lines)} rows")
    check(page.wait_for("twinbus.plots.plots.every((plot) => plot.chart)"), "charts are drawn")
    page.click(".plot .area")
    check(page.wait_for("document.body.classList.contains('past')"), "a click on a plot looks back")
    check("robot time" in page.value(text % "past-text"), page.value(text % "past-text"))
    page.settle(0.5)
    shown = page.value("twinbus.robot.joints[0].angle")
    page.settle(0.5)
    check(page.value("twinbus.robot.joints[0].angle") == shown, "the picture stands still")
    check(page.value(text % "badge-name") == "SIMULATOR", "the badge stays with the present")
    picture("past")
    page.click("#present")
    check(page.wait_for("!document.body.classList.contains('past')"), "and is back in the present")
    page.key("p", "KeyP")

    # --- driving ---
    fake.drain()
    page.drag("#joystick", 0, -48)
    check(fake.wait_for("mode 50 run 1001") is not None, "the stick asks for walking")
    check(fake.wait_for("walk 0.30 ") is not None, "pulled up it walks forward")
    picture("walk")
    page.release()
    check(fake.wait_for("walk 0.00 ") is not None, "let go it stands")
    page.click("#reach [data-side=right]")
    check(page.wait_for("twinbus.target.ball.visible"), "a handle appears at the right hand")
    page.value("(t => { t.handles.dispatchEvent({ type: 'dragging-changed', value: true }); t.ball.position.z += 0.1;"
               " t.handles.dispatchEvent({ type: 'dragging-changed', value: false }); })(twinbus.target)")
    check(fake.wait_for("goal 2 side 2 at ") is not None, "let go, its place is the hand's goal")
    check(page.wait_for("twinbus.armPath.group.visible"), "the planned path is drawn")
    picture("reach")
    page.click("#reach [data-side=right]")
    check(page.value("!twinbus.target.ball.visible"), "and the handle goes")
    fake.drain()
    page.click("#modes [data-mode=sway]")
    check(fake.wait_for("mode 41 ") is not None, "back to swaying")
else:
    page.key("p", "KeyP")

page.key(" ", "Space")
check(fake.wait_for("stop 1") is not None, "space stops, though a button has the focus")
check(page.wait_for("document.body.classList.contains('stopped')"), "and it is seen")
check(page.wait_for(text % "health-text" + ".includes('Stopped')"), page.value(text % "health-text"))
check("mode" not in " ".join(fake.drain()), "nothing else was pressed")
picture("stopped")
check(page.wait_for("!document.getElementById('clear').hidden"), "Clear appears")
page.click("#clear")
check(fake.wait_for("clear 77") is not None, "Clear clears")
page.wait_for("!document.body.classList.contains('stopped')")
page.click("#stop")
check(fake.wait_for("stop") is not None, "the STOP button stops")

fake.end()
check(page.wait_for(text % "badge-name" + " === 'NO SOURCE'"), "a silent source is no source")
picture("silent")
viewer.end()
check(page.wait_for("document.body.classList.contains('offline')"), "and a dead viewer is said")
console_is_clean(check, page, "WebSocket", "GPU stall")
page.end()
check.finish()
