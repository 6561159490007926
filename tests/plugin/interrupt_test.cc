#include "plugin/interrupt.h"

#include <gtest/gtest.h>
#include <signal.h>

namespace octacut {
namespace {

TEST(InterruptHandler, TheFirstSignalAsksTheSecondKills) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const InterruptHandler handler;
    EXPECT_FALSE(handler.Requested());
    raise(signal);
    EXPECT_TRUE(handler.Requested());
    struct sigaction action {};
    for (const int second : {SIGINT, SIGTERM}) {
      sigaction(second, nullptr, &action);
      EXPECT_EQ(action.sa_handler, SIG_DFL);
    }
  }
}

}  // namespace
}  // namespace octacut
