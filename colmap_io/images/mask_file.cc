#include "colmap_io/images/mask_file.h"

#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <system_error>
#include <vector>

#include "colmap_io/images/image_file.h"
#include "core/base/error.h"
#include "core/scene/scene.h"

namespace octacut {

namespace fs = std::filesystem;

namespace {

// The mask's names in the order of precedence.
std::vector<fs::path> MaskNames(const std::string& image_name) {
  const fs::path stem = fs::path(image_name).replace_extension();
  const fs::path prefixed =
      stem.parent_path() / ("mask_" + stem.filename().string());
  std::vector<fs::path> names;
  for (const char* extension : {".png", ".jpg", ".jpeg"}) {
    for (const std::string& name : {image_name,
                                    stem.string(),
                                    stem.string() + ".mask",
                                    stem.string() + "_mask",
                                    prefixed.string()}) {
      names.emplace_back(name + extension);
    }
  }
  names.insert(names.begin() + 5, image_name);
  return names;
}

bool SayTheSame(const fs::path& a, const fs::path& b) {
  const cv::Mat mask_a = ReadMask(a) >= kObjectThreshold;
  const cv::Mat mask_b = ReadMask(b) >= kObjectThreshold;
  return mask_a.size() == mask_b.size() &&
         cv::countNonZero(mask_a != mask_b) == 0;
}

}  // namespace

std::optional<fs::path> FindMaskFile(const fs::path& mask_path,
                                     const std::string& image_name,
                                     const fs::path& image_path) {
  std::optional<fs::path> found;
  std::error_code ignored;
  for (const fs::path& name : MaskNames(image_name)) {
    const fs::path path = mask_path / name;
    if (!fs::is_regular_file(path, ignored) ||
        fs::equivalent(path, image_path / image_name, ignored)) {
      continue;
    }
    if (!found) {
      found = path;
    } else if (!fs::equivalent(path, *found, ignored) &&
               !SayTheSame(path, *found)) {
      throw InputError(fmt::format(
          "{} and {}: both are the mask of image {} and differ; remove one",
          found->string(),
          path.string(),
          image_name));
    }
  }
  return found;
}

}  // namespace octacut
