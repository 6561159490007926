// The photographs of a page, reduced to fit.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"
#include "plugin/option_value.h"
#include "plugin/page/page_blobs.h"

namespace octacut {

// As JPEG files of some five megabytes in all; of very many views every n-th.
// [{"name", "view": index, "width", "height", "fx", "fy", "cx", "cy",
//   "rotation": 9 numbers, row by row, "translation", "blob"}, ...], the camera
// at the reduced size, cam_from_world. Views without an image are left out.
Json PagePhotographsToJson(const std::vector<View>& views,
                           const Context& context,
                           PageBlobs* blobs);

}  // namespace octacut
