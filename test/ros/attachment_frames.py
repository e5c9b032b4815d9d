#!/usr/bin/python3
"""The tether is fastened where tf has the frames that its attachments name: for a node that begins before them, and in a bag."""
import csv
import os
import subprocess
import tempfile
import threading
import unittest

import numpy as np
import rosbag
import rospkg
import rospy
import rostest
import yaml
from geometry_msgs.msg import PoseStamped
from tether_monitor.msg import TetherState
from tf2_msgs.msg import TFMessage

import common.old_rospy  # noqa: F401
from common.imitated_stacks import set_vector, stamped, static
from common.nodes import run_until, start

PACKAGE = rospkg.RosPack().get_path("tether_monitor")
NAMESPACE = "/framed"
VESSEL, VEHICLE = (10.0, 5.0, 0.0), (-80.0, 5.0, -40.0)
FAIRLEAD, BRIDLE = (-12.0, 2.0, 3.0), (1.0, 0.0, 0.5)


def parameters():
    with open(PACKAGE + "/test/ros/common/tow_site.yaml") as text:
        site = yaml.safe_load(text)
    site["vessel"] = {"frame": "ship", "attachment": "fairlead"}
    site["vehicle"] = {"frame": "towfish", "attachment": "bridle"}
    return site


def mounts():
    return TFMessage([static("ship", "stern", (-10.0, 0.0, 0.0), np.eye(3)), static("stern", "fairlead", (-2.0, 2.0, 3.0), np.eye(3)),
                      static("towfish", "bridle", BRIDLE, np.eye(3))])


def pose(place, t):
    message = stamped(PoseStamped(), t, "map")
    set_vector(message.pose.position, place)
    message.pose.orientation.w = 1.0
    return message


class AttachmentFrames(unittest.TestCase):
    def assert_fastened(self, vessel_end, vehicle_end):
        for end, body, lever in ((vessel_end, VESSEL, FAIRLEAD), (vehicle_end, VEHICLE, BRIDLE)):
            for found, place, arm in zip(end, body, lever):
                self.assertAlmostEqual(found, place + arm, delta=0.01)

    def test_of_a_node_that_begins_before_them(self):
        rospy.set_param(NAMESPACE + "/tether_monitor", parameters())
        states = []
        rospy.Subscriber(NAMESPACE + "/tether_monitor/state", TetherState, states.append)
        poses = [(rospy.Publisher(NAMESPACE + "/%s/pose" % name, PoseStamped, queue_size=5), place)
                 for name, place in (("vessel", VESSEL), ("vehicle", VEHICLE))]
        static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        is_over = threading.Event()

        def play():
            count = 0
            while not is_over.wait(0.1):
                count += 1
                for publisher, place in poses:
                    publisher.publish(pose(place, rospy.get_time()))
                if count == 30:
                    static.publish(mounts())
        threading.Thread(target=play, daemon=True).start()
        alive = run_until(start(NAMESPACE, "tether_monitor_node"), lambda: states and states[-1].position, 25.0)
        is_over.set()
        self.assertEqual(alive, [True])
        ends = [(p.x, p.y, p.z) for p in (states[-1].position[0], states[-1].position[-1])]
        self.assert_fastened(*ends)

    def test_without_the_transform_it_says_which(self):
        site = parameters()
        site["vessel"]["attachment"] = "no_such_frame"
        site["vehicle"]["attachment"] = [0.0, 0.0, 0.0]
        rospy.set_param("/lost/tether_monitor", site)
        ended = subprocess.run(["rosrun", "tether_monitor", "tether_monitor_node", "__ns:=lost"], stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, universal_newlines=True, timeout=30)
        self.assertEqual(ended.returncode, 1, ended.stdout)
        self.assertIn("vessel.attachment = 'no_such_frame': no transform from that frame to 'ship'", ended.stdout)

    def replay(self, folder, *arguments):
        config = os.path.join(folder, "site.yaml")
        with open(config, "w") as text:
            yaml.safe_dump(parameters(), text)
        return subprocess.run(["rosrun", "tether_monitor", "tether_replay", "--config", config, "--out", folder + "/out"]
                              + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)

    def record(self, path, compression="none"):
        with rosbag.Bag(path, "w", compression=compression) as bag:
            for k in range(100):
                t = 1000.0 + 0.1 * k
                bag.write(NAMESPACE + "/vessel/pose", pose(VESSEL, t), rospy.Time(t))
                bag.write(NAMESPACE + "/vehicle/pose", pose(VEHICLE, t), rospy.Time(t))
            bag.write("/tf_static", mounts(), rospy.Time(1009.0))

    def test_of_a_bag(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "dive.bag")
            self.record(path)
            ended = self.replay(folder, "--bag", path, "--ns", NAMESPACE)
            self.assertEqual(ended.returncode, 0, ended.stdout)
            with open(folder + "/out/shape.csv") as text:
                rows = list(csv.DictReader(text))
            last = [[float(row[key]) for key in ("x", "y", "z")] for row in rows if row["t"] == rows[-1]["t"]]
            self.assert_fastened(last[0], last[-1])

    def test_of_a_bag_that_is_damaged(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "dive.bag")
            self.record(path, "bz2")
            with open(path, "rb") as bag:
                content = bytearray(bag.read())
            at = content.index(b"BZh") + 200
            content[at:at + 50] = bytes(50)
            with open(path, "wb") as bag:
                bag.write(content)
            ended = self.replay(folder, "--bag", path, "--ns", NAMESPACE)
            self.assertEqual(ended.returncode, 1, ended.stdout)
            self.assertIn("the bag %s is damaged" % path, ended.stdout)

    def test_a_table_has_no_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            ended = self.replay(folder, "--motion", PACKAGE + "/README.md")
            self.assertNotEqual(ended.returncode, 0)
            self.assertIn("vessel.attachment names a frame", ended.stdout)


if __name__ == "__main__":
    rospy.init_node("attachment_frames")
    rostest.rosrun("tether_monitor", "attachment_frames", AttachmentFrames)
