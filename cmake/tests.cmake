# Tests that need no ROS: one executable a file, named after its path and labelled by its folder (ctest -L core).
if(NOT TARGET GTest::gtest_main)  # catkin may have found it
  find_package(GTest CONFIG REQUIRED)
endif()

set(test_files
  test/core/analysis/dynamic_stiffness_test.cpp
  test/core/analysis/natural_modes_test.cpp
  test/core/assembly/cable_model_test.cpp
  test/core/assembly/clamped_end_test.cpp
  test/core/assembly/contact_assembly_test.cpp
  test/core/assembly/deployed_cable_test.cpp
  test/core/assembly/joined_elements_test.cpp
  test/core/assembly/lumped_attachment_test.cpp
  test/core/base/binary_archive_test.cpp
  test/core/base/lane_math_test.cpp
  test/core/base/so3_test.cpp
  test/core/bodies/rigid_body_dynamics_test.cpp
  test/core/cable/cable_layout_test.cpp
  test/core/cable/cable_mesh_test.cpp
  test/core/cable/end_trajectory_test.cpp
  test/core/cable/payout_test.cpp
  test/core/cable/property_variation_test.cpp
  test/core/cable/payout_trajectory_test.cpp
  test/core/cable/winch_drum_test.cpp
  test/core/contact/contact_law_test.cpp
  test/core/element/axial_law_test.cpp
  test/core/element/element_equations_test.cpp
  test/core/element/hermite_shape_functions_test.cpp
  test/core/element/morison_drag_test.cpp
  test/core/element/quadrature_test.cpp
  test/core/cable/axial_stiffening_test.cpp
  test/core/element/slope_transition_test.cpp
  test/core/element/submergence_test.cpp
  test/core/environment/airy_wave_test.cpp
  test/core/environment/current_profile_test.cpp
  test/core/environment/environment_model_test.cpp
  test/core/environment/obstacle_test.cpp
  test/core/environment/sea_state_test.cpp
  test/core/environment/seabed_test.cpp
  test/core/environment/wave_field_test.cpp
  test/core/environment/wave_spectrum_test.cpp
  test/core/kernel/wave_kernel_test.cpp
  test/core/linalg/block_tridiagonal_test.cpp
  test/core/solve/abarbanel_zwas_test.cpp
  test/core/solve/adaptive_stepper_test.cpp
  test/core/solve/dynamic_relaxation_test.cpp
  test/core/solve/mesh_convergence_test.cpp
  test/core/solve/steady_state_catenary_test.cpp
  test/core/solve/steady_state_solver_test.cpp
  test/core/verification/blintsov_steady_tow_test.cpp
  test/core/verification/closed_forms_test.cpp
  test/core/verification/dynamics_test.cpp
  test/core/verification/moordyn_tow_test.cpp
  test/core/verification/parted_tether_test.cpp
  test/core/verification/stiffness_jump_test.cpp
  test/core/verification/synthetic_rope_test.cpp
  test/core/verification/waves_test.cpp
  test/files/csv_table_test.cpp
  test/files/csv_writer_test.cpp
  test/files/cubic_spline_test.cpp
  test/files/depth_grid_file_test.cpp
  test/files/text_file_test.cpp
  test/monitor/alarms/alarm_quantities_test.cpp
  test/monitor/alarms/alarm_life_test.cpp
  test/monitor/alarms/alarm_log_test.cpp
  test/monitor/alarms/alarm_set_test.cpp
  test/monitor/alarms/alarm_table_test.cpp
  test/monitor/alarms/alarm_test.cpp
  test/monitor/config/config_fingerprint_test.cpp
  test/monitor/config/suspicious_values_test.cpp
  test/monitor/estimate/estimate_summary_test.cpp
  test/monitor/estimate/status_test.cpp
  test/monitor/estimator/allocation_test.cpp
  test/monitor/estimator/cloned_pointer_test.cpp
  test/monitor/estimator/estimator_snapshot_test.cpp
  test/monitor/estimator/free_vehicle_end_test.cpp
  test/monitor/estimator/input_faults_test.cpp
  test/monitor/estimator/input_watchdog_test.cpp
  test/monitor/estimator/live_settings_test.cpp
  test/monitor/estimator/observed_vehicle_end_test.cpp
  test/monitor/estimator/observed_vehicle_faults_test.cpp
  test/monitor/estimator/obstacle_tracker_test.cpp
  test/monitor/estimator/load_cell_check_test.cpp
  test/monitor/estimator/alarm_input_tracker_test.cpp
  test/monitor/estimator/payout_follower_test.cpp
  test/monitor/estimator/start_worker_test.cpp
  test/monitor/estimator/steady_start_test.cpp
  test/monitor/estimator/tether_estimator_test.cpp
  test/monitor/estimator/tracked_body_test.cpp
  test/monitor/forecast/end_motion_predictor_test.cpp
  test/monitor/forecast/forecast_score_test.cpp
  test/monitor/forecast/forecast_traces_test.cpp
  test/monitor/forecast/tether_forecaster_test.cpp
  test/monitor/forecast/thrust_reaction_test.cpp
  test/monitor/forecast/vessel_plan_test.cpp
  test/monitor/forecast/winch_reaction_test.cpp
  test/monitor/identification/identification_test.cpp
  test/monitor/measurements/turn_counter_test.cpp
  test/monitor/measurements/body_state_test.cpp
  test/monitor/measurements/correction_blender_test.cpp
  test/monitor/measurements/height_record_test.cpp
  test/monitor/measurements/measured_vector_test.cpp
  test/monitor/measurements/measurement_history_test.cpp
  test/monitor/measurements/motion_buffer_test.cpp
  test/monitor/measurements/payout_buffer_test.cpp
  test/monitor/measurements/ring_buffer_test.cpp
  test/monitor/model/model_factory_test.cpp
  test/monitor/ensemble/ensemble_start_test.cpp
  test/monitor/ensemble/ensemble_summary_test.cpp
  test/monitor/ensemble/ensemble_transform_test.cpp
  test/monitor/ensemble/fading_memory_test.cpp
  test/monitor/ensemble/improbability_test.cpp
  test/monitor/ensemble/innovation_gate_test.cpp
  test/monitor/ensemble/load_cell_record_test.cpp
  test/monitor/ensemble/motion_error_filter_test.cpp
  test/monitor/ensemble/reading_statistics_test.cpp
  test/monitor/ensemble/representative_member_test.cpp
  test/monitor/ensemble/measurement_timing_test.cpp
  test/monitor/ensemble/tether_linearization_test.cpp
  test/monitor/ensemble/vehicle_initializer_test.cpp
  test/monitor/measurements/motion_plausibility_test.cpp
  test/monitor/measurements/noise_estimator_test.cpp
  test/monitor/measurements/payout_plausibility_test.cpp
  test/monitor/measurements/thrust_buffer_test.cpp
  test/monitor/vessel/position_window_test.cpp
  test/monitor/vessel/track_wave_regression_test.cpp
  test/monitor/vessel/vessel_motion_filter_test.cpp
  test/params/attachment_frames_test.cpp
  test/params/load_config_test.cpp
  test/params/load_tether_test.cpp
  test/params/load_waves_test.cpp
  test/params/parameter_reader_test.cpp
  test/replay/csv_replay_test.cpp
  test/replay/input_log_test.cpp
  test/replay/recorded_measurements_test.cpp
  test/replay/recorded_motion_test.cpp
  test/replay/steady_state_run_test.cpp
  test/simulation/acoustic_navigation_test.cpp
  test/simulation/simulator_test.cpp
  test/simulation/vehicle_autopilot_test.cpp
  test/verification/navigation_study_test.cpp
  test/verification/reference_cases_test.cpp
  test/verification/robustness_test.cpp)

