#!/usr/bin/python3
"""Runs the node at 100 Hz beside poses at 100 Hz, and prints what its diagnostics say of its timing."""
import os
import signal
import subprocess
import sys
import time

PORT = "11399"
os.environ["ROS_MASTER_URI"] = "http://localhost:" + PORT

import rospy  # noqa: E402
import yaml  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray  # noqa: E402
from geometry_msgs.msg import PoseStamped  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RATE = 100.0  # [Hz]
BUSY_LOOPS = 4
FIFO = 70


def measure(seconds, busy, priority):
    with open(ROOT + "/test/ros/common/test_site.yaml") as text:
        tree = yaml.safe_load(text)
    tree.setdefault("monitor", {}).update(rate=RATE, realtime={"priority": priority, "lock_memory": priority > 0})
    rospy.set_param("/timing/tether_monitor", tree)
    values = {}

    def keep(message):
        for status in message.status:
            if "timing" in status.name:
                values.update({value.key: value.value for value in status.values}, summary=status.message)
    subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, keep)
    node = subprocess.Popen(["rosrun", "tether_monitor", "tether_monitor_node", "__ns:=timing",
                             "__name:=tether_monitor"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(BUSY_LOOPS if busy else 0)]
    ends = [(rospy.Publisher("/timing/%s/pose" % body, PoseStamped, queue_size=10), place)
            for body, place in (("vessel", (0.0, 0.0, 1.0)), ("vehicle", (60.0, 0.0, -70.0)))]
    end = time.monotonic() + seconds
    due = time.monotonic()
    while time.monotonic() < end:
        message = PoseStamped()
        message.header.stamp = rospy.Time.now()
        message.header.frame_id = tree.get("world_frame", "map")
        message.pose.orientation.w = 1.0
        for publisher, (x, y, z) in ends:
            message.pose.position.x, message.pose.position.y, message.pose.position.z = x, y, z
            publisher.publish(message)
        due += 1.0 / RATE
        time.sleep(max(due - time.monotonic(), 0.0))
    for loop in loops:
        loop.kill()
    time.sleep(1.5)
    node.send_signal(signal.SIGINT)
    node.wait()
    subscriber.unregister()
    print("| %s | %s | %s | %s | %s |" % ("busy" if busy else "idle", "FIFO" if priority else "no",
          values.get("Cycles", "none"), values.get("Wake-up after its time", ""), values.get("Input to output", "")))
    if values.get("summary", "on time") != "on time":
        print("  " + values["summary"])


def main():
    core = subprocess.Popen(["roscore", "-p", PORT], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        time.sleep(3.0)
        rospy.init_node("measure_timing", disable_signals=True)
        print("| machine | priority | cycles | wake-up after its time | input to output |\n|---|---|---|---|---|")
        only = sys.argv[2:]
        for busy in (False, True):
            for priority in (0, FIFO):
                if only and not ("busy" if busy else "idle") + ("-fifo" if priority else "") in only:
                    continue
                measure(float(sys.argv[1]), busy, priority)
    finally:
        core.send_signal(signal.SIGINT)
        core.wait()


if __name__ == "__main__":
    main()
