# One library per folder, so that a wrong arrow between layers or steps does
# not link. DEPENDS are public; a module sees only what it names here.
#   octacut_module(core_grid SOURCES voxel_grid.cc ... DEPENDS core_base ...)
# SOURCES may be empty: the module is then header-only. Up to sixteen of them are
# compiled at once (a unity build): most of the compiler's time goes into headers
# and templates that they share. Names in their anonymous namespaces must differ
# then; see octacut_compile_alone.
function(octacut_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target octacut_${name})
  if(MODULE_SOURCES)
    add_library(${target} STATIC ${MODULE_SOURCES})
    octacut_compile_together(${target})
    octacut_use_precompiled(${target} octacut_headers)
    set(visibility PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(visibility INTERFACE)
  endif()
  add_library(octacut::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${visibility} cxx_std_20)
  target_include_directories(
    ${target} ${visibility} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/octacut>)
  foreach(dependency IN LISTS MODULE_DEPENDS)
    if(dependency MATCHES "^(core|colmap)_")
      set(dependency octacut_${dependency})
    endif()
    target_link_libraries(${target} ${visibility} ${dependency})
  endforeach()
  if(MODULE_SOURCES)
    foreach(dependency IN LISTS MODULE_PRIVATE_DEPENDS)
      if(dependency MATCHES "^(core|colmap)_")
        set(dependency octacut_${dependency})
      endif()
      target_link_libraries(${target} PRIVATE ${dependency})
    endforeach()
    target_compile_options(${target} PRIVATE ${OCTACUT_WARNINGS})
  endif()
  set_property(GLOBAL APPEND PROPERTY OCTACUT_MODULES ${target})
endfunction()

function(octacut_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${OCTACUT_UNITY_BUILD}
                                             UNITY_BUILD_BATCH_SIZE 16)
endfunction()

# Sources of this folder that have names of others in their anonymous namespaces
# are compiled one by one.
function(octacut_compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# A test executable that mirrors one folder; every suite of it is a test of ctest.
#   octacut_test(core_grid SOURCES voxel_grid_test.cc ... DEPENDS core_grid ...)
# COST 1 has its tests started before those of other folders: long ones would
# leave a core idle at the end.
function(octacut_test name)
  cmake_parse_arguments(TEST "" "COST" "SOURCES;DEPENDS" ${ARGN})
  set(target test_${name})
  add_executable(${target} ${TEST_SOURCES})
  octacut_compile_together(${target})
  octacut_use_precompiled(${target} octacut_test_headers)
  foreach(dependency IN LISTS TEST_DEPENDS)
    if(dependency MATCHES "^(core|colmap)_")
      set(dependency octacut_${dependency})
    endif()
    target_link_libraries(${target} PRIVATE ${dependency})
  endforeach()
  target_link_libraries(${target} PRIVATE octacut_test_main GTest::gmock)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE ${OCTACUT_WARNINGS}
                                           ${OCTACUT_TEST_OPTIONS})
  set(properties TIMEOUT 1800 ${OCTACUT_TEST_PROPERTIES})
  if(TEST_COST)
    list(APPEND properties COST ${TEST_COST})
  endif()
  list(JOIN properties " " properties)
  set(discover ${PROJECT_SOURCE_DIR}/cmake/DiscoverSuites.cmake)
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  if(NOT EXISTS ${suites})
    file(WRITE ${suites} "add_test(${name}_NOT_BUILT ${target}_NOT_BUILT)\n")
  endif()
  add_custom_command(
    TARGET ${target}
    POST_BUILD
    BYPRODUCTS ${suites}
    COMMAND
      ${CMAKE_COMMAND} -D EXECUTABLE=$<TARGET_FILE:${target}> -D NAME=${name} -D
      OUTPUT=${suites} -D "PROPERTIES=${properties}" -P ${discover}
    VERBATIM)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${discover})
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${suites})
endfunction()
