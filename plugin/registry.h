// The table of all commands.
//
// To add a command `noun_verber`:
//  1. write plugin/commands/noun_verber.{h,cc}: a class derived from Command
//     in the .cc, `std::unique_ptr<Command> MakeNounVerber();` in the .h;
//  2. name the .cc in plugin/CMakeLists.txt, with the modules that it needs;
//  3. add a line to the table in registry.cc.
// Help, project files, logging, progress, errors and exit codes follow.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "plugin/command.h"

namespace octacut {

struct RegistryEntry {
  std::string_view name;     // noun_verber
  std::string_view summary;  // one line for `octacut help`
  std::unique_ptr<Command> (*make)();
  // Heading of `octacut help` under which the command stands; commands under
  // one heading follow each other.
  std::string_view purpose;
};

// In the order in which `octacut help` lists them.
std::span<const RegistryEntry> CommandRegistry();

}  // namespace octacut
