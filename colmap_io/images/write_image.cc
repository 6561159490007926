#include "colmap_io/images/write_image.h"

#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/lower_extension.h"
#include "core/base/check_option.h"
#include "core/base/error.h"

namespace octacut {

void CheckImagePath(const std::string& option,
                    const std::filesystem::path& path) {
  const std::string extension = LowerExtension(path);
  CheckOption(
      extension == ".png" || extension == ".jpg" || extension == ".jpeg",
      option,
      path.string(),
      "must end with .png or .jpg");
}

void WriteImage(const std::filesystem::path& path,
                const cv::Mat& image,
                const std::vector<int>& parameters) {
  AtomicFiles files;
  WriteImage(path, image, &files, parameters);
  files.Commit();
}

void WriteImage(const std::filesystem::path& path,
                const cv::Mat& image,
                AtomicFiles* files,
                const std::vector<int>& parameters) {
  std::vector<uchar> bytes;
  if (!cv::imencode(path.extension().string(), image, bytes, parameters)) {
    throw InputError(path.string() + ": the picture cannot be encoded");
  }
  files->Write(path, [&](std::ostream& stream) {
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 std::streamsize(bytes.size()));
  });
}

}  // namespace octacut
