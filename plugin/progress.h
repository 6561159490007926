// Shows the progress of a run: on a terminal one line with phase, percentage,
// elapsed and estimated remaining time, which is updated in place; otherwise
// a line when a phase begins and ends and every tenth of it, at most every
// few seconds.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/base/context.h"
#include "plugin/log.h"

namespace octacut {

// "0:07", "12:30", "1:02:03".
std::string FormatDuration(std::chrono::duration<double> duration);

class ProgressReporter : public ProgressSink {
 public:
  using Clock = std::chrono::steady_clock;

  struct Intervals {
    Clock::duration status = std::chrono::milliseconds(100);
    Clock::duration line = std::chrono::seconds(5);
  };

  explicit ProgressReporter(Log& log) : ProgressReporter(log, Intervals()) {}
  ProgressReporter(Log& log, const Intervals& intervals)
      : log_(log), intervals_(intervals) {}

  void BeginPhase(std::string_view name, size_t total) override;
  void Advance(size_t done) override;
  void EndPhase() override;
  void Info(std::string_view message) override { log_.Info(message); }
  void Warn(std::string_view message) override { log_.Warn(message); }

 private:
  struct RunningPhase {
    std::string name;
    size_t total;
    size_t done = 0;
    Clock::time_point begin;
    Clock::time_point last_status;
    Clock::time_point last_line;
    size_t last_tenth = 0;
  };

  std::string Indent() const;
  std::string Describe(const RunningPhase& phase, Clock::time_point now) const;

  Log& log_;
  Intervals intervals_;
  std::vector<RunningPhase> phases_;  // the innermost last
};

}  // namespace octacut
