#include "colmap_io/images/mask_file.h"

#include <fmt/format.h>

#include <array>
#include <opencv2/core.hpp>
#include <system_error>
#include <vector>

#include "colmap_io/files/read_file.h"
#include "colmap_io/images/image_file.h"
#include "core/base/error.h"
#include "core/scene/scene.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// The mask's names in the order of precedence.
std::vector<fs::path> MaskNames(const std::string& image_name) {
  const fs::path stem = fs::path(image_name).replace_extension();
  const fs::path prefixed =
      stem.parent_path() / ("mask_" + stem.filename().string());
  std::vector<fs::path> names;
  const std::array<const char*, 6> extensions = {
      ".png", ".PNG", ".jpg", ".jpeg", ".JPG", ".JPEG"};
  for (const char* extension : extensions) {
    for (const std::string& name : {image_name,
                                    stem.string(),
                                    stem.string() + ".mask",
                                    stem.string() + "_mask",
                                    prefixed.string()}) {
      names.emplace_back(name + extension);
    }
  }
  // The very same name comes after those with .png.
  names.insert(names.begin() + ptrdiff_t(names.size() / 3), image_name);
  return names;
}

bool SayTheSame(const fs::path& a, const fs::path& b) {
  if (ReadFile(a) == ReadFile(b)) {
    return true;
  }
  const cv::Mat mask_a = ReadMask(a) >= kObjectThreshold;
  const cv::Mat mask_b = ReadMask(b) >= kObjectThreshold;
  return mask_a.size() == mask_b.size() &&
         cv::countNonZero(mask_a != mask_b) == 0;
}

}  // namespace

void RequireSameMask(const std::filesystem::path& a,
                     const std::filesystem::path& b,
                     const std::string& image_name) {
  std::error_code ignored;
  if (!fs::equivalent(a, b, ignored) && !SayTheSame(a, b)) {
    throw InputError(fmt::format(
        "{} and {}: both are the mask of image {} and differ; remove one",
        a.string(),
        b.string(),
        image_name));
  }
}

std::optional<std::filesystem::path> FindMaskFile(
    const std::filesystem::path& mask_path,
    const std::string& image_name,
    const std::filesystem::path& image_path) {
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
    } else {
      RequireSameMask(*found, path, image_name);
    }
  }
  return found;
}

}  // namespace octacut
