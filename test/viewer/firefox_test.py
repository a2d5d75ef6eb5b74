#!/usr/bin/env python3
"""The page in Firefox: it tells what runs, draws at a usable pace, and its stop arrives, also where Firefox has no WebGL.

    firefox_test.py BIN_FOLDER [SCREENSHOT.png]        in a private network namespace
"""
import atexit
import base64
import json
import os
import re
import shutil
import sys
import tempfile
import time

from process_tools import Checks, Process, binary, until, console_is_clean
from web_socket import WebSocket

firefox = shutil.which("firefox-esr") or shutil.which("firefox")
if not firefox:
    print("no Firefox: skipped")
    sys.exit(77)
check = Checks()
profile = tempfile.mkdtemp()
with open(profile + "/user.js", "w") as file:  # WebGL by the processor; nothing that calls home
    for name, value in {"webgl.force-enabled": True, "webgl.disabled": False, "network.proxy.type": 0, "app.update.enabled": False,
                        "datareporting.policy.dataSubmissionEnabled": False, "browser.shell.checkDefaultBrowser": False}.items():
        file.write(f'user_pref("{name}", {json.dumps(value)});\n')


class Firefox:
    """WebDriver BiDi over its socket."""

    def __init__(self):
        headless = [] if os.environ.get("DISPLAY") else ["--headless"]
        self.process = Process(firefox, *headless, "--no-remote", "--profile", profile, "--remote-debugging-port", "0", "about:blank")
        atexit.register(shutil.rmtree, profile, ignore_errors=True)
        line = self.process.wait_for("BiDi listening on ws://", 90) or ""
        self.socket = WebSocket(int(re.search(r":(\d+)\s*$", line)[1]), "/session", timeout=90)
        self.number, self.console = 0, []
        self.call("session.new", capabilities={})
        self.call("session.subscribe", events=["log.entryAdded"])
        self.context = self.call("browsingContext.getTree")["contexts"][0]["context"]

    def call(self, method, **parameters):
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.receive())
            if message.get("method") == "log.entryAdded" and message["params"]["level"] == "error":
                self.console.append(str(message["params"].get("text")))
            if message.get("id") == self.number:
                if message["type"] == "error":
                    raise RuntimeError(f"{message['error']}: {message['message']}")
                return message["result"]

    def value(self, script):
        result = self.call("script.evaluate", expression=f"JSON.stringify({script})", awaitPromise=False,
                           target={"context": self.context})
        text = result.get("result", {}).get("value")
        return json.loads(text) if text else None

    def wait_for(self, script, seconds):
        return until(lambda: self.value(script), seconds)

    def key(self, key):
        self.call("input.performActions", context=self.context, actions=[
            {"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]}])


fake = Process(binary(sys.argv[1], "fake_robot"))
fake.wait_for("ready")
viewer = Process(binary(sys.argv[1], "twinbus_viewer"), "--port", "0", "--no-open")
address = re.search(r"http://\S+", viewer.wait_for("ready at ", 20))[0]
page = Firefox()
check("Firefox" in page.value("navigator.userAgent"), page.value("navigator.userAgent"))
page.call("browsingContext.setViewport", context=page.context, viewport={"width": 900, "height": 600})
page.call("browsingContext.navigate", context=page.context, url=address, wait="complete")
check(page.wait_for("globalThis.twinbus?.figures.first ?? 0", 60), f"the page runs {page.console[:3]}")
has_3d = page.value("!document.body.classList.contains('no-3d')")
print("it draws in 3D" if has_3d else "no WebGL in this Firefox: without the 3D picture", flush=True)
check(page.wait_for("document.getElementById('badge-name').textContent === 'SIMULATOR'", 20), "the badge says SIMULATOR")
check(page.wait_for("document.getElementById('health').className === 'good'", 20), "it says that all is well")
counts = "[performance.now(), twinbus.figures.drawn, twinbus.link.received]"
if check.failed:
    print(page.console)
    check.finish()
before = page.value(counts)
time.sleep(5.0)
after = page.value(counts)
pace = [1e3 * (after[i] - before[i]) / (after[0] - before[0]) for i in (1, 2)]
check(pace[0] > 2.0 and pace[1] > 5.0, f"{pace[0]:.1f} pictures and {pace[1]:.0f} messages per second, drawn by the processor")
page.key("p")
check(page.wait_for("twinbus.plots.plots.length === 3 && twinbus.plots.plots.every((p) => p.chart)", 30), "plots are drawn")
page.key("t")
check(page.wait_for("document.body.classList.contains('light')", 10), "light")
if len(sys.argv) > 2:
    time.sleep(2.0)
    with open(sys.argv[2], "wb") as file:
        file.write(base64.b64decode(page.call("browsingContext.captureScreenshot", context=page.context)["data"]))
fake.drain()
page.key(" ")
check(fake.wait_for("stop 1", 10) is not None, "space stops")
check(page.wait_for("document.body.classList.contains('stopped')", 20), "and it is seen")
page.value("(document.getElementById('clear').click(), true)")
check(fake.wait_for("clear 77", 10) is not None, "Clear clears")
console_is_clean(check, page, *([] if has_3d else ["WebGL"]))
page.socket.close()
page.process.end(10)
viewer.end()
fake.end()
check.finish()
