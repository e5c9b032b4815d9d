#!/usr/bin/python3
"""after_node.py NODE COMMAND...: runs a command once NODE has subscribed to something, or after half a minute without it.

A launch-prefix: what is published before somebody listens is lost.
"""
import os
import sys
import time

import rosgraph

LONGEST = 30.0  # [s]
OWN = ("/clock", "/tf", "/tf_static")  # topics to which any node may subscribe while it starts


def listens(master, name):
    subscribers = master.getSystemState()[1]
    return any(topic not in OWN and any(node.split("/")[-1].startswith(name) for node in nodes)
               for topic, nodes in subscribers)


def main():
    master = rosgraph.Master("/after_node")
    end = time.time() + LONGEST
    while time.time() < end and not listens(master, sys.argv[1]):
        time.sleep(0.2)
    os.execvp(sys.argv[2], sys.argv[2:])


if __name__ == "__main__":
    main()
