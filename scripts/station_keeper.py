#!/usr/bin/python3
"""A controller that keeps a vehicle in its place, with or without the tether's force fed forward.

Feedback on the measured pose and velocity (proportional, derivative, slow integral), level and on heading zero.
With `feed_forward` the force of the tether on the vehicle that the monitor estimates is taken off the thrust; where
its standard deviation is larger than itself, in proportion less.

Parameters (private): feed_forward, place [m], mass (with added mass) [kg], inertia [kg m^2], bandwidth [rad/s],
balance [N] (constant force, world axes). Subscribes: vehicle/pose, vehicle/velocity,
tether_monitor/vehicle_end/wrench_body. Publishes: vehicle/command.
"""
import threading

import numpy as np
import rospy
from geometry_msgs.msg import PoseStamped, TwistStamped, Wrench
from tether_monitor.msg import WrenchWithCovarianceStamped

WRENCH_LIFE = 0.5  # [s]


def vector(message):
    return np.array([message.x, message.y, message.z])


def rotation(q):
    x, y, z, w = q.x, q.y, q.z, q.w
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class StationKeeper:
    def __init__(self):
        self.feed_forward = bool(rospy.get_param("~feed_forward"))
        self.place = np.array(rospy.get_param("~place"), dtype=float)
        self.mass = float(rospy.get_param("~mass"))
        self.inertia = np.array(rospy.get_param("~inertia"), dtype=float)
        self.bandwidth = float(rospy.get_param("~bandwidth"))
        self.integral = np.array(rospy.get_param("~balance"), dtype=float)
        self.lock = threading.Lock()
        self.velocity = self.spin = np.zeros(3)
        self.tether, self.tether_at = None, rospy.Time()
        self.last = None
        self.command = rospy.Publisher("vehicle/command", Wrench, queue_size=1)
        rospy.Subscriber("vehicle/velocity", TwistStamped, self.on_velocity, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber("tether_monitor/vehicle_end/wrench_body", WrenchWithCovarianceStamped, self.on_tether,
                         queue_size=1, tcp_nodelay=True)
        rospy.Subscriber("vehicle/pose", PoseStamped, self.on_pose, queue_size=1, tcp_nodelay=True)

    def on_velocity(self, message):
        with self.lock:
            self.velocity, self.spin = vector(message.twist.linear), vector(message.twist.angular)

    def on_tether(self, message):
        force = vector(message.wrench.force)
        trust = 1.0
        if message.covariance[0] > 0.0:
            trust = min(1.0, np.linalg.norm(force) / max(message.covariance[0] ** 0.5, 1e-9))
        with self.lock:
            self.tether, self.tether_at = trust * force, message.header.stamp

    def on_pose(self, message):
        with self.lock:
            velocity, spin = self.velocity, self.spin
            tether, tether_at = self.tether, self.tether_at
        now = message.header.stamp
        dt = min((now - self.last).to_sec(), 0.5) if self.last else 0.0
        self.last = now
        to_world = rotation(message.pose.orientation)
        w = self.bandwidth
        error = self.place - vector(message.pose.position)
        self.integral = self.integral + 0.05 * self.mass * w ** 3 * max(dt, 0.0) * error
        force = to_world.T @ (self.mass * (w * w * error - 1.6 * w * velocity) + self.integral)
        is_fresh = tether is not None and abs((now - tether_at).to_sec()) < WRENCH_LIFE
        if self.feed_forward and is_fresh and np.all(np.isfinite(tether)):
            force = force - tether
        q = message.pose.orientation
        turn = -np.sign(q.w if q.w else 1.0) * np.array([q.x, q.y, q.z])
        torque = self.inertia * (4.0 * w * w * turn - 3.2 * w * (to_world.T @ spin))
        command = Wrench()
        command.force.x, command.force.y, command.force.z = force
        command.torque.x, command.torque.y, command.torque.z = torque
        try:
            self.command.publish(command)
        except rospy.ROSException:
            pass  # the node is being shut down


if __name__ == "__main__":
    rospy.init_node("station_keeper")
    StationKeeper()
    rospy.spin()
