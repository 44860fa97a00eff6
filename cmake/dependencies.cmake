# SPDX-License-Identifier: MIT
# Finds all external libraries, together with libraries.cmake.
include(libraries)
reorient_find(missing
  Eigen3::Eigen sleef::sleef lua::headers turbojpeg::turbojpeg PNG::PNG lz4::lz4 zlib::zlib zstd::zstd civetweb::civetweb tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json
  opencv::core opencv::imgproc)
if(missing)
  message(FATAL_ERROR "reorient: ${missing}")
endif()
find_package(Threads REQUIRED)
# Optional: without them, footage must be MCAP logs with uncompressed images (workbench/footage/opencv).
set(REORIENT_FOOTAGE_IMAGES OFF)
if(REORIENT_DECODE_IMAGES)
  reorient_find(missing opencv::imgcodecs opencv::videoio)
  if(missing)
    message(STATUS "reorient: images and videos cannot be decoded: ${missing}")
  else()
    set(REORIENT_FOOTAGE_IMAGES ON)
  endif()
endif()
# The C++ build of Lua, in which an error of a script runs C++ destructors. engine/script/lua makes a library from it.
find_library(LUA_ARCHIVE NAMES liblua5.4-c++.a REQUIRED)

# Only for the program.
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
reorient_find_plain(libedit::libedit histedit.h edit)
if(NOT TARGET libedit::libedit)
  message(FATAL_ERROR "reorient: libedit is not found; install it (Debian: libedit-dev)")
endif()

if(REORIENT_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()
if(REORIENT_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
