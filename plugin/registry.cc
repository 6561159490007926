#include "plugin/registry.h"

#include <array>

#include "plugin/commands/example_creator.h"
#include "plugin/commands/version.h"

namespace octacut {

std::span<const RegistryEntry> CommandRegistry() {
  static constexpr auto kCommands = std::to_array<RegistryEntry>({
      {"example_creator",
       "Create a synthetic workspace with photographs, masks and ground truth",
       &MakeExampleCreator},
      {"version",
       "Print the versions of octacut and its libraries",
       &MakeVersion},
  });
  return kCommands;
}

}  // namespace octacut
