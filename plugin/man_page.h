// The man page, from the tables of commands and options.
#pragma once

#include <span>
#include <string>

#include "plugin/registry.h"

namespace octacut {

// In the language of man(7).
std::string ManPage(std::span<const RegistryEntry> commands);

}  // namespace octacut
