#!/usr/bin/env python3
"""--listen: another machine gets nothing without its token, watches and stops with it, and a phone shows what matters.

    phone_test.py BIN_FOLDER [SCREENSHOT.png]        in a private network namespace
"""
import json
import os
import re
import socket
import sys
import time

from browser import Browser, find_browser
from pictures import compare
from process_tools import FAR, Checks, Process, binary, fake_robot_seen_from_afar, console_is_clean
from web_socket import WebSocket

ACTS = ("clear", "source", "mode", "walk", "goal")
check = Checks()
bin_folder = sys.argv[1]
fake = fake_robot_seen_from_afar(bin_folder)


def status(port, target, host=None, extra="", to=FAR):
    with socket.create_connection((to, port), timeout=5) as s:
        s.sendall(f"GET {target} HTTP/1.1\r\nHost: {host or f'{to}:{port}'}\r\nConnection: close\r\n{extra}\r\n".encode())
        answer = s.recv(4096)
    return int(answer.split()[1]) if answer else 0


def reachable(port):
    try:
        socket.create_connection((FAR, port), timeout=2).close()
        return True
    except OSError:
        return False


# --- without --listen nobody else is heard ---
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open")
port = int(re.search(r":(\d+)/#token", viewer.wait_for("ready at "))[1])
check(not reachable(port), "without --listen there is nothing at another address")
viewer.end()
for wrong in ("here", "10.99.99.99", "0.0.0.0.0"):
    bad = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open", "--listen", wrong)
    said = bad.wait_for("--listen", 10) or ""
    check(bad.child.wait(10) == 1 and wrong in said, f"--listen {wrong} is refused: {said[-90:]}")

# --- a forwarded port, as that of a container, has another name ---
AT = "robot.example:8123"
viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open", "--listen", "0.0.0.0", env=dict(os.environ, TWINBUS_VIEWER_AT=AT))
check(f"http://{AT}/#token=" in (viewer.wait_for("watch and stop") or ""), "TWINBUS_VIEWER_AT is the address that is told")
port = int(re.search(r":(\d+)/#token", viewer.wait_for("ready at "))[1])
check(status(port, "/", host=AT) == 200 and status(port, "/", host=AT, extra=f"Origin: http://{AT}\r\n") == 200, "and it is let in")
check(status(port, "/robot.urdf", host=AT) == 403, "to the page only, without a token")
check(status(port, "/", host=AT, extra="Origin: http://evil.example\r\n") == 403 and status(port, "/", host="evil.example:8123") == 403, "no other name is")
check(status(port, "/", host=AT, to="127.0.0.1") == 403, "nor is it on loopback, where any name could point")
viewer.end()

