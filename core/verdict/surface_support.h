// What a surface rests on: which shares of it photographs have decided, which
// silhouettes, and which nothing; and from where it was not seen.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/scene/scene.h"
#include "core/verdict/surface_evidence.h"
#include "core/views/view_set.h"

namespace octacut {

enum class Support {
  // The views agree about an offset that is known to a pixel, and the surface
  // lies within a pixel of it.
  kPhotographs,
  // Not so, but the surface lies within a pixel and a half, which is a voxel of
  // the finest level, of the visual hull.
  kSilhouettes,
  kNothing,
};
Support SupportOf(const PointEvidence& point);
bool IsNearHull(const PointEvidence& point);

// The part of a surface that fewer than two views see; shares of the whole
// area. "Above" is where the tops of the images are, by more than 30 degrees.
struct BlindPart {
  double share = 0;
  // Faced by two views or more, but hidden by the object itself.
  double hidden = 0;
  // The rest, by the surface's normal; 0 where the images have no common up.
  double above = 0;
  double below = 0;
  double aside = 0;
  // The view nearest to the mean of the rest's normals; none where there is no
  // rest.
  std::optional<size_t> nearest_view;
};

struct SurfaceSupport {
  // Shares of the area; they add up to 1.
  double photographs = 0;
  double silhouettes = 0;
  double nothing = 0;
  // Mean agreement of the views over what at least two see, -1 .. 1.
  double agreement = 0;
  BlindPart blind;
};

// `views` are those of `prepared`, whose poses may be better.
SurfaceSupport SumUpSupport(const std::vector<PointEvidence>& points,
                            const std::vector<View>& views,
                            const ViewSet& prepared);

}  // namespace octacut
