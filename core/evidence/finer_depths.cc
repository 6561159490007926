#include "core/evidence/finer_depths.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"
#include "core/evidence/confirmed_depths.h"
#include "core/evidence/depth_evidence.h"
#include "core/evidence/depth_trust.h"
#include "core/evidence/neighbor_views.h"
#include "core/evidence/pick_depths.h"
#include "core/grid/morphology.h"

namespace octacut {
namespace {

// The range of depths, voxels: before the present surface, as far as its crust
// reached, and behind it.
constexpr float kBefore = 3;
constexpr float kBehind = 20;
// A peak within so many planes of an end of the range may belong to one beyond.
constexpr float kEndPlanes = 0.75f;
// Side of the squares of samples that are swept at once, each over the range of
// its own surface.
constexpr int kTile = 32;
// Samples between those that tell where a tile is.
constexpr int kStep = 8;
// Where folds are filled must be known before all is swept again: of blocks of
// so many voxels one in kSampleShare, a power of two, is looked at first.
constexpr float kBlock = 32;
constexpr int kSampleShare = 4;
// Share of the confirmed depths there that lie behind the surface's crust, from
// which on the rest is swept. Wrong depths reach a tenth of that.
constexpr double kPays = 1e-3;
constexpr float kRatherRight = 0.5f;
// Voxels behind a depth, and beside the way to it, that a crust needs.
constexpr float kReachBehind = 4;
constexpr int kReachBeside = 2;
// A ray that only brushes the hull: part of windows, without a depth.
constexpr float kOutOfRange = 1e-12f;

VoxelGrid CutVoxels(const LabeledVoxels& surface) {
  std::vector<uint8_t> cut(surface.labels.size());
  for (size_t i = 0; i < cut.size(); ++i) {
    cut[i] = IsCut(surface.labels[i]);
  }
  return Subset(surface.voxels, cut);
}

class ViewSweeper {
 public:
  ViewSweeper(const std::vector<SweepView>& views,
              const VoxelValues& depth_trust,
              int level,
              const DepthSweepOptions& options)
      : views_(views),
        depth_trust_(depth_trust),
        level_(level),
        voxel_(1.0f / float(1 << level)),
        options_(options) {}

  // Adds the depths of the tiles that show blocks of the sample, or of all
  // others.
  void Sweep(int index,
             const std::vector<int>& neighbors,
             bool of_sample,
             SweptDepthMap* map) const {
    if (neighbors.size() < 2) {
      return;  // one alone cannot tell an occlusion from a mismatch
    }
    const SweepView& view = views_[index];
    std::vector<SweepView> compared(1);
    std::vector<int> others;
    for (const int j : neighbors) {
      compared.push_back(views_[j]);
      others.push_back(int(compared.size()) - 1);
    }
    for (int y = 0; y < map->height; y += kTile) {
      for (int x = 0; x < map->width; x += kTile) {
        if (IsWanted(view, x, y, of_sample)) {
          SweepTile(view, x, y, others, &compared, map);
        }
      }
    }
  }

 private:
  // Whether most of the present surface that a tile shows has depths that are
  // relied upon; and whether any of it lies in a block of the sample.
  bool IsWanted(const SweepView& view, int x0, int y0, bool of_sample) const {
    const Eigen::Matrix3f rays = view.projection->linear.inverse();
    int balance = 0;
    bool in_sample = false;
    for (int y = y0; y < std::min(view.grey.rows, y0 + kTile); y += kStep) {
      for (int x = x0; x < std::min(view.grey.cols, x0 + kTile); x += kStep) {
        if (!(view.far_depth(y, x) > 0)) {
          continue;
        }
        const Eigen::Vector3f pixel(
            (float(x) + 0.5f) / view.scale, (float(y) + 0.5f) / view.scale, 1);
        const Eigen::Vector3f point =
            view.projection->center + view.near_depth(y, x) * (rays * pixel);
        balance += TrustAt(point) >= kRatherRight ? 1 : -1;
        const Eigen::Vector3i block =
            (point / (kBlock * voxel_)).array().floor().cast<int>();
        in_sample |= (block.sum() & (kSampleShare - 1)) == 0;
      }
    }
    return balance > 0 && in_sample == of_sample;
  }

  float TrustAt(const Eigen::Vector3f& point) const {
    const Eigen::Vector3i place =
        (point * float(1 << level_)).array().floor().cast<int>();
    if ((place.array() < 0).any() || (place.array() >= (1 << level_)).any()) {
      return 1;
    }
    return depth_trust_.At(EncodeMorton(place), level_, 1);
  }

