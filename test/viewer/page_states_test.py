#!/usr/bin/env python3
"""The page in seven states at five widths: nothing that is to be read or pressed is covered, every state has its way out, and axe-core finds
nothing serious where it is installed.

    page_states_test.py BIN_FOLDER [--all] [--pictures FOLDER] [--axe axe.min.js] [--log run.log]      in a private network namespace

Without --all: two widths, and no pictures. A real stack of simulator and robot: standing, walking, stopped, loaded, fallen, no source; then a log.
"""
import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

from browser import Browser, find_browser
from process_tools import Checks, Process, binary

parser = argparse.ArgumentParser()
parser.add_argument("bin_folder")
parser.add_argument("--all", action="store_true")
parser.add_argument("--pictures")
parser.add_argument("--log", help="only the replay of this log")
parser.add_argument("--axe", default=os.environ.get("AXE_CORE", ""))
arguments = parser.parse_args()
if not find_browser():
    print("no chromium: skipped")
    sys.exit(77)
bin_folder = os.path.abspath(arguments.bin_folder)
WIDTHS = (390, 900, 1280, 1440, 2560) if arguments.all else (390, 1280)
HEIGHTS = {390: 844, 900: 700, 1280: 720, 1440: 900, 2560: 1440}
check = Checks()
runs = tempfile.mkdtemp()
os.environ["TWINBUS_RUNS"] = runs
axe = pathlib.Path(arguments.axe).read_text() if arguments.axe else ""
if arguments.pictures:
    os.makedirs(arguments.pictures, exist_ok=True)

# What lies on what: of everything to be read or pressed, five places must belong to it. What is scrolled out of its box is reached by scrolling.
COVERED = """
(() => {
  const seen = (e) => { const r = e.getBoundingClientRect(); const s = getComputedStyle(e);
    return r.width > 4 && r.height > 4 && s.visibility !== 'hidden' && s.display !== 'none' && s.opacity !== '0'; };
  const box = (e) => { let r = e.getBoundingClientRect(); let [l, t, w, b] = [r.left, r.top, r.right, r.bottom];
    for (let p = e.parentElement; p; p = p.parentElement) if (/auto|scroll|hidden/.test(getComputedStyle(p).overflow + getComputedStyle(p).overflowY)) {
      const q = p.getBoundingClientRect(); l = Math.max(l, q.left); t = Math.max(t, q.top); w = Math.min(w, q.right); b = Math.min(b, q.bottom); }
    return [l, t, w, b]; };
  const name = (e) => e.id ? '#' + e.id : e.tagName.toLowerCase() + (e.textContent.trim() ? ' "' + e.textContent.trim().slice(0, 24) + '"' : '.' + e.className);
  const wrong = [];
  for (const e of document.querySelectorAll('button, input, select, #badge, #health, h2, dd, .hint, .pair, #toast, #past')) {
    if (e.closest('[hidden]') || e.closest('.unseen') || !seen(e)) continue;
    const [l, t, r, b] = box(e);
    if (r - l < 6 || b - t < 6) continue;
    if (l < -1 || t < -1 || r > innerWidth + 1 || b > innerHeight + 1) { wrong.push(name(e) + ' sticks out'); continue; }
    if (getComputedStyle(e).pointerEvents === 'none') continue;
    for (const [x, y] of [[.5, .5], [.1, .3], [.9, .3], [.1, .7], [.9, .7]]) {
      const top = document.elementFromPoint(l + x * (r - l), t + y * (b - t));
      if (top && top !== e && !e.contains(top) && !top.contains(e)) { wrong.push(name(e) + ' under ' + name(top)); break; }
    }
  }
  return wrong;
})()
"""
VISIBLE = "(e => !!e && !e.hidden && !e.disabled && e.getBoundingClientRect().height > 8)(document.querySelector('%s'))"


