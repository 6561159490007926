// Keeps the messages of a run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/context.h"

namespace octacut::testing {

class Recorder : public ProgressSink {
 public:
  void BeginPhase(std::string_view, size_t) override {}
  void Advance(size_t) override {}
  void EndPhase() override {}
  void Info(std::string_view message) override { infos.emplace_back(message); }
  void Warn(std::string_view message) override {
    warnings.emplace_back(message);
  }
  std::vector<std::string> infos;
  std::vector<std::string> warnings;
};

}  // namespace octacut::testing
