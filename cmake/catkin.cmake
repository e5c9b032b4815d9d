# What makes this a catkin package: its messages, and what other packages get of it. Before any target, as catkin wants it.

if(NOT DEFINED CATKIN_DEVEL_PREFIX)
  # Built on its own, without a workspace: the devel space lives in the build tree, and its python and pkg-config folders
  # must be there before catkin looks for them.
  set(CATKIN_DEVEL_PREFIX ${CMAKE_BINARY_DIR}/devel)
  file(MAKE_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/python3/dist-packages ${CATKIN_DEVEL_PREFIX}/lib/pkgconfig)
endif()

find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs diagnostic_updater dynamic_reconfigure geometry_msgs message_generation nav_msgs nodelet pluginlib rosbag rosbag_storage
  roscpp rosgraph_msgs sensor_msgs std_msgs std_srvs tf2 tf2_geometry_msgs tf2_msgs tf2_ros topic_tools visualization_msgs)

add_message_files(FILES
  AcousticFix.msg Alarm.msg AlarmArray.msg AlarmEvent.msg Contact.msg ContactArray.msg CurrentProfile.msg Obstacle.msg
  ObstacleArray.msg ParameterEstimate.msg Payout.msg TensionMeasurement.msg TetherForecast.msg TetherState.msg
  WrenchWithCovarianceStamped.msg)
add_service_files(FILES AlarmAction.srv AlarmLog.srv WhatIf.srv)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES tether_monitor_core tether_monitor_monitor
  CATKIN_DEPENDS diagnostic_msgs dynamic_reconfigure geometry_msgs message_runtime nav_msgs nodelet roscpp rosgraph_msgs
    sensor_msgs std_msgs std_srvs topic_tools visualization_msgs
  DEPENDS EIGEN3
  CFG_EXTRAS tether_monitor-extras.cmake)
