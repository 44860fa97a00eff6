# Every library comes from a Debian 12 package (tools/packages lists them) and is found here, nowhere else.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(spdlog REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
pkg_check_modules(sleef REQUIRED IMPORTED_TARGET sleef)
pkg_check_modules(turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg)
# The C++ build of Lua: an error in a script unwinds C++ destructors. engine/script/lua makes the library of it.
pkg_check_modules(lua REQUIRED lua5.4-c++)
find_library(LUA_ARCHIVE NAMES liblua5.4-c++.a HINTS ${lua_LIBRARY_DIRS} REQUIRED)

# OpenCV's own CMake package asks for all of its modules; only two are wanted here.
find_path(OPENCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(module core imgproc)
  find_library(OPENCV_${module}_LIBRARY opencv_${module} REQUIRED)
  add_library(opencv::${module} SHARED IMPORTED)
  set_target_properties(opencv::${module} PROPERTIES
    IMPORTED_LOCATION "${OPENCV_${module}_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OPENCV_INCLUDE_DIR}")
endforeach()
set_property(TARGET opencv::imgproc APPEND PROPERTY INTERFACE_LINK_LIBRARIES opencv::core)

if(REORIENT_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()
if(REORIENT_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
