#!/usr/bin/env python3
"""Soles, hands and IMU in the set-up sheet of a running stack: seen on the robot, moved with the mouse, written, and used by the next start.

    robot_sheet_test.py BIN_FOLDER [SCREENSHOT.png]        in a private network namespace
"""
import glob
import re
import shutil
import sys
import tempfile

from browser import Browser, find_browser
from process_tools import Checks, console_is_clean, stack_with_page

if not find_browser():
    print("no chromium: skipped")
    sys.exit(77)
check = Checks()
bin_folder = sys.argv[1]
runs = tempfile.mkdtemp()
up, line = stack_with_page(check, bin_folder, runs)
page = Browser(re.search(r"http://\S+", line)[0], (1280, 900))
check(page.wait_for("globalThis.twinbus?.figures.first", 60), "the page draws the robot")
page.value("document.body.focus(); twinbus.stage.follow = false")
page.key("s", "KeyS")
check(page.wait_for("document.querySelectorAll('#limbs .limb').length === 5", 60), "S shows two soles, two hands and the IMU")
page.settle(0.3)

# Where on the screen the end of an arrow of the handles is: AXIS 0 is x; FAR of the arrow's length from the middle.
POINT = """((axis, far) => {
  const { stage: { camera }, limbs } = twinbus, { handle } = limbs.drawn.get(limbs.chosen);
  handle.updateWorldMatrix(true, false);
  const middle = handle.position.clone().setFromMatrixPosition(handle.matrixWorld);
  const arrow = middle.distanceTo(camera.position) * 1.9 * Math.tan(Math.PI * camera.fov / 360) * limbs.handles.size / 8;
  const at = handle.position.clone().set(0, 0, 0).setComponent(axis, arrow * far).applyMatrix4(handle.matrixWorld).project(camera);
  return [(1 + at.x) / 2 * innerWidth, (1 - at.y) / 2 * innerHeight];
})"""
KNOB = """(edge => {
  const { stage: { camera }, limbs } = twinbus, knob = limbs.drawn.get(limbs.chosen).knobs.find(knob => knob.edge === edge);
  knob.updateWorldMatrix(true, false);
  const at = knob.position.clone().setFromMatrixPosition(knob.matrixWorld).project(camera);
  return [(1 + at.x) / 2 * innerWidth, (1 - at.y) / 2 * innerHeight];
})"""


def mouse(kind, at, buttons=0):
    page.call("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button="left" if kind != "mouseMoved" or buttons else "none",
              buttons=buttons, clickCount=1 if kind != "mouseMoved" else 0)


def drag(start, end):
    mouse("mouseMoved", start)
    page.settle()
    mouse("mousePressed", start, 1)
    for share in (0.3, 0.7, 1.0):
        mouse("mouseMoved", [a + share * (b - a) for a, b in zip(start, end)], 1)
    mouse("mouseReleased", end)
    page.settle()


def press(selector):
    page.value(f"document.querySelector('{selector}').scrollIntoView({{ block: 'center' }})")
    page.click(selector)


def chosen(key):
    return page.value(f"JSON.parse(JSON.stringify(twinbus.limbs.chosen?.{key} ?? null))")


def write(label, number):
    """As somebody who types it and goes on with the tabulator."""
    page.value(f"document.querySelector('#limbs input[aria-label=\"{label}\"]').focus(); document.activeElement.select()")
    page.type(str(number))
    page.key("Tab", "Tab")


# --- seen ---
away = page.value("""(() => { const { limbs, robot } = twinbus, limb = limbs.list[0], { carrier } = limbs.drawn.get(limb);
  const link = robot.model.links[limb.frame]; carrier.updateMatrixWorld(true);
  return Math.hypot(...[12, 13, 14].map(i => carrier.matrixWorld.elements[i] - link.matrixWorld.elements[i])); })()""")
check(away is not None and away < 0.02 and page.value("twinbus.limbs.root.visible"), f"the left sole is drawn where the robot's foot is ({away} m)")

# --- moved with the mouse ---
press("#limbs .limb")
page.settle(0.2)
check(chosen("side") == "left" and page.value("document.querySelector('#limbs .limb').ariaPressed") == "true", "a click chooses the left sole")
before = chosen("at")
drag(page.value(POINT + "(0, 0.8)"), page.value(POINT + "(0, 1.3)"))
moved = chosen("at")
check(moved[0] - before[0] > 0.002 and abs(moved[1] - before[1]) < 1e-4 and abs(moved[2] - before[2]) < 1e-4, f"pulled along its x: {before} to {moved}")
check(abs(float(page.value("document.querySelector('#limbs input').value")) - 1000 * moved[0]) < 0.01, "the number follows the mouse")
press("#limb-undo")
check(page.wait_for(f"twinbus.limbs.chosen.at[0] === {before[0]}", 20), "Undo puts it back")
drag(page.value(POINT + "(0, 0.8)"), page.value(POINT + "(0, 1.3)"))
write("y [mm]", 4.5)
check(abs(chosen("at")[1] - 0.0045) < 1e-9, "a number is typed")
press("#limb-size")
page.settle(0.2)
edges = chosen("edges")
knob = page.value(KNOB + "('front')")
middle = page.value(POINT + "(0, 0)")
drag(knob, [k + 0.3 * (m - k) for k, m in zip(knob, middle)])
shorter = chosen("edges")
check(0.001 < shorter["front"] < edges["front"] - 0.005 and shorter["left"] == edges["left"], f"its front edge is pulled in: {edges['front']} to {shorter['front']}")
press("#limbs .limb:nth-child(4)")
press("#limb-rotate")
write("yaw [°]", 30)
check(abs(chosen("rpy")[2] - 0.523599) < 1e-6, "the right hand is turned by a number")
press("#limbs .limb:nth-child(5)")
write("x [mm]", 25)

