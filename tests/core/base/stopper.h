// Stops a run at the beginning of one of its phases.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/context.h"

namespace octacut::testing {

class Stopper : public ProgressSink {
 public:
  // -1: stops nothing, but lists the phases.
  Stopper(int stop_at, std::atomic<bool>* stop)
      : stop_at_(stop_at), stop_(stop) {}
  void BeginPhase(std::string_view name, size_t) override {
    if (int(phases.size()) == stop_at_) {
      stop_->store(true);
    }
    phases.emplace_back(name);
  }
  void Advance(size_t) override {}
  void EndPhase() override {}
  void Info(std::string_view) override {}
  void Warn(std::string_view) override {}

  std::vector<std::string> phases;

 private:
  int stop_at_;
  std::atomic<bool>* stop_;
};

}  // namespace octacut::testing