def look(page, state, width, ways_out):
    page.call("Emulation.setDeviceMetricsOverride", width=width, height=HEIGHTS[width], deviceScaleFactor=1, mobile=width < 500)
    page.value("window.dispatchEvent(new Event('resize'))")
    time.sleep(1.0)
    covered = page.value(COVERED)
    check(not covered, f"{state} at {width}: nothing is covered {covered[:5] if covered else ''}")
    out = [way for way in ways_out if page.value(VISIBLE % way)]
    said = page.value("document.getElementById('health-text').textContent")
    check(bool(out), f"{state} at {width}: a way out, one of {' '.join(ways_out)}: \"{said}\"")
    check(page.value("document.documentElement.scrollWidth <= innerWidth"), f"{state} at {width}: nothing sticks out")
    if arguments.pictures:
        page.screenshot(f"{arguments.pictures}/{state.replace(' ', '_')}_{width}.png")
    if axe:
        page.value(axe)
        page.value("globalThis.axed = null; axe.run(document, {resultTypes: ['violations']}).then((r) => { globalThis.axed = r.violations.filter((v) => /serious|critical/.test(v.impact))"
                   ".map((v) => v.id + ': ' + v.nodes.slice(0, 3).map((n) => n.target).join(' | ')); })")
        page.wait_for("globalThis.axed !== null", 60)
        found = page.value("globalThis.axed")
        check(not found, f"{state} at {width}: axe-core finds nothing serious {found or ''}")


def everywhere(page, state, ways_out):
    for width in WIDTHS:
        look(page, state, width, ways_out)


def cli(*words):
    return subprocess.run([binary(bin_folder, "twinbus"), *words], capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)


def health(page, words, seconds=40):
    return page.wait_for(f"/{words}/.test(document.getElementById('health-text').textContent)", seconds)


def child_of(up, program):
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                if f"\nPPid:\t{up.child.pid}\n" in pathlib.Path(f"/proc/{entry}/status").read_text() and os.readlink(f"/proc/{entry}/exe").endswith(program):
                    return int(entry)
            except OSError:
                pass
    return None


def live_states():
    up = Process(binary(bin_folder, "twinbus"), "up", "stand", "--stack", "both")
    address = re.search(r"http://\S+token=\w+", up.wait_for("http://", 90) or "")
    if not address:
        check(False, "the stack runs: " + " ".join(up.seen))
        check.finish()
    page = Browser(address[0], (1280, 720))
    check(page.wait_for("globalThis.twinbus?.figures.first", 90), "the page draws the robot")
    check(health(page, "Running well|edge|Slower|Stopped"), "standing: " + str(page.value("document.getElementById('health-text').textContent")))
    cli("clear")
    everywhere(page, "standing", ["#stop"])
    walk = subprocess.Popen([binary(bin_folder, "twinbus"), "walk", "0.1", "0", "0", "--for", "40" if arguments.all else "15"], stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)
    page.wait_for("document.getElementById('mode-now').textContent.includes('walk')", 20)
    everywhere(page, "walking", ["#stop"])
    walk.send_signal(signal.SIGINT)
    walk.wait(30)
    cli("stop", "hold")
    check(health(page, "Stopped"), "stopped is said")
    everywhere(page, "stopped", ["#clear"])
    cli("clear")
    simulator = child_of(up, "twinbus_simulator")
    pulses = subprocess.Popen([sys.executable, "-c", "import os, signal, sys, time\nend = time.monotonic() + float(sys.argv[2])\nwhile time.monotonic() < end:\n"
                               "    os.kill(int(sys.argv[1]), signal.SIGSTOP); time.sleep(0.02); os.kill(int(sys.argv[1]), signal.SIGCONT); time.sleep(0.03)\n",
                               str(simulator), "60" if arguments.all else "20"])
    health(page, "Slower|Stopped|edge", 20)
    everywhere(page, "loaded", ["#stop", "#clear"])
    pulses.wait()
    cli("clear")
    time.sleep(1.0)
    cli("push", "CHEST", "0", "1500", "0", "--for", "0.2")
    check(health(page, "fallen", 30), "fallen is said: " + str(page.value("document.getElementById('health-text').textContent")))
    time.sleep(2.0)
    everywhere(page, "fallen", ["#anew"])
    os.kill(simulator, signal.SIGSTOP)
    check(health(page, "silent|No source|no source", 30), "no source is said: " + str(page.value("document.getElementById('health-text').textContent")))
    everywhere(page, "no source", ["#stop", "#sources button"])
    os.kill(simulator, signal.SIGCONT)
    page.end()
    up.end(20)


if not arguments.log:
    live_states()
log = arguments.log or sorted(pathlib.Path(runs).glob("*/run.log"))[-1]
view = Process(binary(bin_folder, "twinbus_log_viewer"), str(log), "--no-open", "--port", "0")
page = Browser(re.search(r"http://\S+", view.wait_for("http://", 40))[0], (1280, 720))
check(page.wait_for("globalThis.twinbus?.figures.first", 60), "the log is drawn")
everywhere(page, "replay", ["#tl-play"])
page.end()
view.end()
check.finish()
