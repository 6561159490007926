// Runs the tests so that those that ask for four threads get four, however many
// cores there are.
#include <gtest/gtest.h>

#include "core/base/with_threads.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  int result = 0;
  octacut::WithThreads(4, [&] { result = RUN_ALL_TESTS(); });
  return result;
}
