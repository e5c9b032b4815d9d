# The benchmarks of bench/; see bench/README.md.
find_package(benchmark REQUIRED)
find_package(nlohmann_json REQUIRED)

add_executable(bench_kernels bench/kernels.cpp)
target_link_libraries(bench_kernels PRIVATE tether_monitor_bench benchmark::benchmark tether_monitor_options)

foreach(driver work_precision steady_states navigation_noise)
  add_executable(bench_${driver} bench/${driver}.cpp)
  target_link_libraries(bench_${driver} PRIVATE tether_monitor_bench nlohmann_json::nlohmann_json tether_monitor_options)
endforeach()
