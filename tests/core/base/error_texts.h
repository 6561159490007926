// What is said when something is refused.
#pragma once

#include <string>

#include "core/base/error.h"

namespace octacut {

// What a call says when it throws InputError.
template <typename Function>
std::string InputErrorOf(const Function& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

// What Check() says of the default options after change(&options).
template <typename Options, typename Change>
std::string RefusalOf(const Change& change) {
  Options options;
  change(&options);
  try {
    options.Check();
  } catch (const OptionError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace octacut
