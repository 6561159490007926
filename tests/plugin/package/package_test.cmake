# Installs a build into a folder of its own, moves it elsewhere (no path may be
# baked in), runs the executable and builds and runs an outside project.
#   cmake -D BUILD=... -D VERSION=... -D CONFIG=... -D FLAGS=... -P this
cmake_policy(VERSION 3.25)

string(RANDOM LENGTH 8 suffix)
set(scratch ${BUILD}/package_test_${suffix})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    file(REMOVE_RECURSE ${scratch})
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${scratch}/first)
file(RENAME ${scratch}/first ${scratch}/prefix)

run(${scratch}/prefix/bin/octacut version)
if(NOT output MATCHES "octacut ${VERSION}")
  file(REMOVE_RECURSE ${scratch})
  message(FATAL_ERROR "the installed executable says ${output}")
endif()

foreach(file share/doc/octacut/copyright include/octacut/core/base/error.h
             include/octacut/colmap_io/mesh/mesh_io.h)
  if(NOT EXISTS ${scratch}/prefix/${file})
    file(REMOVE_RECURSE ${scratch})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${scratch}/consumer
    -DCMAKE_BUILD_TYPE=${CONFIG} "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -DCMAKE_PREFIX_PATH=${scratch}/prefix -DOCTACUT_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${scratch}/consumer)
run(${scratch}/consumer/consumer)
message(STATUS "${output}")
file(REMOVE_RECURSE ${scratch})