# --- pairs ---
press("#pick-pair")
# Two links that are seen in the picture, beside the sheet, and where to click at them.
spots = page.value("""(() => { const { pairLine, stage: { camera }, setup } = twinbus, found = [];
  for (const name of setup.choices.links) {
    const at = pairLine.middle(name)?.project(camera);
    if (!at) continue;
    const [x, y] = [(1 + at.x) / 2 * innerWidth, (1 - at.y) / 2 * innerHeight];
    if (document.elementFromPoint(x, y)?.id === 'view' && pairLine.linkAt({ clientX: x, clientY: y }) === name) found.push([name, x, y]);
  }
  return [found[0], found[found.length - 1]]; })()""")
for _, x, y in spots:
    mouse("mousePressed", (x, y), 1)
    mouse("mouseReleased", (x, y))
    page.settle()
pair = [name for name, _, _ in spots]
check(page.value("[twinbus.setup.first.value, twinbus.setup.second.value]") == pair, f"two clicks in the picture pick {pair}")
check(page.value("twinbus.pairLine.group.visible"), "and a line shows them on the robot")
press("#leave-out")

# --- written ---
folder = glob.glob(runs + "/*/setup")[0]
press("#save-robot")
check(page.wait_for("document.getElementById('robot-saved').textContent.startsWith('Saved.')", 60), "Save robot is answered: " + str(page.value("document.getElementById('robot-saved').textContent")))
page.settle(0.3)
if len(sys.argv) > 2:
    press("#limbs .limb")
    page.settle(0.3)
    page.screenshot(sys.argv[2])
file = glob.glob(folder + "/saved/*/robot.yaml")
text = open(file[0]).read() if file else ""


def numbers_of(pattern):
    found = re.search(pattern, text)
    return [float(word) for word in found[1].split(",")] if found else []


def near(found, wanted):
    return len(found) == len(wanted) and all(abs(a - b) < 1e-6 for a, b in zip(found, wanted))


sole = page.value("twinbus.limbs.list[0]")
check(near(numbers_of(r"LFOOT_SOLE[^}]*?at: \[([^\]]*)\]"), sole["at"]), f"the file has the sole's place {sole['at']}")
check(near(numbers_of(r"LFOOT_SOLE[^}]*?front: ([\d.e+-]+)"), [sole["edges"]["front"]]), "and its length")
check(near(numbers_of(r"RHAND\n[\s\S]*?rpy: \[([^\]]*)\]"), [0, 0, 0.523599]), "the hand's turn")
check(near(numbers_of(r"imu: \{frame: IMU, at: \[([^\]]*)\]"), [0.025, 0, 0]), "and the IMU's place")
srdf = open(glob.glob(folder + "/saved/*/*.srdf")[0]).read()
check(any(f'link1="{a}" link2="{b}"' in srdf for a, b in (pair, pair[::-1])), "and the pair that is left out")
check(not glob.glob(folder + "/.draft") and not glob.glob(folder + "/saved/.draft"), "nothing half done is left")
check(not glob.glob(folder + "/*/robot.yaml"), "and what a start is made of is untouched")

# --- refused ---
page.value("twinbus.limbs.choose(twinbus.limbs.list[0])")
write("front [mm]", 5000)
press("#save-robot")
check(page.wait_for("document.getElementById('robot-saved').textContent.startsWith('robot not saved')", 60), "a sole of 5 m is refused: " + str(page.value("document.getElementById('robot-saved').textContent")))
check(open(file[0]).read() == text, "and nothing is written")
press("#limb-undo")

# --- used ---
press("#start-anew")
check(up.wait_for("set up as the page asked", 60) is not None, "Start anew starts with it")
length = sole["edges"]["front"] + sole["edges"]["back"]
FOOT = "(s => s && Math.hypot(...[0, 1, 2].map(i => s[0][i] - s[1][i])))(globalThis.twinbus.seen?.soles?.[0])"
page.value("(() => { const { on } = twinbus.link, live = on.live; on.live = message => { twinbus.seen = message; live(message); }; })()")
check(page.wait_for(f"Math.abs({FOOT} - {length}) < 0.002", 60), f"the robot that runs has a sole of {length:.3f} m: {page.value(FOOT)}")
check(page.wait_for("twinbus.panels.online && twinbus.seen.age_ms < 200", 40), "and it is there")
page.settle(0.5)
console_is_clean(check, page, "GPU stall", "WebSocket", "ERR_CONNECTION")
page.end()
check(up.end(15) is not None, "it ends")
shutil.rmtree(runs, ignore_errors=True)
check.finish()
