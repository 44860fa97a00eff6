# How a room, a test and a benchmark of this project are declared.

add_library(reorient_options INTERFACE)
target_compile_options(reorient_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wundef -Wcast-align -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(reorient_options INTERFACE -Wno-restrict)  # false alarms in std::string (GCC bug 105651)
endif()
target_include_directories(reorient_options INTERFACE "${PROJECT_SOURCE_DIR}")
# Every x86-64 robot and desktop since 2009 has SSE4.2; a preset may ask for a particular processor instead.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CMAKE_CXX_FLAGS MATCHES "-march=")
  target_compile_options(reorient_options INTERFACE -march=x86-64-v2)
endif()

# reorient_add_room(NAME SOURCES file... LINKS target...): one static library, with includes from the top of the tree.
function(reorient_add_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(${name} PUBLIC reorient_options ${ROOM_LINKS})
endfunction()

# reorient_add_tests(NAME SOURCES file... LINKS target...): one GoogleTest program, each of its tests known to CTest.
function(reorient_add_tests name)
  cmake_parse_arguments(TESTS "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${TESTS_SOURCES})
  target_link_libraries(${name} PRIVATE ${TESTS_LINKS} GTest::gtest GTest::gtest_main rapidcheck)
  target_compile_definitions(${name} PRIVATE REORIENT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endfunction()

# reorient_add_benchmark(NAME LINKS target...): benchmarks/NAME_benchmark.cpp as the program NAME_benchmark.
function(reorient_add_benchmark name)
  cmake_parse_arguments(BENCHMARK "" "" "LINKS" ${ARGN})
  add_executable(${name}_benchmark ${name}_benchmark.cpp)
  target_link_libraries(${name}_benchmark PRIVATE ${BENCHMARK_LINKS} benchmark::benchmark benchmark::benchmark_main)
  target_compile_definitions(${name}_benchmark PRIVATE REORIENT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
