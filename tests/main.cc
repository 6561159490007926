// Runs the tests so that those that ask for four threads get four, however many
// cores there are. Leaves out those that OCTACUT_LEAVE_OUT lists: patterns of
// GoogleTest's with colons between them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "core/base/with_threads.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (const char* const patterns = std::getenv("OCTACUT_LEAVE_OUT")) {
    GTEST_FLAG_SET(filter, GTEST_FLAG_GET(filter) + "-" + patterns);
  }
  int result = 0;
  octacut::WithThreads(4, [&] { result = RUN_ALL_TESTS(); });
  return result;
}
