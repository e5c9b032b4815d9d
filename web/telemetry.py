"""What the monitor publishes, as plain values for the operator page."""
import collections
import math
import threading
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from tether_monitor.msg import Alarm, AlarmArray, ParameterEstimate, TetherForecast, TetherState
from visualization_msgs.msg import MarkerArray

HISTORY = 60.0        # [s] of tensions that a new page begins with
HISTORY_STEP = 0.2    # [s]
SCENE_PERIOD = 1.0    # [s], wall clock, between two pictures of obstacles, seabed and fixes
LOST = 1.5            # [s], wall clock, without a state: the monitor is gone, or its clock stands
STATUS = {TetherState.STATUS_OK: "OK", TetherState.STATUS_DEGRADED: "DEGRADED", TetherState.STATUS_INVALID: "INVALID",
          TetherState.STATUS_STOWED: "STOWED"}
SCENE = ("obstacle", "seabed", "fixes")  # namespaces of the markers that are shown


def constants(message, prefix):
    return {value: name[len(prefix):] for name, value in vars(message).items() if name.startswith(prefix)}


REASON = constants(TetherState, "REASON_")
ALARM_STATES = ("NORMAL", "UNACKNOWLEDGED", "ACKNOWLEDGED", "RETURNED_UNACKNOWLEDGED", "LATCHED", "SHELVED", "SUPPRESSED_BY_DESIGN",
                "OUT_OF_SERVICE")
ALARM_STATE = {getattr(Alarm, name): name for name in ALARM_STATES}
SEVERITY = {Alarm.WARNING: "warning", Alarm.ALARM: "alarm", Alarm.CRITICAL: "critical"}


def number(value):
    """JSON knows no NaN: what is unknown is null."""
    return float("%.6g" % value) if math.isfinite(value) else None


def numbers(values):
    return [number(value) for value in values]


def vector(v):
    return [number(v.x), number(v.y), number(v.z)]


def state_values(m):
    names = ("length", "payout_rate", "vessel_tension", "vehicle_tension", "vessel_tension_stddev", "vehicle_tension_stddev",
             "vessel_tension_p05", "vessel_tension_p95", "vehicle_tension_p05", "vehicle_tension_p95", "max_tension", "max_tension_p95",
             "max_tension_s", "working_utilisation", "breaking_utilisation", "min_bend_radius", "vessel_end_angle", "vehicle_end_angle",
             "seabed_contact_length", "vehicle_position_stddev", "vessel_age", "vehicle_age", "step_time")
    values = {name: number(getattr(m, name)) for name in names}
    values.update(t=m.header.stamp.to_sec(), frame=m.header.frame_id, status=STATUS.get(m.status, "?"), reason=REASON.get(m.reason, "?"),
                  reasons=[name for bit, name in sorted(REASON.items()) if bit and m.reasons >> bit & 1],
                  s=numbers(m.s), position=[vector(p) for p in m.position], tension=numbers(m.tension),
                  position_stddev=[vector(p) for p in m.position_stddev])
    return values


def forecast_values(m):
    names = ("horizon", "probability_over_tension", "probability_breaking", "probability_slack", "time_to_warning", "time_to_limit",
             "time_to_slack", "time_to_limit_p05", "recommended_vessel_speed", "recommended_payout_rate")
    values = {name: number(getattr(m, name)) for name in names}
    values.update(t=m.header.stamp.to_sec(), members=m.members, from_plan=m.from_plan, time=numbers(m.time),
                  position=[vector(p) for p in m.position], median=numbers(m.max_tension), p05=numbers(m.max_tension_p05), p95=numbers(m.max_tension_p95))
    return values


def alarm_values(m):
    values = {name: number(getattr(m, name)) for name in ("value", "limit", "s", "peak")}
    values.update(name=m.name, state=ALARM_STATE.get(m.state, "?"), severity=SEVERITY.get(m.severity, "?"), unit=m.unit, text=m.text,
                  advice=m.advice, first_out=m.first_out, chattering=m.chattering, since=m.since.to_sec(), onset=m.onset.to_sec(),
                  shelved_until=m.shelved_until.to_sec())
    return values


def parameter_values(m):
    return [dict(name=name, mean=number(mean), stddev=number(stddev), configured=number(configured), configured_stddev=number(told))
            for name, mean, stddev, configured, told in zip(m.name, m.mean, m.stddev, m.configured, m.configured_stddev)]


