#!/usr/bin/python3
"""The report of a dive: counts and figures against values that are known."""
import csv
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(ROOT, "report"), os.path.join(ROOT, "web")]

import browser  # noqa: E402
import page  # noqa: E402
import rainflow  # noqa: E402
from replay_folder import ReplayError, ReplayFolder  # noqa: E402

DURATION, RATE, LENGTH = 120.0, 10.0, 100.0


def tension(t):
    return 3000.0 + 1500.0 * math.sin(2.0 * math.pi * t / 8.0)


def write(path, head, rows):
    with open(path, "w", newline="") as out:
        csv.writer(out).writerows([head.split(",")] + rows)


def dive(folder):
    """A tether of 100 m whose tension swings, too taut from 60 s to 64 s."""
    times = [k / RATE for k in range(int(DURATION * RATE))]
    write(folder + "/ends.csv", "t,vessel_fx,vessel_fy,vessel_fz,vehicle_fx,vehicle_fy,vehicle_fz,max_tension,max_tension_s,stretched_length,status,"
          "vessel_tension_p05,vessel_tension_p95",
          [[t, 0.6 * tension(t), 0, 0.8 * tension(t), 100, 0, 0, tension(t), 12.5, LENGTH, "INVALID" if t < 12.0 else "OK", tension(t) - 50.0,
            tension(t) + 50.0] for t in times])
    write(folder + "/alarms.csv", "t,name,state,severity,value,limit,s",
          [[60, "over_tension", "ACTIVE", "ALARM", 1.05, 1, 0], [64, "over_tension", "NORMAL", "ALARM", 0.8, 1, 0],
           [70, "slack", "ACTIVE", "WARNING", 4, 10, 90]])
    write(folder + "/shape.csv", "t,s,x,y,z,tension,strain,bend_radius,stress",
          [[t, 10 * i, 7 + 8 * i, 5, -6 * i, tension(t), 0, 0, 0] for t in range(0, 120) for i in range(11)])
    write(folder + "/parameters.csv", "t,name,mean,stddev,configured,configured_stddev",
          [[t, "tether.drag_normal", 1.2 + 0.002 * t, 0.3 - 0.002 * t, 1.2, 0.3] for t in range(0, 120)]
          + [[t, "tension.bias", 3.0, 178.0, 0, 180] for t in range(0, 120)])
    write(folder + "/forecast.csv", "t,horizon,members,probability_over_tension,probability_breaking,probability_slack,time_to_warning,time_to_limit,"
          "time_to_limit_p05,time_to_slack,place_s,max_tension,max_tension_p05,max_tension_p95",
          [[t, 30, 64, 0.5, 0, 0, "", "", "", "", 0, 4400, 4000, 4700] for t in range(0, 120)])
    write(folder + "/inputs.csv", "t,topic,messages,refused,delay,longest_gap",
          [[t, "vehicle/pose", 10, 0, 1.0, 1.0] for t in range(0, 60, 10)] + [[80, "vehicle/pose", 5, 2, 3.0, 21.5]]
          + [[t, "vessel/pose", 100, 0, 0.0, 0.1] for t in range(0, 120, 10)])
    with open(folder + "/summary.json", "w") as out:
        json.dump({"working_load": 4000.0, "breaking_load": 16000.0, "reason": {"SETTLING": 120}, "epoch": 1600000000.0,
                   "forecast": {"forecasts": 120, "events": 2, "brier_score": 0.125, "cpu_seconds": 7.2,
                                "warnings": [{"from_probability": 0.5, "warnings": 4, "false_warnings": 1, "warned_10_s_ahead": 2, "median_lead_time": 12.5},
                                             {"from_probability": 0.95, "warnings": 0, "false_warnings": 0, "warned_10_s_ahead": 0, "median_lead_time": None}]}}, out)


