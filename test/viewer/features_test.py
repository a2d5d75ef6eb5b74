#!/usr/bin/env python3
"""What is in the picture and what the page does besides driving, each in a browser: terrain, loose bodies, footsteps, camera, arrows, colours,
drag and drop to plots, exports, video, a log, a link, a pad; and that the whole still looks as it did.

    features_test.py BIN_FOLDER        in a private network namespace
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from browser import Browser, find_browser
from pictures import compare
from process_tools import Checks, Process, binary, console_is_clean

if not find_browser():
    print("no chromium: skipped")
    sys.exit(77)
check = Checks()
bin_folder = os.path.abspath(sys.argv[1])
folder = tempfile.mkdtemp()
os.chdir(folder)
os.makedirs("runs/now/setup")
fake = Process(binary(bin_folder, "fake_robot"))
fake.wait_for("ready")
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open", "--run-folder", folder + "/runs/now")
address = re.search(r"http://\S+", viewer.wait_for("ready at "))[0]
page = Browser(address, (1280, 720))
text = "document.getElementById('%s').textContent"
check(page.wait_for("globalThis.twinbus?.figures.first && document.getElementById('health').className === 'good'", 60), "the page draws the robot")
page.value("globalThis.saved = []; HTMLAnchorElement.prototype.click = function () { saved.push(this.download); }")

# --- in the picture ---
shapes = "twinbus.stage.shapes"
check(page.wait_for(f"{shapes}.obstacles.children.length === 1"), "the obstacle is drawn")
check(page.wait_for(f"{shapes}.terrain.children[0]?.count === 2 && {shapes}.terrain.children[0].instanceMatrix.array[12] > 0.5"), "two tiles of terrain")
check(page.wait_for(f"{shapes}.loose.children.length === 2"), "a ball and a cylinder that nothing holds")
before = page.value(f"{shapes}.loose.children[0].position.y")
check(page.wait_for(f"Math.abs({shapes}.loose.children[0].position.y - {before}) > 0.02"), "the ball moves")
page.value("document.getElementById('late').style.display = 'none'")  # whether this machine draws late is its own affair
page.settle(1.0)
compare(page.screenshot(), "live", check)
page.key("t", "KeyT")
page.settle(0.8)
compare(page.screenshot(), "light", check)
page.key("t", "KeyT")
page.click("#modes [data-mode=walk]")
check(page.wait_for(f"{shapes}.steps.children.filter((part) => part.visible).length === 2"), "while it walks, the step to come and the way of the foot")
page.click("#modes [data-mode=sway]")
check(page.wait_for(f"{shapes}.steps.children.every((part) => !part.visible)"), "and then no more")
page.key("e", "KeyE")
check(page.wait_for("!document.getElementById('eye').hidden && document.querySelector('#eye img').naturalWidth === 8"), "E shows the camera's picture")
check(page.wait_for("document.querySelector('#eye figcaption').textContent === 'camera'"), "and says so")
page.value("twinbus.eye.cameAt = -1e9; twinbus.eye.picture = () => {}")
check(page.wait_for("document.querySelector('#eye figcaption').textContent.includes('CAMERA')"), "without one the scene is drawn from there: " + str(page.value("document.querySelector('#eye figcaption').textContent")))
check(page.wait_for("(c => new Set(c.getContext('2d').getImageData(0, 0, 320, 240).data).size)(document.querySelector('#eye canvas')) > 20"), "with something in it")
page.key("e", "KeyE")
TINTS = "(twinbus.robot.warn(twinbus.robot.joints.map((joint) => joint.limit.upper), [{ a: 'RLEG_HIP_R', b: 'WAIST', mm: %d, level: '%s' }]), new Set(twinbus.robot.tint.shown.values()).size)"
check(page.value(TINTS % (8, "close")) == 2, "links that nearly touch, and joints at their limits, are coloured")
check(page.value(TINTS % (28, "")) == 1, "links that are as near in every posture are not")
arrows = "twinbus.stage.forces.shafts.count"
check(page.wait_for(f"{arrows} >= 2"), "forces are arrows")
page.value("(s => { s.value = 200; s.oninput(); twinbus.stage.leastForce = 1e5; })(document.querySelectorAll('#arrow-scale input')[1])")
check(page.wait_for(f"{arrows} === 0"), "and none under the threshold")
page.value("(s => { s.value = 5; s.oninput(); })(document.querySelectorAll('#arrow-scale input')[1])")
page.value("(s => { s.value = 2; s.oninput(); })(document.querySelectorAll('#arrow-scale input')[0])")
check(page.value("twinbus.stage.arrowScale") == 4, "a scale makes them longer")
for key, what, state in (("f", "follow", "!twinbus.stage.follow"), ("c", "forces", "!twinbus.stage.forces.visible"), ("b", "balance", "!twinbus.stage.balance.visible")):
    page.key(key, "Key" + key.upper())
    check(page.value(state), f"{key.upper()} switches off: {what}")
    page.key(key, "Key" + key.upper())

# --- links and joints ---
page.key("q", "KeyQ")
check(page.wait_for("twinbus.parts.open && twinbus.parts.sliders.filter(Boolean).length === twinbus.robot.joints.length && twinbus.parts.rows.length > 30"), "Q shows the tree of links with a slider for each joint")
knee = "twinbus.parts.sliders.find((s) => s && s.name.includes('KNEE'))"
page.value(f"(s => {{ s.input.value = 1.3; s.input.oninput(); }})({knee})")
check(page.wait_for("twinbus.other.made?.visible"), "what is being chosen is a ghost")
page.value(f"globalThis.sent = []; twinbus.parts.send = (request) => sent.push(request); {knee}.input.onchange()")
check(page.value("JSON.stringify(sent)").startswith('[{"do":"pose","joints":{"'), "let go, the joint is asked for: " + page.value("JSON.stringify(sent)"))
page.value("twinbus.parts.rows[0].box.checked = false; twinbus.parts.rows[0].box.onchange()")
meshes = "(n => { twinbus.robot.model.traverse((part) => { if (part.isMesh && !part.visible) ++n; }); return n; })(0)"
hidden, all_meshes = page.value(meshes), page.value("(n => { twinbus.robot.model.traverse((part) => { if (part.isMesh) ++n; }); return n; })(0)")
check(0 < hidden < all_meshes / 4, f"one link is not drawn, {hidden} of {all_meshes} shapes")
page.value("document.querySelector('#parts button').onclick()")
check(page.value(meshes) == 0, "and all of them are again")
page.key("q", "KeyQ")
check(page.wait_for("document.getElementById('parts').hidden && !twinbus.other.made?.visible"), "Q again closes it")

# --- plots ---
page.key("p", "KeyP")
page.wait_for("twinbus.history.count > 60 && twinbus.plots.plots.length === 3", 40)
page.value("twinbus.plots.clear()")
first, second = page.value("twinbus.history.joints.slice(0, 2)")
for typed in (f"= STATE.q.{first} - STATE.q.{second}", f"STATE.q.{first} over STATE.q.{second}"):
    page.value(f"(s => {{ s.value = '{typed}'; s.oninput(); document.querySelector('.found li').click(); s.value = ''; }})(twinbus.plots.search)")
check(page.wait_for("twinbus.plots.plots.length === 2 && twinbus.plots.plots[0].chart?.data[1].some((v) => v !== null)"), "a number that follows from two others is plotted")
check(page.wait_for("twinbus.plots.plots[1].chart?.points > 10 && !!document.querySelector('.plot .area > canvas[aria-label*=over]')"), "and one over the other")
page.value("(s => { s.value = '= STATE.q.NOBODY'; s.oninput(); })(twinbus.plots.search)")
check("was heard" in str(page.value("document.querySelector('.found').textContent")), "what cannot be computed is said")
page.value("(s => { s.value = ''; s.oninput(); document.querySelector('.found').hidden = true; })(twinbus.plots.search); twinbus.plots.keep('mine'); twinbus.plots.preset('ZMP')")
check(page.value("(twinbus.plots.layouts.value = 'mine', twinbus.plots.layouts.onchange(), twinbus.plots.plots.map((p) => p.names[0]).join('|'))")
      == f"= STATE.q.{first} - STATE.q.{second}|STATE.q.{first} over STATE.q.{second}", "a set of plots is kept in the browser")
page.value("twinbus.plots.clear(); twinbus.plots.keep('mine'); twinbus.plots.preset('ZMP')")
check(page.value("twinbus.plots.layouts.hidden && twinbus.plots.plots.length === 3"), "and forgotten")
names = page.value("[...document.querySelectorAll('#plot-box .presets button')].map((b) => b.textContent)")
for i, name in enumerate(names):
    if name == "Two logs":
        continue
    page.value(f"document.querySelectorAll('#plot-box .presets button')[{i}].click()")
    check(page.wait_for("twinbus.plots.plots.length > 0 && twinbus.plots.plots.every((p) => p.chart && p.chart.data.length > 1 && p.chart.data.slice(1).some((c) => c.some((v) => v !== null)))"),
          f"preset {name} has curves")
page.value("twinbus.plots.clear(); twinbus.plots.put('STATE.q.' + twinbus.history.joints[3])")
page.value("""(at => { const data = new DataTransfer(); data.setData('text/plain', 'STATE.tau.' + twinbus.history.joints[3]);
  at.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true })); })(document.querySelector('.plot .area'))""")
check(page.wait_for("twinbus.plots.plots.length === 1 && twinbus.plots.plots[0].names.length === 2"), "a number dragged onto a plot is in it")
page.value("twinbus.plots.put('SHOWN.com.z')")
page.wait_for("twinbus.plots.plots.length === 2 && twinbus.plots.plots.every((p) => p.chart)")
page.click("#plot-box .png")
check(page.wait_for("saved.includes('twinbus_plots.png')"), "PNG is saved")
page.click("#plot-box .csv")
check(page.wait_for("saved.includes('twinbus_plots.csv')"), "and CSV")
page.click(".plot .area")
check(page.wait_for("document.body.classList.contains('past')"), "a click holds the plots")
check(page.value("(([a, b]) => { a.chart.setCursor({ left: 40, top: 10 }, true, true); return a.chart.cursor.idx === b.chart.cursor.idx; })(twinbus.plots.plots)"), "one cursor for all")
page.click("#present")

# --- what is typed into a field is text ---
page.value("document.querySelector('#plot-box input').value = ''")
fake.drain()
page.click("#plot-box input")
for letter in "knee tau":
    page.key(letter, "Space" if letter == " " else "Key" + letter.upper())
check(page.value("document.querySelector('#plot-box input').value") == "knee tau", "'knee tau' is in the field, with its space")
check(page.value("document.querySelectorAll('#plot-box .found li:not(.more)').length") >= 2, "and what it finds is offered")
check(page.value("document.querySelector('#stop small').textContent") == "click", "the button says that no key stops now")
check(page.value("!twinbus.chips || twinbus.stage.follow"), "no letter of it was a key")
page.key("Escape", "Escape")
check(fake.wait_for("stop", 0.7) is None, "and nothing has stopped")
check(page.value("document.querySelector('#stop small').textContent") == "space", "outside the field space stops again")
page.value("document.querySelector('#plot-box select').focus()")
page.key(" ", "Space")
check(fake.wait_for("stop 1", 10) is not None, "also where a list of choices has the focus")
page.value("document.activeElement.blur()")
page.click("#clear")

# --- a link, a video, a log, a pad ---
page.key("f", "KeyF")
page.value("twinbus.stage.camera.position.set(1, 2, 1.5)")
page.key("y", "KeyY")
check(page.wait_for("location.hash.includes('cam=1%2C2%2C1.5') && location.hash.includes('plots=')"), "Y makes an address of camera and plots")
page.key("f", "KeyF")
page.key("p", "KeyP")
page.key("v", "KeyV")
check(page.wait_for("document.getElementById('record').classList.contains('recording')"), "V records a video")
page.settle(2.0)
page.key("v", "KeyV")
check(page.wait_for("saved.includes('twinbus.webm')"), "and saves it as webm")
page.key("r", "KeyR")
check(page.wait_for("document.getElementById('record-log').classList.contains('recording')"), "R records a log: " + str(page.value(text % "toast")))
logs, end = [], time.monotonic() + 40.0
while time.monotonic() < end and not any(log.stat().st_size > 2e6 for log in logs):  # a second or two of everything
    logs = list(pathlib.Path(folder, "runs").glob("*_page/run.log"))
    time.sleep(0.2)
page.key("r", "KeyR")
check(page.wait_for("!document.getElementById('record-log').classList.contains('recording')"), "and ends it: " + str(page.value(text % "toast")))
info = subprocess.run([binary(bin_folder, "twinbus"), "log", "info", logs[0]], capture_output=True, text=True) if logs else None
check(info is not None and info.returncode == 0 and re.search(r"\bLOOSE\b", info.stdout) and re.search(r"\bSTATE\b", info.stdout), "it is a log with everything in it")
fake.drain()
page.value("""globalThis.pad = { connected: true, mapping: 'standard', axes: [0, -1, 0, 0], buttons: Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })) };
  navigator.getGamepads = () => [pad]""")
check(page.wait_for("!document.getElementById('pad').hidden"), "a pad is seen")
page.value("pad.buttons[4].pressed = true")
check(fake.wait_for("walk 0.") is not None, "with the left bumper held its stick walks")
page.value("pad.buttons[4].pressed = false")
check(fake.wait_for("walk 0.00 ") is not None, "let go it stands")
page.value("pad.buttons[1].pressed = true")
check(fake.wait_for("stop 1") is not None, "B stops")
console_is_clean(check, page, "GPU stall")
page.end()
check(viewer.end(10) == 0, "the viewer ends cleanly")
fake.end()
os.chdir("/")
shutil.rmtree(folder, ignore_errors=True)
check.finish()
