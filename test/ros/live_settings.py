#!/usr/bin/python3
"""A dynamic_reconfigure client at a monitor in tow: what is taken acts and stays for a restart, the rest is refused."""
import os
import sys
import threading
import time
import unittest

import rosparam
import rospkg
import rospy
import rostest
from dynamic_reconfigure.client import Client
from geometry_msgs.msg import PoseStamped
from tether_monitor.msg import AlarmArray, TetherState

import common.old_rospy  # noqa: F401
from common.nodes import run_until, start

NAMESPACE = "/live"
MONITOR = NAMESPACE + "/tether_monitor"
SPEED = 1.2  # [m/s]


class Tow:
    """Poses of both ends ten times a second, and what the monitor says of them."""

    def __init__(self):
        self.poses = {"vessel": rospy.Publisher(NAMESPACE + "/vessel/pose", PoseStamped, queue_size=5),
                      "vehicle": rospy.Publisher(NAMESPACE + "/vehicle/pose", PoseStamped, queue_size=5)}
        self.state, self.alarms, self.is_over = None, None, False
        rospy.Subscriber(MONITOR + "/state", TetherState, lambda message: setattr(self, "state", message))
        rospy.Subscriber(MONITOR + "/alarms", AlarmArray, lambda message: setattr(self, "alarms", message))
        threading.Thread(target=self.play, daemon=True).start()

    def play(self):
        begin = rospy.Time.now()
        while not self.is_over and not rospy.is_shutdown():
            now = rospy.Time.now()
            for name, (x, z) in {"vessel": (0.0, 0.0), "vehicle": (-90.0, -40.0)}.items():
                message = PoseStamped()
                message.header.stamp, message.header.frame_id = now, "map"
                message.pose.position.x = x + SPEED * (now - begin).to_sec()
                message.pose.position.z = z
                message.pose.orientation.w = 1.0
                self.poses[name].publish(message)
            time.sleep(0.1)

    def limit(self, name):
        found = [alarm.limit for alarm in self.alarms.alarms if alarm.name == name] if self.alarms else []
        return found[0] if found else None


def wait_for(condition, longest=20.0):
    deadline = time.time() + longest
    while time.time() < deadline and not condition():
        time.sleep(0.05)
    return condition()


class LiveSettings(unittest.TestCase):
    def test_a_client_changes_what_may_change(self):
        site = os.path.join(rospkg.RosPack().get_path("tether_monitor"), "test/ros/common/tow_site.yaml")
        for parameters, _ in rosparam.load_file(site):
            rosparam.upload_params(MONITOR, parameters)
        rospy.set_param(MONITOR + "/vehicle", {})
        tow = Tow()
        nodes = start(NAMESPACE, "tether_monitor_node")
        try:
            self.assertTrue(wait_for(lambda: tow.state and tow.state.status == TetherState.STATUS_OK))
            client = Client(MONITOR, timeout=10.0)
            settings = client.get_configuration(timeout=10.0)
            self.assertEqual(settings["tether.drag_normal"], 1.35)
            self.assertNotIn("vehicle.force_stddev", settings, "of mode observed only")
            descriptions = {p["name"]: p for p in client.get_parameter_descriptions(timeout=10.0)}
            self.assertEqual(descriptions["monitor.alarms.over_tension.limit"]["type"], "double")
            self.assertEqual(set(descriptions), {key for key in settings if key != "groups"})
            time.sleep(3.0)
            before = tow.state.vessel_tension

            taken = client.update_configuration({"tether.drag_normal": 2.7, "monitor.alarms.over_tension.limit": 0.6,
                                                 "monitor.alarms.over_tension.warning": 0.5})
            self.assertEqual(taken["tether.drag_normal"], 2.7)
            self.assertTrue(wait_for(lambda: tow.state.vessel_tension > 1.15 * before),
                            "twice the drag, %g -> %g N" % (before, tow.state.vessel_tension))
            self.assertTrue(wait_for(lambda: tow.state.status == TetherState.STATUS_OK), "it goes on")
            self.assertTrue(wait_for(lambda: tow.limit("over_tension") == 0.6))
            self.assertEqual(rospy.get_param(MONITOR + "/tether/drag_normal"), 2.7)

            # One that cannot be, and the other is not taken either.
            taken = client.update_configuration({"tether.drag_normal": 2.0, "monitor.alarms.over_tension.warning": 0.9})
            self.assertEqual(taken["tether.drag_normal"], 2.7)
            self.assertEqual(taken["monitor.alarms.over_tension.warning"], 0.5)
            taken = client.update_configuration({"tether.drag_normal": -1.0})
            self.assertEqual(taken["tether.drag_normal"], 2.7)
            self.assertEqual(rospy.get_param(MONITOR + "/tether/drag_normal"), 2.7)

            # A new node begins with what was set.
            run_until(nodes, lambda: True, 5.0)
            nodes = start(NAMESPACE, "tether_monitor_node")
            again = Client(MONITOR, timeout=20.0)
            self.assertTrue(wait_for(lambda: (again.get_configuration(timeout=5.0) or {}).get("tether.drag_normal") == 2.7))
            self.assertEqual(run_until(nodes, lambda: False, 1.0), [True])
        finally:
            tow.is_over = True
            run_until(nodes, lambda: True, 1.0)


if __name__ == "__main__":
    rospy.init_node("live_settings_test")
    rostest.rosrun("tether_monitor", "live_settings", LiveSettings, sys.argv)
