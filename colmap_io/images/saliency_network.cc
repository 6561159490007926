#include "colmap_io/images/saliency_network.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "colmap_io/files/read_file.h"
#include "colmap_io/images/onnx_input_size.h"
#include "core/base/error.h"

namespace octacut {
namespace {

// Statistics of ImageNet: red, green and blue in [0, 1].
constexpr std::array<double, 3> kMean = {0.485, 0.456, 0.406};
constexpr std::array<double, 3> kDeviation = {0.229, 0.224, 0.225};
// Where the file says nothing: that of U2-Net, the most used one of its kind.
const cv::Size kUsualSize(320, 320);

std::string ShapeOf(const cv::Mat& blob) {
  std::string shape;
  for (int i = 0; i < blob.dims; ++i) {
    shape += fmt::format("{}{}", i > 0 ? " x " : "", blob.size[i]);
  }
  return shape;
}

}  // namespace

struct SaliencyNetwork::Network {
  std::filesystem::path path;
  cv::dnn::Net net;
  std::string output;
  cv::Size size;
};

SaliencyNetwork::SaliencyNetwork(const std::filesystem::path& path)
    : network_(std::make_unique<Network>()) {
  network_->path = path;
  const std::string bytes = ReadFile(path);
  try {
    network_->net = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
    const std::vector<std::string> outputs =
        network_->net.getUnconnectedOutLayersNames();
    if (network_->net.empty() || outputs.empty()) {
      throw InputError(path.string() + ": the network has no layers");
    }
    network_->output = outputs.front();
  } catch (const cv::Exception& error) {
    throw InputError(
        fmt::format("{}: OpenCV cannot read this file as a network "
                    "in the ONNX format: {}",
                    path.string(),
                    error.err));
  }
  network_->size = OnnxInputSize(bytes).value_or(kUsualSize);
}

SaliencyNetwork::~SaliencyNetwork() = default;

cv::Size SaliencyNetwork::InputSize() const { return network_->size; }

cv::Mat SaliencyNetwork::Saliency(const cv::Mat& image) {
  cv::Mat resized;
  cv::resize(image, resized, network_->size, 0, 0, cv::INTER_AREA);
  cv::Mat blob = cv::dnn::blobFromImage(
      resized, 1 / 255.0, cv::Size(), cv::Scalar(), true, false, CV_32F);
  for (int c = 0; c < 3; ++c) {
    cv::Mat plane(resized.rows, resized.cols, CV_32F, blob.ptr<float>(0, c));
    plane = (plane - kMean[size_t(c)]) / kDeviation[size_t(c)];
  }
  cv::Mat output;
  try {
    network_->net.setInput(blob);
    output = network_->net.forward(network_->output);
  } catch (const cv::Exception& error) {
    throw InputError(
        fmt::format("{}: the network fails for an image of {} x {} pixels with "
                    "three channels: {}",
                    network_->path.string(),
                    network_->size.width,
                    network_->size.height,
                    error.err));
  }
  const int rows = output.dims >= 2 ? output.size[output.dims - 2] : 0;
  const int columns = output.dims >= 2 ? output.size[output.dims - 1] : 0;
  if (output.depth() != CV_32F || rows < 2 || columns < 2 ||
      output.total() != size_t(rows) * size_t(columns)) {
    throw InputError(fmt::format(
        "{}: the network's first output is {}: it must be one map of floats, "
        "1 x 1 x height x width",
        network_->path.string(),
        ShapeOf(output)));
  }
  cv::Mat map = cv::Mat(rows, columns, CV_32F, output.ptr<float>()).clone();
  if (!cv::checkRange(map)) {
    throw InputError(network_->path.string() +
                     ": the network's output is not a number at some pixels");
  }
  double least, most;
  cv::minMaxLoc(map, &least, &most);
  if (least < 0 || most > 1) {
    for (float& value : cv::Mat_<float>(map)) {
      value = 1 / (1 + std::exp(-value));
    }
  }
  cv::resize(map, map, image.size(), 0, 0, cv::INTER_LINEAR);
  return map;
}

}  // namespace octacut
