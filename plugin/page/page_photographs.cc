#include "plugin/page/page_photographs.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

// In base64 a third more: what is left of 15 MB beside 300 000 triangles.
constexpr size_t kPhotographBytes = 4'500'000;
constexpr int kLongestPhotograph = 900;   // pixels; no screen shows more of it
constexpr int kShortestPhotograph = 160;  // less cannot be recognised
constexpr size_t kMostPhotographs = 120;
constexpr int kJpegQuality = 82;

using Bytes = std::vector<uint8_t>;

cv::Size ReducedSize(const cv::Mat& image, int longest) {
  const double factor =
      std::min(1.0, double(longest) / std::max(image.cols, image.rows));
  return {std::max(1, int(std::lround(image.cols * factor))),
          std::max(1, int(std::lround(image.rows * factor)))};
}

Bytes EncodeReduced(const cv::Mat& image, int longest) {
  cv::Mat reduced;
  cv::resize(image, reduced, ReducedSize(image, longest), 0, 0, cv::INTER_AREA);
  Bytes bytes;
  if (!cv::imencode(
          ".jpg", reduced, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
    throw InvariantError("a photograph of the page cannot be encoded");
  }
  return bytes;
}

std::vector<size_t> ViewsToShow(const std::vector<View>& views) {
  std::vector<size_t> chosen;
  const size_t step = (views.size() + kMostPhotographs - 1) / kMostPhotographs;
  for (size_t i = 0; i < views.size(); i += step) {
    if (!views[i].image.empty()) {
      chosen.push_back(i);
    }
  }
  return chosen;
}

std::vector<Bytes> EncodeAll(const std::vector<View>& views,
                             const std::vector<size_t>& chosen,
                             int longest,
                             const Context& context) {
  std::vector<Bytes> files(chosen.size());
  ParallelEach(context, chosen.size(), 1, [&](size_t i) {
    files[i] = EncodeReduced(views[chosen[i]].image, longest);
  });
  return files;
}

size_t TotalBytes(const std::vector<Bytes>& files) {
  size_t total = 0;
  for (const Bytes& file : files) {
    total += file.size();
  }
  return total;
}

Json PhotographToJson(const View& view, size_t index, const cv::Size& size) {
  const double x = double(size.width) / view.camera.width;
  const double y = double(size.height) / view.camera.height;
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation.push_back(view.cam_from_world.rotation(row, column));
    }
  }
  const Eigen::Vector3d& t = view.cam_from_world.translation;
  return {{"name", view.name},
          {"view", index},
          {"width", size.width},
          {"height", size.height},
          {"fx", view.camera.fx * x},
          {"fy", view.camera.fy * y},
          {"cx", view.camera.cx * x},
          {"cy", view.camera.cy * y},
          {"rotation", std::move(rotation)},
          {"translation", VectorToJson(t)}};
}

}  // namespace

Json PagePhotographsToJson(const std::vector<View>& views,
                           const Context& context,
                           PageBlobs* blobs) {
  const Phase phase(context, "photographs of the page");
  const std::vector<size_t> chosen = ViewsToShow(views);
  int longest = kLongestPhotograph;
  std::vector<Bytes> files = EncodeAll(views, chosen, longest, context);
  while (TotalBytes(files) > kPhotographBytes &&
         longest > kShortestPhotograph) {
    const double factor =
        std::sqrt(double(kPhotographBytes) / double(TotalBytes(files)));
    longest = std::max(kShortestPhotograph,
                       int(longest * std::min(0.95, 0.97 * factor)));
    files = EncodeAll(views, chosen, longest, context);
  }
  Json photographs = Json::array();
  for (size_t i = 0; i < chosen.size(); ++i) {
    const View& view = views[chosen[i]];
    Json photograph =
        PhotographToJson(view, chosen[i], ReducedSize(view.image, longest));
    photograph["blob"] = blobs->Add(files[i]);
    photographs.push_back(std::move(photograph));
  }
  return photographs;
}

}  // namespace octacut
