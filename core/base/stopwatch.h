// Seconds of wall time since the start or the last Lap().
#pragma once

#include <chrono>
#include <type_traits>

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

// Returns what `step` returns, and adds the seconds that it takes to *seconds,
// unless it throws.
template <typename Step>
auto Timed(double* seconds, Step&& step) {
  Stopwatch stopwatch;
  if constexpr (std::is_void_v<decltype(step())>) {
    step();
    *seconds += stopwatch.Lap();
  } else {
    auto result = step();
    *seconds += stopwatch.Lap();
    return result;
  }
}

}  // namespace octacut
