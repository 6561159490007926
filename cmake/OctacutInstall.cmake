# Two components. runtime: the executable, its man page, the completion of bash
# and the scripts that use it. development: the libraries of core and colmap_io
# with their headers, and the files that find_package(octacut) reads. The plugin
# library stays inside: it is the executable's own.
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY OCTACUT_MODULES)
list(REMOVE_ITEM modules octacut_plugin)

# octacut::core and octacut::colmap_io: all modules of a layer at once.
foreach(layer core colmap_io)
  string(REPLACE "_io" "" prefix ${layer}) # modules colmap_model, ...
  set(layer_modules ${modules})
  list(FILTER layer_modules INCLUDE REGEX "^octacut_${prefix}_")
  add_library(octacut_${layer} INTERFACE)
  add_library(octacut::${layer} ALIAS octacut_${layer})
  set_target_properties(octacut_${layer} PROPERTIES EXPORT_NAME ${layer})
  target_link_libraries(octacut_${layer} INTERFACE ${layer_modules})
  list(APPEND modules octacut_${layer})
  install(
    DIRECTORY ${PROJECT_SOURCE_DIR}/${layer}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/octacut
    COMPONENT development
    FILES_MATCHING
    PATTERN "*.h")
endforeach()
target_link_libraries(octacut_colmap_io INTERFACE octacut_core)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/octacut)
install(TARGETS ${modules} EXPORT octacutTargets
        ARCHIVE COMPONENT development)
install(
  EXPORT octacutTargets
  NAMESPACE octacut::
  DESTINATION ${package_dir}
  COMPONENT development)

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/octacutConfig.cmake.in
  ${PROJECT_BINARY_DIR}/octacutConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/octacutConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/octacutConfig.cmake
              ${PROJECT_BINARY_DIR}/octacutConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT development)

install(TARGETS octacut RUNTIME COMPONENT runtime)
list(GET OCTACUT_DOCUMENTS 0 man_page)
list(GET OCTACUT_DOCUMENTS 1 completion)
install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
        COMPONENT runtime)
install(
  FILES ${completion}
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME octacut
  COMPONENT runtime)
# They look for the executable beside themselves, then in the PATH.
set(scripts after_mapper.sh align_model.sh colmap_options.sh compare_dense.sh
            find_octacut.sh images_to_mesh.sh option_value.sh run_colmap.sh)
list(TRANSFORM scripts PREPEND ${PROJECT_SOURCE_DIR}/workflows/)
install(PROGRAMS ${scripts}
        DESTINATION ${CMAKE_INSTALL_DATADIR}/octacut/workflows
        COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
# As Debian wants it.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright
        COMPONENT runtime)
