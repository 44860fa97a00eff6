# SPDX-License-Identifier: MIT
# Functions that declare the modules, tests and benchmarks of this project. The sources of a module can include only the
# headers of the modules that it links, and targets that link it do not inherit its flags.

set(REORIENT_WARNINGS
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wundef -Wcast-align -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND REORIENT_WARNINGS -Wno-restrict)  # false alarms in std::string (GCC bug 105651)
  if(CMAKE_CXX_FLAGS MATCHES "fsanitize=address")
    list(APPEND REORIENT_WARNINGS -Wno-maybe-uninitialized)  # false alarms in std::regex (GCC bug 105562)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND REORIENT_WARNINGS -Wno-unknown-pragmas)  # "GCC ivdep", a hint that Clang does not know
endif()
# Flags for code without loops over pixels or particles: tests, tools and the program around the engine. They build in a
# third less time.
set(REORIENT_QUICKLY_COMPILED $<$<CONFIG:Release>:-O1>)
# The same bits on every processor (geometry/pinned_math.h): no fused multiply-add, and a signed `char`, which is unsigned
# on ARM by default.
set(REORIENT_ARCHITECTURE -ffp-contract=off -fsigned-char)
# Every x86-64 robot and desktop since 2009 has SSE4.2; a preset may set a particular processor instead.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CMAKE_CXX_FLAGS MATCHES "-march=")
  list(APPEND REORIENT_ARCHITECTURE -march=x86-64-v2)
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
  # Eigen uses fused multiply-add explicitly, independent of the compiler's flags, and adds in another order. Its packets
  # cannot be disabled: they determine the bits on x86-64, and without them vectors have another alignment than in programs
  # that link this project.
  list(APPEND REORIENT_ARCHITECTURE -U__ARM_FEATURE_FMA "SHELL:-include ${PROJECT_SOURCE_DIR}/geometry/eigen_packets.h")
endif()

# reorient_include_root(TARGET SCOPE header...): makes a folder with links to only these headers (paths from the top of the
# tree) and adds it to the include folders of the target.
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

# reorient_embed(VARIABLE [WITH_EXTENSIONS] file...): VARIABLE becomes the rows of a C++ table, {"name", R"text(...)text"},
# with the text of each file under its name, without the extension if WITH_EXTENSIONS is not given. A program then contains
# the texts and reads no folder.
function(reorient_embed variable)
  cmake_parse_arguments(PARSE_ARGV 1 EMBEDDED "WITH_EXTENSIONS" "" "")
  set(rows)
  foreach(file ${EMBEDDED_UNPARSED_ARGUMENTS})
    if(EMBEDDED_WITH_EXTENSIONS)
      cmake_path(GET file FILENAME name)
    else()
      cmake_path(GET file STEM LAST_ONLY name)
    endif()
    file(READ "${file}" text)
    string(APPEND rows "      {\"${name}\", R\"text(${text})text\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  set(${variable} "${rows}" PARENT_SCOPE)
endfunction()

# reorient_add_module(NAME [SOURCES file...] [HEADERS file...] [WITHOUT folder...] [PUBLIC target...] [PRIVATE target...])
# One module as a static library (without sources: only headers). Its headers are those below the current folder, except
# for the subfolders WITHOUT, which are separate modules; or only HEADERS. PUBLIC: modules that its headers include;
# PRIVATE: modules that only its sources include.
function(reorient_add_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;HEADERS;WITHOUT;PUBLIC;PRIVATE" ${ARGN})
  file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  if(MODULE_HEADERS)
    list(TRANSFORM MODULE_HEADERS PREPEND "${folder}/")
  else()
    file(GLOB_RECURSE MODULE_HEADERS RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS "*.h")
    foreach(other ${MODULE_WITHOUT})
      list(FILTER MODULE_HEADERS EXCLUDE REGEX "^${folder}/${other}(/|$)")
    endforeach()
  endif()
  if(MODULE_SOURCES)
    reorient_unity_sources(MODULE_SOURCES ${name} ${MODULE_SOURCES})
    add_library(${name} STATIC ${MODULE_SOURCES})
    set_target_properties(${name} PROPERTIES OUTPUT_NAME reorient_${name})
    target_compile_options(${name} PRIVATE ${REORIENT_WARNINGS} ${REORIENT_ARCHITECTURE} ${REORIENT_UNITY_FLAGS})
    target_compile_features(${name} PUBLIC cxx_std_20)
    target_link_libraries(${name} PUBLIC ${MODULE_PUBLIC} PRIVATE ${MODULE_PRIVATE})
    reorient_include_root(${name} PUBLIC ${MODULE_HEADERS})
  else()
    add_library(${name} INTERFACE)
    target_compile_features(${name} INTERFACE cxx_std_20)
    target_link_libraries(${name} INTERFACE ${MODULE_PUBLIC})
    reorient_include_root(${name} INTERFACE ${MODULE_HEADERS})
  endif()
  # For cmake/installation.cmake.
  set_property(GLOBAL APPEND PROPERTY REORIENT_MODULES ${name})
  set_target_properties(${name} PROPERTIES
    REORIENT_HEADERS "${MODULE_HEADERS}" REORIENT_LINKS "${MODULE_PUBLIC};${MODULE_PRIVATE}")
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
