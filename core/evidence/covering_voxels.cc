#include "core/evidence/covering_voxels.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "core/evidence/main_matter.h"

namespace octacut {
namespace {

// Steps along a ray, voxels: none that it runs through for longer is missed.
constexpr float kStepAlongRay = 0.5f;
// Score that a voxel beside matter may lack: less than half a voxel's worth
// where the score is a labelling that has been averaged over some voxels.
constexpr float kBesideMatter = 0.1f;
// Views that show a voxel to be missing. One alone is no witness: near
// the border of its mask its ray grazes what the finer surface has left.
constexpr uint8_t kWitnesses = 2;
// Voxels that are looked at for a way to the object: all within some eight.
constexpr size_t kMaxSteps = 1000;

// Uncovered samples in the order of their distance from covered ones, steps to
// the next sample; those that cannot be reached come last.
std::vector<int> FromCoveredOutward(const SampleMap& map) {
  std::vector<int> order;
  std::vector<uint8_t> is_found(map.Size());
  const auto for_each_beside = [&](int sample, const auto& body) {
    const int x = sample % map.width;
    const int y = sample / map.width;
    if (x > 0) body(sample - 1);
    if (x + 1 < map.width) body(sample + 1);
    if (y > 0) body(sample - map.width);
    if (y + 1 < map.height) body(sample + map.width);
  };
  const auto add = [&](int sample) {
    if (map.IsUncovered(size_t(sample)) && !is_found[sample]) {
      is_found[sample] = 1;
      order.push_back(sample);
    }
  };
  size_t next = 0;
  const auto spread = [&] {
    for (; next < order.size(); ++next) {
      for_each_beside(order[next], add);
    }
  };
  for (int sample = 0; sample < int(map.Size()); ++sample) {
    bool is_first = false;
    if (map.IsUncovered(size_t(sample))) {
      for_each_beside(
          sample, [&](int beside) { is_first |= map.is_covered[beside] != 0; });
    }
    if (is_first) {
      add(sample);
    }
  }
  spread();
  for (int sample = 0; sample < int(map.Size()); ++sample) {
    add(sample);
    spread();
  }
  return order;
}

// The rays of one view's samples through a crust.
class SampleRays {
 public:
  SampleRays(const PreparedView& view,
             const SampleMap& map,
             const VoxelGrid& crust)
      : map_(map),
        crust_(crust),
        center_(view.projection.center),
        unproject_(view.projection.RaysOfPixels()) {}

  // Calls body(index, voxel) for the voxels on the ray through the middle of a
  // sample, from the camera on; some more than once.
  template <typename Body>
  void ForEachVoxel(int sample, const Body& body) const {
    const int row = sample / map_.width;
    const int column = sample % map_.width;
    const Eigen::Vector3f direction =
        (unproject_ * Eigen::Vector3f((float(column) + 0.5f) / map_.scale,
                                      (float(row) + 0.5f) / map_.scale,
                                      1))
            .normalized();
    // The root cube is [0, 1]^3.
    const Eigen::Array3f a = -center_.array() / direction.array();
    const Eigen::Array3f b = (1 - center_.array()) / direction.array();
    const float begin = std::max(0.0f, a.min(b).maxCoeff());
    const float end = a.max(b).minCoeff();
    const float step = kStepAlongRay / float(crust_.Resolution());
    float t = begin + step / 2;
    while (t < end) {
      const Eigen::Vector3f point =
          (center_ + t * direction) * float(crust_.Resolution());
      const Eigen::Vector3i voxel = point.array().floor().cast<int>();
      const VoxelGrid::Index index = crust_.Find(voxel);
      if (index != VoxelGrid::kNone) {
        body(index, voxel);
      }
      t += step;
    }
  }

 private:
  const SampleMap& map_;
  const VoxelGrid& crust_;
  Eigen::Vector3f center_;
  Eigen::Matrix3f unproject_;
};

class CoverSearch {
 public:
  CoverSearch(const VoxelGrid& crust,
              const std::vector<FaceLabels>& labels,
              const CoverCandidates& candidates,
              CoveringVoxels* found)
      : crust_(crust),
        candidates_(candidates),
        is_attached_(FindMainMatter(crust, labels)),
        found_(found) {
    found_->is_covering.resize(crust.Size());
  }

  // The likely voxels that at least two views miss.
  void TakeLikely(const std::vector<SampleRays>& rays,
                  const std::vector<std::vector<int>>& samples) {
    CountWitnesses(rays, samples);
    std::vector<Eigen::Vector3i> taken;
    crust_.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      if (candidates_.is_likely[index] && IsWitnessed(index)) {
        Take(index);
        taken.push_back(DecodeMorton(code));
      }
    });
    for (const Eigen::Vector3i& voxel : taken) {
      Attach(voxel);
    }
  }

