#include "colmap_io/images/mask_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <system_error>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/files/lower_extension.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

bool IsPicture(const fs::path& path) {
  const std::string extension = LowerExtension(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

void WriteBytes(AtomicFiles* files,
                const fs::path& path,
                const std::vector<uchar>& bytes) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  files->Write(path, [&](std::ostream& stream) {
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 std::streamsize(bytes.size()));
  });
}

// What the earlier list says of images that the new one does not have.
MaskList Merged(const MaskList& list,
                const std::optional<MaskList>& before,
                const fs::path& folder) {
  MaskList merged = list;
  if (before) {
    std::error_code ignored;
    for (const ListedMask& mask : before->views) {
      if (list.Find(mask.image) == nullptr &&
          (mask.mask.empty() || fs::exists(folder / mask.mask, ignored))) {
        merged.views.push_back(mask);
      }
    }
  }
  return merged;
}

void RemoveDoubtedMasks(const MaskList& list,
                        const std::optional<MaskList>& before,
                        const fs::path& folder) {
  for (const ListedMask& listed : list.views) {
    const fs::path path = folder / (listed.image + ".png");
    std::error_code ignored;
    if (listed.status == MaskStatus::kUnsure && fs::exists(path, ignored) &&
        IsExtractedMask(before, listed.image, path)) {
      fs::remove(path, ignored);
    }
  }
}

}  // namespace

std::vector<uchar> EncodeMask(const cv::Mat& mask) {
  std::vector<uchar> png;
  if (!cv::imencode(".png", mask, png)) {
    throw InvariantError("a mask cannot be encoded");
  }
  return png;
}

void RequireFolderForMasks(const fs::path& folder, const fs::path& image_path) {
  std::error_code error;
  if (fs::equivalent(folder, image_path, error)) {
    throw InputError(
        fmt::format("output_path {}: must not be the folder of the photographs",
                    folder.string()));
  }
  fs::path existing = fs::absolute(folder, error);
  while (!fs::exists(existing, error) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing, error) ||
      ::access(existing.c_str(), W_OK | X_OK) != 0) {
    throw InputError(fmt::format(
        "output_path {}: masks cannot be written there, since {} is not a "
        "folder with permission to write",
        folder.string(),
        existing.string()));
  }
}

void RequireOnlyOwnMasks(const fs::path& folder, const fs::path& image_path) {
  RequireFolderForMasks(folder, image_path);
  std::error_code error;
  if (!fs::exists(folder, error)) {
    return;
  }
  const std::optional<MaskList> list = ReadMaskList(folder);
  fs::recursive_directory_iterator entries(
      folder, fs::directory_options::follow_directory_symlink, error);
  if (error) {
    throw InputError(fmt::format("output_path {}: the folder cannot be read",
                                 folder.string()));
  }
  std::vector<fs::path> pictures;
  for (const auto& entry : entries) {
    if (entry.is_regular_file() && IsPicture(entry.path()) &&
        entry.path() != folder / kContactSheetName) {
      pictures.push_back(entry.path());
    }
  }
  std::sort(pictures.begin(), pictures.end());
  for (const fs::path& path : pictures) {
    const std::string name = path.lexically_relative(folder).string();
    const std::string image = name.substr(0, name.rfind('.'));
    if (!IsExtractedMask(list, image, path)) {
      throw InputError(fmt::format(
          "output_path {}: {} was not made by octacut, or was changed since; "
          "choose another folder",
          folder.string(),
          path.string()));
    }
  }
}

void WriteMaskFolder(const fs::path& folder,
                     MaskList list,
                     const std::vector<std::vector<uchar>>& pngs,
                     const cv::Mat& contact_sheet) {
  const std::optional<MaskList> before = ReadMaskList(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  AtomicFiles files;
  for (size_t i = 0; i < pngs.size(); ++i) {
    if (!pngs[i].empty()) {
      ListedMask& listed = list.views[i];
      listed.mask = listed.image + ".png";
      listed.hash = HashOfBytes(
          {reinterpret_cast<const char*>(pngs[i].data()), pngs[i].size()});
      WriteBytes(&files, folder / listed.mask, pngs[i]);
    }
  }
  if (!contact_sheet.empty()) {
    std::vector<uchar> sheet;
    if (!cv::imencode(".jpg", contact_sheet, sheet)) {
      throw InvariantError("the contact sheet cannot be encoded");
    }
    WriteBytes(&files, folder / kContactSheetName, sheet);
  }
  files.Write(folder / kMaskListName, [&](std::ostream& stream) {
    stream << MaskListText(Merged(list, before, folder));
  });
  files.Commit();
  RemoveDoubtedMasks(list, before, folder);
}

}  // namespace octacut
