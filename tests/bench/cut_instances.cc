#include "tests/bench/cut_instances.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/error.h"

namespace octacut {
namespace {

// A hash of a voxel as a uniform number in [0, 1): the same for any order.
float Noise(MortonCode code, uint64_t seed) {
  uint64_t x = code * 0x9e3779b97f4a7c15ull + seed * 0xbf58476d1ce4e5b9ull;
  x ^= x >> 31;
  x *= 0x94d049bb133111ebull;
  x ^= x >> 29;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 32;
  return float(x >> 40) * 0x1p-24f;
}

// Smooth bumps on the sphere of directions, in [-1, 1].
float Bumps(const Eigen::Vector3f& n, float frequency) {
  return (std::sin(frequency * n.x() + 1) + std::sin(frequency * n.y() + 2) +
          std::sin(frequency * n.z() + 3)) /
         3;
}

struct Shape {
  float resolution;
  // Signed distances in voxels, > 0 outside (to first order).
  float Surface(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / resolution - Eigen::Vector3f::Constant(0.5f);
    const float r = q.norm();
    const Eigen::Vector3f n = q / std::max(r, 1e-6f);
    return (r - 0.37f - 0.02f * Bumps(n, 9) -
            0.03f * std::min(0.0f, Bumps(n, 5))) *
           resolution;
  }
  // The hull: the same with its dents filled.
  float Hull(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / resolution - Eigen::Vector3f::Constant(0.5f);
    const float r = q.norm();
    const Eigen::Vector3f n = q / std::max(r, 1e-6f);
    return (r - 0.385f - 0.01f * Bumps(n, 9)) * resolution;
  }
};

struct Recipe {
  float thickness;  // of the crust to either side, in voxels
  float speckle;    // share of voxels whose consistency is noise
  float noise;      // spread of the rest
  bool fills_hull;
};

float Consistency(const Recipe& recipe,
                  const Eigen::Vector3f& p,
                  float resolution,
                  float distance,
                  MortonCode code) {
  const float u = Noise(code, 1);
  if (Noise(code, 2) < recipe.speckle) {
    return u;
  }
  // Patches without texture are consistent everywhere, within noise.
  const Eigen::Vector3f t = p * (20 / resolution);
  const float patch = std::sin(t.x()) * std::sin(t.y() + 1) * std::sin(t.z());
  const float contrast = patch > 0.35f ? 0.25f : 1.0f;
  const float well = 1 - std::exp(-distance * distance / 3);
  return std::clamp(
      contrast * 0.7f * well + recipe.noise * (u - 0.3f), 0.0f, 1.0f);
}

}  // namespace

CutInstance MakeCutInstance(const std::string& kind, int resolution) {
  const Recipe recipe = kind == "shell"  ? Recipe{2.3f, 0.1f, 0.3f, false}
                        : kind == "hard" ? Recipe{4.6f, 0.3f, 0.6f, false}
                                         : Recipe{0, 0.15f, 0.5f, true};
  if (kind != "shell" && kind != "hard" && kind != "level0" &&
      kind != "evidence") {
    throw OptionError("instance " + kind + " is not known");
  }
  const Shape shape{float(resolution)};
  CutInstance instance;
  instance.name = kind + "-" + std::to_string(resolution);
  // Where the crust is, what lies inside it, and its weights.
  const auto distance_of = [&](const Eigen::Vector3i& v) {
    return shape.Surface(v.cast<float>() + Eigen::Vector3f::Constant(0.5f));
  };
  const auto hull_of = [&](const Eigen::Vector3i& v) {
    return shape.Hull(v.cast<float>() + Eigen::Vector3f::Constant(0.5f));
  };
  const float core = (kind == "evidence" ? 0.33f : 0.22f) * resolution;
  const auto in_crust = [&](const Eigen::Vector3i& v) {
    if (recipe.fills_hull) {
      const float d = hull_of(v);
      return d < 0 && d > -core;
    }
    return std::abs(distance_of(v)) < recipe.thickness;
  };
  const int bricks = resolution / 4;
  std::vector<VoxelGrid::Brick> list;
  const uint64_t num_keys = std::bit_ceil(uint64_t(bricks)) *
                            std::bit_ceil(uint64_t(bricks)) *
                            std::bit_ceil(uint64_t(bricks));
  for (uint64_t key = 0; key < num_keys; ++key) {
    const Eigen::Vector3i corner = 4 * DecodeMorton(key);
    const float d = recipe.fills_hull
                        ? 0
                        : distance_of(corner + Eigen::Vector3i::Constant(2));
    if (std::abs(d) > recipe.thickness + 8) {
      continue;
    }
    uint64_t mask = 0;
    for (int bit = 0; bit < 64; ++bit) {
      mask |= uint64_t(in_crust(DecodeMorton(key << 6 | uint64_t(bit)))) << bit;
    }
    if (mask != 0) {
      list.push_back({key, mask, 0});
    }
  }
  instance.crust =
      VoxelGrid::FromBricks(std::bit_width(unsigned(resolution)) - 1, list);
  const VoxelGrid& grid = instance.crust;
  instance.weights.resize(grid.Size());
  instance.ties.assign(grid.Size(), 0);
  if (kind == "evidence") {
    instance.evidence.resize(grid.Size());
  }
  grid.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    const Eigen::Vector3i v = DecodeMorton(code);
    const Eigen::Vector3f p = v.cast<float>() + Eigen::Vector3f::Constant(0.5f);
    const float distance = distance_of(v);
    const float phi = Consistency(recipe, p, resolution, distance, code);
    instance.weights[i] = phi * phi * phi * phi + 1e-5f;
    if (kind == "evidence") {
      instance.evidence[i] = 0.02f * (Noise(code, 3) - 0.5f) -
                             0.01f * std::clamp(distance / 6, -1.0f, 1.0f);
    }
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i next = NeighborVoxel(v, face);
      if (!grid.Contains(next)) {
        const bool inside =
            recipe.fills_hull ? hull_of(next) <= -core : distance_of(next) < 0;
        instance.ties[i] |= inside ? InsideTie(face) : OutsideTie(face);
      }
    }
  });
  return instance;
}

}  // namespace octacut
