# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, driven by the standard protocol of WebDriver (W3C), with the standard library only."""

import base64
import json
import re
import shutil
import subprocess
import time
import urllib.request
from pathlib import Path

# No graphics card is needed, nor a sandbox, which root has none of. The test has no need of the network.
ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--proxy-server=127.0.0.1:9", "--disable-background-networking"]

PATIENCE = 300  # seconds, for an answer of the page; a busy machine without a graphics card draws a large mesh slowly


def missing():
    """The names of programs that are needed and not there."""
    return [name for name in ("chromium", "chromedriver") if not shutil.which(name)]


class Browser:
    def __init__(self, folder):
        """The folder is for the profile. Ends with close()."""
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        self.address = "http://127.0.0.1:%d" % self._port()
        options = {"binary": shutil.which("chromium"), "args": ARGUMENTS + [f"--user-data-dir={folder}"]}
        wanted = {"browserName": "chrome", "timeouts": {"script": 1000 * PATIENCE}, "goog:loggingPrefs": {"browser": "ALL"}, "goog:chromeOptions": options}
        self.session = ""
        try:
            started = self._call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
        except OSError:
            self.driver.kill()
            raise
        self.session = "/session/" + started["sessionId"]

    def _port(self):
        for line in self.driver.stdout:
            found = re.search(r"started successfully on port (\d+)", line)
            if found:
                return int(found.group(1))
        raise OSError("chromedriver does not start")

    def _call(self, method, path, content=None):
        data = None if content is None else json.dumps(content).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"}, method=method)
        with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=PATIENCE + 20) as answer:
            return json.load(answer)["value"]

    def close(self):
        try:
            self._call("DELETE", self.session)
        finally:
            self.driver.terminate()
            self.driver.communicate()

    def open(self, url, width, height):
        self._call("POST", self.session + "/window/rect", {"width": width, "height": height})
        self._call("POST", self.session + "/url", {"url": url})

    def run(self, script, *arguments):
        """What the body of a function in JavaScript returns, two frames after it."""
        value = self._call("POST", self.session + "/execute/sync", {"script": script, "args": list(arguments)})
        self._call("POST", self.session + "/execute/async", {
            "script": "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()))", "args": []})
        return value

    def pointer(self, selector, start, end, button=0):
        """Drags from one place of an element to another; places in pixels from its middle."""
        element = self._call("POST", self.session + "/element", {"using": "css selector", "value": selector})
        steps = [{"type": "pointerMove", "duration": 50 * i, "origin": element, "x": x, "y": y} for i, (x, y) in enumerate((start, end))]
        steps[1:1] = [{"type": "pointerDown", "button": button}]
        steps.append({"type": "pointerUp", "button": button})
        self._call("POST", self.session + "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": steps}]})
        self.run("return 0")

    def scroll(self, selector, delta):
        element = self._call("POST", self.session + "/element", {"using": "css selector", "value": selector})
        step = {"type": "scroll", "origin": element, "x": 0, "y": 0, "deltaX": 0, "deltaY": delta, "duration": 0}
        self._call("POST", self.session + "/actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [step]}]})
        time.sleep(0.2)  # the event comes later
        self.run("return 0")

    def screenshot(self, path):
        """A PNG file of what the window shows."""
        Path(path).write_bytes(base64.b64decode(self._call("GET", self.session + "/screenshot")))

    def heap(self):
        """Bytes of the page's objects that something refers to. Those of workers are not among them."""
        for method in ("HeapProfiler.enable", "HeapProfiler.collectGarbage", "Performance.enable"):
            self._devtools(method)
        metrics = {entry["name"]: entry["value"] for entry in self._devtools("Performance.getMetrics")["metrics"]}
        return metrics["JSHeapUsedSize"]

    def _devtools(self, method):
        return self._call("POST", self.session + "/goog/cdp/execute", {"cmd": method, "params": {}})

    def messages(self):
        """What was written to the console since the last call, errors and warnings."""
        log = self._call("POST", self.session + "/se/log", {"type": "browser"})
        return [entry["message"] for entry in log if entry["level"] in ("SEVERE", "WARNING")]
