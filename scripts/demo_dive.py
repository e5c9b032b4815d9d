#!/usr/bin/python3
"""Companion of dive.launch: says in a table what is going on, and in words when something is; leaves pictures.

Subscribes: tether_monitor/state, forecast, events, tether_sim/vessel_end/force (the truth). Parameters: ~duration [s] after which it
ends, ~pictures, folder for screen.png and page.png ("none" for none), ~port of the operator page.
"""
import bisect
import math
import os
import subprocess
import sys
import threading

import rospkg
import rospy
from geometry_msgs.msg import WrenchStamped
from tether_monitor.msg import Alarm, AlarmEvent, TetherForecast, TetherState

TABLE_PERIOD = 5.0  # [s]
PROBABLE = 0.3      # probability of over-tension from which on it is worth saying
NEAR = 25.0         # of a waypoint, from where the tether is fastened [m]
PICTURED_AFTER = 90.0  # [s]: a minute of curves is there
STATUS = {TetherState.STATUS_OK: "OK", TetherState.STATUS_DEGRADED: "DEGRADED", TetherState.STATUS_INVALID: "INVALID"}


class Story:
    """What the simulation does of itself, told once when it begins."""

    def __init__(self, say):
        self.say = say
        simulation = rospy.get_param("tether_sim/simulation")
        way, squall = simulation["vessel"]["waypoints"], simulation["squall"]
        first, last = way[0]["position"], way[-2]["position"]
        # A simulation with a clock of its own begins at a stamp of one second.
        self.to_come = [(lambda t, ship: math.dist(ship, first) < NEAR, "the ship begins to turn"),
                        (lambda t, ship: math.dist(ship, last) < NEAR, "the ship comes out of its turn and makes %.1f m/s from now on" % way[-1]["speed"]),
                        (lambda t, ship: t >= 1.0 + squall["from"], "a squall pushes the ship from astern"),
                        (lambda t, ship: t >= 1.0 + squall["to"], "the squall is over")]

    def tell(self, t, ship):
        now = [event for event in self.to_come if event[0](t, ship)]
        for event in now:
            self.say("%8.1f  %s" % (t, event[1]))
            self.to_come.remove(event)


class Watch:
    def __init__(self):
        self.duration, self.pictures = rospy.get_param("~duration", 240.0), rospy.get_param("~pictures", "none")
        self.port = rospy.get_param("~port", 8008)
        self.lock = threading.Lock()
        self.next_row, self.probability, self.has_warned, self.is_done = None, math.nan, False, False
        self.truth = []  # (time, size of the force)
        self.errors = []
        self.painting = None
        self.story = Story(self.say)
        rospy.Subscriber("tether_sim/vessel_end/force", WrenchStamped, self.on_truth, queue_size=200)
        rospy.Subscriber("tether_monitor/forecast", TetherForecast, self.on_forecast, queue_size=5)
        rospy.Subscriber("tether_monitor/events", AlarmEvent, self.on_event, queue_size=50)
        rospy.Subscriber("tether_monitor/state", TetherState, self.on_state, queue_size=50)
        self.say("%8s  %-9s %21s %9s %10s %12s %9s" % ("time [s]", "status", "vessel [kN], band", "true", "P in 30 s", "pay-out [m/s]", "length"))

    @staticmethod
    def say(text):
        print(text, flush=True)

    def on_truth(self, message):
        f = message.wrench.force
        with self.lock:
            self.truth.append((message.header.stamp.to_sec(), math.sqrt(f.x ** 2 + f.y ** 2 + f.z ** 2)))
            del self.truth[:-400]

    def true_at(self, t):
        with self.lock:
            k = bisect.bisect_left(self.truth, (t - 1e-3,))
            return self.truth[k][1] if k < len(self.truth) and abs(self.truth[k][0] - t) < 0.03 else math.nan

    def on_forecast(self, forecast):
        self.probability = forecast.probability_over_tension if forecast.members else math.nan
        if self.probability > PROBABLE and not self.has_warned:
            self.has_warned = True
            rate = forecast.recommended_payout_rate
            advice = "no rate of the winch is known that would prevent it" if math.isnan(rate) else (
                "paying out %.2f m/s or more would prevent it" % rate if rate > 0.0 else "the winch must not haul in faster than %.2f m/s" % -rate)
            self.say("%8.1f  FORECAST: over-tension within %.0f s with a probability of %.0f %%; %s" % (
                forecast.header.stamp.to_sec(), forecast.horizon, 100.0 * self.probability, advice))
            if forecast.header.stamp.to_sec() > PICTURED_AFTER:
                self.paint()
        self.has_warned = self.has_warned and self.probability > 0.1

    def on_event(self, event):
        if event.alarm.severity >= Alarm.ALARM:
            self.say("%8.1f  %s" % (event.header.stamp.to_sec(), event.alarm.text))

    def on_state(self, state):
        t = state.header.stamp.to_sec()
        if state.position:
            self.story.tell(t, (state.position[0].x, state.position[0].y))
        true = self.true_at(t)
        if state.status != TetherState.STATUS_INVALID and math.isfinite(true) and t > 30.0:
            self.errors.append((state.vessel_tension - true, state.vessel_tension_p05 <= true <= state.vessel_tension_p95))
        if self.next_row is None or t >= self.next_row:
            self.next_row = t + TABLE_PERIOD
            self.say("%8.1f  %-9s %7.2f %6.2f-%6.2f %9.2f %8.0f %% %12.2f %9.1f" % (
                t, STATUS.get(state.status, "?"), 1e-3 * state.vessel_tension, 1e-3 * state.vessel_tension_p05, 1e-3 * state.vessel_tension_p95,
                1e-3 * true, 100.0 * self.probability, state.payout_rate, state.length))
        if t > self.duration and not self.is_done:
            self.is_done = True
            self.finish()

    def finish(self):
        if self.errors:
            rms = math.sqrt(sum(e ** 2 for e, _ in self.errors) / len(self.errors))
            inside = sum(is_in for _, is_in in self.errors) / len(self.errors)
            self.say("Estimate against truth at the vessel, from 30 s on: %.2f kN RMS; %.0f %% of the time between the 5 and 95 %% quantiles." % (
                1e-3 * rms, 100.0 * inside))
        self.paint()  # if it was never worth it
        if self.painting:
            self.painting.join(30.0)
        rospy.signal_shutdown("the dive is over")

    def paint(self):
        """Of the screen, where there is one, and of the page, where there is a Chromium."""
        if self.pictures == "none" or self.painting:
            return
        self.painting = threading.Thread(target=self.take_pictures, daemon=True)
        self.painting.start()

    def take_pictures(self):
        if os.environ.get("DISPLAY"):
            subprocess.run(["import", "-window", "root", os.path.join(self.pictures, "screen.png")], check=False)
        sys.path.insert(0, os.path.join(rospkg.RosPack().get_path("tether_monitor"), "web"))
        import browser
        if not browser.program():
            self.say("no Chromium: no picture of the page (scripts/install_dependencies browser)")
            return
        with browser.Browser(1920, 1080) as page:
            page.resize(1920, 1080)
            page.open("http://127.0.0.1:%d/?light=day" % self.port)
            page.wait_for("document.querySelector('#tension .curve')")
            page.picture(os.path.join(self.pictures, "page.png"))


if __name__ == "__main__":
    rospy.init_node("demo_dive")
    Watch()
    rospy.spin()
