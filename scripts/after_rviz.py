#!/usr/bin/python3
"""Runs a command once rviz has subscribed to the markers, or after half a minute without it: a launch-prefix."""
import os
import sys
import time

import rosgraph

LONGEST = 30.0  # [s]


def rviz_listens(master):
    subscribers = master.getSystemState()[1]
    return any(topic.endswith("/markers") and any(node.startswith("/rviz") for node in nodes)
               for topic, nodes in subscribers)


def main():
    master = rosgraph.Master("/after_rviz")
    end = time.time() + LONGEST
    while time.time() < end and not rviz_listens(master):
        time.sleep(0.2)
    os.execvp(sys.argv[1], sys.argv[1:])


if __name__ == "__main__":
    main()
