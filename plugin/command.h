// What a command of the executable is. See registry.h for how to add one.
#pragma once

#include <ostream>
#include <string_view>

#include "core/base/context.h"
#include "plugin/option_manager.h"
#include "plugin/phase_timer.h"

namespace octacut {

// What a command gets to run with; everything outlives the run.
struct CommandEnvironment {
  std::string_view command_name;
  // The options with their values, for the report; the command reads the
  // fields that it bound.
  const OptionManager& options;
  // Threads, seed, cancellation and progress; pass it to every step. Messages
  // for the user go through context.Info() and context.Warn().
  const Context& context;
  // Seconds of the phases so far, for the report.
  const PhaseTimer& timer;
  // Standard output: tables and other results.
  std::ostream& out;
};

class Command {
 public:
  virtual ~Command() = default;
  // Binds the command's options to its fields, whose values at this moment
  // are the defaults.
  virtual void DeclareOptions(OptionManager& options) = 0;
  // Whether Context::Seed() changes the command's results.
  virtual bool UsesRandomSeed() const { return false; }
  // Throws an Error to fail (one line on stderr, exit code 1).
  virtual void Run(const CommandEnvironment& environment) = 0;
};

}  // namespace octacut
