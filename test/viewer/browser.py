"""A headless Chromium that a test looks at a page with: scripts, keys, screenshots, what the console said."""
import atexit
import base64
import json
import re
import shutil
import subprocess
import tempfile
import time

from process_tools import until
from web_socket import WebSocket


def find_browser():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Browser:
    def __init__(self, address, size=(1600, 900), phone=False):
        self.folder = tempfile.mkdtemp()
        self.child = subprocess.Popen(
            [find_browser(), "--headless", "--no-sandbox", "--no-proxy-server", "--enable-unsafe-swiftshader",
             "--hide-scrollbars", "--remote-debugging-port=0", f"--user-data-dir={self.folder}",
             f"--window-size={size[0]},{size[1]}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        atexit.register(self._kill)  # a test that breaks off leaves nothing running
        port = None
        while port is None:
            line = self.child.stderr.readline().decode(errors="replace")
            if not line:
                raise RuntimeError("the browser has ended")
            found = re.search(r"ws://127\.0\.0\.1:(\d+)(/\S+)", line)
            port = found and int(found[1])
        self.drain = subprocess.Popen(["cat"], stdin=self.child.stderr, stdout=subprocess.DEVNULL)
        self.session, self.console, self.number = None, [], 0
        self.socket = WebSocket(port, found[2], timeout=90)
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        self.call("Runtime.enable")
        self.call("Page.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=phone)
        if phone:
            self.call("Emulation.setTouchEmulationEnabled", enabled=True)
        self.call("Page.navigate", url=address)

    def call(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        self.socket.send(json.dumps(request))
        while True:
            message = json.loads(self.socket.receive())
            if message.get("method") == "Runtime.consoleAPICalled" and message["params"]["type"] in ("error", "warning"):
                self.console.append(" ".join(str(a.get("value", a.get("description"))) for a in message["params"]["args"]))
            if message.get("method") == "Runtime.exceptionThrown":
                self.console.append(message["params"]["exceptionDetails"]["exception"].get("description", "exception"))
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(message["error"])
                return message["result"]

    def value(self, script):
        return self.call("Runtime.evaluate", expression=script, returnByValue=True)["result"].get("value")

    def wait_for(self, script, seconds=40.0):
        """Until the script gives something true: as long as a busy machine may need for what an idle one does at once."""
        return until(lambda: self.value(script), seconds)

    def settle(self, seconds=0.0):
        """That long, and until what was said before is in the picture, however slowly the machine draws."""
        time.sleep(seconds)
        drawn = self.value("twinbus.figures.drawn")
        self.wait_for(f"twinbus.figures.drawn > {drawn + 2}")

    def key(self, key, code):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=code, text=key if kind == "keyDown" and len(key) == 1 else "")

    def click(self, selector):
        box = self.value(f"(r => [r.x + r.width / 2, r.y + r.height / 2])(document.querySelector('{selector}').getBoundingClientRect())")
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=box[0], y=box[1], button="left", clickCount=1)

    def tap(self, selector):
        box = self.value(f"(r => [r.x + r.width / 2, r.y + r.height / 2])(document.querySelector('{selector}').getBoundingClientRect())")
        self.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": box[0], "y": box[1]}])
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def drag(self, selector, dx, dy):
        """Presses in the middle and pulls, without letting go: release() does."""
        box = self.value(f"(r => [r.x + r.width / 2, r.y + r.height / 2])(document.querySelector('{selector}').getBoundingClientRect())")
        self.held = (box[0] + dx, box[1] + dy)
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=box[0], y=box[1], button="left", clickCount=1)
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=self.held[0], y=self.held[1], button="left", buttons=1)

    def release(self):
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=self.held[0], y=self.held[1], button="left", clickCount=1)

    def type(self, text):
        self.call("Input.insertText", text=text)

    def screenshot(self, name=None):
        """The bytes of a PNG, also written to the file of that name."""
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        if name:
            with open(name, "wb") as file:
                file.write(data)
        return data

    def _kill(self):
        if self.child.poll() is None:
            self.child.terminate()

    def end(self):
        self.socket.close()
        self.child.terminate()
        self.child.wait(10)
        try:  # ends when the last of Chromium's processes has closed its output, which may take long beside other work
            self.drain.wait(5)
        except subprocess.TimeoutExpired:
            self.drain.kill()
            self.drain.wait()
        shutil.rmtree(self.folder, ignore_errors=True)
