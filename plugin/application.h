// The executable without main(): dispatch, errors and exit codes.
#pragma once

#include <atomic>
#include <ostream>
#include <span>
#include <string>

#include "plugin/registry.h"

namespace octacut {

// Exit codes: as COLMAP's, and the shell's for an interrupted program.
inline constexpr int kExitSuccess = 0;
inline constexpr int kExitFailure = 1;
inline constexpr int kExitInterrupted = 130;

// Runs `arguments` (without the program's name) and returns the exit code.
// Throws nothing: an error is one line `ERROR: ...` on `err`. `cancelled` may
// be null.
int RunApplication(std::span<const std::string> arguments,
                   std::span<const RegistryEntry> commands,
                   std::ostream& out,
                   std::ostream& err,
                   const std::atomic<bool>* cancelled);

}  // namespace octacut
