#include "plugin/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace octacut {

std::string FormatDuration(std::chrono::duration<double> duration) {
  const long seconds = std::lround(duration.count());
  if (seconds >= 3600) {
    return fmt::format(
        "{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  }
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string ProgressReporter::Indent() const {
  return std::string(phases_.empty() ? 0 : 2 * (phases_.size() - 1), ' ');
}

std::string ProgressReporter::Describe(const RunningPhase& phase,
                                       Clock::time_point now) const {
  const std::chrono::duration<double> elapsed = now - phase.begin;
  std::string text = phase.name;
  if (phase.total > 0) {
    text += fmt::format(" {:3d} %", 100 * phase.done / phase.total);
  }
  text += fmt::format(", {} elapsed", FormatDuration(elapsed));
  if (phase.done > 0 && phase.total > 0) {
    const auto left =
        elapsed * (double(phase.total - phase.done) / double(phase.done));
    text += fmt::format(", about {} left", FormatDuration(left));
  }
  return text;
}

void ProgressReporter::BeginPhase(std::string_view name, size_t total) {
  const Clock::time_point now = Clock::now();
  phases_.push_back({std::string(name), total, 0, now, now, now, 0});
  log_.Progress(fmt::format("{}{} ...", Indent(), name));
  if (log_.HasTerminal()) {
    log_.SetStatus(fmt::format("{} ...", name));
  }
}

void ProgressReporter::Advance(size_t done) {
  if (phases_.empty()) {
    return;
  }
  RunningPhase& phase = phases_.back();
  // Reports of several threads may overtake each other.
  phase.done = std::max(phase.done, done);
  if (phase.total > 0) {
    phase.done = std::min(phase.done, phase.total);
  }
  const Clock::time_point now = Clock::now();
  if (log_.HasTerminal() && now - phase.last_status >= intervals_.status) {
    phase.last_status = now;
    log_.SetStatus(Describe(phase, now));
  }
  const size_t tenth = phase.total > 0 ? 10 * phase.done / phase.total : 0;
  if (tenth > phase.last_tenth && tenth < 10 &&
      now - phase.last_line >= intervals_.line) {
    phase.last_line = now;
    phase.last_tenth = tenth;
    log_.Progress(Indent() + Describe(phase, now));
  }
}

void ProgressReporter::EndPhase() {
  if (phases_.empty()) {
    return;
  }
  const RunningPhase& phase = phases_.back();
  const std::chrono::duration<double> elapsed = Clock::now() - phase.begin;
  const std::string line =
      fmt::format("{}{}: {:.2f} s", Indent(), phase.name, elapsed.count());
  if (phases_.size() == 1) {
    log_.Info(line);  // stays on a terminal, too
  } else {
    log_.Progress(line);
    log_.SetStatus("");
  }
  phases_.pop_back();
}

}  // namespace octacut
