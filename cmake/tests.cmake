# SPDX-License-Identifier: MIT
# Functions that declare tests. Each test belongs to a tier, which is a label in CTest:
#   gate      tests that an ordinary change can break: ./test runs them
#   extended  expensive tests that rarely fail: ./test --all runs them. Their label is extended.GROUP.
#             ./test --groups NAME,... and .ci/run run some groups; CONTRIBUTING.md lists them and the files of each
# The targets `gate` and `extended.GROUP` build everything that the tests of a tier or a group need.
add_custom_target(gate)

# Precompiled headers that most tests include, one version without RapidCheck and one with it. The preset `debug` does not
# use them, so that it detects a missing include.
set(headers
  <algorithm> <array> <chrono> <cmath> <cstdint> <cstdlib> <cstring> <filesystem> <fstream> <functional> <iostream> <limits> <map>
  <memory> <optional> <random> <set> <span> <sstream> <stdexcept> <string> <string_view> <thread> <utility> <vector>
  <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry>)
foreach(kind test property_test)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp" CONTENT "" @ONLY)
  add_library(${kind}_headers OBJECT EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp")
  target_link_libraries(${kind}_headers PRIVATE geometry GTest::gtest)
  target_compile_options(${kind}_headers PRIVATE
    ${REORIENT_WARNINGS} ${REORIENT_ARCHITECTURE} ${REORIENT_UNITY_FLAGS} ${REORIENT_QUICKLY_COMPILED})
  target_precompile_headers(${kind}_headers PRIVATE ${headers})
endforeach()
target_link_libraries(property_test_headers PRIVATE rapidcheck)
target_precompile_headers(property_test_headers PRIVATE <rapidcheck/gtest.h>)

# reorient_needs(TIER target...): TIER, `gate` or `extended.GROUP`, builds these targets.
function(reorient_needs tier)
  if(NOT TARGET ${tier})
    add_custom_target(${tier})
  endif()
  add_dependencies(${tier} ${ARGN})
endfunction()

# reorient_add_tests(NAME SOURCES file... LINKS target... [NEEDS target...] [EXTENDED group pattern]... [UNSANITIZED]
# [TOO_SLOW_SANITIZED pattern] [THREADED]): one GoogleTest program, whose tests are registered in CTest. PATTERN, as in
# --gtest_filter: tests of that group; all others belong to the gate. NEEDS: programs that the tests start. UNSANITIZED:
# the sanitizers cannot find anything, because the tests only start external programs or replace operator new.
# TOO_SLOW_SANITIZED: slow tests of code that other tests run as well. THREADED: the tests or the code that they call start
# threads, so the thread sanitizer is useful. Programs that link rapidcheck have its header precompiled.
function(reorient_add_tests name)
  cmake_parse_arguments(TESTS "UNSANITIZED;THREADED" "TOO_SLOW_SANITIZED" "SOURCES;LINKS;NEEDS;EXTENDED" ${ARGN})
  reorient_add_program(${name}
    SOURCES ${TESTS_SOURCES} LINKS ${TESTS_LINKS} test_support GTest::gtest GTest::gtest_main)
  target_compile_options(${name} PRIVATE ${REORIENT_QUICKLY_COMPILED})
  set(kind test)
  if(rapidcheck IN_LIST TESTS_LINKS)
    set(kind property_test)
  endif()
  target_precompile_headers(${name} REUSE_FROM ${kind}_headers)
  # When cross-compiling, building the whole program takes long; tools/test-aarch64 names the targets that it builds.
  if(TESTS_NEEDS AND NOT CMAKE_CROSSCOMPILING)
    add_dependencies(${name} ${TESTS_NEEDS})
  endif()

  set(timeout 300)
  if(CMAKE_CROSSCOMPILING_EMULATOR)
    set(timeout 3600)  # an emulated program takes ten times as long
  endif()
  set(others)
  while(TESTS_EXTENDED)
    list(POP_FRONT TESTS_EXTENDED group pattern)
    string(REGEX REPLACE "^:" "" pattern "${pattern}")
    reorient_discover(${name} "${pattern}" ${timeout} extended.${group})
    reorient_needs(extended.${group} ${name})
    string(APPEND others ":${pattern}")
  endwhile()
  if(NOT TESTS_NEEDS AND NOT TESTS_UNSANITIZED)
    set(left_out "${others}")
    if(TESTS_TOO_SLOW_SANITIZED)
      string(APPEND left_out ":${TESTS_TOO_SLOW_SANITIZED}")
    endif()
    string(REGEX REPLACE "^:" "*-" filter "${left_out}")
    if(NOT filter)
      set(filter "*")
    endif()
    file(RELATIVE_PATH area "${PROJECT_SOURCE_DIR}/tests" "${CMAKE_CURRENT_SOURCE_DIR}")
    set_property(GLOBAL APPEND_STRING PROPERTY REORIENT_TEST_PROGRAMS
      "${name}\t$<TARGET_FILE:${name}>\t${area}\t${filter}\t$<BOOL:${TESTS_THREADED}>\n")
  endif()
  if(NOT others STREQUAL ":*")
    string(REGEX REPLACE "^:" "-" others "${others}")
    reorient_discover(${name} "${others}" ${timeout} gate)
    reorient_needs(gate ${name})
  endif()
endfunction()

# A fixed seed for RapidCheck, so that results are reproducible. tools/deep-run, and a program that is started directly, use
# other seeds.
function(reorient_discover name filter timeout labels)
  set(filter_of)
  if(filter)
    set(filter_of TEST_FILTER "${filter}")
  endif()
  gtest_discover_tests(${name} ${filter_of} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120
    PROPERTIES TIMEOUT ${timeout} LABELS "${labels}" ENVIRONMENT RC_PARAMS=seed=2026)
endfunction()

# reorient_add_check(NAME [GROUP group] [TIMEOUT seconds] [COST seconds] [NEEDS target...] [ENVIRONMENT name=value...]
# COMMAND word...): a command as a test of the gate or of a group. Exit code 77: skipped. COST: approximate duration; CTest
# starts the longest tests first.
function(reorient_add_check name)
  cmake_parse_arguments(CHECK "" "GROUP;TIMEOUT;COST" "NEEDS;ENVIRONMENT;COMMAND" ${ARGN})
  add_test(NAME ${name} COMMAND ${CHECK_COMMAND})
  set(tier gate)
  set(labels gate)
  if(CHECK_GROUP)
    set(tier extended.${CHECK_GROUP})
    set(labels ${tier})
  endif()
  if(NOT CHECK_TIMEOUT)
    set(CHECK_TIMEOUT 300)
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" TIMEOUT ${CHECK_TIMEOUT} SKIP_RETURN_CODE 77
    ENVIRONMENT "${CHECK_ENVIRONMENT}")
  if(CHECK_COST)
    set_tests_properties(${name} PROPERTIES COST ${CHECK_COST})
  endif()
  if(CHECK_NEEDS)
    reorient_needs(${tier} ${CHECK_NEEDS})
  elseif(CHECK_GROUP AND NOT TARGET ${tier})
    add_custom_target(${tier})
  endif()
endfunction()
