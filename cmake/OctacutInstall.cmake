# Installs the executable, the libraries of core and colmap_io with their
# headers, and the files that find_package(octacut) reads. The plugin library
# stays inside: it is the executable's own.
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
    FILES_MATCHING
    PATTERN "*.h")
endforeach()
target_link_libraries(octacut_colmap_io INTERFACE octacut_core)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/octacut)
install(TARGETS octacut RUNTIME)
install(TARGETS ${modules} EXPORT octacutTargets ARCHIVE)
install(
  EXPORT octacutTargets
  NAMESPACE octacut::
  DESTINATION ${package_dir})

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/octacutConfig.cmake.in
  ${PROJECT_BINARY_DIR}/octacutConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/octacutConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/octacutConfig.cmake
              ${PROJECT_BINARY_DIR}/octacutConfigVersion.cmake
        DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