  void SweepTile(const SweepView& view,
                 int x0,
                 int y0,
                 const std::vector<int>& others,
                 std::vector<SweepView>* compared,
                 SweptDepthMap* map) const {
    const int radius = options_.window_radius;
    const int left = std::max(0, x0 - radius);
    const int top = std::max(0, y0 - radius);
    const int right = std::min(view.grey.cols, x0 + kTile + radius);
    const int bottom = std::min(view.grey.rows, y0 + kTile + radius);
    ViewProjection projection = *view.projection;
    const float shift_u = float(left) / view.scale;
    const float shift_v = float(top) / view.scale;
    projection.linear.row(0) -= shift_u * projection.linear.row(2);
    projection.linear.row(1) -= shift_v * projection.linear.row(2);
    projection.offset.x() -= shift_u * projection.offset.z();
    projection.offset.y() -= shift_v * projection.offset.z();
    SweepView& tile = (*compared)[0];
    tile.projection = &projection;
    tile.scale = view.scale;
    const cv::Rect part(left, top, right - left, bottom - top);
    tile.grey = view.grey(part);
    tile.near_depth.create(part.height, part.width);
    tile.far_depth.create(part.height, part.width);
    tile.near_depth.setTo(std::numeric_limits<float>::infinity());
    tile.far_depth.setTo(kOutOfRange);
    bool is_empty = true;
    const int x1 = std::min(view.grey.cols, x0 + kTile);
    const int y1 = std::min(view.grey.rows, y0 + kTile);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const float far = view.far_depth(y, x);
        if (far > 0) {
          is_empty = false;
          // That of the nearest cut voxel, less a voxel.
          const float surface = view.near_depth(y, x) + voxel_;
          tile.near_depth(y - top, x - left) = surface - kBefore * voxel_;
          tile.far_depth(y - top, x - left) =
              std::min(surface + kBehind * voxel_, far);
        }
      }
    }
    if (is_empty) {
      return;
    }
    const ScoreVolume volume =
        ScorePlanes(*compared,
                    0,
                    others,
                    voxel_ / float(options_.planes_per_voxel),
                    radius);
    const SweptDepthMap depths =
        PickDepths(tile, volume, float(options_.min_score));
    const float margin = kEndPlanes * volume.spacing;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const float depth =
            depths.depths[size_t(y - top) * part.width + (x - left)];
        if (depth > tile.near_depth(y - top, x - left) + margin &&
            depth < tile.far_depth(y - top, x - left) - margin) {
          map->depths[size_t(y) * map->width + x] = depth;
        }
      }
    }
  }

  const std::vector<SweepView>& views_;
  const VoxelValues& depth_trust_;
  int level_;
  float voxel_;
  const DepthSweepOptions& options_;
};

// The voxels between a crust and the depths behind it, with what is around
// them.
VoxelGrid VoxelsBeyond(const ViewSet& views,
                       const VoxelGrid& crust,
                       const std::vector<SweptDepthMap>& maps,
                       const Context& context,
                       size_t* num_beyond) {
  const int resolution = crust.Resolution();
  std::vector<std::vector<MortonCode>> codes(maps.size());
  std::vector<size_t> counts(maps.size());
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f& center = views[i].projection.center;
      ForEachDepth(
          maps[i],
          views[i].projection,
          [&](int, int, float depth, const Eigen::Vector3f& ray) {
            const float step = 1 / (float(resolution) * ray.norm());
            const auto place = [&](float d) {
              return Eigen::Vector3i(((center + d * ray) * float(resolution))
                                         .array()
                                         .floor()
                                         .cast<int>());
            };
            const auto is_in_cube = [&](const Eigen::Vector3i& voxel) {
              return (voxel.array() >= 0).all() &&
                     (voxel.array() < resolution).all();
            };
            const Eigen::Vector3i at = place(depth);
            if (!is_in_cube(at) || crust.Contains(at)) {
              return;
            }
            ++counts[i];
            for (float d = depth;; d -= step) {
              const Eigen::Vector3i voxel = place(d);
              if (!is_in_cube(voxel) || crust.Contains(voxel)) {
                break;
              }
              codes[i].push_back(EncodeMorton(voxel));
            }
            for (float d = depth; d < depth + kReachBehind * step; d += step) {
              const Eigen::Vector3i voxel = place(d);
              if (is_in_cube(voxel)) {
                codes[i].push_back(EncodeMorton(voxel));
              }
            }
          });
      std::sort(codes[i].begin(), codes[i].end());
      codes[i].erase(std::unique(codes[i].begin(), codes[i].end()),
                     codes[i].end());
    }
  });
  std::vector<MortonCode> all;
  *num_beyond = 0;
  for (size_t i = 0; i < codes.size(); ++i) {
    all.insert(all.end(), codes[i].begin(), codes[i].end());
    *num_beyond += counts[i];
  }
  return Dilate(VoxelGrid::FromCodes(crust.Level(), std::move(all)),
                kReachBeside,
                context);
}

