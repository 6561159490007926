#include "colmap_io/model/write_sparse_model.h"

#include <fmt/format.h>

#include <string_view>
#include <system_error>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/files/create_folder.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// COLMAP would read such a file with, or instead of, what is written.
void RefuseBeside(const fs::path& folder, const char* file) {
  std::error_code error;
  if (fs::exists(folder / file, error)) {
    throw InputError(
        fmt::format("{}: the file belongs to another model; remove it before "
                    "writing a model to this folder",
                    (folder / file).string()));
  }
}

void RefuseName(const SparseImage& image, const char* format) {
  throw InputError(
      fmt::format("image {}: its name \"{}\" cannot be written in a {} model",
                  image.id,
                  image.name,
                  format));
}

void CheckNamesForBinary(const SparseModel& model) {
  for (const SparseImage& image : model.images) {
    if (image.name.find('\0') != std::string::npos) {
      RefuseName(image, "binary");
    }
  }
}

// In text a name ends with its line and begins and ends with no blank.
void CheckNamesForText(const SparseModel& model) {
  constexpr std::string_view kBlanksAndNul(" \t\r\n\0", 5);
  for (const SparseImage& image : model.images) {
    if (image.name.find_first_of(kBlanksAndNul.substr(2)) !=
            std::string::npos ||
        kBlanksAndNul.find(image.name.front()) != std::string_view::npos ||
        kBlanksAndNul.find(image.name.back()) != std::string_view::npos) {
      RefuseName(image, "text");
    }
  }
}

}  // namespace

void WriteSparseModelBinary(const SparseModel& model, const fs::path& folder) {
  CheckSparseModel(model);
  CheckNamesForBinary(model);
  CreateFolder(folder);
  for (const char* file : {"rigs.bin", "frames.bin"}) {
    RefuseBeside(folder, file);
  }
  AtomicFiles files;
  files.Write(folder / "cameras.bin", [&](std::ostream& stream) {
    WriteCamerasBinary(model.cameras, stream);
  });
  files.Write(folder / "images.bin", [&](std::ostream& stream) {
    WriteImagesBinary(model.images, stream);
  });
  files.Write(folder / "points3D.bin", [&](std::ostream& stream) {
    WritePointsBinary(model.points, stream);
  });
  files.Commit();
}

void WriteSparseModelText(const SparseModel& model, const fs::path& folder) {
  CheckSparseModel(model);
  CheckNamesForText(model);
  CreateFolder(folder);
  for (const char* file : {"rigs.txt", "frames.txt", "cameras.bin"}) {
    RefuseBeside(folder, file);
  }
  AtomicFiles files;
  files.Write(folder / "cameras.txt", [&](std::ostream& stream) {
    WriteCamerasText(model.cameras, stream);
  });
  files.Write(folder / "images.txt", [&](std::ostream& stream) {
    WriteImagesText(model.images, stream);
  });
  files.Write(folder / "points3D.txt", [&](std::ostream& stream) {
    WritePointsText(model.points, stream);
  });
  files.Commit();
}

}  // namespace octacut
