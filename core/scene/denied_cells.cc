#include "core/scene/denied_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/median.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

// Cells are about as large as so many pixels of the median view.
constexpr double kPixelsPerCell = 2;
constexpr int kMinLevel = 4;
constexpr int kMaxLevel = 8;
constexpr int kBlockLevel = 3;

int LevelFor(const std::vector<View>& views, const Eigen::AlignedBox3d& box) {
  std::vector<double> sizes;
  for (const View& view : views) {
    const double depth = (view.cam_from_world * box.center()).z();
    sizes.push_back(depth > 0 ? box.sizes().maxCoeff() * view.camera.fx / depth
                              : 0);
  }
  const double size = Median(std::move(sizes));
  return std::clamp(
      int(std::ceil(std::log2(std::max(1.0, size / kPixelsPerCell)))),
      kMinLevel,
      kMaxLevel);
}

// Depth-first refinement of a block.
class Refiner {
 public:
  Refiner(const std::vector<View>& views,
          const std::vector<OutlineDistance>& outlines,
          size_t max_denials,
          double slack,
          DeniedCells* cells)
      : views_(views),
        outlines_(outlines),
        max_denials_(max_denials),
        slack_(slack),
        cells_(*cells) {}

  // `undecided` holds the views that neither deny the parent nor show only
  // object there, `deniers` those that deny it.
  void Refine(const Eigen::Vector3d& center,
              const Eigen::Vector3d& half,
              int levels_below,
              const std::vector<int>& undecided,
              Deniers deniers) {
    size_t num_denials =
        size_t(2 - std::count(deniers.begin(), deniers.end(), -1));
    std::vector<int> mixed;
    for (const int v : undecided) {
      const double radius = CellRadius(views_[v], center, half.norm());
      if (!std::isfinite(radius)) {
        mixed.push_back(v);
        continue;
      }
      const double distance = outlines_[v].At(
          views_[v].camera.Project(views_[v].cam_from_world * center));
      if (distance > radius + slack_) {
        if (num_denials == max_denials_) {
          return;
        }
        deniers[num_denials++] = v;
      } else if (distance > -radius) {
        mixed.push_back(v);
      }
    }
    if (mixed.empty() && num_denials == 0) {
      return;
    }
    if (levels_below == 0) {
      Add(center, deniers);
      return;
    }
    for (int child = 0; child < 8; ++child) {
      const Eigen::Vector3d side(child & 1 ? 0.5 : -0.5,
                                 child & 2 ? 0.5 : -0.5,
                                 child & 4 ? 0.5 : -0.5);
      Refine(center + side.cwiseProduct(half),
             half / 2,
             levels_below - 1,
             mixed,
             deniers);
    }
  }

 private:
  void Add(const Eigen::Vector3d& center, Deniers deniers) {
    if (deniers[0] < 0) {
      cells_.shown.push_back(center);
      return;
    }
    if (deniers[1] >= 0) {
      std::sort(deniers.begin(), deniers.end());
    }
    cells_.denied.push_back(center);
    cells_.deniers.push_back(deniers);
  }

  const std::vector<View>& views_;
  const std::vector<OutlineDistance>& outlines_;
  const size_t max_denials_;
  const double slack_;
  DeniedCells& cells_;
};

template <typename T>
void Append(const std::vector<T>& from, std::vector<T>* to) {
  to->insert(to->end(), from.begin(), from.end());
}

}  // namespace

double CellRadius(const View& view,
                  const Eigen::Vector3d& center,
                  double radius) {
  const double nearest = (view.cam_from_world * center).z() - radius;
  return nearest > 0
             ? radius * std::max(view.camera.fx, view.camera.fy) / nearest
             : std::numeric_limits<double>::infinity();
}

DeniedCells FindDeniedCells(const std::vector<View>& views,
                            const std::vector<OutlineDistance>& outlines,
                            const Eigen::AlignedBox3d& box,
                            size_t max_denials,
                            double slack,
                            const Context& context) {
  const int level = LevelFor(views, box);
  const int num_sides = 1 << kBlockLevel;
  const Eigen::Vector3d half = box.sizes() / 2 / num_sides;
  std::vector<int> all(views.size());
  for (size_t v = 0; v < all.size(); ++v) {
    all[v] = int(v);
  }
  std::vector<DeniedCells> of_blocks(size_t(num_sides) * num_sides * num_sides);
  ParallelEach(context, of_blocks.size(), 1, [&](size_t b) {
    const Eigen::Vector3i block(int(b) % num_sides,
                                int(b) / num_sides % num_sides,
                                int(b) / (num_sides * num_sides));
    const Eigen::Vector3d center =
        box.min() +
        (2 * block.cast<double>() + Eigen::Vector3d::Ones()).cwiseProduct(half);
    Refiner(views, outlines, max_denials, slack, &of_blocks[b])
        .Refine(center, half, level - kBlockLevel, all, {-1, -1});
  });
  DeniedCells cells;
  cells.radius = half.norm() / (1 << (level - kBlockLevel));
  for (const DeniedCells& block : of_blocks) {
    Append(block.shown, &cells.shown);
    Append(block.denied, &cells.denied);
    Append(block.deniers, &cells.deniers);
  }
  return cells;
}

}  // namespace octacut
