#include "tests/core/cut/cut_test_problems.h"

#include <bit>
#include <map>
#include <stdexcept>

#include "core/cut/fixed_point.h"

namespace octacut {

std::vector<MortonCode> BoxCodes(const Eigen::Vector3i& origin,
                                 const Eigen::Vector3i& size) {
  std::vector<MortonCode> codes;
  for (int z = 0; z < size.z(); ++z) {
    for (int y = 0; y < size.y(); ++y) {
      for (int x = 0; x < size.x(); ++x) {
        codes.push_back(EncodeMorton(origin + Eigen::Vector3i(x, y, z)));
      }
    }
  }
  return codes;
}

OwnedCutProblem TieRandomly(VoxelGrid crust,
                            const RandomTieOptions& options,
                            std::mt19937& random) {
  OwnedCutProblem problem;
  problem.crust = std::move(crust);
  const VoxelGrid& grid = problem.crust;
  problem.weights.assign(grid.Size(), 1.0f);
  problem.ties.assign(grid.Size(), 0);
  std::uniform_real_distribution<double> uniform(0, 1);
  grid.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    for (int face = 0; face < kNumFaces; ++face) {
      const VoxelGrid::Index other =
          grid.Find(NeighborVoxel(DecodeMorton(code), face));
      const bool border = other == VoxelGrid::kNone;
      if (!border && ((face & 1) || uniform(random) >= options.inner)) {
        continue;
      }
      const bool inside = uniform(random) < options.inside;
      const auto tie = [&](int f) {
        return inside ? InsideTie(f) : OutsideTie(f);
      };
      const double who = uniform(random);
      if (border || who < 0.7) {
        problem.ties[i] |= tie(face);
      }
      if (!border && who > 0.3) {
        problem.ties[other] |= tie(OppositeFace(face));
      }
    }
  });
  return problem;
}

void SetRandomWeights(WeightKind kind,
                      std::mt19937& random,
                      OwnedCutProblem& problem) {
  std::uniform_real_distribution<float> uniform(0, 1);
  for (float& weight : problem.weights) {
    const float u = uniform(random);
    switch (kind) {
      case WeightKind::kUniform:
        weight = u + 1e-5f;
        break;
      case WeightKind::kEqual:
        weight = 0.25f;
        break;
      case WeightKind::kExtreme:
        weight = u < 0.3f ? 1e-12f : u < 0.6f ? 1023.0f : 3e-6f;
        break;
      case WeightKind::kSpeckle:
        weight = u * u * u * u + 1e-5f;
        break;
    }
  }
}

void SetRandomEvidence(float scale,
                       std::mt19937& random,
                       OwnedCutProblem& problem) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  problem.evidence.resize(problem.crust.Size());
  for (float& evidence : problem.evidence) {
    evidence = random() % 4 == 0 ? 0.0f : scale * uniform(random);
  }
}

OctahedralCut ExhaustiveCut(const OctahedralCutProblem& problem) {
  const VoxelGrid& grid = *problem.crust;
  // Faces by their doubled centre, so that both owners find the same one.
  struct Face {
    int tie = 0;  // 1 outside, 2 inside
    int64_t inside_evidence = 0;
    int variable = -1;
  };
  const auto key_of = [](MortonCode code, int face) {
    Eigen::Vector3i centre =
        2 * DecodeMorton(code) + Eigen::Vector3i::Constant(1);
    centre[face / 2] += (face & 1) ? 1 : -1;
    return std::array<int, 3>{centre.x(), centre.y(), centre.z()};
  };
  std::map<std::array<int, 3>, Face> faces;
  grid.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    for (int f = 0; f < kNumFaces; ++f) {
      Face& face = faces[key_of(code, f)];
      face.tie |= (problem.ties[i] & OutsideTie(f)) ? 1 : 0;
      face.tie |= (problem.ties[i] & InsideTie(f)) ? 2 : 0;
      if (!problem.evidence.empty()) {
        face.inside_evidence += FixedFaceEvidence(problem.evidence[i]);
      }
    }
  });
  std::vector<int64_t> evidence;
  for (auto& [key, face] : faces) {
    if (face.tie == 0) {
      face.variable = int(evidence.size());
      evidence.push_back(face.inside_evidence);
    }
  }
  if (evidence.size() > 20) {
    throw std::logic_error("too many untied faces for an exhaustive cut");
  }
  const auto labels_of = [&](uint32_t assignment) {
    std::vector<FaceLabels> labels(grid.Size(), 0);
    grid.ForEach([&](VoxelGrid::Index i, MortonCode code) {
      for (int f = 0; f < kNumFaces; ++f) {
        const Face& face = faces.at(key_of(code, f));
        const bool inside =
            face.tie != 0 ? face.tie == 2 : (assignment >> face.variable) & 1;
        labels[i] |= FaceLabels(inside << f);
      }
    });
    return labels;
  };
  // Per voxel: its fixed labels and the variable of each face.
  struct Voxel {
    int fixed = 0;
    std::array<int, kNumFaces> variable;
    int64_t weight = 0;
  };
  std::vector<Voxel> voxels(grid.Size());
  grid.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    voxels[i].weight = FixedWeight(problem.weights[i]);
    for (int f = 0; f < kNumFaces; ++f) {
      const Face& face = faces.at(key_of(code, f));
      voxels[i].variable[f] = face.variable;
      voxels[i].fixed |= (face.tie == 2) << f;
    }
  });
  int64_t best = -1;
  uint32_t best_assignment = 0;
  for (uint32_t assignment = 0; assignment < 1u << evidence.size();
       ++assignment) {
    int64_t cost = 0;
    for (size_t k = 0; k < evidence.size(); ++k) {
      const bool inside = (assignment >> k) & 1;
      cost += std::max<int64_t>(0, inside ? -evidence[k] : evidence[k]);
    }
    for (const Voxel& voxel : voxels) {
      int labels = voxel.fixed;
      for (int f = 0; f < kNumFaces; ++f) {
        if (voxel.variable[f] >= 0) {
          labels |= ((assignment >> voxel.variable[f]) & 1) << f;
        }
      }
      int cut_edges = 0;
      for (int f = 0; f < kNumFaces; ++f) {
        for (int g = f + 1; g < kNumFaces; ++g) {
          cut_edges += f / 2 != g / 2 && (((labels >> f) ^ (labels >> g)) & 1);
        }
      }
      cost += cut_edges * voxel.weight;
    }
    if (best < 0 || cost < best ||
        (cost == best &&
         std::popcount(assignment) > std::popcount(best_assignment))) {
      best = cost;
      best_assignment = assignment;
    }
  }
  OctahedralCut cut;
  cut.labels = labels_of(best_assignment);
  cut.cost_fixed_point = best;
  cut.num_nodes = evidence.size();
  return cut;
}

}  // namespace octacut
