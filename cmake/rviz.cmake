# The panel for rviz, where rviz can be built against: a robot without a screen does without.
find_package(rviz QUIET)
find_package(Qt5 QUIET COMPONENTS Widgets)
if(NOT rviz_FOUND OR NOT Qt5_FOUND)
  message(STATUS "No panel for rviz: rviz or Qt 5 is missing")
  return()
endif()

add_library(tether_monitor_rviz MODULE
  src/rviz/alarm_table.cpp
  src/rviz/panel_text.cpp
  src/rviz/tension_scale.cpp
  src/rviz/tether_panel.cpp)
target_include_directories(tether_monitor_rviz SYSTEM PRIVATE ${rviz_INCLUDE_DIRS})
target_compile_definitions(tether_monitor_rviz PRIVATE QT_NO_KEYWORDS)
target_link_libraries(tether_monitor_rviz PRIVATE tether_monitor_ros ${rviz_LIBRARIES} Qt5::Widgets tether_monitor_options)
install(TARGETS tether_monitor_rviz LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(FILES rviz_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
