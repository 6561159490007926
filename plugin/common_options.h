// The options that every command has, of COLMAP 3.8 and of COLMAP 4.
#pragma once

#include <cstdint>

#include "plugin/log.h"
#include "plugin/option_manager.h"

namespace octacut {

struct CommonOptions {
  int num_threads = -1;
  uint64_t random_seed = 0;
  LogOptions log;

  // The seed is accepted by every command, but listed only where it is used.
  void Declare(OptionManager& options, bool uses_random_seed);
  // Throws OptionError.
  void Check() const;
};

}  // namespace octacut
