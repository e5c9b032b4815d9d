# The rospy of Debian 11 asks its threads isAlive(), which the Python there has no more.
import threading

if not hasattr(threading.Thread, "isAlive"):
    threading.Thread.isAlive = threading.Thread.is_alive
