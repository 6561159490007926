#include "core/cut/cut_problem.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cut/fixed_point.h"

namespace octacut {
namespace {

constexpr char kFaceNames[kNumFaces][3] = {"x-", "x+", "y-", "y+", "z-", "z+"};

std::string VoxelName(MortonCode code) {
  const Eigen::Vector3i voxel = DecodeMorton(code);
  return fmt::format("({}, {}, {})", voxel.x(), voxel.y(), voxel.z());
}

void CheckSize(std::string_view field, size_t size, size_t num_voxels) {
  if (size != num_voxels) {
    throw InputError(fmt::format(
        "cut problem: {} {} for {} voxels", size, field, num_voxels));
  }
}

// Throws the error of the first voxel that fails, whatever the threads did.
template <typename IsValid, typename Throw>
void CheckAll(size_t count,
              const Context& context,
              IsValid&& is_valid,
              Throw&& throw_error) {
  std::vector<size_t> first_bad(NumChunks(count, kCutVoxelGrain), count);
  ParallelChunks(context,
                 count,
                 kCutVoxelGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   for (size_t i = begin; i < end; ++i) {
                     if (!is_valid(i)) {
                       first_bad[chunk] = i;
                       return;
                     }
                   }
                 });
  for (const size_t i : first_bad) {
    if (i != count) {
      throw_error(i);
    }
  }
}

[[noreturn]] void ThrowValue(std::string_view field,
                             const VoxelGrid& grid,
                             size_t index,
                             float value,
                             std::string_view constraint) {
  MortonCode voxel = 0;
  grid.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    if (i == index) {
      voxel = code;
    }
  });
  throw InputError(fmt::format("cut problem: {} of voxel {} = {}: {}",
                               field,
                               VoxelName(voxel),
                               value,
                               constraint));
}

// Names the first face that is tied both ways, or on the border and not tied.
[[noreturn]] void ThrowTies(const VoxelGrid& grid,
                            const VoxelSlot& slot,
                            int both_ways,
                            int untied) {
  const int face = std::countr_zero(unsigned(both_ways ? both_ways : untied));
  throw InputError(fmt::format(
      "cut problem: face {} of voxel {} is {}",
      kFaceNames[face],
      VoxelName(VoxelGrid::CodeOf(grid.Bricks()[slot.brick], int(slot.bit))),
      both_ways ? "tied both outside and inside"
                : "on the border of the crust and not tied"));
}

}  // namespace

void CheckCutValues(const OctahedralCutProblem& problem,
                    const Context& context) {
  if (problem.crust == nullptr) {
    throw InputError("cut problem: no crust");
  }
  const VoxelGrid& grid = *problem.crust;
  CheckSize("weights", problem.weights.size(), grid.Size());
  CheckSize("ties", problem.ties.size(), grid.Size());
  CheckAll(
      grid.Size(),
      context,
      [&](size_t i) {
        return problem.weights[i] > 0 && problem.weights[i] <= kMaxCutWeight;
      },
      [&](size_t i) {
        ThrowValue("weight",
                   grid,
                   i,
                   problem.weights[i],
                   fmt::format("must be > 0 and at most {}", kMaxCutWeight));
      });
  if (problem.evidence.empty()) {
    return;
  }
  CheckSize("evidence values", problem.evidence.size(), grid.Size());
  CheckAll(
      grid.Size(),
      context,
      [&](size_t i) { return std::abs(problem.evidence[i]) <= kMaxEvidence; },
      [&](size_t i) {
        ThrowValue(
            "evidence",
            grid,
            i,
            problem.evidence[i],
            fmt::format("must be at most {} in magnitude", kMaxEvidence));
      });
}

std::vector<FaceTies> MergeFaceTies(const OctahedralCutProblem& problem,
                                    const VoxelWalk& walk,
                                    const Context& context) {
  const VoxelGrid& grid = *problem.crust;
  std::vector<FaceTies> merged(grid.Size());
  ParallelFor(
      context,
      grid.Bricks().size(),
      kCutBrickGrain,
      [&](size_t begin, size_t end) {
        walk.ForEachWithNeighbors(
            begin, end, [&](const VoxelSlot& slot, const auto& neighbors) {
              const uint32_t i = slot.index;
              int ties = problem.ties[i] & 0xfff;
              int border = 0;
              for (int face = 0; face < kNumFaces; ++face) {
                if (neighbors[face] == VoxelGrid::kNone) {
                  border |= 1 << face;
                } else {
                  const int other = problem.ties[neighbors[face]];
                  ties |= ((other >> OppositeFace(face)) & 0x41) << face;
                }
              }
              const int both_ways = ties & (ties >> kNumFaces) & kAllFaces;
              const int untied = border & ~(ties | (ties >> kNumFaces));
              if (both_ways | untied) {
                ThrowTies(grid, slot, both_ways, untied);
              }
              merged[i] = FaceTies(ties);
            });
      });
  return merged;
}

int64_t LabellingCost(const OctahedralCutProblem& problem,
                      const VoxelWalk& walk,
                      std::span<const FaceTies> merged_ties,
                      std::span<const FaceLabels> labels,
                      const CutScale& scale,
                      const Context& context) {
  const VoxelGrid& grid = *problem.crust;
  const bool with_evidence = !problem.evidence.empty();
  const auto face_cost = [&](size_t i, int face, size_t j) {
    if (((labels[i] >> face) & 1) != ((labels[j] >> (face ^ 1)) & 1)) {
      throw InvariantError("cut: two voxels disagree on the face they share");
    }
    if (!with_evidence || ((merged_ties[i] >> face) & 0x41)) {
      return int64_t{0};
    }
    const int64_t inside = int64_t{scale.FaceEvidence(problem.evidence[i])} +
                           scale.FaceEvidence(problem.evidence[j]);
    const bool is_inside = (labels[i] >> face) & 1;
    return is_inside ? std::max<int64_t>(0, -inside)
                     : std::max<int64_t>(0, inside);
  };
  return ParallelSum(
      context,
      grid.Bricks().size(),
      kCutBrickGrain,
      [&](size_t begin, size_t end) {
        int64_t cost = 0;
        walk.ForEachWithNeighbors(
            begin, end, [&](const VoxelSlot& slot, const auto& neighbors) {
              const uint32_t i = slot.index;
              const int outside_ties = merged_ties[i] & kAllFaces;
              const int inside_ties = merged_ties[i] >> kNumFaces;
              if ((labels[i] & outside_ties) || (~labels[i] & inside_ties)) {
                throw InvariantError("cut: a label contradicts its tie");
              }
              cost += int64_t{NumCutEdges(labels[i])} *
                      scale.Weight(problem.weights[i]);
              for (int face = 0; face < kNumFaces; face += 2) {
                if (neighbors[face] != VoxelGrid::kNone) {
                  cost += face_cost(i, face, neighbors[face]);
                }
              }
            });
        return cost;
      });
}

}  // namespace octacut
