// The size of the images that a network in an ONNX file takes. OpenCV reads
// such files, but does not tell it.
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <string_view>

namespace octacut {

// The size of the first input of shape (batch, 3, height, width) with numbers
// for height and width; none if there is no such input, or if the bytes are not
// those of an ONNX file. The format: https://onnx.ai, onnx.proto.
std::optional<cv::Size> OnnxInputSize(std::string_view bytes);

}  // namespace octacut
