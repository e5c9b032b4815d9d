#!/usr/bin/python3
"""A small controller of a winch: keeps the tension at the vessel under its working load and out of slack.

Waves: it pays out and takes in as the vessel's end moves along the tether, which ~state has every cycle.
Feedback: it pays out with the tension above its mean, at most `reference`, and takes in below.
Forecast: while over-tension is probable it pays out towards the rate that the forecast recommends, gently, and
less as the drum runs empty: the waves want tether left.
Flag: while over_tension is true, or has not come for half a second, it only takes in what the waves give.
It goes back to its usual length when nothing else is wanted.

Parameters (private): reference [N], damping [N s/m], usual_length, shortest, longest [m], fastest [m/s],
return_time [s]. Subscribes: tether_monitor/state, forecast, over_tension. Publishes: winch/command [m/s].
"""
import math
import threading

import numpy as np
import rospy
from std_msgs.msg import Bool, Float64
from tether_monitor.msg import TetherForecast, TetherState

FLAG_LIFE = 0.5      # [s]
FORECAST_LIFE = 3.0  # [s]
MEMORY = 40.0        # [s] of the means of tension and velocity
LEAD = 0.1           # [s] from the motion to that of the drum, which is made up for
PROBABLE = 0.3       # probability of over-tension that is acted on
GENTLE = 6.0         # [s] in which the recommended rate is reached
RESERVE = 30.0       # [m] short of the longest, kept for the waves: the forecast gets none of it
TAPER = 60.0         # [m] before that, over which it gets less and less


class WinchController:
    def __init__(self):
        def number(name):
            return float(rospy.get_param("~" + name))
        self.reference, self.damping = number("reference"), number("damping")
        self.usual_length, self.return_time = number("usual_length"), number("return_time")
        self.shortest, self.longest, self.fastest = number("shortest"), number("longest"), number("fastest")
        self.lock = threading.Lock()
        self.forecast = None
        self.dt = 0.0
        self.last = None  # time, place of the vessel's end
        self.precaution = 0.0  # pay-out rate for the forecast's sake [m/s]
        self.velocity = self.mean_velocity = self.mean_tension = None
        self.flag, self.flag_at = True, rospy.Time()
        self.command = rospy.Publisher("winch/command", Float64, queue_size=1)
        rospy.Subscriber("tether_monitor/forecast", TetherForecast, self.on_forecast, queue_size=1)
        rospy.Subscriber("tether_monitor/over_tension", Bool, self.on_flag, queue_size=1)
        rospy.Subscriber("tether_monitor/state", TetherState, self.on_state, queue_size=1, tcp_nodelay=True)

    def on_forecast(self, message):
        with self.lock:
            self.forecast = message

    def on_flag(self, message):
        with self.lock:
            self.flag, self.flag_at = message.data, rospy.Time.now()

    def recommended(self, now):
        """Pay-out rate that keeps over-tension improbable; 0 while it is improbable anyway."""
        forecast = self.forecast
        if forecast is None or forecast.members == 0 or (now - forecast.header.stamp).to_sec() > FORECAST_LIFE:
            return 0.0
        if not forecast.probability_over_tension > PROBABLE:
            return 0.0
        rate = forecast.recommended_payout_rate
        return self.fastest if math.isnan(rate) else max(rate, 0.0)

    def wave_rate(self, state):
        """How fast the vessel's end moves up along the tether in the waves; None at first. Keeps the means."""
        t, places = state.header.stamp.to_sec(), state.position[:2]
        end, next_place = (np.array([p.x, p.y, p.z]) for p in places)
        last, self.last = self.last, (t, end)
        if last is None or not 0.0 < t - last[0] < 0.5:
            return None
        dt = t - last[0]
        velocity = (end - last[1]) / dt
        if self.mean_velocity is None:
            self.velocity, self.mean_velocity, self.mean_tension = velocity, velocity, state.vessel_tension
        acceleration, self.velocity = (velocity - self.velocity) / dt, velocity
        share, self.dt = dt / MEMORY, dt
        self.mean_velocity = self.mean_velocity + share * (velocity - self.mean_velocity)
        self.mean_tension += share * (state.vessel_tension - self.mean_tension)
        down = (next_place - end) / np.linalg.norm(next_place - end)
        return -float(np.dot(velocity + LEAD * acceleration - self.mean_velocity, down))

    def on_state(self, state):
        if state.status == TetherState.STATUS_INVALID or not math.isfinite(state.vessel_tension):
            return  # no number, no command: the winch stops by itself
        now = state.header.stamp
        with self.lock:
            recommended = self.recommended(now)
            is_flagged = self.flag or (rospy.Time.now() - self.flag_at).to_sec() > FLAG_LIFE
        waves = self.wave_rate(state)
        if waves is None:
            return
        recommended *= min(max((self.longest - RESERVE - state.length) / TAPER, 0.0), 1.0)
        rate = (state.vessel_tension - min(self.mean_tension, self.reference)) / self.damping
        self.precaution += min(self.dt / GENTLE, 1.0) * (recommended - self.precaution)
        rate += max((self.usual_length - state.length) / self.return_time, self.precaution)
        if is_flagged:
            rate = max(rate, 0.0)
        rate += waves
        if state.length >= self.longest:
            rate = min(rate, 0.0)
        if state.length <= self.shortest:
            rate = max(rate, 0.0)
        try:
            self.command.publish(Float64(max(-self.fastest, min(self.fastest, rate))))
        except rospy.ROSException:
            pass  # the node is being shut down


if __name__ == "__main__":
    rospy.init_node("winch_controller")
    WinchController()
    rospy.spin()
