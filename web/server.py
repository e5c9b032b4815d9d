"""The operator page's server: files, and a websocket that sends what is new five times a second."""
import asyncio
import concurrent.futures
import datetime
import hmac
import ipaddress
import json
import os
import socket
import threading
import time

import tornado.gen
import tornado.ioloop
import tornado.locks
import tornado.web
import tornado.websocket

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "page")
D3 = "/usr/share/javascript/d3/d3.min.js"  # Debian's and Ubuntu's libjs-d3
PERIOD = 0.2           # [s] between two frames
STUCK = 15.0           # [s] that a client may take for one frame before it is let go
ANSWER = 3.0           # [s] that the monitor has to answer an action
LONGEST_MESSAGE = 2000  # bytes that a page may send at once
MOST_CLIENTS = 50
WRONG_KEY_WAIT = 1.0   # [s] that an answer to a wrong key takes
MOST_WRONG_KEYS = 5
ACTIONS = ("acknowledge", "shelve", "unshelve", "reset")
LONGEST_SHELVING = 43200.0  # [s]
SECURITY = {"Content-Security-Policy": "default-src 'self'; img-src 'self' data:; style-src 'self' 'unsafe-inline'; frame-ancestors 'none'",
            "X-Content-Type-Options": "nosniff", "X-Frame-Options": "DENY", "Referrer-Policy": "no-referrer", "Cache-Control": "no-cache"}


def as_json(kind, values):
    return json.dumps({"kind": kind, "values": values}, allow_nan=False, separators=(",", ":"))


class Hosts:
    """
    Under which names this server may be called. A page from elsewhere can let its own name point to this machine; an address,
    or a name of this machine, it cannot have.
    """

    def __init__(self, more=()):
        own = socket.gethostname().lower()
        self.names = {"localhost", own, own + ".local"} | {name.lower() for name in more}

    def knows(self, host):
        name = host.lower().rsplit(":", 1)[0] if not host.endswith("]") else host.lower()
        try:
            ipaddress.ip_address(name.strip("[]"))
            return True
        except ValueError:
            return name in self.names


class Guarded:
    """What all handlers share."""

    def initialize(self, desk):
        self.desk = desk

    def prepare(self):
        if not self.desk.hosts.knows(self.request.host):
            raise tornado.web.HTTPError(403, "this machine is not known as '%s'" % self.request.host)

    def set_default_headers(self):
        for name, value in SECURITY.items():
            self.set_header(name, value)


class PageFile(Guarded, tornado.web.StaticFileHandler):
    def initialize(self, desk, **files):
        Guarded.initialize(self, desk)
        tornado.web.StaticFileHandler.initialize(self, **files)


class Library(Guarded, tornado.web.RequestHandler):
    def get(self):
        self.set_header("Content-Type", "text/javascript; charset=utf-8")
        self.set_header("Cache-Control", "max-age=3600")
        with open(D3, "rb") as source:
            self.write(source.read())


class Live(Guarded, tornado.websocket.WebSocketHandler):
    """
    One open page, of this server's own origin: tornado checks it. It is sent the newest of everything; a page that is slow misses
    frames and keeps nobody waiting.
    """

    def open(self):
        self.seen, self.sent_at, self.frame, self.seen_frame = {}, 0.0, 0, 0
        self.wrong_keys, self.is_busy = 0, False
        if not self.desk.add(self):
            self.close(1013, "too many pages are open")
            return
        self.set_nodelay(True)
        self.send([as_json("welcome", dict(monitor=self.desk.telemetry.monitor, may_act=bool(self.desk.key), period=PERIOD)),
                   as_json("history", self.desk.telemetry.past())], self.desk.telemetry.is_lost())

    def on_close(self):
        self.desk.remove(self)

    def send(self, texts, lost):
        """With a pulse at the end, which the page sends back: what is under way to a slow page is one frame."""
        self.frame, self.sent_at = self.frame + 1, time.monotonic()
        tornado.ioloop.IOLoop.current().spawn_callback(self.deliver, texts + [as_json("pulse", dict(lost=lost, frame=self.frame))])

    async def deliver(self, texts):
        try:
            for text in texts:
                await self.write_message(text)
        except (tornado.websocket.WebSocketClosedError, tornado.iostream.StreamClosedError):
            pass

    def push(self, lost):
        if self.seen_frame < self.frame:
            if time.monotonic() - self.sent_at > STUCK:
                self.desk.remove(self)
                stream = getattr(self.ws_connection, "stream", None)
                if stream:
                    stream.close()
            return
        self.send([self.desk.text(kind, values) for kind, values in self.desk.telemetry.since(self.seen)], lost)

    def on_message(self, text):
        if self not in self.desk.pages:
            return
        try:
            wish = json.loads(text)
            if "frame" in wish:
                self.seen_frame = max(self.seen_frame, min(int(wish["frame"]), self.frame))
                return
            wanted = wish["action"], wish["name"], float(wish.get("seconds", 0.0)), str(wish.get("key", ""))
        except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
            wanted = None
        # Frames go on meanwhile.
        if not self.is_busy:
            self.is_busy = True
            tornado.ioloop.IOLoop.current().spawn_callback(self.obey, wanted)

    async def obey(self, wanted):
        """One wish at a time: what comes while it is under way is passed over."""
        succeeded, text = await self.desk.fulfil(self, wanted)
        self.is_busy = False
        if self.wrong_keys >= MOST_WRONG_KEYS:
            return self.close(1008, "wrong key")
        await self.answer(succeeded, text)

    async def answer(self, succeeded, text):
        try:
            await self.write_message(as_json("answer", dict(succeeded=succeeded, text=text)))
        except (tornado.websocket.WebSocketClosedError, tornado.iostream.StreamClosedError):
            pass


