// Whether what was removed for being small was a part of the object.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/views/view_set.h"

namespace octacut {

// One per view: how many of its pixels that are not 0 in `missed` (CV_8UC1, one
// per view) the components `removed` (unit coordinates) would cover.
std::vector<size_t> CountPixelsOfRemoved(const IndexedMesh& removed,
                                         const ViewSet& views,
                                         const std::vector<cv::Mat>& missed,
                                         const Context& context);

}  // namespace octacut
