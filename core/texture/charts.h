// Charts: connected pieces of a mesh with their coordinates in a plane.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/texture/face_neighbors.h"
#include "core/texture/photographs.h"

namespace octacut {

inline constexpr uint32_t kNoView = std::numeric_limits<uint32_t>::max();

// Texels around each chart that its colours go on for, so that bilinear
// filtering and the first steps of a mipmap stay within them.
inline constexpr int kChartMargin = 4;

struct Chart {
  uint32_t view = kNoView;      // kNoView: no photograph shows it
  std::vector<uint32_t> faces;  // ascending
  // Texels of the bounding box, the margin included.
  int width = 0;
  int height = 0;
};

struct Charts {
  std::vector<Chart> charts;
  std::vector<uint32_t> chart_of_face;
  // Texels of the corners of each triangle within its chart's box, x to the
  // right and y down.
  std::vector<std::array<Eigen::Vector2f, 3>> texels;
};

struct ChartOptions {
  // Texels per pixel of the photographs.
  double texel_scale = 1;
  // No chart is larger than this, texels; larger ones are divided.
  int max_size = 8192;
};

// Charts of triangles with the same view, as that photograph shows them, so
// that the density of texels is that of its pixels; at a scale of 1 texels lie
// on pixels. Triangles without a view (kNoView), whose colours have no detail,
// are projected along the axis nearest to their normal, at a quarter of the
// mean density.
//
// No two triangles of a chart overlap, to half a texel: what does is divided.
Charts MakeCharts(const IndexedMesh& mesh,
                  const std::vector<std::array<uint32_t, 3>>& neighbors,
                  const std::vector<uint32_t>& views,
                  const std::vector<PhotographPose>& poses,
                  const ChartOptions& options,
                  const Context& context);

}  // namespace octacut
