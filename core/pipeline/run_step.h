// Steps of a reconstruction: what all of them report.
#pragma once

#include <string_view>

#include "core/base/context.h"
#include "core/base/stopwatch.h"

namespace octacut {

// Returns what `step` returns; its seconds are shown, and added to *seconds.
template <typename Step>
auto RunStep(const Context& context,
             std::string_view name,
             double* seconds,
             const Step& step) {
  const Phase phase(context, name);
  return Timed(seconds, step);
}

}  // namespace octacut
