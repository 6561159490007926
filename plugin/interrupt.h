// SIGINT and SIGTERM as a request to stop.
#pragma once

#include <atomic>

namespace octacut {

// While an instance lives, the first SIGINT or SIGTERM sets Requested(); the
// next one ends the process as if there were no handler. At most one instance
// at a time: signal handlers belong to the process.
class InterruptHandler {
 public:
  InterruptHandler();
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;

  const std::atomic<bool>& Requested() const;
};

}  // namespace octacut
