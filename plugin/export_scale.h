// How many millimetres a unit of the mesh has, as the user says it.
#pragma once

#include <optional>
#include <vector>

#include "colmap_io/images/workspace.h"
#include "core/base/context.h"
#include "core/print/aruco_markers.h"
#include "plugin/option_manager.h"

namespace octacut {

// clang-tidy does not see that moving a Json cannot fail.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct ExportScale {
  double factor = 1;
  // {"source": "none", "scale_factor", "known_length" or "aruco", "factor",
  //  and for markers what was measured}
  Json json;
};

class ExportScaleOptions {
 public:
  void Declare(OptionManager& options);
  // Throws OptionError.
  void Check() const;
  bool NeedsWorkspace() const { return aruco_side_ > 0; }
  // `workspace` may be empty unless NeedsWorkspace(). Warns where nothing is
  // given.
  ExportScale Find(const std::optional<Workspace>& workspace,
                   const Context& context) const;

 private:
  ExportScale FromMarkers(const Workspace& workspace,
                          const Context& context) const;

  double scale_factor_ = 0;
  double known_length_ = 0;
  std::vector<double> between_;
  double aruco_side_ = 0;
  MarkerDictionary dictionary_ = MarkerDictionary::kFour50;
};

}  // namespace octacut
