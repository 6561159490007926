#include "colmap_io/model/write_sparse_model.h"

#include <fmt/format.h>

#include <string>
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

void CheckNames(const SparseModel& model) {
  for (const SparseImage& image : model.images) {
    if (image.name.find('\0') != std::string::npos) {
      throw InputError(fmt::format(
          "image {}: its name \"{}\" cannot be written in a binary model",
          image.id,
          image.name));
    }
  }
}

}  // namespace

void WriteSparseModelBinary(const SparseModel& model, const fs::path& folder) {
  CheckSparseModel(model);
  CheckNames(model);
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

}  // namespace octacut
