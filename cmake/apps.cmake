# The tools. Without ROS tether_replay and tether_identify read no bags.
find_package(Boost REQUIRED COMPONENTS program_options)

add_library(tether_monitor_command_line STATIC src/apps/command_line.cpp)
target_include_directories(tether_monitor_command_line PUBLIC src/apps)
target_link_libraries(tether_monitor_command_line PUBLIC Boost::program_options PRIVATE tether_monitor_options)

add_executable(tether_steady src/apps/tether_steady.cpp)
target_link_libraries(tether_steady PRIVATE tether_monitor_command_line tether_monitor_replay tether_monitor_options)

foreach(tool tether_replay tether_identify)
  add_executable(${tool} src/apps/${tool}.cpp src/apps/recording.cpp)
  target_link_libraries(${tool} PRIVATE tether_monitor_command_line tether_monitor_replay tether_monitor_options)
  if(WITH_ROS)
    target_link_libraries(${tool} PRIVATE tether_monitor_ros)
  else()
    target_sources(${tool} PRIVATE src/apps/bag_replay_without_ros.cpp)
  endif()
endforeach()
