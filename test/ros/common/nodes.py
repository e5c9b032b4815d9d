"""Nodes of the package that a test starts and ends."""
import signal
import subprocess
import time


def start(ns, *commands):
    """Each command without its namespace; a string is what rosrun runs of the package."""
    return [subprocess.Popen((["rosrun", "tether_monitor"] + command.split() if isinstance(command, str) else command)
                             + ["__ns:=" + ns]) for command in commands]


def run_until(nodes, is_done, longest):
    """Waits until is_done(), the end of a node, or `longest` seconds; ends all. Which of them were alive till then."""
    deadline = time.time() + longest
    while time.time() < deadline and all(node.poll() is None for node in nodes) and not is_done():
        time.sleep(0.1)
    alive = [node.poll() is None for node in nodes]
    for node in nodes:
        node.send_signal(signal.SIGINT)
    for node in nodes:
        node.wait(timeout=15.0)
    return alive