# test/core/solve/adaptive_stepper_test.cpp: target core_solve_adaptive_stepper_test, labels core and core/solve.
function(add_unit_test file)
  string(REGEX REPLACE "^test/(.*)\\.cpp$" "\\1" path "${file}")
  string(REPLACE "/" "_" target "${path}")
  get_filename_component(folder "${path}" DIRECTORY)
  string(REGEX REPLACE "/.*" "" room "${folder}")
  if(WITH_ROS)
    catkin_add_gtest(${target} ${file} TIMEOUT 600)
    set(test_name _ctest_${PROJECT_NAME}_gtest_${target})
    target_link_libraries(${target} GTest::gtest_main)
  else()
    add_executable(${target} ${file})
    set(test_name ${target})
    target_link_libraries(${target} GTest::gtest_main)
    add_test(NAME ${target} COMMAND ${target})
  endif()
  target_link_libraries(${target} tether_monitor_replay tether_monitor_verification tether_monitor_options)
  target_include_directories(${target} PRIVATE test)
  target_compile_definitions(${target} PRIVATE PROJECT_DIR="${CMAKE_CURRENT_SOURCE_DIR}")
  set_tests_properties(${test_name} PROPERTIES LABELS "${room};${folder}")
endfunction()

foreach(file ${test_files})
  add_unit_test(${file})
endforeach()

# Folders, sizes and words of the house; that the check finds what it looks for; format, where clang-format is the one that
# the house uses.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME house COMMAND ${Python3_EXECUTABLE} scripts/check_house WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
add_test(NAME house_self_test COMMAND ${Python3_EXECUTABLE} scripts/check_house --self-test
  WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
add_test(NAME format COMMAND scripts/check_format WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
set_tests_properties(house house_self_test format PROPERTIES LABELS house)
set_tests_properties(format PROPERTIES SKIP_RETURN_CODE 77)

# A plain CMake project that finds the installed core library.
add_test(NAME consumer COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/test/consumer/run ${CMAKE_CURRENT_SOURCE_DIR}
  ${CMAKE_BINARY_DIR} ${CMAKE_GENERATOR})
set_tests_properties(consumer PROPERTIES LABELS consumer TIMEOUT 900)
