# What find_package(tether_monitor) gives: the targets tether_monitor::tether_monitor_core and
# tether_monitor::tether_monitor_monitor, from an installation, and with ROS from the devel space as well.
include(GNUInstallDirs)
if(NOT WITH_ROS)
  set(lib_folder ${CMAKE_INSTALL_LIBDIR})
  set(include_folder ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME})
  set(bin_folder ${CMAKE_INSTALL_BINDIR})
  set(share_folder ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})
else()
  set(lib_folder ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(include_folder ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
  set(bin_folder ${CATKIN_PACKAGE_BIN_DESTINATION})
  set(share_folder ${CATKIN_PACKAGE_SHARE_DESTINATION})
endif()
get_filename_component(include_root ${include_folder} DIRECTORY)

install(TARGETS tether_monitor_core tether_monitor_monitor EXPORT tether_monitor_targets
  ARCHIVE DESTINATION ${lib_folder}
  LIBRARY DESTINATION ${lib_folder}
  INCLUDES DESTINATION ${include_root})
install(DIRECTORY include/${PROJECT_NAME}/core include/${PROJECT_NAME}/monitor DESTINATION ${include_folder})
install(EXPORT tether_monitor_targets NAMESPACE tether_monitor:: FILE tether_monitor-targets.cmake
  DESTINATION ${share_folder}/cmake)
install(TARGETS tether_identify tether_replay tether_steady RUNTIME DESTINATION ${bin_folder})
install(PROGRAMS scripts/tether_report DESTINATION ${bin_folder})
if(WITH_ROS)
  install(PROGRAMS scripts/tether_web DESTINATION ${bin_folder})
endif()
install(DIRECTORY config launch report rviz web DESTINATION ${share_folder})

if(NOT WITH_ROS)
  include(CMakePackageConfigHelpers)
  file(WRITE ${CMAKE_BINARY_DIR}/tether_monitorConfig.cmake
    "include(CMakeFindDependencyMacro)\nfind_dependency(Eigen3 3.3 NO_MODULE)\nfind_dependency(Threads)\n"
    "include(\"\${CMAKE_CURRENT_LIST_DIR}/tether_monitor-targets.cmake\")\n")
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/tether_monitorConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/tether_monitorConfig.cmake ${CMAKE_BINARY_DIR}/tether_monitorConfigVersion.cmake
    DESTINATION ${share_folder}/cmake)
endif()
