#include "colmap_io/images/mask_file.h"

#include <system_error>

namespace octacut {

namespace fs = std::filesystem;

std::optional<fs::path> FindMaskFile(const fs::path& mask_path,
                                     const std::string& image_name,
                                     const fs::path& image_path) {
  const std::string stem = fs::path(image_name).replace_extension().string();
  std::error_code ignored;
  const auto is_mask = [&](const std::string& name) {
    const fs::path path = mask_path / name;
    return fs::is_regular_file(path, ignored) &&
           !fs::equivalent(path, image_path / image_name, ignored);
  };
  for (const char* extension : {".png", ".jpg", ".jpeg"}) {
    for (const std::string& name : {image_name + extension,
                                    stem + extension,
                                    stem + ".mask" + extension}) {
      if (is_mask(name)) {
        return mask_path / name;
      }
    }
    if (is_mask(image_name)) {
      return mask_path / image_name;
    }
  }
  return {};
}

}  // namespace octacut
