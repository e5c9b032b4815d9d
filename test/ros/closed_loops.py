#!/usr/bin/python3
"""Closed loops on the monitor's outputs, each beside the same run with the loop open."""
import os
import threading
import unittest

import rospkg
import rospy
import rostest
import yaml
from geometry_msgs.msg import PoseStamped, WrenchStamped
from tether_monitor.msg import AlarmEvent, TetherState

import common.old_rospy  # noqa: F401
from common.nodes import run_until, start

PACKAGE = rospkg.RosPack().get_path("tether_monitor")
SPEED = 5.0      # simulated seconds per second, at most
LONGEST = 400.0  # [s], of the machine's clock, for a run


def size(v):
    return (v.x ** 2 + v.y ** 2 + v.z ** 2) ** 0.5


class Run:
    """A scenario with simulation, monitor and a controller (None: the loop is open) in a namespace of its own."""

    def __init__(self, ns, scenario, simulated, controller, parameters):
        with open(PACKAGE + "/config/scenarios/%s.yaml" % scenario) as text:
            self.tree = yaml.safe_load(text)
        self.tree["simulation"].update(clock=True, lockstep=True, speed=SPEED)
        self.ns, self.lock = "/" + ns, threading.Lock()
        self.tension, self.places, self.states, self.events = [], [], [], []
        for node in ("tether_sim", "tether_monitor"):
            rospy.set_param("%s/%s" % (self.ns, node), self.tree)
        rospy.set_param("/use_sim_time", True)
        subscribers = [
            rospy.Subscriber(self.ns + "/tether_sim/vessel_end/force", WrenchStamped, self.on_force, queue_size=1000),
            rospy.Subscriber(self.ns + "/vehicle/pose", PoseStamped, self.keeper(self.places), queue_size=1000),
            rospy.Subscriber(self.ns + "/tether_monitor/state", TetherState, self.keeper(self.states), queue_size=1000),
            rospy.Subscriber(self.ns + "/tether_monitor/events", AlarmEvent, self.keeper(self.events), queue_size=1000)]
        commands = ["tether_monitor_node __name:=tether_monitor", "tether_sim_node __name:=tether_sim"]
        if controller:
            name = controller.replace(".py", "")
            rospy.set_param("%s/%s" % (self.ns, name), parameters)
            commands.insert(0, [PACKAGE + "/scripts/" + controller, "__name:=" + name])
        self.alive = all(run_until(start(ns, *commands), lambda: self.time() > simulated, LONGEST))
        for subscriber in subscribers:
            subscriber.unregister()

    def time(self):
        """Simulated, of the last force [s]."""
        with self.lock:
            return self.tension[-1][0] if self.tension else 0.0

    def on_force(self, message):
        with self.lock:
            self.tension.append((message.header.stamp.to_sec(), size(message.wrench.force)))

    def keeper(self, target):
        def keep(message):
            with self.lock:
                target.append(message)
        return keep


def plot(name, curves, title, unit):
    """Leaves a picture in the folder of the environment variable CLOSED_LOOPS_PLOTS, if there is one."""
    folder = os.environ.get("CLOSED_LOOPS_PLOTS")
    if not folder:
        return
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(9.0, 4.0))
    for label, points in curves:
        axes.plot([p[0] for p in points], [p[1] for p in points], label=label, linewidth=0.8)
    axes.set_xlabel("time [s]")
    axes.set_ylabel(unit)
    axes.set_title(title)
    axes.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(folder, name + ".png"), dpi=110)


def parameters_of(controller):
    with open(PACKAGE + "/launch/controllers/%s.yaml" % controller) as text:
        return yaml.safe_load(text)


class ClosedLoops(unittest.TestCase):
    def test_winch(self):
        limit, end = 13000.0, 285.0
        loops = {name: Run("winch_" + name, "winch_control", end, controller, parameters_of("winch_controller"))
                 for name, controller in (("open", None), ("closed", "winch_controller.py"))}
        above, slack = {}, {}
        for name, loop in loops.items():
            self.assertTrue(loop.alive, name)
            points = [p for p in loop.tension if p[0] > 20.0]
            self.assertGreater(len(points), 1000)
            above[name] = sum(1 for _, tension in points if tension > limit) / len(points)
            valid = [s for s in loop.states if s.status != TetherState.STATUS_INVALID and s.header.stamp.to_sec() > 20.0]
            slack[name] = sum(1 for s in valid if min(s.tension) < 200.0) / len(valid)
            rospy.logwarn("winch, loop %s: above the working load %.3f of the time, slack %.3f, largest %.0f N, length %.0f to "
                  "%.0f m" % (name, above[name], slack[name], max(p[1] for p in points),
                              min(s.length for s in valid), max(s.length for s in valid)))
        plot("winch_control", [("loop " + name, loop.tension) for name, loop in loops.items()],
             "Tension at the vessel, working load 13 kN", "N")
        raised = {name: [e for e in loop.events if e.alarm.name == "over_tension" and e.to == 1]
                  for name, loop in loops.items()}
        self.assertGreater(above["open"], 0.005, "the scenario is worth a controller")
        self.assertTrue(raised["open"], "without a controller it alarms")
        self.assertLessEqual(above["closed"], 0.1 * above["open"])
        self.assertLess(slack["closed"], 0.001)

    def test_feed_forward(self):
        keeper, end, error = parameters_of("station_keeper"), 200.0, {}
        curves = []
        for name in ("without", "with"):
            loop = Run("feed_" + name, "feed_forward", end, "station_keeper.py",
                       dict(keeper, feed_forward=name == "with"))
            self.assertTrue(loop.alive, name)
            points = [(p.header.stamp.to_sec(), sum((getattr(p.pose.position, axis) - keeper["place"][i]) ** 2
                                                    for i, axis in enumerate("xyz")) ** 0.5) for p in loop.places]
            settled = [distance for t, distance in points if t > 60.0]
            self.assertGreater(len(settled), 1000)
            error[name] = (sum(d ** 2 for d in settled) / len(settled)) ** 0.5
            rospy.logwarn("station keeping %s feed-forward: position error %.3f m RMS, largest %.3f m",
                          name, error[name], max(settled))
            curves.append((name + " feed-forward", points))
        plot("feed_forward", curves, "Distance of the ROV from its place", "m")
        self.assertGreater(error["without"], 0.1, "the scenario is worth a feed-forward")
        self.assertLessEqual(error["with"], 0.5 * error["without"])


if __name__ == "__main__":
    rospy.init_node("closed_loops", disable_signals=True)
    rostest.rosrun("tether_monitor", "closed_loops", ClosedLoops)
