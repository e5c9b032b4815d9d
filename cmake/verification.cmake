# Random tethers, the cases A to F and the navigation study: shared by tests, fuzzing and benchmarks.
add_library(tether_monitor_verification STATIC
  verification/drawn_truths.cpp
  verification/estimation_study.cpp
  verification/estimation_truths.cpp
  verification/forecast_study.cpp
  verification/identification_study.cpp
  verification/manoeuvres.cpp
  verification/navigation_study.cpp
  verification/random_tether.cpp
  verification/reference_cases.cpp
  verification/robustness_checks.cpp)
target_include_directories(tether_monitor_verification PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(tether_monitor_verification PUBLIC tether_monitor_monitor PRIVATE tether_monitor_options)

add_executable(fuzz_campaign EXCLUDE_FROM_ALL fuzz/campaign.cpp)
target_link_libraries(fuzz_campaign PRIVATE tether_monitor_verification tether_monitor_options)

# With clang: libFuzzer looks for bytes that break something.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  foreach(fuzzer element_fuzzer tether_fuzzer restore_fuzzer)
    add_executable(${fuzzer} EXCLUDE_FROM_ALL fuzz/${fuzzer}.cpp)
    target_link_libraries(${fuzzer} PRIVATE tether_monitor_verification tether_monitor_options -fsanitize=fuzzer)
  endforeach()
endif()
