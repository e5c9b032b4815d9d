#!/usr/bin/python3
import signal
import subprocess
import time
import unittest

import rospkg
import rospy
import rostest
import yaml

import common.old_rospy  # noqa: F401

PACKAGE = rospkg.RosPack().get_path("tether_monitor")


class BadParameters(unittest.TestCase):
    def setUp(self):
        with open(PACKAGE + "/test/ros/common/test_site.yaml") as text:
            self.parameters = yaml.safe_load(text)

    def start(self):
        rospy.set_param("/bad/tether_monitor", self.parameters)
        try:
            return subprocess.run(["rosrun", "tether_monitor", "tether_monitor_node", "__ns:=bad"], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, universal_newlines=True, timeout=10)
        except subprocess.TimeoutExpired as alive:
            return alive
        finally:
            rospy.delete_param("/bad")

    def test_good_parameters_keep_it_running(self):
        self.assertIsInstance(self.start(), subprocess.TimeoutExpired)

    def test_sigint_ends_it_with_exit_code_0(self):
        rospy.set_param("/bad/tether_monitor", self.parameters)
        node = subprocess.Popen([self.binary(), "__ns:=bad"])
        time.sleep(2.0)
        self.assertIsNone(node.poll())
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(timeout=1.0), 0)

    def binary(self):
        found = subprocess.check_output(["catkin_find", "--first-only", "--libexec", "tether_monitor", "tether_monitor_node"],
                                        universal_newlines=True)
        return found.strip()

    def test_all_faults_at_once(self):
        self.parameters["tether"]["drag_tangental"] = self.parameters["tether"].pop("drag_tangential")
        self.parameters["tether"]["axial_stiffness"] = "stiff"
        self.parameters["tether"]["diameter"] = -0.012
        self.parameters["monitor"]["rate"] = 0
        self.parameters["montor"] = {"rate": 1.0}
        ended = self.start()
        self.assertEqual(ended.returncode, 1, ended)
        for fault in ("6 problem(s) with the parameters in /bad/tether_monitor",
                      "tether.axial_stiffness = 'stiff' is not a number",
                      "tether.drag_tangential is missing",
                      "tether.drag_tangental is not a known parameter",
                      "montor is not a known parameter",
                      "tether.diameter = -0.012 (must be > 0 m)",
                      "monitor.rate = 0 (must be"):
            self.assertIn(fault, ended.stdout)

    def test_no_parameters_at_all(self):
        self.parameters = {"tether": {}}
        ended = self.start()
        self.assertEqual(ended.returncode, 1, ended)
        self.assertIn("tether.length is missing", ended.stdout)


if __name__ == "__main__":
    rostest.rosrun("tether_monitor", "bad_parameters", BadParameters)
