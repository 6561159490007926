// Validation of options: every refusal names field, value and constraint.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "core/base/error.h"

namespace octacut {

// Throws OptionError unless `valid`; for example
//   CheckOption(level <= 12, "hull_level", level, "must be at most 12");
template <typename T>
void CheckOption(bool valid,
                 std::string_view field,
                 const T& value,
                 std::string_view constraint) {
  if (!valid) {
    throw OptionError(fmt::format("{} = {}: {}", field, value, constraint));
  }
}

}  // namespace octacut
