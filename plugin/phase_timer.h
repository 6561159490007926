// Measures the phases of a run on their way to another sink.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/base/context.h"

namespace octacut {

struct PhaseTiming {
  std::string name;
  int depth = 0;       // 0: not inside another phase
  double seconds = 0;  // wall time; so far, when the phase still runs
};

class PhaseTimer : public ProgressSink {
 public:
  // `next` may be null; it must outlive the timer.
  explicit PhaseTimer(ProgressSink* next) : next_(next) {}

  void BeginPhase(std::string_view name, size_t total) override;
  void Advance(size_t done) override;
  void EndPhase() override;
  void Info(std::string_view message) override;
  void Warn(std::string_view message) override;

  // In the order in which the phases began; an inner phase follows the one
  // that it is in.
  std::vector<PhaseTiming> Timings() const;
  // Warnings of the run in their order, for the report.
  const std::vector<std::string>& Warnings() const { return warnings_; }
  // Since the construction.
  double TotalSeconds() const;

 private:
  using Clock = std::chrono::steady_clock;

  struct RunningPhase {
    size_t index;  // in timings_
    Clock::time_point begin;
  };

  ProgressSink* next_;
  Clock::time_point begin_ = Clock::now();
  std::vector<PhaseTiming> timings_;
  std::vector<RunningPhase> running_;  // the innermost last
  std::vector<std::string> warnings_;
};

}  // namespace octacut
