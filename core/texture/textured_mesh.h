// A triangle mesh with a texture atlas: what texturing gives and files take.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// One image of the atlas.
struct TexturePage {
  cv::Mat color;  // CV_8UC3, BGR, sRGB
  // CV_8UC3, BGR of the same size: normals in the frame of `tangents` as glTF
  // has them, x to the right and y up in the page; empty without a normal map.
  cv::Mat normals;
};

struct TexturedMesh {
  IndexedMesh mesh;  // with vertex normals
  // Texture coordinates of the corners of each triangle, in units of the page's
  // width and height; (0, 0) is the page's top-left corner, y points down.
  std::vector<std::array<Eigen::Vector2f, 3>> texcoords;
  // Number of the chart of each triangle. Vertices have one pair of texture
  // coordinates a chart.
  std::vector<uint32_t> charts;
  std::vector<uint32_t> page_of_chart;
  std::vector<TexturePage> pages;
  // Unit tangents of the corners of each triangle and the sign of the
  // bitangent, as glTF has them; empty without a normal map.
  std::vector<std::array<Eigen::Vector4f, 3>> tangents;

  uint32_t PageOf(size_t triangle) const {
    return page_of_chart[charts[triangle]];
  }
};

}  // namespace octacut
