# The ROS shell, the node, the tools that read bags, installation.

# Its packages name it differently, and not all of them bring a configuration for CMake.
find_path(GEOGRAPHICLIB_INCLUDE_DIR GeographicLib/LocalCartesian.hpp)
find_library(GEOGRAPHICLIB_LIBRARY NAMES GeographicLib Geographic)
if(NOT GEOGRAPHICLIB_INCLUDE_DIR OR NOT GEOGRAPHICLIB_LIBRARY)
  message(FATAL_ERROR "GeographicLib is missing (libgeographiclib-dev or libgeographic-dev)")
endif()

export(TARGETS tether_monitor_core tether_monitor_monitor NAMESPACE tether_monitor::
  FILE ${CMAKE_BINARY_DIR}/tether_monitor-targets.cmake)

add_library(tether_monitor_ros STATIC
  src/ros/alarm_publisher.cpp
  src/ros/alarm_text.cpp
  src/ros/attachment_frames.cpp
  src/ros/bag_messages.cpp
  src/ros/bag_recording.cpp
  src/ros/bag_replay.cpp
  src/ros/body_input.cpp
  src/ros/motion_input_adapter.cpp
  src/ros/sensor_input_adapter.cpp
  src/ros/crash_guard.cpp
  src/ros/cycle_statistics.cpp
  src/ros/cycle_thread.cpp
  src/ros/diagnostics.cpp
  src/ros/estimator_runner.cpp
  src/ros/force_text.cpp
  src/ros/forecast_publisher.cpp
  src/ros/forecast_thread.cpp
  src/ros/geodetic_datum.cpp
  src/ros/geometry_conversions.cpp
  src/ros/header_check.cpp
  src/ros/input_adapter.cpp
  src/ros/input_statistics.cpp
  src/ros/recent_fixes.cpp
  src/ros/input_topics.cpp
  src/ros/live_settings_server.cpp
  src/ros/markers.cpp
  src/ros/master_watch.cpp
  src/ros/message_bounds.cpp
  src/ros/message_conversions.cpp
  src/ros/monitor_node.cpp
  src/ros/output_publisher.cpp
  src/ros/parameter_server.cpp
  src/ros/publishing_thread.cpp
  src/ros/sensor_mounts.cpp
  src/ros/simulator_bridge.cpp
  src/ros/simulator_node.cpp
  src/ros/standard_outputs.cpp
  src/ros/state_keeper.cpp
  src/ros/transform_input.cpp
  src/ros/transform_pose_reader.cpp)
add_dependencies(tether_monitor_ros ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
target_include_directories(tether_monitor_ros SYSTEM PUBLIC ${catkin_INCLUDE_DIRS} ${GEOGRAPHICLIB_INCLUDE_DIR})
target_link_libraries(tether_monitor_ros
  PUBLIC tether_monitor_params tether_monitor_replay ${catkin_LIBRARIES} ${GEOGRAPHICLIB_LIBRARY}
  PRIVATE tether_monitor_options)

add_executable(tether_monitor_node src/apps/tether_monitor_node.cpp)
target_link_libraries(tether_monitor_node PRIVATE tether_monitor_ros tether_monitor_options)

add_executable(tether_sim_node src/apps/tether_sim_node.cpp)
target_link_libraries(tether_sim_node PRIVATE tether_monitor_ros tether_monitor_options)

add_library(tether_monitor_nodelet MODULE src/apps/tether_monitor_nodelet.cpp)
target_link_libraries(tether_monitor_nodelet PRIVATE tether_monitor_ros tether_monitor_options)

install(TARGETS tether_monitor_node tether_sim_node RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(TARGETS tether_monitor_nodelet LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(FILES test/data/tank_run.bag test/data/tank_run.md
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/test/data)
catkin_install_python(PROGRAMS scripts/after_node.py scripts/demo_dive.py scripts/demo_monitor.py scripts/station_keeper.py
  scripts/winch_controller.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
