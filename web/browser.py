"""A headless Chromium, driven over its DevTools websocket: for pictures of the page, and its tests."""
import base64
import json
import os
import shutil
import subprocess
import tempfile
import time
import urllib.request

import tornado.ioloop
import tornado.websocket

ANSWER = 20.0  # [s]


def program():
    """Its path; None where there is no Chromium, as on Ubuntu 20.04, whose package is a snap."""
    return shutil.which("chromium")


class Browser:
    """One page. Blocking; of one thread."""

    def __init__(self, width=1920, height=1080):
        self.loop = tornado.ioloop.IOLoop(make_current=False)
        self.folder = tempfile.mkdtemp()
        self.process = subprocess.Popen(
            [program(), "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--remote-debugging-port=0",
             "--user-data-dir=" + self.folder, "--window-size=%d,%d" % (width, height), "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.number = 0
        self.complaints = []  # errors and warnings of the console, exceptions, requests that failed
        try:
            self.socket = self.wait(self.connect())
            for domain in ("Page", "Runtime", "Log", "Performance"):
                self.call(domain + ".enable")
        except BaseException:
            self.__exit__()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def wait(self, coroutine):
        async def awaited():
            return await coroutine
        return self.loop.run_sync(awaited, timeout=2 * ANSWER)

    def port(self):
        """Where it listens; it writes that into a file."""
        deadline = time.monotonic() + ANSWER
        while time.monotonic() < deadline:
            try:
                with open(os.path.join(self.folder, "DevToolsActivePort"), encoding="ascii") as text:
                    words = text.read().split()
                if words:
                    return words[0]
            except OSError:
                pass
            time.sleep(0.05)
        raise RuntimeError("Chromium does not start")

    async def connect(self):
        with urllib.request.urlopen("http://127.0.0.1:%s/json" % self.port(), timeout=ANSWER) as answer:
            pages = json.load(answer)
        url = next(page["webSocketDebuggerUrl"] for page in pages if page["type"] == "page")
        return await tornado.websocket.websocket_connect(url, max_message_size=100 * 1024 * 1024)

    def note(self, message):
        method, params = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description") or details["text"])
        elif method == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            self.complaints.append(params["entry"]["text"] + " " + params["entry"].get("url", ""))
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            self.complaints.append(str([a.get("value") for a in params["args"]]))

    async def exchange(self, method, params):
        self.number += 1
        await self.socket.write_message(json.dumps(dict(id=self.number, method=method, params=params)))
        while True:
            text = await self.socket.read_message()
            if text is None:
                raise RuntimeError("Chromium has ended")
            message = json.loads(text)
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError("%s: %s" % (method, message["error"]))
                return message["result"]
            self.note(message)

    def call(self, method, **params):
        return self.wait(self.exchange(method, params))

    def open(self, url):
        self.call("Page.navigate", url=url)

    def resize(self, width, height, is_phone=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=is_phone)

    def value(self, expression):
        """Of a JavaScript expression, as Python has it."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(str(result["exceptionDetails"]))
        return result["result"].get("value")

    def wait_for(self, expression, seconds=20.0):
        """@return whether it became true."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            if self.value("Boolean(%s)" % expression):
                return True
            time.sleep(0.1)
        return False

    def text(self, selector):
        return self.value("document.querySelector(%s).textContent" % json.dumps(selector))

    def heap(self):
        """Used by JavaScript, after its garbage is collected [bytes]."""
        self.call("HeapProfiler.collectGarbage")
        metrics = self.call("Performance.getMetrics")["metrics"]
        return next(m["value"] for m in metrics if m["name"] == "JSHeapUsedSize")

    def png(self):
        """What it shows, as the bytes of a PNG file."""
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])

    def picture(self, path):
        with open(path, "wb") as out:
            out.write(self.png())
