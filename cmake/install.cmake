# What `cmake --install` puts where: libraries, headers, a package for find_package(burin) and two pkg-config files, all
# of them relocatable. The tool installs itself in src/cli.
include(CMakePackageConfigHelpers)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/src/burin/curves/text/hershey/LICENSE-hershey
        DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(burin_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/burin)
set(burin_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(TARGETS burin_core EXPORT burin_core_targets FILE_SET HEADERS)
install(EXPORT burin_core_targets FILE burinCoreTargets.cmake NAMESPACE burin:: DESTINATION ${burin_package_dir})
if(BURIN_CAIRO)
  set_target_properties(burin_cairo PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS burin_cairo EXPORT burin_cairo_targets FILE_SET HEADERS)
  install(EXPORT burin_cairo_targets FILE burinCairoTargets.cmake NAMESPACE burin:: DESTINATION ${burin_package_dir})
endif()

get_target_property(burin_core_type burin_core TYPE)
if(burin_core_type STREQUAL "STATIC_LIBRARY")
  set(burin_is_static TRUE)
  set(burin_core_private_requires "Requires.private: fmt tomlplusplus muparser pugixml libpng libjpeg libdeflate polyclipping")
  set(burin_cairo_private_requires "Requires.private: cairo cairo-svg cairo-pdf cairo-png")
else()
  set(burin_is_static FALSE)
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/burinConfig.cmake.in ${PROJECT_BINARY_DIR}/burinConfig.cmake
                              INSTALL_DESTINATION ${burin_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/burinConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/burinConfig.cmake ${PROJECT_BINARY_DIR}/burinConfigVersion.cmake
        DESTINATION ${burin_package_dir})

file(RELATIVE_PATH burin_pc_prefix ${CMAKE_INSTALL_PREFIX}/${burin_pkgconfig_dir} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" burin_pc_prefix "${burin_pc_prefix}")
set(burin_pc_files burin)
if(BURIN_CAIRO)
  list(APPEND burin_pc_files burin-cairo)
endif()
foreach(name IN LISTS burin_pc_files)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${burin_pkgconfig_dir})
endforeach()
