// The texts of `-h`, `--help_all 1` and `octacut help`.
#pragma once

#include <span>
#include <string>

#include "plugin/option_manager.h"
#include "plugin/registry.h"

namespace octacut {

// The list of commands.
std::string ProgramHelp(std::span<const RegistryEntry> commands);

// The options of a command with their defaults, those for experts on request.
std::string CommandHelp(const RegistryEntry& command,
                        const OptionManager& options,
                        bool for_experts);

}  // namespace octacut
