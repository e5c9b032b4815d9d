# Tests of the node, each owning the clock, and of the tools.
find_package(rostest REQUIRED)
find_package(roslaunch REQUIRED)

roslaunch_add_file_check(launch IGNORE_UNSET_ARGS)

foreach(unit cycle_statistics force_text forecast_thread geometry_conversions input_adapter input_statistics input_topics markers message_bounds message_conversions
        recent_fixes sensor_input_adapter standard_outputs
        state_keeper time_conversion transform_input)
  add_unit_test(test/ros/unit/${unit}_test.cpp)
  target_link_libraries(ros_unit_${unit}_test tether_monitor_ros)
endforeach()

foreach(scenario nominal_bag over_tension stale_vehicle rejected_input clock_jump shutdown message_fuzz input_faults
        alarms bridge forecast)
  add_rostest_gtest(${scenario}_test test/ros/${scenario}.test test/ros/${scenario}_test.cpp)
  target_link_libraries(${scenario}_test tether_monitor_ros)
  target_include_directories(${scenario}_test PRIVATE ${PROJECT_SOURCE_DIR}/test)
  add_dependencies(${scenario}_test tether_monitor_node)
endforeach()

if(TARGET tether_monitor_rviz)
  add_unit_test(test/rviz/panel_text_test.cpp)
  target_sources(rviz_panel_text_test PRIVATE src/rviz/panel_text.cpp)
  target_link_libraries(rviz_panel_text_test tether_monitor_ros)
  add_rostest_gtest(tether_panel_test test/rviz/tether_panel.test test/rviz/tether_panel_test.cpp)
  target_include_directories(tether_panel_test SYSTEM PRIVATE ${rviz_INCLUDE_DIRS})
  target_compile_definitions(tether_panel_test PRIVATE QT_NO_KEYWORDS)
  target_link_libraries(tether_panel_test tether_monitor_ros ${rviz_LIBRARIES} Qt5::Widgets)
  add_dependencies(tether_panel_test tether_monitor_rviz)
endif()

# The installation, where the prefix is a folder of the build (scripts/environment.sh): elsewhere a test must not install.
if(CMAKE_INSTALL_PREFIX STREQUAL "${CMAKE_BINARY_DIR}/install")
  add_test(NAME installed COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/test/installed.py ${CMAKE_BINARY_DIR} ${CMAKE_INSTALL_PREFIX})
  set_tests_properties(installed PROPERTIES RUN_SERIAL ON)
endif()
add_test(NAME report COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/test/report.py)
add_test(NAME tutorials COMMAND ${CATKIN_ENV} /usr/bin/python3 ${PROJECT_SOURCE_DIR}/test/tutorials.py)
add_rostest(test/ros/nodelet.test DEPENDENCIES nominal_bag_test tether_monitor_nodelet)

foreach(script attachment_frames bad_parameters closed_loops live_settings operator_page sim_scenarios stacks tools)
  add_rostest(test/ros/${script}.test DEPENDENCIES tether_monitor_node tether_sim_node tether_identify tether_replay tether_steady)
endforeach()
# Two nodes ten times as fast as in life want the machine for themselves.
set_tests_properties(_ctest_tether_monitor_rostest_test_ros_sim_scenarios.test PROPERTIES RUN_SERIAL ON)
