// A network in an ONNX file, small enough to be written by hand: one
// convolution with a window of one pixel, and its logistic function.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace octacut::testing {

struct TinyNetwork {
  int height = 32;  // 0: not declared
  int width = 48;
  int num_outputs = 1;  // channels
  // Weights of red, green and blue as the network gets them; the bias is added.
  std::vector<float> weights = {0, 0, 0};
  float bias = 0;
  bool is_logistic = true;
};

// Protocol buffers, by the field numbers of onnx.proto.
class OnnxWriter {
 public:
  static std::string Write(const TinyNetwork& network) {
    std::string convolution = Text(1, "x") + Text(1, "w") + Text(1, "b");
    convolution += Text(2, "sum") + Text(4, "Conv");
    convolution += Bytes(
        5,
        Text(1, "kernel_shape") + Number(8, 1) + Number(8, 1) + Number(20, 7));
    std::string graph = Bytes(1, convolution);
    if (network.is_logistic) {
      graph += Bytes(1, Text(1, "sum") + Text(2, "y") + Text(4, "Sigmoid"));
    }
    std::vector<float> weights;
    std::vector<float> biases;
    for (int i = 0; i < network.num_outputs; ++i) {
      weights.insert(
          weights.end(), network.weights.begin(), network.weights.end());
      biases.push_back(network.bias);
    }
    const uint64_t outputs = uint64_t(network.num_outputs);
    graph += Text(2, "tiny");
    graph += Bytes(5, Tensor("w", {outputs, 3, 1, 1}, weights));
    graph += Bytes(5, Tensor("b", {outputs}, biases));
    graph += Bytes(11, Value("x", 3, network));
    graph +=
        Bytes(12, Value(network.is_logistic ? "y" : "sum", outputs, network));
    return Number(1, 7) + Bytes(7, graph) +
           Bytes(8, Text(1, "") + Number(2, 11));
  }

 private:
  static std::string Varint(uint64_t value) {
    std::string bytes;
    for (; value >= 0x80; value >>= 7) {
      bytes += char((value & 0x7f) | 0x80);
    }
    return bytes + char(value);
  }
  static std::string Number(uint32_t field, uint64_t value) {
    return Varint(field << 3) + Varint(value);
  }
  static std::string Bytes(uint32_t field, const std::string& bytes) {
    return Varint(field << 3 | 2) + Varint(bytes.size()) + bytes;
  }
  static std::string Text(uint32_t field, const std::string& text) {
    return Bytes(field, text);
  }
  static std::string Tensor(const std::string& name,
                            const std::vector<uint64_t>& shape,
                            const std::vector<float>& values) {
    std::string tensor;
    for (const uint64_t side : shape) {
      tensor += Number(1, side);
    }
    std::string raw(values.size() * sizeof(float), '\0');
    std::memcpy(raw.data(), values.data(), raw.size());
    return tensor + Number(2, 1) + Text(8, name) + Bytes(9, raw);
  }
  static std::string Value(const std::string& name,
                           uint64_t channels,
                           const TinyNetwork& network) {
    std::string shape = Bytes(1, Number(1, 1)) + Bytes(1, Number(1, channels));
    for (const auto& [side, parameter] :
         {std::pair(network.height, "h"), std::pair(network.width, "w")}) {
      shape +=
          Bytes(1, side > 0 ? Number(1, uint64_t(side)) : Text(2, parameter));
    }
    return Text(1, name) + Bytes(2, Bytes(1, Number(1, 1) + Bytes(2, shape)));
  }
};

}  // namespace octacut::testing
