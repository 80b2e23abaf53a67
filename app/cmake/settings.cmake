# One interface target holds what every target of ours is compiled with; third-party headers stay
# outside it, so warnings as errors never reach them.
add_library(rotorbench_settings INTERFACE)
target_compile_options(rotorbench_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # NaN checks and reproducible bits rule out -ffast-math; these two only drop errno and traps.
  -fno-math-errno -fno-trapping-math
  # The same bits on machines with and without fused multiply-add.
  -ffp-contract=off)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# A program holds the functions it calls, not all of the objects these stand in.
add_compile_options(-ffunction-sections -fdata-sections)
add_link_options(-Wl,--gc-sections)
if(ROTORBENCH_SANITIZE)
  add_compile_options(-fsanitize=${ROTORBENCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ROTORBENCH_SANITIZE})
  # g++ 12 sees uninitialised and unallocated variants where the instrumentation hides how they are filled.
  target_compile_options(rotorbench_settings INTERFACE -Wno-maybe-uninitialized -Wno-free-nonheap-object)
endif()
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # What ccache asks for where precompiled headers are used.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
  target_compile_options(rotorbench_settings INTERFACE -fpch-preprocess)
endif()

# Parsing Eigen, the standard library and Qt is more than half of the compile time without this.
set(ROTORBENCH_PRECOMPILED <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <atomic> <cmath> <cstdint>
    <filesystem> <functional> <limits> <map> <memory> <optional> <span> <string> <string_view> <utility>
    <variant> <vector>)

# A hundred programs are linked with the libraries: this linker takes a fifth of the time.
find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM)
  add_link_options(-fuse-ld=mold)
endif()

# Sources that stay alone in a unity build. What runs in every tick of a flight or a comparison: beside others its loops
# are inlined otherwise. And what knows which controllers there are: tests/recipe puts its own in their place.
function(rotorbench_single_sources)
  set_source_files_properties(${ARGN} TARGET_DIRECTORY rotorbench_sim PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
