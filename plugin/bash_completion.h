// Completion of commands, options and their values in bash, from the tables of
// commands and options.
#pragma once

#include <span>
#include <string>

#include "plugin/registry.h"

namespace octacut {

// A script for /usr/share/bash-completion/completions.
std::string BashCompletion(std::span<const RegistryEntry> commands);

}  // namespace octacut
