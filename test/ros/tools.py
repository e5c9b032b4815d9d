#!/usr/bin/python3
import csv
import fcntl
import json
import math
import os
import random
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import rosbag
import rospkg
import rospy
import rostest
import yaml
from geometry_msgs.msg import PoseStamped
from std_msgs.msg import String

import common.old_rospy  # noqa: F401

PACKAGE = rospkg.RosPack().get_path("tether_monitor")
SITE = PACKAGE + "/test/ros/common/test_site.yaml"
TANK = PACKAGE + "/config/tank_run.yaml"
TANK_BAG = PACKAGE + "/test/data/tank_run.bag"
HEADER = "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z\n"


def run(tool, *arguments):
    return subprocess.run(["rosrun", "tether_monitor", tool] + list(arguments), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, timeout=60)


def rows(path):
    with open(path, newline="") as lines:
        return list(csv.DictReader(lines))


class Tools(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = os.path.join(self.folder.name, "out")

    def tearDown(self):
        self.folder.cleanup()

    def file(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w") as target:
            target.write(text)
        return path

    def refused(self, ended, *words):
        self.assertEqual(ended.returncode, 1, ended.stdout)
        for word in words:
            self.assertIn(word, ended.stdout)

    def replay(self, *arguments, config=SITE):
        return run("tether_replay", "--config", config, "--out", self.out, "--quiet", *arguments)

    def tow_config(self, name, mode, drag):
        with open(SITE) as text:
            tree = yaml.safe_load(text)
        tree["tether"].update(drag_normal=drag, elements=10)
        tree["vehicle"] = {"mode": mode, "mass": 120.0, "volume": 0.02, "inertia": [5.0, 5.0, 5.0],
                           "drag_area": [0.1, 0.1, 0.1], "added_mass": [20.0, 20.0, 20.0], "center_of_buoyancy": [0.0, 0.0, 0.05]}
        return self.file(name + ".yaml", yaml.safe_dump(tree))

    def test_identify(self):
        # A tow that turns, by a free vehicle under a tether with more drag than will be configured.
        radius, speed, noise = 60.0, 1.5, random.Random(1)
        way, x, y, heading = [], 0.0, 0.0, 0.0
        for k in range(1800):
            vx, vy = speed * math.cos(heading), speed * math.sin(heading)
            way.append("%.1f,%.4f,%.4f,0,%.5f,%.5f,0" % (0.1 * k, x, y, vx, vy))
            heading += 0.1 * speed / radius if 600 <= k < 1200 else 0.0
            x, y = x + 0.1 * vx, y + 0.1 * vy
        head = "t,vessel_x,vessel_y,vessel_z,vessel_vx,vessel_vy,vessel_vz"
        path = self.file("way.csv", "\n".join([head] + way) + "\n")
        ended = self.replay("--motion", path, config=self.tow_config("truth", "free", 1.8))
        self.assertEqual((ended.returncode, ended.stdout), (0, ""))
        dive = [head + ",vehicle_x,vehicle_y,vehicle_z,tension"]
        for k, row in enumerate(rows(self.out + "/ends.csv")):
            place = ["%.3f" % (float(row["vehicle_" + axis]) + noise.gauss(0.0, 0.1)) for axis in "xyz"] if k % 10 == 0 else [""] * 3
            tension = math.sqrt(sum(float(row["vessel_f" + axis]) ** 2 for axis in "xyz"))
            dive.append(",".join([way[k]] + place + ["%.2f" % (tension * (1.0 + noise.gauss(0.0, 0.01)))]))
        dive = "\n".join(dive) + "\n"
        told = self.tow_config("told", "observed", 1.35)
        ended = run("tether_identify", "--config", told, "--motion", self.file("dive.csv", dive), "--out", self.out)
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertIn("the record does not tell", ended.stdout)
        with open(self.out + "/identified.yaml") as text:
            found = yaml.safe_load(text)
        self.assertAlmostEqual(float(found["tether"]["drag_normal"]), 1.8, delta=0.2, msg=ended.stdout)
        self.assertLess(float(found["tether"]["uncertainty"]["drag_normal"]), 0.2)
        self.assertEqual(found["tether"]["length"], 100.0 if "length" not in found["tether"]["uncertainty"] else found["tether"]["length"])
        self.assertEqual(found["vehicle"]["mass"], 120.0)
        ended = self.replay("--motion", os.path.join(self.folder.name, "dive.csv"), config=self.out + "/identified.yaml")
        self.assertEqual((ended.returncode, ended.stdout), (0, ""), "what it wrote can be used")
        self.refused(run("tether_identify", "--config", SITE, "--motion", path, "--out", self.out), "vehicle.mode must be observed")

    def test_bag(self):
        ended = self.replay("--bag", TANK_BAG, config=TANK)
        self.assertEqual((ended.returncode, ended.stdout), (0, ""))
        ends = rows(self.out + "/ends.csv")
        self.assertEqual(len(ends), 249)
        self.assertTrue(all(row["status"] in ("OK", "DEGRADED") for row in ends))
        with open(self.out + "/summary.json") as text:
            summary = json.load(text)
        self.assertEqual(set(summary), {"elements", "largest_step", "expected_error", "reason", "simulated_seconds", "cpu_seconds",
                                        "steps", "iterations", "rejected_steps", "worst_step_us", "max_tension", "max_tension_t", "max_tension_s", "status",
                                        "working_load", "breaking_load"})
        self.assertEqual(sum(summary["status"].values()), 249)
        alarms = rows(self.out + "/alarms.csv")
        self.assertIn("over_tension", [row["name"] for row in alarms])
        self.assertEqual(len({row["t"] for row in rows(self.out + "/shape.csv")}), 13)

    def test_the_output_rate_does_not_change_what_a_bag_says(self):
        largest = []
        for rate in ("20", "1"):
            self.assertEqual(self.replay("--bag", TANK_BAG, "--rate", rate, config=TANK).returncode, 0)
            with open(self.out + "/summary.json") as text:
                largest.append(json.load(text)["max_tension"])
            self.assertIn("over_tension", [row["name"] for row in rows(self.out + "/alarms.csv")])
        self.assertAlmostEqual(largest[0], largest[1], delta=1e-3 * largest[0])

    def test_bags_with_streams_of_uneven_rates_and_stray_stamps(self):
        path = os.path.join(self.folder.name, "uneven.bag")
        with rosbag.Bag(path, "w") as bag:
            for i in range(4000):
                message = PoseStamped()
                message.header.stamp = rospy.Time.from_sec(100.0 + i / 400.0)
                message.header.frame_id = "map"
                message.pose.orientation.w = 1.0
                message.pose.position.z = 1.0
                bag.write("/vessel/pose", message, message.header.stamp)
                if i % 400 == 0:
                    message.pose.position.x, message.pose.position.z = 60.0, -70.0
                    bag.write("/vehicle/pose", message, message.header.stamp)
            message.header.stamp = rospy.Time(4.0e8)
            bag.write("/vehicle/pose", message, rospy.Time(105))
        ended = self.replay("--bag", path)
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertIn("1 message(s) on vehicle/pose refused", ended.stdout)
        ends = rows(self.out + "/ends.csv")
        self.assertLess(len(ends), 250)
        self.assertNotIn("INVALID", [row["status"] for row in ends])

    def test_steady_state_of_a_free_vehicle(self):
        with open(SITE) as site:
            config = self.file("free.yaml", site.read() + "vehicle: {mode: free, mass: 100.0, volume: 0.05, "
                               "inertia: [1, 1, 1], drag_area: [0.1, 0.1, 0.1], center_of_buoyancy: [0, 0, 0.05]}\n")
        ended = run("tether_steady", "--config", config, "--vessel-position", "0,0,-1", "--out", self.out, "--quiet")
        self.assertEqual((ended.returncode, ended.stdout), (0, ""))
        ends = rows(self.out + "/ends.csv")[0]
        self.assertAlmostEqual(float(ends["vehicle_z"]), -100.0, delta=0.1)
        self.assertAlmostEqual(float(ends["vehicle_fz"]), (100.0 - 1025.0 * 0.05) * 9.81, delta=0.01)
        self.refused(run("tether_steady", "--config", config, "--vehicle-position", "1,2,3", "--out", self.out),
                     "cannot be given for a free vehicle")

    def free_vehicle(self):
        with open(SITE) as site:
            return self.file("free.yaml", site.read() + "vehicle: {mode: free, mass: 100.0, volume: 0.05, "
                             "inertia: [1, 1, 1], drag_area: [0.1, 0.1, 0.1], center_of_buoyancy: [0, 0, 0.05]}\n")

    def test_replay_of_a_free_vehicle(self):
        rows_of_motion = "".join("%g,%g,0,-1,%g,0,0\n" % (0.1 * i, 0.05 * i, 0.0 if i < 50 else 30.0)
                                 for i in range(100))
        header = "t,vessel_x,vessel_y,vessel_z,thrust_x,thrust_y,thrust_z\n"
        ended = self.replay("--motion", self.file("m.csv", header + rows_of_motion), config=self.free_vehicle())
        self.assertEqual((ended.returncode, ended.stdout), (0, ""))
        ends = rows(self.out + "/ends.csv")
        self.assertEqual(list(ends[0])[-7:], ["vehicle_x", "vehicle_y", "vehicle_z", "vehicle_qx", "vehicle_qy",
                                              "vehicle_qz", "vehicle_qw"])
        self.assertGreater(float(ends[-1]["vehicle_x"]), float(ends[0]["vehicle_x"]))
        self.assertEqual({row["status"] for row in ends}, {"OK"})
        self.refused(self.replay("--motion", self.file("m.csv", HEADER + "0,0,0,1,60,0,-70\n"),
                                 config=self.free_vehicle()), "vehicle_x is not for a free vehicle")
        self.refused(self.replay("--motion", self.file("m.csv", HEADER[:-1] + ",thrust_x,thrust_y,thrust_z\n"
                                                       "0,0,0,1,60,0,-70,1,0,0\n")), "thrust_x is not known")

    def test_replay_with_the_papers_scheme_and_contacts(self):
        with open(SITE) as site:
            tree = yaml.safe_load(site)
        tree["solver"] = {"integrator": "abarbanel_zwas", "corrections": 1}
        tree["tether"].update(axial_stiffness=2.0e5, elements=6)
        tree["environment"] = {"seabed": {"depth": 60.0}, "waves": {"amplitude": 0.5, "length": 60.0}}
        config = self.file("site.yaml", yaml.safe_dump(tree))
        motion = "".join("%g,0,0,1,60,0,-59.9,100\n" % (0.5 * i) for i in range(5))
        ended = self.replay("--motion", self.file("m.csv", HEADER[:-1] + ",payout\n" + motion), config=config)
        self.assertEqual((ended.returncode, ended.stdout), (0, ""))
        self.assertIn("stress", rows(self.out + "/shape.csv")[0])
        self.assertNotIn("INVALID", {row["status"] for row in rows(self.out + "/ends.csv")})

    def test_modes(self):
        ended = run("tether_steady", "--config", SITE, "--vessel-position", "0,0,-1", "--vehicle-position", "70,0,-70",
                    "--modes", "7", "--out", self.out, "--quiet")
        self.assertEqual((ended.returncode, ended.stdout), (0, ""))
        modes = rows(self.out + "/modes.csv")
        self.assertEqual([row["mode"] for row in modes], [str(i) for i in range(1, 8)])
        frequencies = [float(row["frequency_hz"]) for row in modes]
        self.assertEqual(frequencies, sorted(frequencies))
        self.assertLessEqual({row["kind"] for row in modes}, {"axial", "transverse"})
        shapes = rows(self.out + "/mode_shapes.csv")
        self.assertEqual(list(shapes[0]), ["mode", "s", "dx", "dy", "dz"])
        self.refused(run("tether_steady", "--config", SITE, "--vehicle-position", "70,0,-70", "--modes", "-1",
                         "--out", self.out), "--modes")

    def test_motion_with_a_gap_in_time(self):
        motion = self.file("m.csv", "# a comment\n" + HEADER + "0,0,0,1,60,0,-70\n0.5,0,0,1,60.1,0,-70\n4,0,0,1,61,0,-70\n")
        ended = self.replay("--motion", motion, "--shape-rate", "0")
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertEqual([row["t"] for row in rows(self.out + "/ends.csv")], ["0", "0.5", "4"])
        self.assertFalse(os.path.exists(self.out + "/shape.csv"))

    def test_bad_motions(self):
        self.refused(self.replay("--motion", self.file("m.csv", "")), "m.csv is empty")
        self.refused(self.replay("--motion", self.file("m.csv", HEADER.replace(",vessel_z", "") + "0,0,0,0,0,0\n")),
                     "column vessel_z is missing")
        self.refused(self.replay("--motion", self.file("m.csv", HEADER + "0,0,0,1,60,0,-70\n0,0,0,1,60,0,-70\n")),
                     "m.csv, line 3: t does not increase")
        self.refused(self.replay("--motion", "/nowhere.csv"), "cannot read /nowhere.csv")

    def test_bad_bags(self):
        self.refused(self.replay("--bag", "/nowhere.bag"), "/nowhere.bag")
        self.refused(self.replay("--bag", self.file("text.bag", "no bag at all\n")), "text.bag")
        with open(TANK_BAG, "rb") as whole:
            content = whole.read()
        for name, share in (("half.bag", 0.5), ("stub.bag", 0.0001), ("nothing.bag", 0.0)):
            path = os.path.join(self.folder.name, name)
            with open(path, "wb") as part:
                part.write(content[:int(share * len(content))])
            self.refused(self.replay("--bag", path), name)
        empty = os.path.join(self.folder.name, "empty.bag")
        with rosbag.Bag(empty, "w"):
            pass
        self.refused(self.replay("--bag", empty), "empty.bag", "no messages at all")
        foreign = os.path.join(self.folder.name, "foreign.bag")
        with rosbag.Bag(foreign, "w") as bag:
            bag.write("/chatter", String("hello"), rospy.Time(1))
            pose = PoseStamped()
            pose.header.stamp = rospy.Time(1)
            bag.write("/rov7/vessel/pose", pose, rospy.Time(1))
        self.refused(self.replay("--bag", foreign), "/vessel/pose", "/chatter", "Try --ns rov7")
        with rosbag.Bag(foreign, "w") as bag:
            for topic in ("/vessel/pose", "/vehicle/pose"):
                bag.write(topic, pose, rospy.Time(1))
        self.refused(self.replay("--bag", foreign), "was refused", "frame_id is empty")
        self.assertEqual(os.listdir(self.out), [], "files of results without a result")

    def test_a_topic_of_another_type_is_named_with_both(self):
        path = os.path.join(self.folder.name, "type.bag")
        with rosbag.Bag(path, "w") as bag:
            bag.write("/vessel/pose", String("hello"), rospy.Time(1))
        self.refused(self.replay("--bag", path), "std_msgs/String", "geometry_msgs/PoseStamped")

    def test_a_topic_that_the_bag_has_not_and_a_useless_result_are_told(self):
        with open(TANK) as text:
            tree = yaml.safe_load(text)
        tree["inputs"] = [{"topic": "vehicle/velocity", "from": "/robot/twst"}]
        tree["tether"]["length"] = 0.5
        ended = self.replay("--bag", TANK_BAG, config=self.file("typo.yaml", yaml.safe_dump(tree)))
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertIn("the bag has no topic /robot/twst, from which vehicle/velocity is to be read", ended.stdout)
        self.assertRegex(ended.stdout, "there is no estimate: .*[A-Z]+ [0-9.]+ %")

    def test_what_was_written_is_named(self):
        ended = run("tether_replay", "--config", TANK, "--bag", TANK_BAG, "--out", self.out)
        self.assertRegex(ended.stdout, r"estimate: OK [0-9.]+ %")
        named = re.search("wrote (.*) to", ended.stdout).group(1).split(", ")
        self.assertEqual(sorted(named), sorted(os.listdir(self.out)))

    def test_one_record_of_the_year_2096_does_not_lose_the_run(self):
        path = os.path.join(self.folder.name, "far.bag")
        with rosbag.Bag(path, "w") as bag:
            for i in range(100):
                for topic, x, z in (("/vessel/pose", 0.0, 1.0), ("/vehicle/pose", 60.0, -70.0)):
                    pose = PoseStamped()
                    pose.header.stamp = rospy.Time(4000000000 if i == 50 else 1700000000 + i)
                    pose.header.frame_id = "map"
                    pose.pose.position.x, pose.pose.position.z, pose.pose.orientation.w = x, z, 1.0
                    bag.write(topic, pose, pose.header.stamp)
        ended = self.replay("--bag", path, "--rate", "1")
        self.assertEqual(ended.returncode, 0, ended.stdout)
        self.assertIn("30 days", ended.stdout)
        self.assertEqual(len(rows(self.out + "/ends.csv")), 100)

    def test_two_runs_into_one_folder(self):
        os.mkdir(self.out)
        held = os.open(self.out, os.O_RDONLY)
        fcntl.flock(held, fcntl.LOCK_EX)
        self.refused(self.replay("--bag", TANK_BAG, config=TANK), "another run")
        os.close(held)
        self.assertEqual(self.replay("--bag", TANK_BAG, config=TANK).returncode, 0)

    def test_an_interrupted_run_leaves_whole_rows_and_says_so(self):
        motion = self.file("long.csv", "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z\n" + "".join(
            "%d,0,0,1,%g,0,-70\n" % (i, 60 + 0.5 * math.sin(0.3 * i)) for i in range(200000)))
        replay = subprocess.Popen([shutil.which("rosrun"), "tether_monitor", "tether_replay", "--config", SITE, "--motion",
                                   motion, "--out", self.out, "--rate", "1"], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
        for _ in range(100):
            if os.path.exists(self.out + "/ends.csv") and os.path.getsize(self.out + "/ends.csv") > 4096:
                break
            time.sleep(0.1)
        replay.send_signal(signal.SIGINT)
        self.assertEqual(replay.wait(20), 130)
        with open(self.out + "/summary.json") as text:
            self.assertTrue(json.load(text)["interrupted"])
        lines = open(self.out + "/ends.csv").read()
        self.assertTrue(lines.endswith("\n"))
        self.assertEqual({line.count(",") for line in lines.splitlines()}, {10})

    def test_a_tether_that_parts(self):
        motion = self.file("still.csv", "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z\n" + "".join(
            "%d,0,0,1,60,0,-70\n" % i for i in range(61)))
        self.assertEqual(self.replay("--motion", motion, "--part-at", "5,40").returncode, 0)
        ends = rows(self.out + "/ends.csv")
        self.assertLess(abs(float(ends[-1]["vessel_fx"])), 0.1 * abs(float(ends[0]["vessel_fx"])))
        self.refused(self.replay("--motion", motion, "--part-at", "5"), "two numbers")
        self.refused(self.replay("--motion", motion, "--part-at", "500,40"), "cannot part at t = 500")

    def test_forecasts_are_made_and_scored(self):
        motion = self.file("off.csv", "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z\n" + "".join(
            "%.1f,0,0,1,%.3f,0,%.3f\n" % (0.5 * i, 48 + 0.15 * i, -58 - 0.1 * i) for i in range(161)))
        self.assertEqual(self.replay("--motion", motion, "--forecast").returncode, 0)
        forecasts = rows(self.out + "/forecast.csv")
        self.assertGreater(len(forecasts), 50)
        self.assertLess(float(forecasts[0]["probability_over_tension"]), 0.1)
        with open(self.out + "/summary.json") as text:
            score = json.load(text)["forecast"]
        self.assertEqual(score["forecasts"], len(forecasts))
        self.assertEqual(score["events"], 1)
        self.assertEqual([(w["warned_10_s_ahead"], w["false_warnings"]) for w in score["warnings"]], [(1, 0)] * 3)

    def test_bad_arguments(self):
        self.assertEqual(run("tether_replay").returncode, 1)
        self.assertEqual(run("tether_replay", "--help").returncode, 0)
        self.refused(run("tether_replay", "--config", SITE, "--out", self.out), "--bag or --motion")
        self.refused(self.replay("--bag", TANK_BAG, "--motion", "x.csv"), "cannot be given together")
        self.refused(self.replay("--bag", TANK_BAG, config="/nowhere.yaml"), "/nowhere.yaml")
        bad = self.file("bad.yaml", "tether: {length: 3}\n")
        self.refused(self.replay("--bag", TANK_BAG, config=bad), "bad.yaml", "tether.diameter is missing")
        blocker = self.file("blocker", "")
        self.refused(run("tether_replay", "--config", TANK, "--bag", TANK_BAG, "--out", blocker + "/out", "--quiet"),
                     "cannot make the folder " + blocker + "/out")

    def test_steady(self):
        ended = run("tether_steady", "--config", SITE, "--vessel-position", "0,0,1", "--vehicle-position", "60,0,-70",
                    "--out", self.out)
        self.assertEqual(ended.returncode, 0, ended.stdout)
        ends = rows(self.out + "/ends.csv")
        self.assertEqual(len(ends), 1)
        self.assertEqual(float(ends[0]["vehicle_z"]), -71.0)
        self.assertLess(float(ends[0]["vessel_fz"]), 0.0)
        self.assertEqual(len(rows(self.out + "/shape.csv")), 41)
        self.refused(run("tether_steady", "--config", SITE, "--vehicle-position", "60,0", "--out", self.out),
                     "--vehicle-position = '60,0' is not three numbers")
        self.assertEqual(run("tether_steady", "--config", SITE, "--out", self.out).returncode, 1)


if __name__ == "__main__":
    rostest.rosrun("tether_monitor", "tools", Tools)
