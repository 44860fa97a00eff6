# SPDX-License-Identifier: MIT
# If ccache is installed (tools/packages), it provides objects that were compiled before in this clone or in another one
# of the same user. Its folder ${XDG_CACHE_HOME:-~/.cache}/reorient/ccache is outside of the clones and has at most
# REORIENT_CACHE_SIZE. Several builds may use it at the same time. The compiler's version is part of each key.
option(REORIENT_CCACHE "Take objects from ccache where it is installed" ON)
set(REORIENT_CACHE_SIZE "5G" CACHE STRING "How much ccache may hold")
if(NOT REORIENT_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
  return()
endif()
find_program(REORIENT_CCACHE_PROGRAM ccache)
mark_as_advanced(REORIENT_CCACHE_PROGRAM)
if(NOT REORIENT_CCACHE_PROGRAM)
  return()
endif()

set(folder "$ENV{XDG_CACHE_HOME}")
if(NOT IS_ABSOLUTE "${folder}")  # the XDG specification says: ignore an empty or relative path
  set(folder "$ENV{HOME}/.cache")
endif()
set(folder "${folder}/reorient/ccache")
# ccache fails if it cannot write, but a build must not fail then.
execute_process(COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
if(failed OR NOT IS_ABSOLUTE "${folder}")
  message(STATUS "No compiler cache: cannot create ${folder}")
  return()
endif()
execute_process(COMMAND test -w "${folder}" RESULT_VARIABLE failed)
if(failed)
  message(STATUS "No compiler cache: cannot write to ${folder}")
  return()
endif()

# DEPEND: a miss costs no run of the preprocessor. pch_defines, time_macros: required by ccache with precompiled headers. BASEDIR, NOHASHDIR: paths below the tree count as
# relative, so that every clone has the same keys.
set(CMAKE_CXX_COMPILER_LAUNCHER
  "${CMAKE_COMMAND}" -E env
  "CCACHE_DIR=${folder}" "CCACHE_MAXSIZE=${REORIENT_CACHE_SIZE}" "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
  "CCACHE_SLOPPINESS=pch_defines,time_macros" "CCACHE_COMPILERCHECK=%compiler% -v" --
  "${REORIENT_CCACHE_PROGRAM}")
