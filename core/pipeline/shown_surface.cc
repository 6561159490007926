#include "core/pipeline/shown_surface.h"

#include "core/base/ramp.h"
#include "core/pipeline/surface_agreement.h"

namespace octacut {
namespace {

// Agreements up to which an object mirrors and from which on it does not: metal
// of twelve shapes has at most 0.30, all else with views near enough to be
// swept at least 0.42.
constexpr float kMirror = 0.33f;
constexpr float kMatt = 0.42f;

}  // namespace

ShownSurface MeasureShownSurface(const ViewSet& views,
                                 const LabeledVoxels& hull,
                                 const RefineOptions& options,
                                 const Context& context) {
  constexpr double kHalfVoxel = 0.5;
  const MeasuredSurface measured =
      MeasureSurface(views,
                     hull,
                     kHalfVoxel,
                     "agreement of the views on the hull",
                     options,
                     context);
  ShownSurface shown;
  if (measured.mesh.positions.empty()) {
    return shown;
  }
  shown.agreement = measured.agreement.UpperDecile();
  shown.share = Ramp(float(shown.agreement), kMirror, kMatt);
  return shown;
}

}  // namespace octacut
