#!/usr/bin/python3
import collections
import threading
import unittest

import rospkg
import rospy
import rostest
import yaml
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import WrenchStamped
from tether_monitor.msg import ContactArray, TetherState

import common.old_rospy  # noqa: F401
from common.nodes import run_until, start

PACKAGE = rospkg.RosPack().get_path("tether_monitor")
WORDS = {TetherState.STATUS_OK: "OK", TetherState.STATUS_DEGRADED: "DEGRADED", TetherState.STATUS_INVALID: "INVALID"}


def size(wrench):
    f = wrench.wrench.force
    return (f.x ** 2 + f.y ** 2 + f.z ** 2) ** 0.5


class SimScenarios(unittest.TestCase):
    """Each test runs simulation and monitor in a namespace of its own, up to ten times as fast as real time."""

    def run_scenario(self, scenario, simulated, change=lambda tree: None, after=5.0, bound=0.05, good=("OK",)):
        with open(PACKAGE + "/config/scenarios/%s.yaml" % scenario) as text:
            tree = yaml.safe_load(text)
        tree["simulation"].update(clock=True, lockstep=True, speed=10.0)
        change(tree)
        ns = "/" + scenario
        for node in ("tether_sim", "tether_monitor"):
            rospy.set_param("%s/%s" % (ns, node), tree)
        lock = threading.Lock()
        truth, states, contacts, diagnostics = {}, [], [], []

        def keep(target):
            def callback(message):
                with lock:
                    target.append(message)
            return callback

        def keep_truth(message):
            with lock:
                truth[message.header.stamp] = size(message)

        subscribers = [
            rospy.Subscriber(ns + "/tether_sim/vessel_end/force", WrenchStamped, keep_truth, queue_size=1000),
            rospy.Subscriber(ns + "/tether_monitor/state", TetherState, keep(states), queue_size=1000),
            rospy.Subscriber(ns + "/tether_monitor/contacts", ContactArray, keep(contacts), queue_size=1000),
            rospy.Subscriber("/diagnostics", DiagnosticArray, keep(diagnostics), queue_size=1000)]
        rospy.set_param("/use_sim_time", True)

        def is_over():
            with lock:
                return states and states[-1].header.stamp.to_sec() > simulated

        nodes = start(ns[1:], "tether_monitor_node __name:=tether_monitor", "tether_sim_node __name:=tether_sim")
        alive = run_until(nodes, is_over, 240.0)
        for subscriber in subscribers:
            subscriber.unregister()
        self.assertEqual(alive, [True, True], "a node ended early")
        with lock:
            settled = [s for s in states if s.header.stamp.to_sec() > after]
            words = [WORDS[s.status] for s in settled]
            pairs = [(s, truth[s.header.stamp]) for s in settled
                     if s.header.stamp in truth and s.status != TetherState.STATUS_INVALID]
        self.assertGreater(len(settled), 100)
        spacing = (settled[-1].header.stamp - settled[0].header.stamp).to_sec() / (len(settled) - 1)
        self.assertLess(spacing, 1.1 / tree.get("monitor", {}).get("rate", 20.0), "time waits for every cycle")
        self.assertGreater(sum(word in good for word in words) / len(words), 0.95, collections.Counter(s.reason for s in settled))
        self.assertGreater(len(pairs), 50)
        mean = sum(force for _, force in pairs) / len(pairs)
        # The monitor extrapolates the newest pose to its tick: one tick late at most.
        rms = (sum((s.vessel_tension - force) ** 2 for s, force in pairs) / len(pairs)) ** 0.5
        self.assertLess(rms, max(bound * mean, 5.0), "vessel tension against the truth: %g of %g N" % (rms, mean))
        if states[-1].vessel_tension_stddev > 0.0:
            inside = sum(s.vessel_tension_p05 <= force <= s.vessel_tension_p95 for s, force in pairs)
            self.assertGreater(inside / len(pairs), 0.75, "truth between the 5 and 95 % quantiles")
        return [s for s in settled if s.status != TetherState.STATUS_INVALID], contacts, diagnostics

    def test_tow_and_turn(self):
        states, _, diagnostics = self.run_scenario("tow_and_turn", 60.0)
        self.assertGreater(states[-1].vessel_tension, 1000.0)
        vibration = [s.message for d in diagnostics for s in d.status if "vibration" in s.name]
        self.assertTrue(any("strum" in message for message in vibration), vibration[-3:])

    def test_heave_in_waves(self):
        states, _, _ = self.run_scenario("heave_in_waves", 60.0)
        tensions = [s.vessel_tension for s in states]
        self.assertGreater(max(tensions) - min(tensions), 300.0)

    def test_rov_and_pile(self):
        states, contacts, _ = self.run_scenario("rov_and_pile", 110.0)
        self.assertGreater(max(s.seabed_contact_length for s in states), 1.0)
        self.assertTrue(any(c.obstacle == "pile" for message in contacts for c in message.contacts))

    def test_payout_and_recovery(self):
        states, _, _ = self.run_scenario("payout_and_recovery", 90.0)
        self.assertAlmostEqual(max(s.payout_rate for s in states), 1.0, delta=0.02)
        self.assertGreater(states[-1].length, 240.0)

    def test_acoustic_navigation(self):
        # How good it is, simulation_test says, AcousticNavigation.*: a tow from positions alone has a wide band, and may be
        # DEGRADED for it. Here the two nodes have to get along.
        def lighter(tree):
            tree["simulation"]["speed"] = 4.0
            tree["solver"] = dict(tree.get("solver", {}), members=64)
            tree["tether"]["elements"] = 10
        states, _, diagnostics = self.run_scenario("acoustic_navigation", 140.0, lighter, after=80.0, bound=0.35,
                                                   good=("OK", "DEGRADED"))
        self.assertTrue(all(s.vessel_tension_stddev > 0.0 for s in states))
        values = {v.key: v.value for d in diagnostics for s in d.status for v in s.values}
        self.assertIn("Disturbance force on the vehicle [N]", values)

    def test_a_free_vehicle_is_followed_by_its_thrust(self):
        # A free vehicle starts from the steady state of the moment: the straight part of a tow is one.
        def free(tree):
            body = {key: tree["simulation"]["vehicle"][key]
                    for key in ("mass", "volume", "inertia", "drag_area", "added_mass", "rotational_drag",
                                "center_of_buoyancy")}
            tree["vehicle"] = dict(body, mode="free")
        self.run_scenario("tow_and_turn", 90.0, free)


if __name__ == "__main__":
    rospy.init_node("sim_scenarios", disable_signals=True)
    rostest.rosrun("tether_monitor", "sim_scenarios", SimScenarios)
