// The size of a scene from square markers whose side is known.
#pragma once

#include <array>
#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "core/scene/camera.h"

namespace octacut {

// One marker in one view.
struct MarkerSighting {
  int id = 0;
  Rigid3d cam_from_world;
  double focal_length = 1;  // pixels
  // Rays to the corners in the frame of the camera, of any length, in the
  // order of the corners around the marker.
  std::array<Eigen::Vector3d, 4> rays;
};

struct MeasuredMarker {
  int id = 0;
  size_t num_views = 0;  // that agree
  double side = 0;       // mean of the four, in world units
  std::array<Eigen::Vector3d, 4> corners;
};

struct MarkerScale {
  double factor = 0;  // from world units to those of the side
  std::vector<MeasuredMarker> markers;
  double reprojection_rms = 0;  // pixels
  // Of the sides of all markers from what they should be, as fractions of it.
  double side_rms = 0;
  double side_max = 0;
};

// Triangulates the corners of each marker from the views that see it. A view
// whose corners are more than 3 pixels off is left out, the worst first.
// Markers count that at least two views see from directions that differ by at
// least two degrees. `side` is what the sides measure in the world. Throws
// InputError where no marker counts.
MarkerScale MeasureMarkerScale(const std::vector<MarkerSighting>& sightings,
                               double side);

}  // namespace octacut
