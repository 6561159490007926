#include "colmap_io/images/missing_files.h"

#include <fmt/format.h>

#include <string>

#include "core/base/error.h"

namespace octacut {

void MissingFiles::Add(const std::filesystem::path& path) {
  if (count++ == 0) {
    first = path;
  }
}

void MissingFiles::Report(bool skip,
                          size_t num_images,
                          const Context& context) const {
  if (count == 0) {
    return;
  }
  const std::string message =
      fmt::format("{}: no such {}; missing for {} of {} images",
                  first.string(),
                  what,
                  count,
                  num_images);
  if (!skip) {
    throw InputError(fmt::format(
        "{} (--skip_missing_{}s 1 leaves out these images)", message, what));
  }
  context.Warn(message + "; these are left out");
}

}  // namespace octacut
