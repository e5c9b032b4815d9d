#!/usr/bin/python3
"""endurance.py HOURS SPEED ELEMENTS: a simulated tow, watched; a row of memory, status and missed cycles for every 24th of it."""
import collections
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

PORT, PAGE = "11398", 8038
os.environ["ROS_MASTER_URI"] = "http://localhost:" + PORT

import rospy  # noqa: E402
import tornado.ioloop  # noqa: E402
import tornado.websocket  # noqa: E402
import yaml  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray  # noqa: E402
from tether_monitor.msg import TetherState  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROWS, FIFO = 24, 70
SIDE = 1500.0  # [m] of the square that the vessel sails
WORDS = {TetherState.STATUS_OK: "OK", TetherState.STATUS_DEGRADED: "DEGRADED", TetherState.STATUS_INVALID: "INVALID"}


def scenario(hours, speed, elements):
    with open(ROOT + "/config/scenarios/acoustic_navigation.yaml") as text:
        tree = yaml.safe_load(text)
    sim = tree["simulation"]
    way = sim["vessel"]["speed"]
    corners = [(SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE), (0.0, 0.0)]
    laps = int(hours * 3600.0 * way / (4.0 * SIDE)) + 2
    sim["vessel"]["waypoints"] = [{"position": list(corner), "speed": way} for _ in range(laps) for corner in corners]
    sim.update(clock=speed != 1.0, lockstep=speed != 1.0, speed=speed if speed > 0.0 else 1000.0)
    tree["tether"]["elements"] = elements
    tree.setdefault("solver", {})["members"] = 64
    tree["monitor"].update(rate=10.0, forecast={"members": 24})
    if speed == 1.0:
        tree["monitor"]["realtime"] = {"priority": FIFO, "lock_memory": True}
    return tree


def family(pid):
    """A process and all that it started."""
    children = subprocess.run(["pgrep", "-P", str(pid)], stdout=subprocess.PIPE, universal_newlines=True).stdout.split()
    return [pid] + [other for child in children for other in family(child)]


def memory(process):
    """[MB] resident, of a process and all that it started."""
    total = 0.0
    for pid in family(process.pid) if process else []:
        try:
            with open("/proc/%s/status" % pid) as lines:
                total += sum(float(line.split()[1]) / 1024.0 for line in lines if line.startswith("VmRSS"))
        except OSError:
            pass
    return total


class Watch:
    def __init__(self):
        self.lock = threading.Lock()
        self.time, self.statuses, self.timing, self.frames = 0.0, collections.Counter(), {}, 0

    def state(self, message):
        with self.lock:
            self.time = message.header.stamp.to_sec()
            self.statuses[WORDS[message.status]] += 1

    def diagnostics(self, message):
        for status in message.status:
            if "timing" in status.name:
                with self.lock:
                    self.timing.update({value.key: value.value for value in status.values})

    def client(self):
        """Reads the page's frames as a browser does."""
        async def read():
            while True:
                try:
                    connection = await tornado.websocket.websocket_connect("ws://127.0.0.1:%d/live" % PAGE)
                    while True:
                        text = await connection.read_message()
                        if text is None:
                            break
                        message = json.loads(text)
                        if message["kind"] == "pulse":
                            self.frames += 1
                            await connection.write_message(json.dumps({"frame": message["values"]["frame"]}))
                except Exception:
                    time.sleep(1.0)
        tornado.ioloop.IOLoop(make_current=True).run_sync(read)


def main():
    hours, speed, elements = float(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
    profile = tempfile.mkdtemp()
    processes = [subprocess.Popen(["roscore", "-p", PORT], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)]
    try:
        time.sleep(3.0)
        rospy.init_node("endurance", disable_rostime=True, disable_signals=True)
        tree = scenario(hours, speed, elements)
        rospy.set_param("/use_sim_time", speed != 1.0)
        for node in ("tether_sim", "tether_monitor"):
            rospy.set_param("/long/" + node, tree)
        watch = Watch()
        rospy.Subscriber("/long/tether_monitor/state", TetherState, watch.state, queue_size=100)
        rospy.Subscriber("/diagnostics", DiagnosticArray, watch.diagnostics)

        def start(*command):
            ns = ["__ns:=long"] if command[0] == "rosrun" else []
            processes.append(subprocess.Popen(list(command) + ns, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
            return processes[-1]
        page = start("rosrun", "tether_monitor", "tether_web", "_port:=%d" % PAGE)
        monitor = start("rosrun", "tether_monitor", "tether_monitor_node", "__name:=tether_monitor")
        time.sleep(5.0)  # time waits for a monitor that is there
        simulator = start("rosrun", "tether_monitor", "tether_sim_node", "__name:=tether_sim")
        threading.Thread(target=watch.client, daemon=True).start()
        browser = shutil.which("chromium") or shutil.which("google-chrome")
        if browser:
            time.sleep(3.0)
            browser = start(browser, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-port=0",
                            "--user-data-dir=" + profile, "http://127.0.0.1:%d/" % PAGE)
        began, wall, since = None, time.time(), time.time()
        print("| simulated [h] | real [h] | monitor [MB] | simulator [MB] | page's server, browser [MB] | states: OK, DEGRADED, INVALID | cycles | page's frames |\n"
              "|---|---|---|---|---|---|---|---|", flush=True)
        row = 0
        while row < ROWS and all(process.poll() is None for process in processes):
            time.sleep(0.2)
            with watch.lock:
                now, statuses, timing = watch.time, dict(watch.statuses), dict(watch.timing)
            if now == 0.0:
                continue
            if began is None:
                began, since = now, time.time()
            if time.time() - since > 3600.0 * hours + 600.0:
                break
            if now - began >= 3600.0 * hours * (row + 1) / ROWS:
                row += 1
                print("| %.2f | %.3f | %.1f | %.1f | %.1f, %.1f | %s | %s | %d |" % (
                    (now - began) / 3600.0, (time.time() - wall) / 3600.0, memory(monitor), memory(simulator), memory(page), memory(browser),
                    ", ".join(str(statuses.get(word, 0)) for word in ("OK", "DEGRADED", "INVALID")), timing.get("Cycles", "none"),
                    watch.frames), flush=True)
        ended = [p.args[2] if len(p.args) > 2 else p.args[0] for p in processes if p.poll() is not None]
        print("all nodes lived" if not ended else "ended early: %s" % ended)
        return 1 if ended or row < ROWS else 0
    finally:
        for process in reversed(processes):
            process.send_signal(signal.SIGINT)
        for process in processes:
            try:
                process.wait(timeout=15.0)
            except subprocess.TimeoutExpired:
                process.kill()
        shutil.rmtree(profile, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