class Desk:
    """The pages that are open, and what they may do."""

    def __init__(self, telemetry, act, key="", hosts=()):
        """act(name, action, seconds) -> (succeeded, what is wrong); without a key no page may act."""
        self.telemetry, self.act, self.key = telemetry, act, key
        self.hosts = Hosts(hosts)
        self.pages = set()
        self.texts = {}
        self.key_check = tornado.locks.Lock()

    async def is_key(self, key):
        """Pages wait for each other: a wrong key costs all of them a second."""
        async with self.key_check:
            is_right = hmac.compare_digest(key.encode("utf-8", "replace"), self.key.encode("utf-8"))
            if not is_right:
                await tornado.gen.sleep(WRONG_KEY_WAIT)
        return is_right

    async def fulfil(self, page, wanted):
        """@return whether it was done, and a text for the page."""
        if not wanted:
            return False, "that is no action on an alarm"
        action, name, seconds, key = wanted
        if not self.key:
            return False, "this page only shows: the server was started without a key"
        if not await self.is_key(key):
            page.wrong_keys += 1
            return False, "wrong key"
        if action not in ACTIONS or not isinstance(name, str) or not 0.0 <= seconds <= LONGEST_SHELVING:
            return False, "one of %s, of an alarm by its name" % ", ".join(ACTIONS)
        succeeded, why = await self.do(name, action, seconds)
        return succeeded, why or "%s: %s" % (action, name)

    async def do(self, name, action, seconds):
        """What a monitor that hangs never answers is left to its thread."""
        answer = concurrent.futures.Future()

        def run():
            try:
                answer.set_result(self.act(name, action, seconds))
            except Exception as error:  # whatever it is, the page is told
                answer.set_result((False, str(error)))
        threading.Thread(target=run, daemon=True).start()
        try:
            return await tornado.gen.with_timeout(datetime.timedelta(seconds=ANSWER), asyncio.wrap_future(answer))
        except tornado.gen.TimeoutError:
            return False, "the monitor does not answer"

    def add(self, page):
        if len(self.pages) >= MOST_CLIENTS:
            return False
        self.pages.add(page)
        return True

    def remove(self, page):
        self.pages.discard(page)

    def text(self, kind, values):
        """The same for all pages: written once."""
        known = self.texts.get(kind)
        if known is None or known[0] is not values:
            self.texts[kind] = (values, as_json(kind, values))
        return self.texts[kind][1]

    def push(self):
        lost = self.telemetry.is_lost()
        for page in list(self.pages):
            page.push(lost)


def serve(desk, address, port):
    """Listens, and pushes from then on. @return the application's server. @raise OSError: address or port cannot be had."""
    if not os.path.exists(D3):
        raise OSError("%s is missing: install libjs-d3" % D3)
    application = tornado.web.Application(
        [(r"/live", Live, dict(desk=desk)), (r"/lib/d3\.js", Library, dict(desk=desk)),
         (r"/(.*)", PageFile, dict(desk=desk, path=PAGE, default_filename="index.html"))],
        websocket_max_message_size=LONGEST_MESSAGE, log_function=lambda handler: None)
    server = application.listen(port, address=address)
    tornado.ioloop.PeriodicCallback(desk.push, 1e3 * PERIOD).start()
    return server
