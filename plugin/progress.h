// Shows the progress of a run. Phases that have ended are a line each, in
// which equal names are summed: they are written before the next message, or
// when the run ends. While a phase runs, a terminal has a bar, which is updated
// in place; otherwise there is a line only for phases that take long.
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
    Clock::duration line = std::chrono::seconds(30);
    // Phases that took less in all are left to the report: their time would
    // be written as 0.0 s.
    Clock::duration shortest = std::chrono::milliseconds(50);
  };

  explicit ProgressReporter(Log& log) : ProgressReporter(log, Intervals()) {}
  ProgressReporter(Log& log, const Intervals& intervals)
      : log_(log), intervals_(intervals) {}
  ~ProgressReporter() override { WriteEndedPhases(); }

  void BeginPhase(std::string_view name, size_t total) override;
  void Advance(size_t done) override;
  void EndPhase() override;
  void Info(std::string_view message) override;
  void Warn(std::string_view message) override;

 private:
  struct RunningPhase {
    std::string name;
    size_t total;
    size_t done = 0;
    Clock::time_point begin;
    Clock::time_point last_status;
    Clock::time_point last_line;
  };
  struct EndedPhase {
    std::string name;
    Clock::duration duration{};
    int count = 0;
    bool is_stopped = false;  // by an error or a signal
  };

  std::string Describe(const RunningPhase& phase,
                       Clock::time_point now,
                       bool with_bar) const;
  void WriteEndedPhases();

  Log& log_;
  Intervals intervals_;
  std::vector<RunningPhase> running_;  // the innermost last
  std::vector<EndedPhase> ended_;      // outermost ones, not yet written
};

}  // namespace octacut
