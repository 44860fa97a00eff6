# SPDX-License-Identifier: MIT
# Installs all modules that are declared so far: libraries, headers below include/reorient/, a CMake package with a
# component for each module, and a pkg-config file for each. They contain no path of this machine except those of other
# packages.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/reorient")
file(RELATIVE_PATH prefix_from_pkgconfig "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" prefix_from_pkgconfig "${prefix_from_pkgconfig}")

# The name of an external library in pkg-config. Libraries without a name get flags instead.
set(module_of_Eigen3::Eigen eigen3)
set(module_of_sleef::sleef sleef)
set(module_of_turbojpeg::turbojpeg libturbojpeg)
set(module_of_PNG::PNG libpng)
set(module_of_nlohmann_json::nlohmann_json nlohmann_json)
set(module_of_tomlplusplus::tomlplusplus tomlplusplus)

get_property(rooms GLOBAL PROPERTY REORIENT_ROOMS)
set_property(GLOBAL PROPERTY REORIENT_INSTALLED_ROOMS ${rooms})
set(headers)
set(components)  # for the package: the modules and libraries that each component needs, the component itself last
foreach(room ${rooms})
  get_target_property(links ${room} REORIENT_LINKS)
  get_target_property(kind ${room} TYPE)
  set(rooms_of_${room})
  set(libraries_of_${room})
  set(modules)
  set(compile_flags "-I\${includedir}")
  set(link_flags)
  if(kind STREQUAL "STATIC_LIBRARY")
    set(link_flags "-L\${libdir} -lreorient_${room}")
  endif()
  foreach(link ${links})
    if(link IN_LIST rooms)
      list(APPEND rooms_of_${room} ${rooms_of_${link}})
      list(APPEND libraries_of_${room} ${libraries_of_${link}})
      list(APPEND modules "reorient-${link} = ${PROJECT_VERSION}")
    elseif(NOT TARGET ${link})
      string(APPEND link_flags " -l${link}")
    else()
      list(APPEND libraries_of_${room} ${link})
      if(module_of_${link})
        list(APPEND modules "${module_of_${link}}")
      else()
        get_target_property(include_folder ${link} INTERFACE_INCLUDE_DIRECTORIES)
        get_target_property(library ${link} IMPORTED_LOCATION)
        string(APPEND compile_flags " -isystem ${include_folder}")
        if(library)
          string(APPEND link_flags " ${library}")
        endif()
      endif()
    endif()
  endforeach()
  list(APPEND rooms_of_${room} ${room})
  list(REMOVE_DUPLICATES rooms_of_${room})
  list(REMOVE_DUPLICATES libraries_of_${room})
  string(APPEND components "set(_reorient_rooms_${room} ${rooms_of_${room}})\n"
    "set(_reorient_libraries_${room} ${libraries_of_${room}})\n")

  get_target_property(room_headers ${room} REORIENT_HEADERS)
  list(APPEND headers ${room_headers})
  # One export set for each module, so that a module requires only its own dependencies.
  install(TARGETS ${room} EXPORT reorient-${room}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  install(EXPORT reorient-${room} NAMESPACE reorient:: FILE reorient-${room}-targets.cmake DESTINATION "${package_folder}")
  list(JOIN modules ", " modules)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/room.pc.in" "${PROJECT_BINARY_DIR}/package/reorient-${room}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/package/reorient-${room}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endforeach()

list(JOIN rooms ", " names)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/reorient-config.cmake.in"
  "${PROJECT_BINARY_DIR}/package/reorient-config.cmake" INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/reorient-config-version.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/package/reorient-config.cmake" "${PROJECT_BINARY_DIR}/package/reorient-config-version.cmake"
  DESTINATION "${package_folder}")
install(FILES "${CMAKE_CURRENT_LIST_DIR}/libraries.cmake" DESTINATION "${package_folder}" RENAME reorient-libraries.cmake)

install(CODE "set(headers \"${headers}\")
set(source \"${PROJECT_SOURCE_DIR}\")
set(stage \"${PROJECT_BINARY_DIR}/package/include\")
set(destination \"${CMAKE_INSTALL_INCLUDEDIR}\")")
install(SCRIPT "${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake")
