"""Messages as four stacks publish them, of a boat and a vehicle that move slowly: types, topics, frames, rates and what is left out are those of
their sources (doc/stacks.md)."""
import math

import numpy as np
import rospy
from geometry_msgs.msg import TransformStamped, TwistWithCovarianceStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, NavSatFix, NavSatStatus
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage

LATITUDE, LONGITUDE = 63.45, 10.4
METRES_NORTH = 111473.6  # of a degree there, WGS 84
METRES_EAST = 49932.3
ENU_NED = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
FLU_FRD = np.diag([1.0, -1.0, -1.0])


def boat(t):
    """Position (east, north, up), velocity, heading from east, its rate."""
    return (np.array([2.0 * math.sin(0.05 * t), 0.0, 1.0]), np.array([0.1 * math.cos(0.05 * t), 0.0, 0.0]),
            0.3 + 0.1 * math.sin(0.1 * t), 0.01 * math.cos(0.1 * t))


def vehicle(t):
    return (np.array([35.0 + 3.0 * math.sin(0.05 * t), 10.0 + 3.0 * math.cos(0.05 * t), -25.0]),
            np.array([0.15 * math.cos(0.05 * t), -0.15 * math.sin(0.05 * t), 0.0]), 1.0 + 0.02 * t, 0.02)


def turned(heading):
    c, s = math.cos(heading), math.sin(heading)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def set_vector(field, value):
    field.x, field.y, field.z = (float(x) for x in value)


def set_quaternion(field, matrix):
    """Of a rotation that is a half turn at most about any axis."""
    w = 0.5 * math.sqrt(max(0.0, 1.0 + np.trace(matrix)))
    if w > 1e-3:
        v = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / (4.0 * w)
    else:
        v = np.sqrt(np.maximum(0.0, 0.5 * (np.diag(matrix) + 1.0)))
        v[1] = math.copysign(v[1], matrix[0, 1])
        v[2] = math.copysign(v[2], matrix[0, 2])
    field.w, field.x, field.y, field.z = w, float(v[0]), float(v[1]), float(v[2])


def stamped(message, t, frame):
    message.header.stamp = rospy.Time.from_sec(t)
    message.header.frame_id = frame
    return message


def fix(t, frame, position, altitude):
    message = stamped(NavSatFix(), t, frame)
    message.status.service = NavSatStatus.SERVICE_GPS
    message.latitude = LATITUDE + position[1] / METRES_NORTH
    message.longitude = LONGITUDE + position[0] / METRES_EAST
    message.altitude = altitude
    return message


def imu(t, frame, heading, rate):
    message = stamped(Imu(), t, frame)
    set_quaternion(message.orientation, turned(heading))
    message.orientation_covariance = [1e-4 if k in (0, 4, 8) else 0.0 for k in range(9)]
    message.angular_velocity.z = rate
    return message


def odometry(t, frame, child, position, rotation, velocity, rate):
    message = stamped(Odometry(), t, frame)
    message.child_frame_id = child
    set_vector(message.pose.pose.position, position)
    set_quaternion(message.pose.pose.orientation, rotation)
    set_vector(message.twist.twist.linear, velocity)
    set_vector(message.twist.twist.angular, rate)
    return message


def static(frame, child, translation, rotation):
    transform = stamped(TransformStamped(), 0.0, frame)
    transform.child_frame_id = child
    set_vector(transform.transform.translation, translation)
    set_quaternion(transform.transform.rotation, rotation)
    return transform


class Stack:
    """What is published at time t: (topic, message)."""
    transforms = []

    def __init__(self):
        self.random = np.random.RandomState(5)

    def noise(self, stddev):
        return self.random.normal(0.0, stddev, 3)

    def tf_static(self):
        return TFMessage(self.transforms)


