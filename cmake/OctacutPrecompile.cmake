# Headers that most files include, precompiled once for the libraries and once
# for the tests, whose options differ: reading them anew takes a fifth of the
# compiler's time. Files still include what they use; the lint build, without
# precompiled headers, fails on one that does not.
option(OCTACUT_PRECOMPILE "Precompile the headers that most files include" ON)

set(OCTACUT_COMMON_HEADERS
    <algorithm> <array> <bit> <cmath> <cstdint> <filesystem> <fstream>
    <functional> <limits> <map> <memory> <numbers> <numeric> <optional> <random>
    <span> <sstream> <string> <string_view> <utility> <vector>
    <Eigen/Core> <Eigen/Geometry> <fmt/format.h> <opencv2/core.hpp>)

# octacut_precompiled(octacut_headers <vector> ... OPTIONS -O1 DEPENDS GTest::gmock)
# makes a library that other targets take their precompiled headers from.
function(octacut_precompiled target)
  if(NOT OCTACUT_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(PRECOMPILED "" "" "HEADERS;OPTIONS;DEPENDS" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/${target}.cc)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "")
  endif()
  add_library(${target} OBJECT ${source})
  target_link_libraries(${target} PRIVATE Eigen3::Eigen fmt::fmt opencv_core
                                          ${PRECOMPILED_DEPENDS})
  target_compile_options(${target} PRIVATE ${OCTACUT_WARNINGS}
                                           ${PRECOMPILED_OPTIONS})
  target_precompile_headers(${target} PRIVATE ${OCTACUT_COMMON_HEADERS}
                            ${PRECOMPILED_HEADERS})
endfunction()

function(octacut_use_precompiled target precompiled)
  if(OCTACUT_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
  endif()
endfunction()