for listen in ("0.0.0.0", FAR):
    viewer = Process(binary(bin_folder, "twinbus_viewer"), "--port", "0", "--no-open", "--listen", listen)
    watch_line = viewer.wait_for("watch and stop") or ""
    watch_host, watch_port, watch = re.search(r"http://([\d.]+):(\d+)/#token=(\w+)", watch_line).groups()
    port, token = re.search(r"http://127.0.0.1:(\d+)/#token=(\w+)", viewer.wait_for("ready at ")).groups()
    port = int(port)
    check(watch_host == FAR and int(watch_port) == port and watch != token, f"--listen {listen} tells an address to watch at: {watch_line[-70:-34]}")
    check(status(port, "/") == 200 and status(port, "/app.js") == 200, "the page itself is for everybody")
    check(status(port, "/robot.urdf") == 403 and status(port, "/robot/meshes/x.stl") == 403, "the robot is not")
    check(status(port, f"/robot.urdf?token={watch}") == 200, "but with the token to watch")
    check(status(port, "/robot.urdf?token=" + "0" * 32) == 403, "a wrong one is refused")
    check(status(port, "/", host=f"evil.example:{port}") == 403 and status(port, "/", host=f"127.0.0.1:{port}") == 403, "a foreign Host is refused")
    check(status(port, "/", extra="Origin: http://evil.example\r\n") == 403, "a foreign Origin is refused")
    for given in ("", "?token=" + "0" * 32):
        check(WebSocket(port, "/ws" + given, f"http://{FAR}:{port}", host=FAR).status == 403, "no frames without the token" if not given else "nor with a wrong one")
    check(WebSocket(port, f"/ws?token={watch}", "http://evil.example", host=FAR).status == 403, "nor for a foreign page that knows it")
    check(status(port, "/robot.urdf", to="127.0.0.1") == 200, "on this machine all is as it was")
    check(WebSocket(port, "/ws").status == 101, "and watching needs no token")

    watcher = WebSocket(port, f"/ws?token={watch}", f"http://{FAR}:{port}", host=FAR)
    check(watcher.status == 101, "with the token to watch there are frames")
    watcher.send(json.dumps({"do": "hello"}))
    hello = None
    while hello is None or hello["type"] != "hello":
        hello = json.loads(watcher.receive())
    check(hello["trusted"] is False, "who watches is not trusted")
    fake.drain()
    for request in ({"do": "mode", "mode": "idle"}, {"do": "clear"}, {"do": "walk", "vx": 1, "vy": 0, "wz": 0}, {"do": "cancel"}):
        watcher.send(json.dumps(request))
    time.sleep(0.6)
    said = fake.drain()
    check(not any(line.startswith(ACTS) for line in said), f"nothing that he asks acts {said[:2]}")
    watcher.send(json.dumps({"do": "stop", "kind": 2}))
    check(fake.wait_for("stop 2") is not None, "but his stop")
    actor = WebSocket(port, f"/ws?token={token}", f"http://{FAR}:{port}", host=FAR)
    actor.send(json.dumps({"do": "hello"}))
    while json.loads(actor.receive())["type"] != "live":  # by now the viewer knows what there is to clear
        pass
    actor.send(json.dumps({"do": "clear"}))
    check(fake.wait_for("clear 7", 10) is not None, "with the other token he acts")
    # A crowd from elsewhere leaves room for who is here.
    crowd = []
    for _ in range(70):
        try:
            crowd.append(socket.create_connection((FAR, port), timeout=2))
        except OSError:
            break
    check(status(port, "/", to="127.0.0.1") == 200, "a crowd from elsewhere does not shut out this machine")
    for one in crowd:
        one.close()
    watcher.close()
    actor.close()
    if listen == "0.0.0.0":
        viewer.end()

if not find_browser():
    viewer.end()
    fake.end()
    print("no chromium: the phone's page is not looked at")
    check.finish()

page = Browser(f"http://{FAR}:{port}/#token={watch}", (390, 844), phone=True)
text = "document.getElementById('%s').textContent"
check(page.wait_for(text % "badge-name" + " === 'SIMULATOR'", 40), "on a phone: the badge")
check(page.wait_for("globalThis.twinbus?.figures.first", 40), "the robot is drawn, its description came with the token")
inside = "(r => r.x >= 0 && r.y >= 0 && r.right <= innerWidth && r.bottom <= innerHeight && r.width > %d && r.height > %d)(document.getElementById('%s').getBoundingClientRect())"
check(page.value(inside % (300, 70, "stop")), "STOP is there, wide and whole")
check(page.value(inside % (300, 20, "badge")) and page.value(inside % (300, 20, "health")), "which source, and is it healthy")
check(page.value("document.documentElement.scrollWidth <= innerWidth"), "nothing sticks out")
check(page.value("document.body.classList.contains('no-panels')"), "the panels are put away")
page.value("document.getElementById('late').style.display = 'none'")  # whether this machine draws late is its own affair
page.settle(1.0)
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2])
else:
    compare(page.screenshot(), "phone", check)
page.tap("#show-panels")
check(page.wait_for("!document.body.classList.contains('no-panels')"), "and come with a tap")
check(page.value("getComputedStyle(document.getElementById('joystick').parentElement).display === 'none'"), "without what a watcher may not do")
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2].replace(".png", "_panels.png"))
page.tap("#show-panels")
fake.drain()
page.tap("#stop")
check(fake.wait_for("stop 1") is not None, "STOP stops at the touch")
check(page.wait_for("document.body.classList.contains('stopped')"), "and it is seen")
if len(sys.argv) > 2:
    page.screenshot(sys.argv[2].replace(".png", "_stopped.png"))
console_is_clean(check, page, "GPU stall")
page.end()
viewer.end()
fake.end()
check.finish()
