#!/usr/bin/python3
"""Stacks as they are published, without a line of adapter code: live through their launch files, and as bags."""
import csv
import os
import re
import subprocess
import tempfile
import threading
import time
import unittest

import numpy as np
import rosbag
import rospkg
import rospy
import rostest
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

import common.imitated_stacks as stacks
import common.old_rospy  # noqa: F401
from tether_monitor.msg import TetherState

PACKAGE = rospkg.RosPack().get_path("tether_monitor")
BEGIN, DURATION, SPEED = 1000.0, 60.0, 8.0  # [s], [s], simulated seconds per second at most
TICK = 0.05  # [s] of the clock
PLACES = {"bluerov2_mavros": 1.0, "waterlinked_ugps": 1.0, "uuv_simulator": 0.05, "stonefish_cola2": 0.05}  # [m] off at most


def relative(t):
    return stacks.vehicle(t)[0] - stacks.boat(t)[0]


class Stacks(unittest.TestCase):
    def setUp(self):
        rospy.set_param("/use_sim_time", True)

    def replay(self, name):
        with tempfile.TemporaryDirectory() as folder:
            bag = os.path.join(folder, "dive.bag")
            with rosbag.Bag(bag, "w") as out:
                for t, topic, message in stacks.messages(name, BEGIN, DURATION):
                    out.write(topic, message, rospy.Time.from_sec(t))
            done = subprocess.run(["rosrun", "tether_monitor", "tether_replay", "--config", "%s/config/stacks/%s.yaml" % (PACKAGE, name),
                                   "--bag", bag, "--out", folder, "--quiet"], stderr=subprocess.PIPE, universal_newlines=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            refused = sum(int(n) for n in re.findall(r"(\d+) message\(s\)", done.stderr))
            self.assertLessEqual(refused, 3, "only what comes before the first attitude: " + done.stderr)
            with open(os.path.join(folder, "ends.csv"), newline="") as rows:
                statuses = [row["status"] for row in csv.DictReader(rows)]
        settled = statuses[len(statuses) // 2:]
        self.assertGreater(settled.count("OK"), 0.95 * len(settled), "%s: %s" % (name, set(settled)))

    def wait_for_monitor(self, states, now):
        """Time waits for the monitor, which a busy machine may hold up, two seconds at most."""
        deadline = time.time() + 2.0
        while states and now - states[-1].header.stamp.to_sec() > 1.5 * TICK and time.time() < deadline:
            time.sleep(0.002)

    def live(self, name):
        ns = "live_" + name
        launch = subprocess.Popen(["roslaunch", "tether_monitor", name + ".launch", "ns:=" + ns])
        states = []
        subscriber = rospy.Subscriber("/%s/tether_monitor/state" % ns, TetherState, states.append)
        clock = rospy.Publisher("/clock", Clock, queue_size=10)
        publishers = {}
        try:
            deadline = threading.Event()
            for _ in range(100):
                if subscriber.get_num_connections():
                    break
                deadline.wait(0.1)
            self.assertTrue(subscriber.get_num_connections(), "%s: no monitor" % name)
            all_messages = [m for m in stacks.messages(name, BEGIN, DURATION) if m[1] != "/tf_static"]
            for _, topic, message in all_messages:
                if topic not in publishers:
                    publishers[topic] = rospy.Publisher(topic, type(message), queue_size=50)
            deadline.wait(1.0)
            now = BEGIN - 0.1
            for t, topic, message in all_messages:
                while now < t - 1e-6:
                    now = round(now + TICK, 3)
                    clock.publish(Clock(rospy.Time.from_sec(now)))
                    deadline.wait(TICK / SPEED)
                    self.wait_for_monitor(states, now)
                publishers[topic].publish(message)
            deadline.wait(0.5)
        finally:
            launch.terminate()
            launch.wait(timeout=20.0)
            subscriber.unregister()
            for publisher in publishers.values():
                publisher.unregister()
        late = [(s.header.stamp.to_sec(), s) for s in states]
        late = [(t, s) for t, s in late if t > BEGIN + 0.5 * DURATION]
        self.assertGreater(len(late), 100, name)
        ok = [(t, s) for t, s in late if s.status == TetherState.STATUS_OK]
        self.assertGreater(len(ok), 0.9 * len(late), "%s: %s" % (name, {(s.status, s.reason) for _, s in late}))
        off = [np.array([s.vehicle_relative.x, s.vehicle_relative.y, s.vehicle_relative.z]) - relative(t) for t, s in ok]
        rms = float(np.sqrt(np.mean([o.dot(o) for o in off])))
        print("%s: OK %d of %d, vehicle relative to the vessel %.3f m RMS off" % (name, len(ok), len(late), rms))
        self.assertLess(rms, PLACES[name], name)


for stack in stacks.STACKS:
    setattr(Stacks, "test_%s_as_a_bag" % stack, lambda self, name=stack: self.replay(name))
    setattr(Stacks, "test_%s_live" % stack, lambda self, name=stack: self.live(name))

if __name__ == "__main__":
    rospy.init_node("stacks", disable_rostime=True)
    rostest.rosrun("tether_monitor", "stacks", Stacks)
