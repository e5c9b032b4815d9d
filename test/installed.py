#!/usr/bin/python3
"""Installs the build and uses what is installed: programs, launch files, messages, headers, a replay and its report.

installed.py BUILD PREFIX (of that build)
"""
import os
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
STEPS = [
    ("is found where it was installed", 'test "$(rospack find tether_monitor)" = "{prefix}/share/tether_monitor"'),
    ("replays", "rosrun tether_monitor tether_replay --config {prefix}/share/tether_monitor/config/tank_run.yaml --bag {root}/test/data/tank_run.bag"
     " --out {prefix}/out --quiet"),
    ("reports", "rosrun tether_monitor tether_report {prefix}/out --out {prefix}/out/report.html"),
    ("has the tools", "for tool in tether_steady tether_identify; do rosrun tether_monitor $tool --help > {prefix}/out/help.txt; done"),
    ("has the messages", 'python3 -c "from tether_monitor.msg import TetherForecast, TetherState; from tether_monitor.srv import WhatIf"'),
    ("has the nodes that its launch files start",
     'nodes() {{ roslaunch --nodes tether_monitor "$@" rviz:=false > {prefix}/out/nodes.txt; }};'
     " nodes tether_monitor.launch config:={prefix}/share/tether_monitor/config/tank_run.yaml;"
     " for launch in demo dive operator sim tank_run winch_control feed_forward; do nodes $launch.launch; done"),
    ("has the page", "test -f {prefix}/share/tether_monitor/web/page/index.html && python3 -m py_compile {prefix}/share/tether_monitor/web/server.py"),
    ("has the nodelet", "test -f {prefix}/share/tether_monitor/nodelet_plugins.xml && ls {prefix}/lib/libtether_monitor_nodelet.so"),
    ("has the panel where it was built", "test ! -f {build}/devel/lib/libtether_monitor_rviz.so || {{ test -f {prefix}/lib/libtether_monitor_rviz.so;"
     " rospack plugins --attrib=plugin rviz | grep -q '^tether_monitor {prefix}/share/tether_monitor/rviz_plugins.xml'; }}"),
]


def main(build, prefix):
    shutil.rmtree(prefix, ignore_errors=True)
    done = subprocess.run(["cmake", "--build", build, "--target", "install"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    if done.returncode != 0:
        sys.exit(done.stdout)
    failed = 0
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("ROS_PACKAGE", "CMAKE_PREFIX", "PYTHONPATH", "LD_LIBRARY"))}
    for name, command in STEPS:
        command = command.format(build=build, prefix=prefix, root=ROOT)
        done = subprocess.run(["bash", "-c", "set -e; . %s/setup.bash; set -uo pipefail; %s" % (prefix, command)], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, universal_newlines=True, env=environment)
        print("%s: %s" % (name, "passed" if done.returncode == 0 else "FAILED\n" + done.stdout))
        failed += done.returncode != 0
    shutil.rmtree(prefix)  # inside of the sources rosrun would find every program twice
    print("%d passed, %d failed" % (len(STEPS) - failed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
