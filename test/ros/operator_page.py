#!/usr/bin/python3
"""The operator page beside a monitor that the test plays: what is sent, who may act, what a browser shows."""
import json
import math
import os
import socket
import sys
import threading
import time
import unittest
import urllib.error
import urllib.request

import rospkg
import rospy
import rostest
import tornado.httpclient
import tornado.ioloop
import tornado.websocket
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from geometry_msgs.msg import Point, Vector3
from tether_monitor.msg import Alarm, AlarmArray, ParameterEstimate, TetherForecast, TetherState
from tether_monitor.srv import AlarmAction, AlarmActionResponse
from visualization_msgs.msg import Marker, MarkerArray

import common.old_rospy  # noqa: F401
from common.nodes import run_until, start

sys.path.insert(0, os.path.join(rospkg.RosPack().get_path("tether_monitor"), "web"))
import browser  # noqa: E402

MONITOR = "/rov1/tether_monitor"
PORT, OPEN_PORT = 8118, 8119  # with a key, and without
KEY = "harbour-7"
PICTURES = os.environ.get("OPERATOR_PAGE_PICTURES")  # a folder that pictures are left in


def state_at(t):
    m = TetherState()
    m.header.stamp, m.header.frame_id = rospy.Time.from_sec(t), "map"
    m.status, m.reason = TetherState.STATUS_DEGRADED, TetherState.REASON_UNCERTAIN
    m.reasons = 1 << TetherState.REASON_UNCERTAIN
    m.length, m.payout_rate = 250.0, 0.2
    for k in range(21):
        share = k / 20.0
        m.s.append(250.0 * share)
        m.position.append(Point(150.0 * share, 40.0 * share, -170.0 * share ** 1.3))
        m.tension.append(4540.0 - 3000.0 * share)
        m.position_stddev.append(Vector3(2.0 * share, 1.0 * share, 1.5 * share))
    m.vessel_tension, m.vehicle_tension = 4540.0 + 300.0 * math.sin(t), 1540.0
    m.vessel_tension_stddev, m.vehicle_tension_stddev = 400.0, 150.0
    m.vessel_tension_p05, m.vessel_tension_p95 = m.vessel_tension - 600.0, m.vessel_tension + 700.0
    m.vehicle_tension_p05, m.vehicle_tension_p95 = 1300.0, 1800.0
    m.max_tension, m.max_tension_p95, m.max_tension_s = m.vessel_tension, m.vessel_tension_p95, 0.0
    m.working_utilisation, m.breaking_utilisation = m.max_tension / 5000.0, m.max_tension / 20000.0
    m.min_bend_radius, m.vessel_end_angle, m.vehicle_end_angle = 80.0, 0.9, 0.4
    m.vessel_age, m.vehicle_age, m.touchdown_s, m.vehicle_position_stddev = 0.05, 0.8, math.nan, 0.6
    return m


def alarm(name, state, severity, **values):
    known = dict(unit="N", value=math.nan, limit=math.nan, s=math.nan, peak=math.nan, text=name + " text", advice="do something")
    known.update(values)
    return Alarm(name=name, state=state, severity=severity, **known)