class Report(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        dive(self.folder)

    def tearDown(self):
        self.temporary.cleanup()

    def page(self):
        return page.page(ReplayFolder(self.folder), "A <dive>")

    def test_says_what_the_files_say(self):
        text = self.page()
        self.assertIn("<h1>A &lt;dive&gt;</h1>", text)
        for words in ("largest tension<b>4.5 kN</b>", "of the working load<b>112 %</b>", "INVALID<b>10.0 % of the time</b>", "OK<b>90.0 % of the time</b>",
                      "<td>over tension</td><td>alarm</td><td>60.0</td><td>64.0</td><td>1.05</td>", "<td>slack</td><td>warning</td><td>70.0</td><td>-</td>",
                      "<td>vehicle/pose</td><td>65</td><td>2</td><td>1.15</td><td>21.5, in the ten seconds from t = 80</td>",
                      "<td>SETTLING</td><td>120</td>", "began<b>2020-09-13 12:26:40 UTC</b>",
                      "<td>120</td><td>2</td><td>0.12</td><td>0.060</td>", "<td>50 %</td><td>4</td><td>1</td><td>2</td><td>12</td>", "<td>95 %</td><td>0</td><td>0</td><td>0</td><td>-</td>",
                      "<td>tether.drag_normal</td><td></td><td>1.20 ± 0.30</td><td>1.438 ± 0.062</td>",
                      "<td>tension.bias</td><td>N</td><td>0 ± 180</td><td>the dive does not tell</td>"):
            self.assertIn(words, text)
        data = json.loads(re.search(r'id="shape-data">(.*?)</script>', text).group(1))
        self.assertEqual(len(data["frames"]), 120)
        self.assertEqual(data["frames"][30]["r"][10], 80.0)
        self.assertEqual(data["frames"][30]["z"][10], -60.0)
        self.assertEqual(data["frames"][2]["tension"][0], 4500.0)
        self.assertEqual(data["unit"], "kN")

    def test_needs_no_network(self):
        text = self.page()
        self.assertEqual(re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', text), [])
        self.assertNotIn("@import", text)

    def test_says_what_is_missing(self):
        def refused(*words):
            with self.assertRaises(ReplayError) as raised:
                self.page()
            for word in words:
                self.assertIn(word, str(raised.exception))
        ends = self.folder + "/ends.csv"
        with open(ends) as text:
            whole = text.read()
        for damaged, words in ((whole.replace("status", "state", 1), ["ends.csv", "status"]), (whole.splitlines()[0] + "\n", ["no rows"]),
                               (whole + "1,2\n", ["13 fields"]), (whole.replace("3000", "many", 1), ["many"])):
            with open(ends, "w") as out:
                out.write(damaged)
            refused(*words)
        with open(ends, "w") as out:
            out.write(whole)
        os.remove(self.folder + "/summary.json")
        refused("summary.json")

    def test_a_dive_without_extras(self):
        for name in ("shape", "parameters", "forecast", "inputs"):
            os.remove(self.folder + "/%s.csv" % name)
        text = self.page()
        self.assertIn("Tension", text)
        self.assertNotIn("shape-data", text)

    def test_program(self):
        program = ROOT + "/scripts/tether_report"
        out = self.folder + "/report.html"
        done = subprocess.run([program, self.folder, "--out", out], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual((done.returncode, done.stdout), (0, "wrote %s\n" % out))
        done = subprocess.run([program, "/nowhere"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual((done.returncode, done.stdout), (1, "tether_report: /nowhere is no folder\n"))


    @unittest.skipUnless(browser.program(), "no Chromium: scripts/install_dependencies browser")
    def test_in_a_browser(self):
        path = self.folder + "/report.html"
        with open(path, "w", encoding="utf-8") as out:
            out.write(self.page())
        with browser.Browser() as shown:
            shown.open("file://" + path)
            self.assertTrue(shown.wait_for("document.getElementById('shape-label') && document.getElementById('shape-label').textContent"))
            first = shown.text("#shape-label")
            shown.value("(() => { const s = document.getElementById('shape-time'); s.value = s.max; s.dispatchEvent(new Event('input')); })()")
            self.assertNotEqual(shown.text("#shape-label"), first, "the slider moves the shape")
            for width, height, is_phone in ((1920, 1080, False), (1280, 720, False), (390, 844, True)):
                shown.resize(width, height, is_phone)
                self.assertLessEqual(shown.value("document.documentElement.scrollWidth"), width, "nothing sticks out sideways")
            self.assertEqual(shown.complaints, [])


class Rainflow(unittest.TestCase):
    def test_the_example_of_the_standard(self):
        counts = {}
        for size, count in rainflow.cycles([-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0]):
            counts[size] = counts.get(size, 0.0) + count
        self.assertEqual(counts, {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5})

    def test_a_swing_is_counted_once_a_period(self):
        found = rainflow.cycles([math.sin(2.0 * math.pi * k / 40.0) for k in range(40 * 25 + 1)])
        self.assertAlmostEqual(sum(count for size, count in found if size > 1.9), 25.0, delta=0.6)
        self.assertEqual(rainflow.cycles([1.0, 1.0, 1.0]), [])


if __name__ == "__main__":
    unittest.main()
