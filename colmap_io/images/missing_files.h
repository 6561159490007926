// The files of a workspace that are not there.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "core/base/context.h"

namespace octacut {

struct MissingFiles {
  std::string_view what;  // as the option names them: "image" or "mask"
  size_t count = 0;
  std::filesystem::path first{};

  void Add(const std::filesystem::path& path);
  // If files are missing: one warning if `skip`, else InputError that names the
  // first one and the option that skips them.
  void Report(bool skip, size_t num_images, const Context& context) const;
};

}  // namespace octacut
