# SPDX-License-Identifier: MIT
# How a room, a test and a benchmark of this project are declared. A room's doors are shut: its sources see the headers of
# only the modules that it links, and targets that link it inherit none of its flags.

set(REORIENT_WARNINGS
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wundef -Wcast-align -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND REORIENT_WARNINGS -Wno-restrict)  # false alarms in std::string (GCC bug 105651)
  if(CMAKE_CXX_FLAGS MATCHES "fsanitize=address")
    list(APPEND REORIENT_WARNINGS -Wno-maybe-uninitialized)  # false alarms in std::regex (GCC bug 105562)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND REORIENT_WARNINGS -Wno-unknown-pragmas)  # "GCC ivdep", a hint of which it knows nothing
endif()
# For what has no loop over pixels or particles: tests, tools and the program around the engine, not what a frame runs through.
# A third less time to build them.
set(REORIENT_QUICKLY_COMPILED $<$<CONFIG:Release>:-O1>)
# The same bits on every processor (geometry/pinned_math.h): no product and sum become one rounding, and `char` has a sign, which
# it lacks on ARM.
set(REORIENT_ARCHITECTURE -ffp-contract=off -fsigned-char)
# Every x86-64 robot and desktop since 2009 has SSE4.2; a preset may set a particular processor instead.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CMAKE_CXX_FLAGS MATCHES "-march=")
  list(APPEND REORIENT_ARCHITECTURE -march=x86-64-v2)
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
  # Eigen would fuse products by hand, whatever the compiler may do, and add in another order. To do without its packets would be
  # no way: they are what gives x86-64 its bits, and without them vectors are aligned differently from programs that link us.
  list(APPEND REORIENT_ARCHITECTURE -U__ARM_FEATURE_FMA "SHELL:-include ${PROJECT_SOURCE_DIR}/geometry/eigen_packets.h")
endif()

# reorient_include_root(TARGET SCOPE header...): a folder of links to just these headers (paths from the top of the tree)
# becomes an include folder of the target.
function(reorient_include_root target scope)
  set(root "${PROJECT_BINARY_DIR}/include/${target}")
  file(REMOVE_RECURSE "${root}")
  if(NOT ARGN)
    return()
  endif()
  foreach(header ${ARGN})
    get_filename_component(folder "${root}/${header}" DIRECTORY)
    file(MAKE_DIRECTORY "${folder}")
    file(RELATIVE_PATH origin "${folder}" "${PROJECT_SOURCE_DIR}/${header}")
    file(CREATE_LINK "${origin}" "${root}/${header}" SYMBOLIC)
  endforeach()
  target_include_directories(${target} ${scope} "$<BUILD_INTERFACE:${root}>")
endfunction()

# reorient_embed(VARIABLE file...): VARIABLE becomes the rows of a C++ table, {"name", R"text(...)text"}, with the text of each file
# under its name without the ending. So a program needs no folder to read them from.
function(reorient_embed variable)
  set(rows)
  foreach(file ${ARGN})
    cmake_path(GET file STEM LAST_ONLY name)
    file(READ "${file}" text)
    string(APPEND rows "      {\"${name}\", R\"text(${text})text\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  set(${variable} "${rows}" PARENT_SCOPE)
endfunction()

# reorient_add_room(NAME [SOURCES file...] [HEADERS file...] [WITHOUT folder...] [PUBLIC target...] [PRIVATE target...])
# One static library (or, without sources, headers alone). Its headers are those below the present folder, except for
# the subfolders WITHOUT, which are rooms of their own; or just HEADERS. PUBLIC: what its headers include; PRIVATE: what
# only its sources do.
function(reorient_add_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;HEADERS;WITHOUT;PUBLIC;PRIVATE" ${ARGN})
  file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  if(ROOM_HEADERS)
    list(TRANSFORM ROOM_HEADERS PREPEND "${folder}/")
  else()
    file(GLOB_RECURSE ROOM_HEADERS RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS "*.h")
    foreach(other ${ROOM_WITHOUT})
      list(FILTER ROOM_HEADERS EXCLUDE REGEX "^${folder}/${other}(/|$)")
    endforeach()
  endif()
  if(ROOM_SOURCES)
    reorient_unity_sources(ROOM_SOURCES ${name} ${ROOM_SOURCES})
    add_library(${name} STATIC ${ROOM_SOURCES})
    set_target_properties(${name} PROPERTIES OUTPUT_NAME reorient_${name})
    target_compile_options(${name} PRIVATE ${REORIENT_WARNINGS} ${REORIENT_ARCHITECTURE} ${REORIENT_UNITY_FLAGS})
    target_compile_features(${name} PUBLIC cxx_std_20)
    target_link_libraries(${name} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE})
    reorient_include_root(${name} PUBLIC ${ROOM_HEADERS})
  else()
    add_library(${name} INTERFACE)
    target_compile_features(${name} INTERFACE cxx_std_20)
    target_link_libraries(${name} INTERFACE ${ROOM_PUBLIC})
    reorient_include_root(${name} INTERFACE ${ROOM_HEADERS})
  endif()
  # For cmake/installation.cmake.
  set_property(GLOBAL APPEND PROPERTY REORIENT_ROOMS ${name})
  set_target_properties(${name} PROPERTIES
    REORIENT_HEADERS "${ROOM_HEADERS}" REORIENT_LINKS "${ROOM_PUBLIC};${ROOM_PRIVATE}")
endfunction()

# reorient_add_program(NAME SOURCES file... LINKS target...)
function(reorient_add_program name)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;LINKS" ${ARGN})
  reorient_unity_sources(PROGRAM_SOURCES ${name} ${PROGRAM_SOURCES})
  add_executable(${name} ${PROGRAM_SOURCES})
  target_compile_options(${name} PRIVATE ${REORIENT_WARNINGS} ${REORIENT_ARCHITECTURE} ${REORIENT_UNITY_FLAGS})
  target_link_libraries(${name} PRIVATE ${PROGRAM_LINKS})
  if(CMAKE_CROSSCOMPILING_EMULATOR)
    list(JOIN CMAKE_CROSSCOMPILING_EMULATOR " " emulator)
    target_compile_definitions(${name} PRIVATE REORIENT_EMULATOR="${emulator}")
  endif()
endfunction()
