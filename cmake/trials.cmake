# Random tethers and the cases A to F: for tests, for the campaign of scripts/fuzz, and for the benchmarks.
add_library(tether_monitor_fuzz STATIC fuzz/random_tether.cpp fuzz/checks.cpp)
target_include_directories(tether_monitor_fuzz PUBLIC fuzz)
target_link_libraries(tether_monitor_fuzz PUBLIC tether_monitor_monitor PRIVATE tether_monitor_options)

add_library(tether_monitor_bench STATIC bench/cases.cpp bench/navigation.cpp)
target_include_directories(tether_monitor_bench PUBLIC bench)
target_link_libraries(tether_monitor_bench PUBLIC tether_monitor_fuzz PRIVATE tether_monitor_options)

add_executable(fuzz_campaign EXCLUDE_FROM_ALL fuzz/campaign.cpp)
target_link_libraries(fuzz_campaign PRIVATE tether_monitor_fuzz tether_monitor_options)

# With clang: libFuzzer looks for bytes that break something.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  foreach(fuzzer element_fuzzer tether_fuzzer restore_fuzzer)
    add_executable(${fuzzer} EXCLUDE_FROM_ALL fuzz/${fuzzer}.cpp)
    target_link_libraries(${fuzzer} PRIVATE tether_monitor_fuzz tether_monitor_options -fsanitize=fuzzer)
  endforeach()
endif()
