// Messages of core name options by the fields of their structs, in backticks;
// on their way to another sink they get the names that the user knows.
#pragma once

#include <string_view>

#include "core/base/context.h"
#include "plugin/option_manager.h"

namespace octacut {

class OptionNaming : public ProgressSink {
 public:
  // Both must outlive this object.
  OptionNaming(const OptionManager& options, ProgressSink* next)
      : options_(options), next_(*next) {}

  void BeginPhase(std::string_view name, size_t total) override {
    next_.BeginPhase(name, total);
  }
  void Advance(size_t done) override { next_.Advance(done); }
  void EndPhase() override { next_.EndPhase(); }
  void Info(std::string_view message) override {
    next_.Info(options_.NameOptionsIn(message));
  }
  void Warn(std::string_view message) override {
    next_.Warn(options_.NameOptionsIn(message));
  }

 private:
  const OptionManager& options_;
  ProgressSink& next_;
};

}  // namespace octacut
