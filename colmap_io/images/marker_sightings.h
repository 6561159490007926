// Printed markers in the photographs of a workspace.
#pragma once

#include <vector>

#include "colmap_io/images/workspace.h"
#include "core/base/context.h"
#include "core/print/aruco_markers.h"
#include "core/print/marker_scale.h"

namespace octacut {

// Looks for markers in all photographs of the model; the result has the order
// of the images. Throws InputError that names an image that is missing, damaged
// or of another size than its camera.
std::vector<MarkerSighting> FindMarkerSightings(const Workspace& workspace,
                                                MarkerDictionary dictionary,
                                                const Context& context);

}  // namespace octacut
