"""A headless Chromium, driven through chromedriver with Python's own library.

Debian: apt-get install chromium chromium-driver. Speaks WebDriver (W3C) and, where that has no word for it, Chromium's
own protocol.
"""

import base64
import json
import re
import shutil
import subprocess
import tempfile
import urllib.request

FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
]
# Seconds for one command: printing a library takes the longest.
PATIENCE = 120


def missing():
    """The programs that a test needs and that are not installed."""
    programs = {"chromium": ("chromium", "chromium-browser", "google-chrome"), "chromedriver": ("chromedriver",)}
    return [name for name, known in programs.items() if not any(map(shutil.which, known))]


class Browser:
    """A browser window, closed at the end of the `with` block."""

    def __enter__(self):
        self.profile = tempfile.TemporaryDirectory()
        self.driver = subprocess.Popen(
            [shutil.which("chromedriver"), "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        self.session = None
        try:
            self.port = self._port()
            program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
            options = {"binary": program, "args": [*FLAGS, f"--user-data-dir={self.profile.name}"]}
            expected = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
            session = self._ask("POST", "/session", {"capabilities": {"alwaysMatch": expected}})
            self.session = session["sessionId"]
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        try:
            if self.session:
                self._ask("DELETE", f"/session/{self.session}")
        finally:
            self.driver.terminate()
            self.driver.wait(10)
            self.profile.cleanup()

    def _port(self):
        for line in self.driver.stdout:
            match = re.search(r"started successfully on port (\d+)", line)
            if match:
                return int(match[1])
        raise RuntimeError("chromedriver ended before it said its port")

    def _ask(self, method, path, body=None):
        data = json.dumps(body or {}).encode() if method == "POST" else None
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", data=data, method=method)
        # No proxy between this program and its own browser.
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        with opener.open(request, timeout=PATIENCE) as answer:
            return json.load(answer)["value"]

    def _tell(self, command, body):
        return self._ask("POST", f"/session/{self.session}/{command}", body)

    def protocol(self, command, **parameters):
        """A command of Chromium's own protocol."""
        return self._tell("goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, path, width, scheme):
        """Opens a file, `width` CSS pixels wide, in the scheme `light` or `dark`."""
        self.resize(width)
        self.media("", scheme)
        self.logs("browser"), self.logs("performance")
        self._tell("url", {"url": path.resolve().as_uri()})

    def resize(self, width):
        """Makes the window so wide, in CSS pixels."""
        self.protocol(
            "Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False
        )

    def media(self, media, scheme):
        """Shows the page as in `print`, or with "" as the browser does by itself, in the scheme `light` or `dark`."""
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.protocol("Emulation.setEmulatedMedia", media=media, features=features)

    def run(self, script):
        """The value that a piece of script returns."""
        return self._tell("execute/sync", {"script": script, "args": []})

    def run_async(self, script):
        """The value with which a piece of script calls `done`."""
        script = f"const done = arguments[arguments.length - 1]; {script}"
        return self._tell("execute/async", {"script": script, "args": []})

    def logs(self, kind):
        """Messages that were logged since the last time: `browser` for the console, `performance` for events."""
        return self._tell("se/log", {"type": kind})

    def requests(self):
        """Addresses of everything the page asked for since it was opened."""
        events = (json.loads(entry["message"])["message"] for entry in self.logs("performance"))
        sent = [event["params"] for event in events if event["method"] == "Network.requestWillBeSent"]
        return [one["request"]["url"] for one in sent]

    def picture(self, path, first, last):
        """A picture of the page from one element to another as WebP, so that small letters are readable in a small file."""
        top, bottom, width = self.run(
            f"return [document.querySelector('{first}').getBoundingClientRect().top + scrollY,"
            f"document.querySelector('{last}').getBoundingClientRect().bottom + scrollY, innerWidth]"
        )
        clip = {"x": 0, "y": top, "width": width, "height": bottom - top, "scale": 1}
        options = {"captureBeyondViewport": True, "format": "webp", "quality": 50, "clip": clip}
        path.write_bytes(base64.b64decode(self.protocol("Page.captureScreenshot", **options)["data"]))

    def print(self):
        """The page as PDF, as its style sheet for print wants it."""
        return base64.b64decode(self.protocol("Page.printToPDF", preferCSSPageSize=True)["data"])
