# Writes a file for ctest in which every suite of a GoogleTest executable is one
# test: what the tests of a suite share is set up once, and the libraries of the
# executable are loaded once for all of them.
#   cmake -D EXECUTABLE=... -D NAME=core_grid -D PROPERTIES=... -D OUTPUT=... -P this
cmake_policy(VERSION 3.25)

unset(ENV{OCTACUT_LEAVE_OUT})
execute_process(
  COMMAND ${EXECUTABLE} --gtest_list_tests
  OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
# The lines that are not indented: "Morton." or "PhotoConsistency/Measure.".
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listing}")
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n|\\.$" "" suite "${suite}")
  string(
    APPEND tests
    "add_test(\"${NAME}.${suite}\" \"${EXECUTABLE}\" \"--gtest_filter=${suite}.*\")\n"
    "set_tests_properties(\"${NAME}.${suite}\" PROPERTIES ${PROPERTIES})\n")
endforeach()
file(WRITE ${OUTPUT} "${tests}")
