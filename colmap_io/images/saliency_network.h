// A network of the user's that finds salient objects, such as U2-Net or IS-Net,
// in an ONNX file, by OpenCV's DNN module.
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>

namespace octacut {

// The network gets RGB images as floats, in the order batch, channel, row,
// column, with the mean (0.485, 0.456, 0.406) subtracted and divided by (0.229,
// 0.224, 0.225), as networks that are trained on ImageNet expect. Their size is
// the one that the file declares, or 320 x 320 where it declares none. The
// first output has one channel: probabilities, or log odds where values lie
// outside of [0, 1].
class SaliencyNetwork {
 public:
  // Throws InputError naming the file when it cannot be read.
  explicit SaliencyNetwork(const std::filesystem::path& path);
  ~SaliencyNetwork();

  // CV_32F of the size of `image` (CV_8UC3, BGR): 0 is background, 1 object.
  // Throws InputError naming the file when the network does not fit the
  // description above. Not for several threads at once.
  cv::Mat Saliency(const cv::Mat& image);

  // The size of the images that the network gets.
  cv::Size InputSize() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace octacut
