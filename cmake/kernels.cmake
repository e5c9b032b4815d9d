# The kernels of the core: one translation unit for each instruction set, chosen at run time. They are optimised in
# every kind of build but the sanitized one: nobody steps through them, and everybody waits for them.
if(NOT SANITIZE)
  set(kernel_optimisation -O3)
elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  set(kernel_optimisation -O1 -fno-sanitize=undefined)  # clang needs minutes for it, and the kernels are arithmetic
elseif(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(kernel_optimisation -O1)
else()
  set(kernel_optimisation -O2)
endif()
set_source_files_properties(
  src/core/kernel/portable.cpp src/core/kernel/avx2.cpp src/core/kernel/avx512.cpp
  PROPERTIES COMPILE_OPTIONS "-ffp-contract=fast;-fno-math-errno;-fno-trapping-math;-Wno-psabi;${kernel_optimisation}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_definitions(tether_monitor_core PRIVATE TETHER_MONITOR_X86_KERNELS)
  set_property(SOURCE src/core/kernel/avx2.cpp APPEND PROPERTY COMPILE_OPTIONS -mavx2 -mfma)
  set_property(SOURCE src/core/kernel/avx512.cpp APPEND PROPERTY COMPILE_OPTIONS -mavx512f -mavx512dq -mavx512vl -mavx2 -mfma)
else()
  set_property(SOURCE src/core/kernel/avx2.cpp src/core/kernel/avx512.cpp PROPERTY HEADER_FILE_ONLY ON)
endif()