class BlueRov2(Stack):
    """mavros with ArduSub: global_position/global at 5 Hz in base_link, rel_alt (up), imu/data at 10 Hz."""
    def at(self, t, k):
        place, _, heading, rate = vehicle(t)
        yield "/mavros/imu/data", imu(t, "base_link", heading, rate)
        if k % 2 == 0:
            yield "/topside/fix", fix(t, "", boat(t)[0] + self.noise(0.3), 41.0)
            yield "/mavros/global_position/rel_alt", Float64(place[2] + self.random.normal(0.0, 0.02))
        if k % 10 == 0:
            position = fix(t, "base_link", place + self.noise(0.5), 15.0)
            position.position_covariance = [-1.0] + [0.0] * 8
            position.position_covariance_type = NavSatFix.COVARIANCE_TYPE_UNKNOWN
            yield "/mavros/global_position/global", position


class WaterLinked(Stack):
    """/waterlinked/fix in "ugps_link", altitude minus depth, no covariance; a log in dvl_link."""
    transforms = [static("base_link", "locator", [0.0, 0.0, 0.2], np.eye(3)),
                  static("base_link", "dvl_link", [0.1, 0.0, -0.15], np.eye(3))]

    def at(self, t, k):
        _, velocity, heading, rate = vehicle(t)
        yield "/imu/data", imu(t, "base_link", heading, rate)
        if k % 2 == 0:
            yield "/topside/fix", fix(t, "", boat(t)[0] + self.noise(0.3), boat(t)[0][2])
            twist = stamped(TwistWithCovarianceStamped(), t, "dvl_link")
            at_log = turned(heading).T.dot(velocity) + np.cross([0.0, 0.0, rate], [0.1, 0.0, -0.15])
            set_vector(twist.twist.twist.linear, at_log + self.noise(0.02))
            for axis in range(3):
                twist.twist.covariance[7 * axis] = 0.02**2
            yield "/dvl/twist", twist
        if k % 5 == 0:
            place = vehicle(t - 0.5)[0] + [0.0, 0.0, 0.2] + self.noise(0.5)
            yield "/waterlinked/fix", fix(t, "ugps_link", place, place[2])


class UuvSimulator(Stack):
    """PoseGTROSPlugin: Odometry in "world" at 20 Hz, twist in its axes, the variance of its noise (zero)."""
    def at(self, t, k):
        for topic, child, motion in (("/boat/pose_gt", "boat/base_link", boat),
                                     ("/rexrov/pose_gt", "rexrov/base_link", vehicle)):
            place, velocity, heading, rate = motion(t)
            yield topic, odometry(t, "world", child, place, turned(heading), velocity, [0.0, 0.0, rate])


class Stonefish(Stack):
    """ROSInterface::PublishOdometry: "world_ned", body forward-right-down, twist in the body's axes."""
    transforms = [static("map", "world_ned", [0.0, 0.0, 0.0], ENU_NED)]

    def at(self, t, k):
        for topic, child, motion in (("/boat/odometry", "boat/base_link", boat),
                                     ("/girona500/navigator/odometry", "girona500/base_link", vehicle)):
            place, velocity, heading, rate = motion(t)
            rotation = ENU_NED.dot(turned(heading)).dot(FLU_FRD)
            in_body = FLU_FRD.dot(turned(heading).T).dot(velocity)
            yield topic, odometry(t, "world_ned", child, ENU_NED.dot(place), rotation, in_body, [0.0, 0.0, -rate])


STACKS = {"bluerov2_mavros": BlueRov2, "waterlinked_ugps": WaterLinked, "uuv_simulator": UuvSimulator, "stonefish_cola2": Stonefish}


def messages(name, begin, duration, rate=10.0):
    """(time, topic, message) in order; /tf_static first."""
    stack = STACKS[name]()
    if stack.transforms:
        yield begin, "/tf_static", stack.tf_static()
    for k in range(int(duration * rate)):
        for topic, message in stack.at(begin + k / rate, k):
            yield begin + k / rate, topic, message
