"""A headless Chromium, driven through the DevTools protocol over a pipe: nothing but Python's standard library."""

import fcntl
import json
import math
import os
import select
import shutil
import subprocess
import tempfile
import time

CAP_SECONDS = 5 * 12  # for a start on a machine under load; the script's own waiting for the page is capped at 5 s
WAIT_SECONDS = 5


class BrowserError(Exception):
    """The browser does not start, does not answer, or refuses a command."""


def program():
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if shutil.which(name):
            return shutil.which(name)
    raise BrowserError("Chromium is missing: install Debian's package 'chromium' (packages.txt); "
                       "without it nothing is known about pages, so that this test fails")


def _high(descriptor):
    """The same pipe's end under a number that cannot be 3 or 4."""
    high = fcntl.fcntl(descriptor, fcntl.F_DUPFD, 20)
    os.close(descriptor)
    return high


class Browser:
    """One process with a fresh profile. `events` keeps what pages report, in order."""

    FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run",
             "--disable-sync", "--disable-component-update", "--disable-default-apps", "--disable-dev-shm-usage",
             "--force-color-profile=srgb", "--hide-scrollbars", "--remote-debugging-pipe"]

    def __init__(self):
        self.profile = tempfile.mkdtemp(prefix="asts-browser-")
        child_reads, self.to_browser = (_high(end) for end in os.pipe())
        self.from_browser, child_writes = (_high(end) for end in os.pipe())

        def wire():  # the protocol's descriptors
            os.dup2(child_reads, 3)
            os.dup2(child_writes, 4)

        self.process = subprocess.Popen(
            [program(), *self.FLAGS, f"--user-data-dir={self.profile}", "about:blank"], preexec_fn=wire,
            close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(child_reads)
        os.close(child_writes)
        self.buffer = b""
        self.events = []
        self.number = 0

    def call(self, method, session=None, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to_browser, data):]
        while True:
            answer = self.receive(CAP_SECONDS)
            if answer is None:
                raise BrowserError(f"no answer to {method}")
            if answer.get("id") != self.number:
                continue
            if "error" in answer:
                raise BrowserError(f"{method}: {answer['error']}")
            return answer["result"]

    def receive(self, seconds):
        """The next message, which is kept when it is an event; nothing when none comes in time."""
        end = time.monotonic() + seconds
        while b"\0" not in self.buffer:
            if not select.select([self.from_browser], [], [], max(0, end - time.monotonic()))[0]:
                return None
            chunk = os.read(self.from_browser, 1 << 20)
            if not chunk:
                raise BrowserError(f"Chromium ended ({self.process.wait()})")
            self.buffer += chunk
        text, self.buffer = self.buffer.split(b"\0", 1)
        message = json.loads(text)
        if "method" in message:
            self.events.append(message)
        return message

    def close(self):
        try:
            self.call("Browser.close")
            self.process.wait(10)
        except (BrowserError, subprocess.TimeoutExpired, OSError):
            self.process.kill()
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)
        shutil.rmtree(self.profile, ignore_errors=True)


class Page:
    """A tab. Sizes are CSS pixels."""

    KEYS = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Home": 36, "End": 35, "Tab": 9,
            "Enter": 13, " ": 32, "PageUp": 33, "PageDown": 34}

    def __init__(self, browser, width=800, height=900):
        self.browser = browser
        target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.url = "about:blank"
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.resize(width, height)

    def call(self, method, **params):
        return self.browser.call(method, self.session, **params)

    def resize(self, width, height=900):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 500)

    def media(self, media="screen", scheme="light"):
        self.call("Emulation.setEmulatedMedia", media=media,
                  features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, path):
        self.load(path)
        self.settle()

    def load(self, path):
        self.browser.events.clear()
        self.url = "file://" + os.path.abspath(path)
        result = self.call("Page.navigate", url=self.url)
        if result.get("errorText"):
            raise BrowserError(f"{self.url}: {result['errorText']}")
        end = time.monotonic() + CAP_SECONDS
        while not any(event["method"] == "Page.loadEventFired" for event in self.mine()):
            if time.monotonic() > end:
                raise BrowserError(f"{self.url}: not loaded")
            self.browser.receive(1)

    def mine(self):
        return [event for event in self.browser.events if event.get("sessionId") == self.session]

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def settle(self):
        """Until two more frames have been drawn; 5 s at most."""
        frames = "new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => r(true))))"
        late = f"new Promise(r => setTimeout(() => r(false), {1000 * WAIT_SECONDS}))"
        if not self.evaluate(f"Promise.race([{frames}, {late}])"):
            raise BrowserError(f"no frame within {WAIT_SECONDS} s")

    def problems(self):
        """Errors and warnings of the console, uncaught exceptions, and what the browser logs."""
        found = []
        for event in self.mine():
            params = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                found.append(json.dumps(params["exceptionDetails"]))
            elif event["method"] == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
                found.append(json.dumps(params["args"]))
            elif event["method"] == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
                found.append(params["entry"]["text"])
        return found

    def requests(self):
        """What the page asked for besides itself."""
        urls = [event["params"]["request"]["url"] for event in self.mine()
                if event["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if url.split("#")[0] != self.url]

    # ---- a reader's hands -------------------------------------------------------------------------------------------

    def mouse(self, kind, x, y, button="left", buttons=0, clicks=0):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, clickCount=clicks)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y, "none")
        self.mouse("mousePressed", x, y, buttons=1, clicks=1)
        self.mouse("mouseReleased", x, y, clicks=1)
        self.settle()

    def drag(self, x, y, dx, dy, steps=4):
        self.mouse("mouseMoved", x, y, "none")
        self.mouse("mousePressed", x, y, buttons=1, clicks=1)
        for i in range(1, steps + 1):
            self.mouse("mouseMoved", x + dx * i / steps, y + dy * i / steps, buttons=1)
        self.mouse("mouseReleased", x + dx, y + dy, clicks=1)
        self.settle()

    def press(self, key):
        code = self.KEYS.get(key, ord(key.upper()) if len(key) == 1 else 0)
        text = {"Enter": "\r"}.get(key, key if len(key) == 1 else "")
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, code=key, windowsVirtualKeyCode=code, text=text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, code=key, windowsVirtualKeyCode=code)

    def centre_of(self, selector):
        """Of an element, scrolled into view."""
        x, y = self.evaluate(f"""(() => {{
            const element = document.querySelector({json.dumps(selector)});
            element.scrollIntoView({{block: 'center'}});
            const r = element.getBoundingClientRect();
            return [r.left + r.width / 2, r.top + r.height / 2];
        }})()""")
        if not (math.isfinite(x) and math.isfinite(y)):
            raise BrowserError(f"{selector} is not on the page")
        return x, y

    def click_on(self, selector):
        self.click(*self.centre_of(selector))