class PlayedMonitor:
    """Publishes like a monitor, twenty times a second, until it is told to be silent."""

    def __init__(self):
        def topic(name, kind):
            return rospy.Publisher(MONITOR + "/" + name, kind, queue_size=5, latch=name == "alarms")
        self.state, self.forecast = topic("state", TetherState), topic("forecast", TetherForecast)
        self.alarms, self.parameters = topic("alarms", AlarmArray), topic("parameters", ParameterEstimate)
        self.markers = topic("markers", MarkerArray)
        self.diagnostics = rospy.Publisher("/diagnostics", DiagnosticArray, queue_size=5)
        self.actions, self.is_silent, self.sent = [], False, {}
        self.t = 1000.0
        rospy.Service(MONITOR + "/alarm_action", AlarmAction, self.act)
        threading.Thread(target=self.play, daemon=True).start()

    def act(self, request):
        self.actions.append((request.name, request.action, request.seconds))
        is_known = request.name == "over_tension"
        return AlarmActionResponse(success=is_known, message="" if is_known else "no such alarm")

    def play(self):
        cycle = 0
        while not rospy.is_shutdown():
            time.sleep(0.05)
            if self.is_silent:
                continue
            self.t = round(self.t + 0.05, 3)
            message = state_at(self.t)
            self.sent[self.t] = message
            self.state.publish(message)
            self.markers.publish(self.scene())
            if cycle % 20 == 0:
                self.publish_rare()
            cycle += 1

    def scene(self):
        pile = Marker(ns="obstacle", type=Marker.CYLINDER)
        pile.pose.position, pile.pose.orientation.w, pile.scale = Point(90.0, 20.0, -60.0), 1.0, Vector3(6.0, 6.0, 120.0)
        fixes = Marker(ns="fixes", type=Marker.LINE_LIST)
        for i in range(5):
            x, y, z = 150.0 - i, 40.0 + i, -170.0
            fixes.points += [Point(x - 1, y, z), Point(x + 1, y, z), Point(x, y - 1, z), Point(x, y + 1, z), Point(x, y, z - 2), Point(x, y, z + 2)]
        return MarkerArray([pile, fixes, Marker(ns="tether")])

    def publish_rare(self):
        stamp = rospy.Time.from_sec(self.t)
        times = [0.5 * k for k in range(1, 61)]
        forecast = TetherForecast(time=times, max_tension=[4600.0 + 20 * x for x in times], max_tension_p05=[4300.0] * 60,
                                  max_tension_p95=[4900.0 + 40 * x for x in times], horizon=30.0, probability_over_tension=0.62,
                                  probability_slack=0.01, time_to_limit=12.0, members=96, recommended_vessel_speed=0.7,
                                  position=[Point(p.x + 30.0, p.y, p.z) for p in state_at(self.t).position])
        forecast.header.stamp = stamp
        self.forecast.publish(forecast)
        alarms = AlarmArray(alarms=[
            alarm("over_tension", Alarm.UNACKNOWLEDGED, Alarm.ALARM, unit="fraction of working_load", value=1.02, limit=1.0, peak=1.07, s=0.0,
                  first_out=True, onset=rospy.Time.from_sec(990.0)),
            alarm("mismatch", Alarm.ACKNOWLEDGED, Alarm.WARNING, unit="-", value=4.2, limit=4.0, peak=4.4, onset=rospy.Time.from_sec(980.0)),
            alarm("breaking", Alarm.NORMAL, Alarm.CRITICAL, unit="fraction of breaking_load", value=0.2, limit=0.9)])
        alarms.header.stamp = stamp
        self.alarms.publish(alarms)
        self.parameters.publish(ParameterEstimate(name=["tether.drag_normal"], mean=[1.62], stddev=[0.14], configured=[1.2], configured_stddev=[0.36]))
        self.diagnostics.publish(DiagnosticArray(status=[DiagnosticStatus(
            name=MONITOR[1:] + ": tether", level=1, message="DEGRADED: wide band",
            values=[KeyValue("Input vehicle/pose", "%d, 1 Hz" % self.t), KeyValue("Refused on vehicle/pose", "3, last: a leap")])]))


class Client:
    """A page without a browser; blocking."""

    def __init__(self, port, headers=()):
        self.loop = tornado.ioloop.IOLoop(make_current=False)
        request = tornado.httpclient.HTTPRequest("ws://127.0.0.1:%d/live" % port, headers=dict(headers))

        async def connect():
            return await tornado.websocket.websocket_connect(request)
        self.socket = self.loop.run_sync(connect, timeout=10.0)

    def read(self, kind, seconds=10.0):
        """The next message of a kind."""
        async def awaited():
            while True:
                text = await self.socket.read_message()
                if text is None:
                    raise RuntimeError("closed: %s" % self.socket.close_reason)
                message = json.loads(text)
                if message["kind"] == "pulse":
                    await self.socket.write_message(json.dumps(dict(frame=message["values"]["frame"])))
                if message["kind"] == kind:
                    return message["values"]
        return self.loop.run_sync(awaited, timeout=seconds)

    def wish(self, **values):
        async def send():
            await self.socket.write_message(json.dumps(values))
        self.loop.run_sync(send, timeout=5.0)
        return self.read("answer")

    def close(self):
        self.socket.close()


class OperatorPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.monitor = PlayedMonitor()
        rospy.set_param("/rov1/guarded", dict(port=PORT, key=KEY))
        rospy.set_param("/rov1/open", dict(port=OPEN_PORT))
        cls.nodes = start("/rov1", "tether_web __name:=guarded", "tether_web __name:=open")
        deadline = time.monotonic() + 30.0
        for port in (PORT, OPEN_PORT):
            while time.monotonic() < deadline:
                try:
                    urllib.request.urlopen("http://127.0.0.1:%d/" % port, timeout=1.0)
                    break
                except OSError:
                    time.sleep(0.1)

    @classmethod
    def tearDownClass(cls):
        alive = run_until(cls.nodes, lambda: True, 1.0)
        assert alive == [True, True], "a server ended"

    def setUp(self):
        self.monitor.is_silent = False

    def test_values_are_those_of_the_topics(self):
        client = Client(PORT)
        self.assertEqual(client.read("welcome"), dict(monitor=MONITOR, may_act=True, period=0.2))
        self.assertGreater(len(client.read("history")), 0)
        shown = client.read("state")
        sent = self.monitor.sent[round(shown["t"], 3)]
        self.assertAlmostEqual(shown["vessel_tension"], sent.vessel_tension, delta=0.01)
        self.assertEqual(shown["status"], "DEGRADED")
        self.assertEqual((shown["reason"], shown["reasons"]), ("UNCERTAIN", ["UNCERTAIN"]))
        self.assertEqual(len(shown["position"]), 21)
        alarms = Client(PORT).read("alarms")
        self.assertEqual([(a["name"], a["state"], a["severity"]) for a in alarms][0], ("over_tension", "UNACKNOWLEDGED", "alarm"))
        self.assertIsNone(alarms[1]["s"], "what is not known is null, not NaN")

    def test_without_a_key_pages_only_show(self):
        before = len(self.monitor.actions)
        answer = Client(OPEN_PORT).wish(action="acknowledge", name="over_tension", key=KEY)
        self.assertFalse(answer["succeeded"])
        self.assertIn("without a key", answer["text"])
        self.assertEqual(len(self.monitor.actions), before)

    def test_with_the_key_an_alarm_is_acknowledged_and_shelved(self):
        client, before = Client(PORT), len(self.monitor.actions)
        self.assertFalse(client.wish(action="acknowledge", name="over_tension", key="harbour-8")["succeeded"])
        self.assertFalse(client.wish(action="acknowledge", name="over_tension")["succeeded"])
        self.assertFalse(client.wish(action="suppress_by_design", name="over_tension", key=KEY)["succeeded"], "not from a page")
        self.assertFalse(client.wish(nonsense=True)["succeeded"])
        self.assertEqual(len(self.monitor.actions), before)
        self.assertTrue(client.wish(action="acknowledge", name="over_tension", key=KEY)["succeeded"])
        self.assertTrue(client.wish(action="shelve", name="over_tension", seconds=600, key=KEY)["succeeded"])
        self.assertEqual(self.monitor.actions[before:], [("over_tension", "acknowledge", 0.0), ("over_tension", "shelve", 600.0)])
        refused = client.wish(action="acknowledge", name="nothing", key=KEY)
        self.assertFalse(refused["succeeded"])
        self.assertIn("no such alarm", refused["text"])

    def test_a_page_from_elsewhere_gets_nothing(self):
        for headers in (dict(Origin="http://elsewhere.example"), dict(Origin="http://elsewhere.example", Host="elsewhere.example:%d" % PORT)):
            with self.assertRaises(tornado.httpclient.HTTPClientError) as refusal:
                Client(PORT, headers)
            self.assertEqual(refusal.exception.code, 403)
        request = urllib.request.Request("http://127.0.0.1:%d/" % PORT, headers=dict(Host="elsewhere.example"))
        with self.assertRaises(urllib.error.HTTPError) as refusal:
            urllib.request.urlopen(request, timeout=5.0)
        self.assertEqual(refusal.exception.code, 403)
        for path in ("/../server.py", "/%2e%2e/server.py", "/..%2ftelemetry.py"):
            with self.assertRaises(urllib.error.HTTPError):
                urllib.request.urlopen("http://127.0.0.1:%d%s" % (PORT, path), timeout=5.0)

    def test_one_that_never_reads_harms_nobody(self):
        stuck = []
        for _ in range(2):
            s = socket.create_connection(("127.0.0.1", PORT))
            s.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
            s.sendall(("GET /live HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n" % PORT).encode())
            stuck.append(s)
        clients = [Client(PORT) for _ in range(10)]
        begun, frames = time.monotonic(), 0
        while time.monotonic() - begun < 4.0:
            for client in clients:
                client.read("pulse", 2.0)
            frames += 1
        self.assertGreater(frames, 12, "five a second are sent")
        for s in stuck:
            s.close()

    def test_silence_is_told_within_two_seconds(self):
        client = Client(PORT)
        while client.read("pulse")["lost"]:
            pass
        self.monitor.is_silent, begun = True, time.monotonic()
        while not client.read("pulse")["lost"]:
            self.assertLess(time.monotonic() - begun, 2.0)
        self.monitor.is_silent = False
        while client.read("pulse")["lost"]:
            self.assertLess(time.monotonic() - begun, 10.0)

    @unittest.skipUnless(browser.program(), "no Chromium: scripts/install_dependencies browser")
    def test_a_browser_shows_it(self):
        with browser.Browser() as page:
            page.open("http://127.0.0.1:%d/?light=day" % PORT)
            self.assertTrue(page.wait_for("document.querySelectorAll('#alarms tbody tr:not(.advice)').length > 1 && document.querySelector('#tension .curve')"))
            self.assertTrue(page.wait_for("document.getElementById('cover').hidden"))
            self.assertEqual(page.text("#status-word"), "DEGRADED")
            self.assertEqual(page.text("#status-alarm"), "ALARM over tension and 1 more")
            self.assertTrue(page.wait_for("document.getElementById('status-text').textContent.includes('wide band')"), "the diagnostics say why")
            self.assertRegex(page.text("#vessel-tension"), r"^4\.[2-8]\d kN$")
            self.assertEqual(page.text("#vehicle-tension"), "1.54 kN")
            self.assertEqual(page.text("#vehicle-band"), "90 % between 1.30 kN and 1.80 kN")
            self.assertTrue(page.wait_for("document.getElementById('probability').textContent === '62 %'"))
            self.assertIn("limit in 12 s", page.text("#time-to-limit"))
            self.assertIn("over tension", page.text("#alarms tbody"))
            self.assertIn("107 %", page.text("#alarms tbody"))
            self.assertTrue(page.wait_for("document.querySelector('#parameters tbody').textContent.includes('1.62 ± 0.14')"))
            self.assertRegex(page.text("#max-place"), r"; 95 % quantile \d\.\d\d kN, \d+ % of it$")
            self.assertIn("do something", page.text("#alarms tr.advice"))
            self.assertTrue(page.wait_for("document.getElementById('inputs').textContent.includes('vehicle/pose')"))
            self.assertTrue(page.wait_for("document.querySelectorAll('#plan .fix').length === 5"))
            self.assertEqual(page.value("document.querySelectorAll('#elevation .obstacle').length"), 1)
            self.assertEqual(page.value("document.querySelectorAll('#plan .ghost, #elevation .ghost').length"), 2)
            page.value("document.getElementById('key').value = %s" % json.dumps(KEY))
            before = len(self.monitor.actions)
            page.value("document.querySelector('button[data-action=acknowledge]').click()")
            self.assertTrue(page.wait_for("document.getElementById('answer').textContent.startsWith('Done')"))
            self.assertEqual(self.monitor.actions[before:], [("over_tension", "acknowledge", 0.0)])
            for name, width, height, is_phone in (("1920x1080", 1920, 1080, False), ("1280x720", 1280, 720, False), ("phone", 390, 844, True)):
                for light in ("day", "night"):
                    page.resize(width, height, is_phone)
                    page.value("document.documentElement.dataset.light === '%s' || document.getElementById('night').click()" % light)
                    time.sleep(0.6)
                    self.assertLessEqual(page.value("document.documentElement.scrollWidth"), width, "nothing sticks out sideways")
                    if PICTURES:
                        page.picture(os.path.join(PICTURES, "%s_%s.png" % (name, light)))
            self.monitor.is_silent = True
            self.assertTrue(page.wait_for("!document.getElementById('cover').hidden", 3.0))
            if PICTURES:
                page.picture(os.path.join(PICTURES, "silent.png"))
            self.monitor.is_silent = False
            self.assertTrue(page.wait_for("document.getElementById('cover').hidden"))
            self.assertEqual(page.complaints, [])


if __name__ == "__main__":
    rospy.init_node("operator_page", disable_signals=True)
    rostest.rosrun("tether_monitor", "operator_page", OperatorPage)