// Trust in a depth is no more than the first sweep has in those around it.
void LimitTrust(const ViewSet& views,
                const VoxelValues& depth_trust,
                int level,
                const Context& context,
                TrustedDepths* depths) {
  const int resolution = 1 << level;
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const SweptDepthMap& map = depths->maps[i];
      ForEachDepth(
          map,
          views[i].projection,
          [&](int x, int y, float depth, const Eigen::Vector3f& ray) {
            const Eigen::Vector3f point =
                (views[i].projection.center + depth * ray) * float(resolution);
            if ((point.array() >= 0).all() &&
                (point.array() < float(resolution)).all()) {
              float& trust = depths->trust[i][size_t(y) * map.width + x];
              trust =
                  std::min(trust,
                           depth_trust.At(
                               EncodeMorton(Eigen::Vector3i(point.cast<int>())),
                               level,
                               1));
            }
          });
    }
  });
}

struct FinerMaps {
  std::vector<SweptDepthMap> swept;
  std::vector<std::vector<uint8_t>> counts;  // of confirming neighbours
  std::vector<SweptDepthMap> agreeing;
  VoxelGrid beyond;  // as VoxelsBeyond has them
  size_t num_depths = 0;
  size_t num_beyond = 0;
};

// Empty where a sample of the surface says that it does not pay.
FinerMaps SweepNearSurface(const ViewSet& views,
                           const LabeledVoxels& surface,
                           const VoxelValues& depth_trust,
                           const InsideEvidenceOptions& options,
                           const Context& context) {
  const DepthSweepOptions& sweep = options.sweep;
  const std::vector<std::vector<int>> neighbors = SelectNeighborViews(
      views, sweep.num_neighbors, sweep.min_angle, sweep.max_angle);
  Phase phase(context, "finer depth sweep", 3 * views.size());
  const VoxelGrid cut = CutVoxels(surface);
  std::vector<SweepView> reduced(views.size());
  FinerMaps maps;
  maps.swept.resize(views.size());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      reduced[i] = ReduceForSweep(views[i], cut, sweep.samples_per_voxel);
      SweptDepthMap& map = maps.swept[i];
      map.width = reduced[i].grey.cols;
      map.height = reduced[i].grey.rows;
      map.scale = reduced[i].scale;
      map.depths.assign(size_t(map.width) * map.height, 0);
      phase.Advance();
    }
  });
  const ViewSweeper sweeper(
      reduced, depth_trust, surface.voxels.Level(), sweep);
  for (const bool of_sample : {true, false}) {
    ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        sweeper.Sweep(int(i), neighbors[i], of_sample, &maps.swept[i]);
        phase.Advance();
      }
    });
    maps.counts = CountAgreeing(views,
                                maps.swept,
                                neighbors,
                                1.0f / float(surface.voxels.Resolution()),
                                context);
    maps.agreeing =
        KeepAgreeing(maps.swept, maps.counts, options.min_agreeing_views);
    maps.num_depths = CountDepths(maps.agreeing);
    maps.beyond = VoxelsBeyond(
        views, surface.voxels, maps.agreeing, context, &maps.num_beyond);
    if (double(maps.num_beyond) <= kPays * double(maps.num_depths)) {
      return {};
    }
  }
  return maps;
}

}  // namespace

FinerEvidence FindFinerDepths(const ViewSet& views,
                              const LabeledVoxels& surface,
                              const VoxelValues& depth_trust,
                              const InsideEvidenceOptions& options,
                              const Context& context) {
  FinerMaps maps =
      SweepNearSurface(views, surface, depth_trust, options, context);
  FinerEvidence finer;
  finer.num_depths = maps.num_depths;
  finer.num_beyond = maps.num_beyond;
  if (maps.num_beyond == 0) {
    return finer;
  }
  finer.voxels = Union(surface.voxels, maps.beyond);
  TrustedDepths depths =
      EstimateDepthTrust(views, finer.voxels, maps.agreeing, context);
  LimitTrust(views, depth_trust, surface.voxels.Level(), context, &depths);
  InsideEvidenceOptions without_ballooning = options;
  without_ballooning.ballooning = 0;
  finer.values =
      EvidenceOf(views, finer.voxels, depths, without_ballooning, context);
  if (options.min_agreeing_views > 1 && options.min_like_samples <= 8) {
    AddPlausible(views,
                 finer.voxels,
                 KeepAgreeing(std::move(maps.swept), maps.counts, 1),
                 finer.values,
                 without_ballooning,
                 context,
                 &depths.maps);
    finer.values =
        EvidenceOf(views, finer.voxels, depths, without_ballooning, context);
  }
  return finer;
}

}  // namespace octacut
