#include "core/scene/coarse_hull.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace octacut {
namespace {

// Depth-first refinement of one cell. `undecided` holds the silhouettes whose
// verdict on the parent was kMixed, `denials` is how many called it background.
class Carver {
 public:
  Carver(const std::vector<SilhouettePyramid>& silhouettes,
         size_t max_denials,
         CoarseHull* hull)
      : silhouettes_(silhouettes), max_denials_(max_denials), hull_(*hull) {}

  void Refine(const Eigen::Vector3i& first,
              int size,
              const std::vector<uint32_t>& undecided,
              size_t denials) {
    const Eigen::AlignedBox3d box =
        hull_.CellBox(first).merged(hull_.CellBox(first.array() + (size - 1)));
    std::vector<uint32_t> mixed;
    for (uint32_t s : undecided) {
      const BoxVerdict verdict = silhouettes_[s].Classify(box);
      if (verdict == BoxVerdict::kBackground && ++denials > max_denials_) {
        return;
      }
      if (verdict == BoxVerdict::kMixed) {
        mixed.push_back(s);
      }
    }
    if (size == 1 || mixed.empty()) {
      Fill(first, size);
      return;
    }
    const int half = size / 2;
    for (int child = 0; child < 8; ++child) {
      Refine(first + half * Eigen::Vector3i(
                                child & 1, (child >> 1) & 1, child >> 2),
             half,
             mixed,
             denials);
    }
  }

 private:
  void Fill(const Eigen::Vector3i& first, int size) {
    for (int z = 0; z < size; ++z) {
      for (int y = 0; y < size; ++y) {
        const size_t begin = hull_.CellNumber(first + Eigen::Vector3i(0, y, z));
        std::fill_n(hull_.inside.begin() + begin, size, uint8_t{1});
      }
    }
  }

  const std::vector<SilhouettePyramid>& silhouettes_;
  const size_t max_denials_;
  CoarseHull& hull_;
};

// Visits the piece of `seed` and takes it off `open`; returns its size.
size_t TakePiece(const CoarseHull& hull,
                 const Eigen::Vector3i& seed,
                 std::vector<uint8_t>* open,
                 Eigen::AlignedBox3i* extent) {
  std::vector<Eigen::Vector3i> stack = {seed};
  (*open)[hull.CellNumber(seed)] = 0;
  size_t size = 0;
  while (!stack.empty()) {
    const Eigen::Vector3i cell = stack.back();
    stack.pop_back();
    extent->extend(cell);
    ++size;
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i neighbor =
          cell + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if ((neighbor.array() < 0).any() ||
          (neighbor.array() >= hull.resolution).any()) {
        continue;
      }
      uint8_t& is_open = (*open)[hull.CellNumber(neighbor)];
      if (is_open) {
        is_open = 0;
        stack.push_back(neighbor);
      }
    }
  }
  return size;
}

}  // namespace

Eigen::AlignedBox3d CoarseHull::CellBox(const Eigen::Vector3i& cell) const {
  const Eigen::Array3d step = box.sizes().array() / resolution;
  const Eigen::Array3d first =
      box.min().array() + cell.cast<double>().array() * step;
  return {first.matrix(), (first + step).matrix()};
}

CoarseHull CarveBox(const std::vector<SilhouettePyramid>& silhouettes,
                    const Eigen::AlignedBox3d& box,
                    int level,
                    const Context& context,
                    size_t max_denials) {
  CoarseHull hull;
  hull.box = box;
  hull.resolution = 1 << level;
  hull.inside.assign(size_t{1} << (3 * level), 0);
  std::vector<uint32_t> all(silhouettes.size());
  for (size_t s = 0; s < all.size(); ++s) {
    all[s] = uint32_t(s);
  }
  const int block_level = std::min(level, 2);
  const int blocks = 1 << block_level;
  const int block_size = hull.resolution / blocks;
  ParallelFor(context,
              size_t(blocks) * blocks * blocks,
              1,
              [&](size_t begin, size_t end) {
                Carver carver(silhouettes, max_denials, &hull);
                for (size_t b = begin; b < end; ++b) {
                  const int block = int(b);
                  const Eigen::Vector3i first(block % blocks,
                                              block / blocks % blocks,
                                              block / (blocks * blocks));
                  carver.Refine(first * block_size, block_size, all, 0);
                }
              });
  return hull;
}

Eigen::AlignedBox3d BoundingBoxOfPieces(const CoarseHull& hull,
                                        double min_fraction) {
  struct Piece {
    size_t size = 0;
    Eigen::AlignedBox3i extent;
  };
  std::vector<Piece> pieces;
  std::vector<uint8_t> open = hull.inside;
  size_t largest = 0;
  for (int z = 0; z < hull.resolution; ++z) {
    for (int y = 0; y < hull.resolution; ++y) {
      for (int x = 0; x < hull.resolution; ++x) {
        const Eigen::Vector3i cell(x, y, z);
        if (open[hull.CellNumber(cell)]) {
          Piece& piece = pieces.emplace_back();
          piece.size = TakePiece(hull, cell, &open, &piece.extent);
          largest = std::max(largest, piece.size);
        }
      }
    }
  }
  Eigen::AlignedBox3d box;
  for (const Piece& piece : pieces) {
    if (double(piece.size) >= min_fraction * double(largest)) {
      box.extend(hull.CellBox(piece.extent.min()));
      box.extend(hull.CellBox(piece.extent.max()));
    }
  }
  return box;
}

}  // namespace octacut