def marker_values(marker):
    # Of the seabed's triangles a corner of every second one does.
    points = marker.points[::6] if marker.ns == "seabed" else marker.points
    return dict(ns=marker.ns, id=marker.id, type=marker.type, position=vector(marker.pose.position), scale=vector(marker.scale),
                orientation=numbers([getattr(marker.pose.orientation, axis) for axis in "xyzw"]), points=[vector(p) for p in points])


class InputLamps:
    """When each input was heard last, from the counts of the diagnostics."""

    def __init__(self):
        self.counts, self.heard = {}, {}

    def update(self, values, now):
        lamps = []
        for key, text in values.items():
            if not key.startswith("Input "):
                continue
            topic, count = key[len("Input "):], text.split(",")[0]
            if self.counts.get(topic) != count:
                self.counts[topic], self.heard[topic] = count, now
            lamps.append(dict(topic=topic, text=text, age=number(now - self.heard[topic]), refused=values.get("Refused on " + topic, "")))
        return lamps


class Telemetry:
    """
    The newest of every kind of message, as (version, values): versions grow, so that a page is sent what it has not seen. Any
    thread may read; callbacks of rospy write.
    """

    def __init__(self, monitor):
        self.monitor = monitor
        self.lock = threading.Lock()
        self.latest = {}
        self.history = collections.deque()
        self.heard = None  # wall clock of the last state
        self.lamps = InputLamps()
        self.scene_read = 0.0
        self.subscribers = [
            rospy.Subscriber(monitor + "/state", TetherState, self.on_state, queue_size=2, tcp_nodelay=True),
            rospy.Subscriber(monitor + "/forecast", TetherForecast, lambda m: self.put("forecast", forecast_values(m)), queue_size=1),
            rospy.Subscriber(monitor + "/alarms", AlarmArray,
                             lambda m: self.put("alarms", [alarm_values(alarm) for alarm in m.alarms]), queue_size=2),
            rospy.Subscriber(monitor + "/parameters", ParameterEstimate,
                             lambda m: self.put("parameters", parameter_values(m)), queue_size=1),
            rospy.Subscriber(monitor + "/markers", rospy.AnyMsg, self.on_markers, queue_size=1),
            rospy.Subscriber("/diagnostics", DiagnosticArray, self.on_diagnostics, queue_size=10)]

    def put(self, kind, values):
        with self.lock:
            version = self.latest[kind][0] + 1 if kind in self.latest else 1
            self.latest[kind] = (version, values)

    def on_state(self, message):
        values = state_values(message)
        self.put("state", values)
        with self.lock:
            self.heard = time.monotonic()
            last = self.history[-1]["t"] if self.history else -math.inf
            if values["t"] < last:
                self.history.clear()  # the clock has started again
            elif values["t"] - last < HISTORY_STEP - 1e-3:
                return
            self.history.append({name: values[name] for name in ("t", "status", "vessel_tension", "vessel_tension_p05", "vessel_tension_p95",
                                                                 "vehicle_tension", "vehicle_tension_p05", "vehicle_tension_p95",
                                                                 "max_tension")})
            while values["t"] - self.history[0]["t"] > HISTORY:
                self.history.popleft()

    def on_markers(self, raw):
        """They come with every cycle, and few are shown: most are not even unpacked."""
        now = time.monotonic()
        if now - self.scene_read < SCENE_PERIOD:
            return
        self.scene_read = now
        markers = MarkerArray().deserialize(raw._buff).markers
        self.put("scene", [marker_values(m) for m in markers if m.ns in SCENE and m.action == m.ADD])

    def on_diagnostics(self, message):
        for status in message.status:
            if status.name == self.monitor.lstrip("/") + ": tether":
                values = {v.key: v.value for v in status.values}
                lamps = self.lamps.update(values, time.monotonic())
                self.put("inputs", dict(level=status.level, summary=status.message, lamps=lamps))

    def is_lost(self):
        """Nothing of the monitor for a while, or never."""
        with self.lock:
            return self.heard is None or time.monotonic() - self.heard > LOST

    def since(self, seen):
        """What is newer than the versions in `seen`, which is brought up to date: a list of (kind, values)."""
        with self.lock:
            news = [(kind, version, values) for kind, (version, values) in self.latest.items() if seen.get(kind) != version]
        seen.update({kind: version for kind, version, _ in news})
        return [(kind, values) for kind, _, values in news]

    def past(self):
        with self.lock:
            return list(self.history)
