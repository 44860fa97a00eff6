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
set(package_of_Eigen3::Eigen eigen3)
set(package_of_sleef::sleef sleef)
set(package_of_turbojpeg::turbojpeg libturbojpeg)
set(package_of_PNG::PNG libpng)
set(package_of_nlohmann_json::nlohmann_json nlohmann_json)
set(package_of_tomlplusplus::tomlplusplus tomlplusplus)

get_property(modules GLOBAL PROPERTY REORIENT_MODULES)
set_property(GLOBAL PROPERTY REORIENT_INSTALLED_MODULES ${modules})
set(headers)
set(components)  # for the package: the modules and libraries that each component needs, the component itself last
foreach(module ${modules})
  get_target_property(links ${module} REORIENT_LINKS)
  get_target_property(kind ${module} TYPE)
  set(modules_of_${module})
  set(libraries_of_${module})
  set(requires)
  set(compile_flags "-I\${includedir}")
  set(link_flags)
  if(kind STREQUAL "STATIC_LIBRARY")
    set(link_flags "-L\${libdir} -lreorient_${module}")
  endif()
  foreach(link ${links})
    if(link IN_LIST modules)
      list(APPEND modules_of_${module} ${modules_of_${link}})
      list(APPEND libraries_of_${module} ${libraries_of_${link}})
      list(APPEND requires "reorient-${link} = ${PROJECT_VERSION}")
    elseif(NOT TARGET ${link})
      string(APPEND link_flags " -l${link}")
    else()
      list(APPEND libraries_of_${module} ${link})
      if(package_of_${link})
        list(APPEND requires "${package_of_${link}}")
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
  list(APPEND modules_of_${module} ${module})
  list(REMOVE_DUPLICATES modules_of_${module})
  list(REMOVE_DUPLICATES libraries_of_${module})
  string(APPEND components "set(_reorient_modules_${module} ${modules_of_${module}})\n"
    "set(_reorient_libraries_${module} ${libraries_of_${module}})\n")

  get_target_property(module_headers ${module} REORIENT_HEADERS)
  list(APPEND headers ${module_headers})
  # One export set for each module, so that a module requires only its own dependencies.
  install(TARGETS ${module} EXPORT reorient-${module}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  install(EXPORT reorient-${module} NAMESPACE reorient:: FILE reorient-${module}-targets.cmake DESTINATION "${package_folder}")
  list(JOIN requires ", " requires)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/module.pc.in" "${PROJECT_BINARY_DIR}/package/reorient-${module}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/package/reorient-${module}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endforeach()

list(JOIN modules ", " names)
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
