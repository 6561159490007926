#include "colmap_io/model/read_sparse_model.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <optional>
#include <string_view>

#include "colmap_io/model/binary_reader.h"
#include "colmap_io/model/text_line.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kParts = {
    "cameras", "images", "points3D"};

std::string FileName(std::string_view part, std::string_view extension) {
  return fmt::format("{}{}", part, extension);
}

bool Has(const fs::path& folder,
         std::string_view part,
         std::string_view extension) {
  std::error_code error;
  return fs::is_regular_file(folder / FileName(part, extension), error);
}

int CountParts(const fs::path& folder, std::string_view extension) {
  int count = 0;
  for (std::string_view part : kParts) count += Has(folder, part, extension);
  return count;
}

// The extension of a complete model, .bin before .txt as COLMAP has it.
std::optional<std::string_view> FindExtension(const fs::path& folder) {
  for (std::string_view extension : {".bin", ".txt"}) {
    if (CountParts(folder, extension) == int(kParts.size())) return extension;
  }
  return std::nullopt;
}

// Says what is missing of the format of which the folder has more files.
[[noreturn]] void RefuseIncomplete(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: no such folder", folder.string()));
  }
  const int num_bin = CountParts(folder, ".bin");
  const int num_txt = CountParts(folder, ".txt");
  if (num_bin + num_txt == 0) {
    throw InputError(
        fmt::format("{}: the folder holds no sparse model (cameras, images and "
                    "points3D, all as .bin or all as .txt)",
                    folder.string()));
  }
  const std::string_view extension = num_txt > num_bin ? ".txt" : ".bin";
  std::string missing;
  for (std::string_view part : kParts) {
    if (Has(folder, part, extension)) continue;
    if (!missing.empty()) missing += " and ";
    missing += FileName(part, extension);
  }
  throw InputError(fmt::format(
      "{}: incomplete sparse model: {} missing", folder.string(), missing));
}

std::string_view RequireExtension(const fs::path& folder) {
  const auto extension = FindExtension(folder);
  if (!extension) RefuseIncomplete(folder);
  return *extension;
}

template <typename Reader>
auto ReadFile(const std::string& path, const Reader& reader) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be opened", path));
  auto result = reader(stream, path);
  if (stream.bad()) throw InputError(fmt::format("{}: cannot be read", path));
  return result;
}

}  // namespace

SparseModel ReadSparseModel(const fs::path& folder) {
  const std::string_view extension = RequireExtension(folder);
  const auto path = [&](std::string_view part) {
    return (folder / FileName(part, extension)).string();
  };
  const SparseModelNames names{
      path("cameras"), path("images"), path("points3D")};
  const bool binary = extension == ".bin";
  SparseModel model;
  model.cameras =
      ReadFile(names.cameras, binary ? ReadCamerasBinary : ReadCamerasText);
  model.images =
      ReadFile(names.images, binary ? ReadImagesBinary : ReadImagesText);
  model.points =
      ReadFile(names.points, binary ? ReadPointsBinary : ReadPointsText);
  CheckSparseModel(model, names);
  return model;
}

uint64_t CountSparseImages(const fs::path& folder) {
  const std::string_view extension = RequireExtension(folder);
  const std::string path = (folder / FileName("images", extension)).string();
  if (extension == ".bin") {
    return ReadFile(path, [](std::istream& stream, const std::string& name) {
      return BinaryReader(stream, name).ReadCount(1, "number of images");
    });
  }
  return ReadFile(path, [](std::istream& stream, const std::string& name) {
    TextLines lines(stream, name);
    uint64_t count = 0;
    for (; lines.NextContent(); ++count) lines.Next();
    return count;
  });
}

}  // namespace octacut
