# The benchmarks of bench/; see bench/README.md.
find_package(benchmark REQUIRED)

add_executable(bench_kernels bench/kernel_benchmark.cpp bench/member_elimination.cpp)
target_link_libraries(bench_kernels PRIVATE tether_monitor_verification benchmark::benchmark tether_monitor_options)

function(add_bench_driver name source)
  add_executable(bench_${name} ${source})
  target_link_libraries(bench_${name} PRIVATE tether_monitor_verification nlohmann_json::nlohmann_json
                                              tether_monitor_options)
endfunction()
add_bench_driver(work_precision bench/work_precision.cpp)
add_bench_driver(steady_states bench/steady_state_success_rate.cpp)
add_bench_driver(estimation bench/estimation.cpp)
add_bench_driver(forecast bench/forecast.cpp)
add_bench_driver(identification bench/identification.cpp)
