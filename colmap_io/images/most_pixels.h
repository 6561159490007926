// How large the photographs are that a loop over files decodes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// The pixels of the largest photograph of `files`, at least 1. `camera` is the
// member of an element that points to its camera, or a function that returns
// such a pointer.
template <typename Files, typename CameraOf>
size_t MostPixels(const Files& files, const CameraOf& camera) {
  size_t pixels = 1;
  for (const auto& file : files) {
    const SparseCamera* of_file = std::invoke(camera, file);
    pixels = std::max(pixels, size_t(of_file->width * of_file->height));
  }
  return pixels;
}

}  // namespace octacut
