# Runs some tests of the command line with an installed executable; the others
# say the same of the library that it is made of.
#   cmake -D BUILD=... -D TESTS=... -P this
cmake_policy(VERSION 3.25)

string(RANDOM LENGTH 8 suffix)
set(scratch ${BUILD}/installed_test_${suffix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix
                        ${scratch} OUTPUT_QUIET RESULT_VARIABLE installed)
set(tests
    CommandLine.HelpListsEveryCommand CommandLine.VersionInBothForms
    CommandLine.LogsGoWhereTheOptionsSay CommandLine.ErrorsGoToTheLogFileToo
    CommandLine.SignalsStopARunWithExitCode130
    OctahedralMesher.LeavesMeshReportAndPicture)
list(JOIN tests : tests)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env OCTACUT_EXECUTABLE=${scratch}/bin/octacut
          ${TESTS} --gtest_filter=${tests}
  RESULT_VARIABLE tested)
file(REMOVE_RECURSE ${scratch})
if(NOT installed EQUAL 0 OR NOT tested EQUAL 0)
  message(FATAL_ERROR "install: ${installed}, tests: ${tested}")
endif()
