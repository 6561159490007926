#include "plugin/command_options.h"

namespace octacut {

CommandOptions::CommandOptions(const RegistryEntry& entry)
    : command_(entry.make()) {
  command_->DeclareOptions(options_);
  common_.Declare(options_, command_->UsesRandomSeed());
}

bool IsListed(const Option& option, bool for_experts) {
  return option.audience == OptionAudience::kEveryone ||
         (for_experts && option.audience == OptionAudience::kExperts);
}

}  // namespace octacut
