#!/usr/bin/python3
"""Companion of tank_run.launch: compares a point of the tether with its measurement, prints a table, draws a plot.

Subscribes: tether_monitor/state, tether_monitor/over_tension, marker/measured. Publishes: demo/markers.
Parameters: ~s, place of the marker on the tether [m]; ~plot, PNG file to write at the end, ~screenshot, PNG file of the
screen when the over-tension alarm comes ("" for none).
"""
import bisect
import math
import subprocess
import threading

import rospy
from geometry_msgs.msg import Point, PointStamped
from std_msgs.msg import Bool
from tether_monitor.msg import TetherState
from visualization_msgs.msg import Marker, MarkerArray

TABLE_PERIOD = 1.0   # [s]
STATUS = {TetherState.STATUS_OK: "OK", TetherState.STATUS_DEGRADED: "DEGRADED", TetherState.STATUS_INVALID: "INVALID"}


def point_at(state, s):
    """Position at arc length s, linear between stations."""
    hi = min(max(bisect.bisect_right(state.s, s), 1), len(state.s) - 1)
    share = (s - state.s[hi - 1]) / (state.s[hi] - state.s[hi - 1])
    a, b = state.position[hi - 1], state.position[hi]
    return Point(*(p + share * (q - p) for p, q in ((a.x, b.x), (a.y, b.y), (a.z, b.z))))


def distance(a, b):
    return math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2 + (a.z - b.z) ** 2)


def ball(header, marker_id, position, colour, size):
    marker = Marker(header=header, ns="marker", id=marker_id, type=Marker.SPHERE, action=Marker.ADD)
    marker.pose.position = position
    marker.pose.orientation.w = 1.0
    marker.scale.x = marker.scale.y = marker.scale.z = size
    marker.color.r, marker.color.g, marker.color.b = colour
    marker.color.a = 1.0
    return marker


def optional(name):
    """The file that a parameter names; roslaunch has "none" for none."""
    value = rospy.get_param(name, "none")
    return "" if value == "none" else value


class Watch:
    def __init__(self):
        self.s = rospy.get_param("~s", 1.2)
        self.plot = optional("~plot")
        self.screenshot = optional("~screenshot")
        self.lock = threading.Lock()
        self.measured = None
        self.over_tension = True
        self.next_row = None
        self.rows = []
        self.markers = rospy.Publisher("demo/markers", MarkerArray, queue_size=2)
        rospy.Subscriber("marker/measured", PointStamped, self.on_measured, queue_size=10)
        rospy.Subscriber("tether_monitor/over_tension", Bool, self.on_over_tension, queue_size=10)
        rospy.Subscriber("tether_monitor/state", TetherState, self.on_state, queue_size=10)
        rospy.on_shutdown(self.draw)
        print("%8s  %-9s %10s %10s %8s  %s" % ("time [s]", "status", "vessel [N]", "vehicle [N]", "apart", "over-tension"),
              flush=True)

    def on_measured(self, message):
        self.measured = message

    def on_over_tension(self, message):
        if message.data and not self.over_tension and self.screenshot:
            subprocess.Popen("sleep 0.12; import -window root '%s'" % self.screenshot, shell=True)
            self.screenshot = ""
        self.over_tension = message.data

    def on_state(self, state):
        time = state.header.stamp.to_sec()
        apart = float("nan")
        if state.status != TetherState.STATUS_INVALID and self.measured is not None:
            predicted = point_at(state, self.s)
            apart = distance(predicted, self.measured.point)
            size = 0.02 * state.length
            self.markers.publish(MarkerArray(markers=[
                ball(state.header, 0, predicted, (1.0, 1.0, 1.0), size),
                ball(state.header, 1, self.measured.point, (1.0, 0.3, 1.0), size)]))
        with self.lock:
            self.rows.append((time, state.vessel_tension, state.vehicle_tension, state.max_tension, apart, self.over_tension))
        if self.next_row is None or time >= self.next_row or time < self.next_row - 2.0 * TABLE_PERIOD:
            self.next_row = time + TABLE_PERIOD
            print("%8.2f  %-9s %10.3f %10.3f %5.0f mm  %s" % (
                time, STATUS[state.status], state.vessel_tension, state.vehicle_tension, 1e3 * apart,
                "ALARM" if self.over_tension else "-"), flush=True)

    def draw(self):
        with self.lock:
            rows = list(zip(*self.rows))
        if not self.plot or not rows:
            return
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure, (tension, marker) = pyplot.subplots(2, 1, sharex=True, figsize=(9, 6), constrained_layout=True)
        time = rows[0]
        tension.plot(time, rows[3], color="tab:red", label="largest along the tether")
        tension.plot(time, rows[1], label="vessel end")
        tension.plot(time, rows[2], label="vehicle end")
        limit = rospy.get_param("tether_monitor/tether/working_load", float("nan"))
        tension.axhline(limit, color="black", linestyle="--", linewidth=1, label="working load (set low for the demo)")
        tension.fill_between(time, 0, 1, where=rows[5], transform=tension.get_xaxis_transform(), color="tab:red", alpha=0.1,
                             label="over_tension is true")
        tension.set_ylabel("tension [N]")
        tension.legend(loc="upper right", fontsize="small")
        tension.set_title("Measured tank run: predicted tension, and the predicted against the measured marker")
        marker.plot(time, [1e3 * x for x in rows[4]], color="tab:purple")
        marker.set_ylabel("marker: predicted to measured [mm]")
        marker.set_xlabel("time [s]")
        marker.set_ylim(bottom=0.0)
        figure.savefig(self.plot, dpi=110)


if __name__ == "__main__":
    rospy.init_node("demo_monitor")
    WATCH = Watch()
    rospy.spin()
