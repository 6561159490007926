// Parallel loops over the pixels of a picture.
#pragma once

#include <cstddef>

#include "core/base/context.h"
#include "core/base/parallel.h"

namespace octacut {

// Calls body(x, y) for each pixel; a chunk of ParallelFor is a few rows.
template <typename Body>
void ParallelPixels(const Context& context,
                    int width,
                    int height,
                    const Body& body) {
  constexpr size_t kRows = 8;
  ParallelEach(context, size_t(height), kRows, [&](size_t y) {
    for (int x = 0; x < width; ++x) {
      body(x, int(y));
    }
  });
}

}  // namespace octacut
