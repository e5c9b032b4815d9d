# The tools. Without ROS tether_replay reads no bags.
find_package(Boost REQUIRED COMPONENTS program_options)

add_library(tether_monitor_command_line STATIC src/apps/command_line.cpp)
target_include_directories(tether_monitor_command_line PUBLIC src/apps)
target_link_libraries(tether_monitor_command_line PUBLIC Boost::program_options PRIVATE tether_monitor_options)

add_executable(tether_steady src/apps/tether_steady.cpp)
target_link_libraries(tether_steady PRIVATE tether_monitor_command_line tether_monitor_replay tether_monitor_options)

add_executable(tether_replay src/apps/tether_replay.cpp)
target_link_libraries(tether_replay PRIVATE tether_monitor_command_line tether_monitor_replay tether_monitor_options)
if(WITH_ROS)
  target_link_libraries(tether_replay PRIVATE tether_monitor_ros)
else()
  target_sources(tether_replay PRIVATE src/apps/bag_replay_without_ros.cpp)
endif()