  // Something on the ray, unless it meets what has been taken.
  void TakeBest(const SampleRays& rays, int sample) {
    on_ray_.clear();
    bool is_covered = false;
    float best = -1;
    rays.ForEachVoxel(
        sample, [&](VoxelGrid::Index index, const Eigen::Vector3i& voxel) {
          is_covered |= found_->is_covering[index] != 0;
          if (candidates_.scores[index] >= 0 && IsWitnessed(index) &&
              (num_witnesses_.empty() || IsBesideMatter(voxel))) {
            on_ray_.emplace_back(index, voxel);
            best = std::max(best, candidates_.scores[index]);
          }
        });
    if (is_covered) {
      return;
    }
    if (on_ray_.empty()) {
      ++found_->num_impossible;
      return;
    }
    float highest = -1;
    std::pair<VoxelGrid::Index, Eigen::Vector3i> chosen;
    for (const auto& candidate : on_ray_) {
      float score = candidates_.scores[candidate.first];
      if (score >= best - kBesideMatter && IsBesideMatter(candidate.second)) {
        score += kBesideMatter;
      }
      if (score > highest) {
        highest = score;
        chosen = candidate;
      }
    }
    Take(chosen.first);
    Attach(chosen.second);
  }

 private:
  void Take(VoxelGrid::Index index) {
    found_->num_voxels += !found_->is_covering[index];
    found_->is_covering[index] = 1;
  }

  // How many views have an uncovered ray through each candidate, up to two.
  void CountWitnesses(const std::vector<SampleRays>& rays,
                      const std::vector<std::vector<int>>& samples) {
    std::vector<uint16_t> last_view(crust_.Size());
    num_witnesses_.resize(crust_.Size());
    for (size_t view = 0; view < rays.size(); ++view) {
      for (const int sample : samples[view]) {
        rays[view].ForEachVoxel(
            sample, [&](VoxelGrid::Index index, const Eigen::Vector3i&) {
              if (candidates_.scores[index] >= 0 &&
                  last_view[index] != view + 1 &&
                  num_witnesses_[index] < kWitnesses) {
                last_view[index] = uint16_t(view + 1);
                ++num_witnesses_[index];
              }
            });
      }
    }
  }

  // All are where nothing is likely.
  bool IsWitnessed(VoxelGrid::Index index) const {
    return num_witnesses_.empty() || num_witnesses_[index] >= kWitnesses;
  }

  bool IsBesideMatter(const Eigen::Vector3i& voxel) const {
    for (int i = 0; i < 27; ++i) {
      const VoxelGrid::Index beside = crust_.Find(
          voxel + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
      if (beside != VoxelGrid::kNone && is_attached_[beside]) {
        return true;
      }
    }
    return false;
  }

  // Takes the voxels of a shortest path, through faces, from a voxel to what is
  // attached to the object already, so that no part hangs in the air.
  void Attach(const Eigen::Vector3i& voxel);

  const VoxelGrid& crust_;
  const CoverCandidates& candidates_;
  std::vector<uint8_t> is_attached_;
  std::vector<uint8_t> num_witnesses_;  // one per voxel
  std::vector<std::pair<VoxelGrid::Index, Eigen::Vector3i>> on_ray_;
  CoveringVoxels* found_;
};

void CoverSearch::Attach(const Eigen::Vector3i& voxel) {
  struct Step {
    VoxelGrid::Index index;
    Eigen::Vector3i voxel;
    int from;
  };
  const VoxelGrid::Index first = crust_.Find(voxel);
  if (is_attached_[first]) {
    return;
  }
  std::vector<Step> steps = {{first, voxel, -1}};
  std::unordered_set<VoxelGrid::Index> is_reached = {first};
  int end = -1;
  for (size_t next = 0;
       end < 0 && next < steps.size() && steps.size() < kMaxSteps;
       ++next) {
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i beside = NeighborVoxel(steps[next].voxel, face);
      const VoxelGrid::Index index = crust_.Find(beside);
      if (index == VoxelGrid::kNone) {
        continue;
      }
      if (is_attached_[index]) {
        end = int(next);
        break;
      }
      if (candidates_.scores[index] >= 0 && is_reached.insert(index).second) {
        steps.push_back({index, beside, int(next)});
      }
    }
  }
  for (; end >= 0; end = steps[end].from) {
    Take(steps[end].index);
    is_attached_[steps[end].index] = 1;
  }
}

}  // namespace

CoveringVoxels FindCoveringVoxels(const ViewSet& views,
                                  const VoxelGrid& crust,
                                  const std::vector<FaceLabels>& labels,
                                  const std::vector<SampleMap>& maps,
                                  const CoverCandidates& candidates,
                                  const Context& context) {
  CoveringVoxels found;
  std::vector<SampleRays> rays;
  std::vector<std::vector<int>> samples;
  for (size_t i = 0; i < views.size(); ++i) {
    rays.emplace_back(views[i], maps[i], crust);
    samples.push_back(FromCoveredOutward(maps[i]));
  }
  CoverSearch search(crust, labels, candidates, &found);
  if (!candidates.is_likely.empty()) {
    search.TakeLikely(rays, samples);
  }
  for (size_t i = 0; i < views.size(); ++i) {
    for (const int sample : samples[i]) {
      context.ThrowIfCancelled();
      search.TakeBest(rays[i], sample);
    }
  }
  return found;
}

}  // namespace octacut
