#include "colmap_io/mesh/textured_mesh_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <ostream>
#include <string>

#include "colmap_io/files/lower_extension.h"
#include "colmap_io/mesh/glb_writer.h"
#include "colmap_io/mesh/textured_writers.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Above it, files grow without a visible gain.
constexpr int kJpegQuality = 95;

EncodedImage Encode(const cv::Mat& image, TextureImageFormat format) {
  const bool is_png = format == TextureImageFormat::kPng;
  EncodedImage result;
  result.mime_type = is_png ? "image/png" : "image/jpeg";
  const std::vector<int> parameters =
      is_png ? std::vector<int>()
             : std::vector<int>{cv::IMWRITE_JPEG_QUALITY, kJpegQuality};
  if (!cv::imencode(
          is_png ? ".png" : ".jpg", image, result.bytes, parameters)) {
    throw InputError("a page of the texture could not be encoded");
  }
  return result;
}

EncodedPages EncodePages(const TexturedMesh& mesh, TextureImageFormat format) {
  EncodedPages pages;
  for (const TexturePage& page : mesh.pages) {
    pages.colors.push_back(Encode(page.color, format));
    if (!page.normals.empty()) {
      pages.normals.push_back(Encode(page.normals, TextureImageFormat::kPng));
    }
  }
  return pages;
}

fs::path WithEnding(const fs::path& path, const std::string& ending) {
  fs::path result = path;
  result.replace_extension();
  result += ending;
  return result;
}

// What the names of images end with, before the number of the page.
const std::string kTextureEnding = "_texture";
const std::string kNormalEnding = "_normal";

// Nothing for a single page.
std::string PageNumber(size_t page, size_t num_pages) {
  return num_pages == 1 ? "" : fmt::format("_{}", page);
}

fs::path ImagePath(const fs::path& mesh,
                   const std::string& ending,
                   TextureImageFormat format) {
  return WithEnding(
      mesh, ending + (format == TextureImageFormat::kPng ? ".png" : ".jpg"));
}

}  // namespace

void CheckTexturedMeshPath(const fs::path& path) {
  const std::string extension = LowerExtension(path);
  if (extension != ".glb" && extension != ".obj" && extension != ".ply") {
    throw OptionError(
        fmt::format("{}: unknown extension \"{}\" of a textured mesh: must be "
                    ".glb, .obj or .ply",
                    path.string(),
                    extension));
  }
}

std::vector<fs::path> TexturedMeshPaths(const fs::path& path,
                                        const TexturedMeshOptions& options,
                                        int max_pages,
                                        bool has_normal_map) {
  std::vector<fs::path> paths = {path};
  const std::string extension = LowerExtension(path);
  if (extension == ".glb") {
    return paths;
  }
  if (extension == ".obj") {
    paths.push_back(WithEnding(path, ".mtl"));
  }
  std::vector<std::string> numbers = {PageNumber(0, 1)};
  for (int page = 0; page < max_pages; ++page) {
    numbers.push_back(PageNumber(size_t(page), 2));
  }
  for (const std::string& number : numbers) {
    paths.push_back(
        ImagePath(path, kTextureEnding + number, options.image_format));
    if (has_normal_map) {
      paths.push_back(
          ImagePath(path, kNormalEnding + number, TextureImageFormat::kPng));
    }
  }
  return paths;
}

bool CanHoldNormalMaps(const fs::path& path) {
  return LowerExtension(path) != ".ply";
}

std::vector<fs::path> WriteTexturedMesh(const fs::path& path,
                                        const TexturedMesh& mesh,
                                        const TexturedMeshOptions& options,
                                        AtomicFiles* files) {
  CheckTexturedMeshPath(path);
  const EncodedPages pages = EncodePages(mesh, options.image_format);
  std::vector<fs::path> written;
  const auto write = [&](const fs::path& file,
                         const std::function<void(std::ostream&)>& body) {
    files->Write(file, body);
    written.push_back(file);
  };
  const std::string extension = LowerExtension(path);
  if (extension == ".glb") {
    write(path,
          [&](std::ostream& stream) { WriteTexturedGlb(mesh, pages, stream); });
    return written;
  }
  // The images come first, so that none is missing where the mesh is there.
  PageNames names;
  const auto write_image = [&](const EncodedImage& image,
                               const fs::path& file) {
    write(file, [&](std::ostream& stream) {
      stream.write(reinterpret_cast<const char*>(image.bytes.data()),
                   std::streamsize(image.bytes.size()));
    });
    return file.filename().string();
  };
  for (size_t page = 0; page < pages.colors.size(); ++page) {
    const std::string number = PageNumber(page, pages.colors.size());
    names.colors.push_back(write_image(
        pages.colors[page],
        ImagePath(path, kTextureEnding + number, options.image_format)));
    if (extension == ".obj" && !pages.normals.empty()) {
      names.normals.push_back(write_image(
          pages.normals[page],
          ImagePath(path, kNormalEnding + number, TextureImageFormat::kPng)));
    }
  }
  if (extension == ".obj") {
    const fs::path materials = WithEnding(path, ".mtl");
    write(materials, [&](std::ostream& stream) { WriteMtl(names, stream); });
    write(path, [&](std::ostream& stream) {
      WriteTexturedObj(mesh, materials.filename().string(), stream);
    });
  } else {
    write(path,
          [&](std::ostream& stream) { WriteTexturedPly(mesh, names, stream); });
  }
  return written;
}

}  // namespace octacut
