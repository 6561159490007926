// The texts of `-h` and `octacut help`.
#pragma once

#include <span>
#include <string>

#include "plugin/option_manager.h"
#include "plugin/registry.h"

namespace octacut {

// The list of commands.
std::string ProgramHelp(std::span<const RegistryEntry> commands);

// Every option of a command with its default.
std::string CommandHelp(const RegistryEntry& command,
                        const OptionManager& options);

}  // namespace octacut
