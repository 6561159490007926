// Exception types by cause. Every message is one line that names the file or
// option, the field and the offending value.
#pragma once

#include <stdexcept>
#include <string>

namespace octacut {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The input (a file, a model, an image, a mask) cannot be used as it is.
class InputError : public Error {
 public:
  using Error::Error;
};

// An option has a value outside its constraint.
class OptionError : public Error {
 public:
  using Error::Error;
};

// The run was interrupted through its Context.
class CancelledError : public Error {
 public:
  CancelledError() : Error("interrupted") {}
};

// A guarantee of octacut's own does not hold: a defect, never bad input.
class InvariantError : public Error {
 public:
  using Error::Error;
};

// What `step` returns. The message of an InputError that it throws gets `name`,
// a file or folder, in front.
template <typename Step>
auto NamingErrors(const std::string& name, Step&& step) {
  try {
    return step();
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

}  // namespace octacut
