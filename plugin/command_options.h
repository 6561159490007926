// All options of a command, for what is made from the tables of options: help,
// man page, completion of the shell.
#pragma once

#include "plugin/common_options.h"
#include "plugin/registry.h"

namespace octacut {

class CommandOptions {
 public:
  explicit CommandOptions(const RegistryEntry& entry);

  const OptionManager& Manager() const { return options_; }

 private:
  std::unique_ptr<Command> command_;  // whose fields the options are bound to
  CommonOptions common_;
  OptionManager options_;
};

// Whether -h lists an option, or --help_all 1 does.
bool IsListed(const Option& option, bool for_experts);

}  // namespace octacut
