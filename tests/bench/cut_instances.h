// Cut problems for measurements: synthetic crusts with noisy
// photo-consistency.
#pragma once

#include <string>
#include <vector>

#include "core/cut/octahedral_cut.h"

namespace octacut {

struct CutInstance {
  std::string name;
  VoxelGrid crust;
  std::vector<float> weights;
  std::vector<FaceTies> ties;
  std::vector<float> evidence;

  OctahedralCutProblem View() const {
    return {&crust, weights, ties, evidence};
  }
};

// "shell": a crust of d = 2 around a bumpy ball; "hard": d = 5 and noisier;
// "level0": the crust fills a hull with dents the photographs do not show, a
// small deep core is inside; "evidence": level0 with evidence in place of
// most of the core. `resolution` is a power of two.
CutInstance MakeCutInstance(const std::string& kind, int resolution);

}  // namespace octacut
