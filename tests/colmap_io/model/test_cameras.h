// Cameras with plausible parameters for every supported model.
#pragma once

#include <vector>

#include "colmap_io/model/camera_models.h"

namespace octacut {

// Several cameras a model, 640x480: moderate distortions as calibrations of
// real lenses have them, of both signs, and none. Every pixel of the image has
// a ray.
inline std::vector<SparseCamera> TestCameras() {
  using P = std::vector<double>;
  const std::vector<std::pair<int, std::vector<P>>> table = {
      {0, {{500, 320, 240}, {812.5, 301.25, 255.5}}},
      {1, {{500, 510, 320, 240}}},
      {2, {{500, 320, 240, 0}, {500, 315, 242, -0.12}, {500, 320, 240, 0.3}}},
      {3, {{500, 320, 240, -0.2, 0.06}, {500, 320, 240, 0.1, 0.02}}},
      {4, {{500, 505, 318, 243, -0.18, 0.05, 0.002, -0.003}}},
      {5, {{300, 305, 318, 243, -0.02, 0.01, -0.004, 0.0005}}},
      {6, {{500, 505, 318, 243, 0.3, 0.1, 1e-3, -2e-3, 0.02, 0.5, 0.2, 0.03}}},
      {7, {{500, 505, 318, 243, 0.9}, {500, 505, 318, 243, 0.005}}},
      {8, {{300, 320, 240, -0.01}, {300, 320, 240, 0.05}}},
      {9, {{300, 320, 240, -0.02, 0.005}}},
      {10,
       {{300,
         305,
         318,
         243,
         -0.02,
         0.01,
         1e-3,
         -2e-3,
         -0.004,
         5e-4,
         1e-3,
         -1e-3}}},
      {11,
       {{300,
         305,
         318,
         243,
         -0.0232,
         0.0924,
         -0.0591,
         0.003,
         0.0048,
         -0.0009,
         0.0002,
         0.0005,
         -0.0009,
         -1e-4,
         7e-5,
         -1.7e-4}}},
      {12, {{500, 320, 240, -0.1}, {500, 320, 240, 0.15}, {500, 320, 240, 0}}},
      {13, {{500, 505, 318, 243, -0.2}}},
      {14, {{300, 320, 240}}},
      {15, {{300, 305, 318, 243}}},
      {16,
       {{400, 405, 318, 243, 0.6, 1.1},
        {400, 405, 318, 243, 0.0, 1.0},
        {400, 405, 318, 243, 0.4, 0.8}}},
  };
  std::vector<SparseCamera> cameras;
  for (const auto& [model_id, params] : table) {
    for (const P& p : params) {
      cameras.push_back({uint32_t(cameras.size() + 1), model_id, 640, 480, p});
    }
  }
  return cameras;
}

}  // namespace octacut
