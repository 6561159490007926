#include "plugin/phase_timer.h"

namespace octacut {
namespace {

double SecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

}  // namespace

void PhaseTimer::BeginPhase(std::string_view name, size_t total) {
  if (next_ != nullptr) {
    next_->BeginPhase(name, total);
  }
  running_.push_back({timings_.size(), Clock::now()});
  timings_.push_back({std::string(name), int(running_.size()) - 1, 0});
}

void PhaseTimer::Advance(size_t done) {
  if (next_ != nullptr) {
    next_->Advance(done);
  }
}

void PhaseTimer::EndPhase() {
  if (!running_.empty()) {
    timings_[running_.back().index].seconds =
        SecondsSince(running_.back().begin);
    running_.pop_back();
  }
  if (next_ != nullptr) {
    next_->EndPhase();
  }
}

void PhaseTimer::Info(std::string_view message) {
  if (next_ != nullptr) {
    next_->Info(message);
  }
}

void PhaseTimer::Warn(std::string_view message) {
  warnings_.emplace_back(message);
  if (next_ != nullptr) {
    next_->Warn(message);
  }
}

std::vector<PhaseTiming> PhaseTimer::Timings() const {
  std::vector<PhaseTiming> timings = timings_;
  for (const RunningPhase& phase : running_) {
    timings[phase.index].seconds = SecondsSince(phase.begin);
  }
  return timings;
}

double PhaseTimer::TotalSeconds() const { return SecondsSince(begin_); }

}  // namespace octacut
