#include "plugin/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace octacut {
namespace {

constexpr size_t kBarWidth = 20;

std::string Bar(size_t done, size_t total) {
  const size_t filled = kBarWidth * done / total;
  return fmt::format(" [{:-<{}}]", std::string(filled, '#'), kBarWidth);
}

std::string Capitalized(std::string_view name) {
  std::string text(name);
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = char(text[0] - 'a' + 'A');
  }
  return text;
}

}  // namespace

std::string FormatDuration(std::chrono::duration<double> duration) {
  const long seconds = std::lround(duration.count());
  if (seconds >= 3600) {
    return fmt::format(
        "{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  }
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string ProgressReporter::Describe(const RunningPhase& phase,
                                       Clock::time_point now,
                                       bool with_bar) const {
  const std::chrono::duration<double> elapsed = now - phase.begin;
  std::string text = phase.name;
  if (phase.total > 0) {
    text += with_bar ? Bar(phase.done, phase.total) : "";
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
  running_.push_back({Capitalized(name), total, 0, now, now, now});
  log_.SetStatus(running_.back().name + " ...");
}

void ProgressReporter::Advance(size_t done) {
  if (running_.empty()) {
    return;
  }
  RunningPhase& phase = running_.back();
  // Reports of several threads may overtake each other.
  phase.done = std::max(phase.done, done);
  if (phase.total > 0) {
    phase.done = std::min(phase.done, phase.total);
  }
  const Clock::time_point now = Clock::now();
  if (log_.HasTerminal() && now - phase.last_status >= intervals_.status) {
    phase.last_status = now;
    log_.SetStatus(Describe(phase, now, true));
  }
  // However short the inner ones are, the outer phase may take long.
  Clock::time_point& last_line = running_.front().last_line;
  if (now - last_line >= intervals_.line) {
    last_line = now;
    WriteEndedPhases();
    log_.Progress(Describe(phase, now, false));
  }
}

void ProgressReporter::EndPhase() {
  if (running_.empty()) {
    return;
  }
  log_.SetStatus("");
  const RunningPhase phase = std::move(running_.back());
  running_.pop_back();
  if (!running_.empty()) {
    return;  // part of the outer phase's time
  }
  auto ended = std::find_if(
      ended_.begin(), ended_.end(), [&](const EndedPhase& earlier) {
        return earlier.name == phase.name;
      });
  if (ended == ended_.end()) {
    ended = ended_.insert(ended, {phase.name});
  }
  ended->duration += Clock::now() - phase.begin;
  ++ended->count;
  ended->is_stopped = std::uncaught_exceptions() > 0;
}

void ProgressReporter::Info(std::string_view message) {
  WriteEndedPhases();
  log_.Info(message);
}

void ProgressReporter::Warn(std::string_view message) {
  WriteEndedPhases();
  log_.Warn(message);
}

void ProgressReporter::WriteEndedPhases() {
  for (const EndedPhase& phase : ended_) {
    if (phase.duration < intervals_.shortest && !phase.is_stopped) {
      continue;
    }
    const std::chrono::duration<double> seconds = phase.duration;
    log_.Info(fmt::format(
        "{}: {}{:.1f} s{}",
        phase.name,
        phase.is_stopped ? "stopped after " : "",
        seconds.count(),
        phase.count > 1 ? fmt::format(" in {} runs", phase.count) : ""));
  }
  ended_.clear();
}

}  // namespace octacut
