// Seconds of wall time since the start or the last Lap().
#pragma once

#include <chrono>

namespace octacut {

class Stopwatch {
 public:
  double Lap() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> elapsed = now - start_;
    start_ = now;
    return elapsed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace octacut
