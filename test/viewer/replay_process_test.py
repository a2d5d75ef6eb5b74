#!/usr/bin/env python3
"""Recordings in the page: scrub, step, speed, loop, marks, jumps to events, a second log beside, links; and that none of it acts.

    replay_process_test.py BIN_FOLDER [SCREENSHOT.png [--all]]        in a private network namespace
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time

from process_tools import Checks, Process, binary, console_is_clean
from web_socket import WebSocket

check = Checks()
bin_folder = sys.argv[1]
pictures = sys.argv[2] if len(sys.argv) > 2 else None
twinbus, viewer_program = binary(bin_folder, "twinbus"), binary(bin_folder, "twinbus_log_viewer")
folder = pathlib.Path(tempfile.mkdtemp())
runs = folder / "runs"
HEAD = struct.Struct(">IqqII")
STOP_KIND = 104  # offset in an encoded STATE: behind the type hash, 9 int64, 5 int32, 1 int16, source and role


def events_of(data):
    at = 0
    while at + HEAD.size <= len(data):
        _, number, utime, name, size = HEAD.unpack_from(data, at)
        yield at, utime, data[at + 28:at + 28 + name], at + 28 + name, size
        at += HEAD.size + name + size


def record(name, *words):
    """A run in one process, as a run folder."""
    (runs / name).mkdir(parents=True)
    file = runs / name / "run.log"
    subprocess.run([twinbus, "run", "sway", "--for", "6", "--log", file, *words], stdout=subprocess.DEVNULL, check=False)
    return file


first, second = record("2026-01-01-000001"), record("2026-01-01-000002", "--set", "model.mass_scale=1.05")
data = bytearray(first.read_bytes())
start = next(events_of(data))[1]
for _, utime, channel, at, size in events_of(bytes(data)):  # a stop from second 2 to 3
    if channel == b"STATE" and 2.0 < 1e-6 * (utime - start) < 3.0:
        data[at + STOP_KIND] = 2
first.write_bytes(data)
os.utime(first, (2e9, 2e9))  # the newest

viewer = Process(viewer_program, "--port", "0", "--no-open", "--runs", str(runs))
line = viewer.wait_for("ready at ") or ""
match = re.search(r"http://127\.0\.0\.1:(\d+)/#token=([0-9a-f]{32})$", line)
check(match is not None and str(first) in line, "without a name the newest run is shown: " + line)
if not match:
    print(viewer.drain())
    check.finish()
PORT, TOKEN = int(match[1]), match[2]


class Page(WebSocket):
    def __init__(self, token=""):
        super().__init__(PORT, "/ws" + (f"?token={token}" if token else ""), f"http://127.0.0.1:{PORT}")
        self.newest = {}

    def ask(self, **request):
        self.send(json.dumps(request))

    def wait_for(self, kind, condition=None, seconds=60.0):
        """The next message of that kind; with a condition also the newest that came already: a recording at rest says things once."""
        if condition and kind in self.newest and condition(self.newest[kind]):
            return self.newest[kind]
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            message = json.loads(self.receive())
            self.newest[message["type"]] = message
            if message["type"] == kind and (condition is None or condition(message)):
                return message
        return None


# --- over the socket ---
page = Page(TOKEN)
state = page.wait_for("replay")
check(state["log"] == "2026-01-01-000001" and not state["playing"] and 5.5 < state["duration"] < 6.5, "it stands at the beginning")
page.ask(do="seek", s=3.5)
state = page.wait_for("replay", lambda m: abs(m["position"] - 3.5) < 1e-3)
check(state is not None, "seek goes there")
live = page.wait_for("live", lambda m: abs(m["log_s"] - 3.5) < 1e-3)
page.ask(do="step", by=1)
after = page.wait_for("live", lambda m: m["tick"] == live["tick"] + 1)
page.ask(do="step", by=-1)
check(after is not None and page.wait_for("live", lambda m: m["tick"] == live["tick"]) is not None, "step goes to the next state and back")
page.ask(do="seek", s=1.0)
page.ask(do="seek", s=3.5)
again = page.wait_for("live", lambda m: m["log_s"] == live["log_s"])
check(again is not None and again["q"] == live["q"] and max(abs(a - b) for a, b in zip(again["base"], live["base"])) < 2e-3,
      "a moment looks the same whenever it is visited")
page.ask(do="speed", x=4)
page.ask(do="mark", **{"in": 2.0, "out": 2.4})
page.ask(do="loop", on=True)
page.ask(do="seek", s=2.0)
page.ask(do="play")
page.wait_for("replay", lambda m: m["playing"] and m["position"] < 2.5)
seen = [page.wait_for("replay")["position"] for _ in range(60)]
check(max(seen) <= 2.5 and sum(b < a - 0.1 for a, b in zip(seen, seen[1:])) >= 1, f"it loops from in to out ({min(seen):.2f} to {max(seen):.2f} s)")
page.ask(do="mark", **{"in": None, "out": None})
page.ask(do="loop", on=False)
page.ask(do="seek", s=5.0)
page.ask(do="play")  # a busy machine may have come to the end already
ended = page.wait_for("replay", lambda m: not m["playing"] and m["position"] > 5.5)
check(ended is not None, "at the end it stops")
page.ask(do="beside", log="2026-01-01-000002", shift=0)
page.ask(do="seek", s=4.0)
other = page.wait_for("live", lambda m: "other" in m and abs(m["log_s"] - 4.0) < 1e-3)
check(other is not None and 1e-5 < max(abs(a - b) for a, b in zip(other["other"]["q"], other["q"])) < 0.1, "the second log stands beside, a little different")
check(abs(other["other"]["tick"] - other["tick"]) <= 1, "at the same tick")
signals = page.wait_for("signals", lambda m: "RESIDUAL" in m)
check(signals is not None and len(signals["RESIDUAL"]["q"]) == 29 and "left_foot" in signals["RESIDUAL"]["wrench"], "with residuals to plot")
marks = Page(TOKEN).wait_for("marks")["marks"]
stops = [m for m in marks if m[1] == "stop"]
check([round(m[0]) for m in stops] == [2, 3] and any(m[1] == "switch" for m in marks), f"switch and stops are found: {stops}")
watcher = Page()
watcher.ask(do="seek", s=0.0)
check(watcher.wait_for("note") is not None and abs(watcher.wait_for("replay")["position"] - 4.0) < 1e-3, "without the token a page watches")
watcher.close()
for request in ({"do": "open", "log": "../../etc/passwd"}, {"do": "beside", "log": str(second), "shift": 0}):
    page.ask(**request)
    check("no log" in page.wait_for("shelf", lambda m: request["log"] in m["trouble"])["trouble"], f"{request['log']} is not on the shelf")
page.ask(do="stop", kind=1)
check("nothing to stop" in page.wait_for("note")["text"], "a stop is told that nothing moves")
page.ask(do="beside", log="", shift=0)
page.close()

# --- in a browser ---
from browser import Browser, find_browser  # noqa: E402
from pictures import compare  # noqa: E402
if not find_browser():
    print("no chromium: the page itself is not looked at")
    viewer.end()
    check.finish()
browser = Browser(f"http://127.0.0.1:{PORT}/#token={TOKEN}", (1440, 810) if pictures else (1200, 720))
text = "document.getElementById('%s').textContent"
at = "twinbus.timeline.state.position"


def picture(name):
    if pictures:
        time.sleep(2.0)
        browser.screenshot(pictures.replace(".png", f"_{name}.png"))


check(browser.wait_for(text % "badge-name" + " === 'REPLAY'", 30), "the badge says REPLAY")
check(browser.wait_for(text % "badge-detail" + ".includes('recorded from simulator')"), browser.value(text % "badge-detail"))
check(browser.value("getComputedStyle(document.getElementById('stop').parentElement).display") == "none", "there is no STOP, for nothing moves")
check(browser.wait_for("document.querySelectorAll('#tl-marks i').length >= 3"), "events are on the line of time")
browser.value("twinbus.timeline.seek(1)")
browser.wait_for(f"Math.abs({at} - 1) < 0.01")
browser.value("document.getElementById('tl-kind').value = 'stop'")
browser.key("]", "BracketRight")
check(browser.wait_for(f"Math.abs({at} - 2) < 0.02"), "] jumps to the stop")
check(browser.wait_for("document.getElementById('health').className === 'stopped'"), "and the page shows the stop: " + browser.value(text % "health-text"))
browser.key("[", "BracketLeft")
check(browser.wait_for(text % "toast" + ".includes('No such event')"), "before it there is none")
before = browser.value(at)
browser.key("ArrowRight", "ArrowRight")
check(browser.wait_for(f"{at} > {before} && {at} < {before} + 0.01"), "→ steps")
browser.key("i", "KeyI")
check(browser.wait_for("twinbus.timeline.state.in !== null"), "I sets a mark")
browser.key("i", "KeyI")
check(browser.wait_for("twinbus.timeline.state.in === null"), "and takes it away")
browser.value("twinbus.link.send({ do: 'speed', x: 0.25 })")  # or it is over before a busy machine looks
browser.key(" ", "Space")
check(browser.wait_for(f"twinbus.timeline.state.playing && {at} > {before} + 0.1"), "space plays")
browser.key(" ", "Space")
check(browser.wait_for("!twinbus.timeline.state.playing"), "and pauses")
box = browser.value("(r => [r.x, r.width])(document.getElementById('tl-line').getBoundingClientRect())")
browser.click("#tl-line")
check(browser.wait_for(f"Math.abs({at} / twinbus.timeline.state.duration - 0.5) < 0.02"), "the line of time is clicked on")
if not pictures:
    browser.wait_for("document.getElementById('toast').hidden")
    browser.value("twinbus.timeline.seek(4)")
    browser.wait_for(f"Math.abs({at} - 4) < 0.01")
    browser.settle(1.5)
    compare(browser.screenshot(), "replay", check)
if "--all" in sys.argv:
    browser.value("(s => { s.value = '2026-01-01-000002'; s.onchange(); })(document.getElementById('tl-beside'))")
    check(browser.wait_for("twinbus.other.model?.visible"), "the second log is a ghost")
    browser.value("twinbus.timeline.seek(5.5)")
    browser.wait_for(f"Math.abs({at} - 5.5) < 0.01")
    browser.key("p", "KeyP")
    check(browser.wait_for("twinbus.history.count > 100", 30), "the seconds before are there to plot")
    browser.value("twinbus.plots.preset('Two logs')")
    check(browser.wait_for("twinbus.plots.plots.length === 3 && twinbus.plots.plots[2].names.length === 6 && twinbus.plots.plots.every((p) => p.chart)"),
          "forces, joint and residuals of both are plotted")
    picture("two_logs")
    browser.value("twinbus.plots.seek(4.25)")
    check(browser.wait_for(f"Math.abs({at} - 4.25) < 0.01"), "a click on a plot goes there")
    browser.value("twinbus.stage.follow = false; twinbus.stage.camera.position.set(1.2, -2.4, 1.1); twinbus.stage.controls.target.set(0, 0, 0.6)")
    browser.key("y", "KeyY")
    link = browser.value("location.href")
    check("t=4.25" in link and "with=" in link and "cam=1.2" in link and "plots=" in link, "Y gives a link: " + link[:90] + " ...")
    browser.end()
    viewer.end()
    viewer = Process(viewer_program, link, "--port", "0", "--no-open", "--runs", str(runs))
    address = re.search(r"http://\S+", viewer.wait_for("ready at "))[0]
    browser = Browser(address, (1440, 810))
    check(browser.wait_for("twinbus.timeline?.state?.beside && Math.abs(twinbus.timeline.state.position - 4.25) < 0.01", 30),
          "./twinbus view LINK shows the same log, second log and time")
    check(browser.wait_for("Math.abs(twinbus.stage.camera.position.x - 1.2) < 0.02 && !twinbus.stage.follow"), "from the same place")
    check(browser.wait_for("twinbus.plots.plots.length === 3 && twinbus.plots.plots.every((p) => p.chart)"), "with the same plots")
    check(browser.wait_for("twinbus.history.count > 100", 30), "and curves in them")
    picture("link")
console_is_clean(check, browser, "WebSocket", "GPU stall")
browser.end()
check(viewer.end() == 0, "it ends cleanly")
for words in (["--port", "x"], ["--what"]):
    check(Process(viewer_program, *words).child.wait(10) == 2, f"{' '.join(words)} is bad arguments")
for words in (["/nothing.log"], ["http://127.0.0.1/#t=3"], ["--robot", "biped12", "--runs", str(runs)]):
    bad = Process(viewer_program, *words, "--no-open")
    check(bad.child.wait(20) == 1 and bad.wait_for("twinbus_log_viewer: ") is not None, f"{words[0]}: one line and exit 1: {bad.seen[-1:]}")
subprocess.run(["rm", "-rf", folder], check=False)
check.finish()
