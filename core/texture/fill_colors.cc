#include "core/texture/fill_colors.h"

#include <algorithm>

#include "core/texture/charts.h"
#include "core/texture/solve_channels.h"

namespace octacut {
namespace {

// So weak a pull to the mean that only pieces without any known vertex feel it.
constexpr double kToMean = 1e-6;
constexpr int kKnown = -1;

struct SeenColors {
  std::vector<Eigen::Vector3f> colors;  // of all vertices, 0 if not known
  std::vector<int> unknowns;  // the number of each that is not, else kKnown
  int num_unknown = 0;
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();  // of those known
};

SeenColors FindSeenColors(const VertexCorners& vertex_faces,
                          const FaceChoice& chosen,
                          size_t num_vertices) {
  SeenColors seen{.colors = {num_vertices, Eigen::Vector3f::Zero()},
                  .unknowns = std::vector<int>(num_vertices, kKnown)};
  for (size_t v = 0; v < num_vertices; ++v) {
    Eigen::Vector3f around = Eigen::Vector3f::Zero();
    int count = 0;
    for (const uint32_t f : vertex_faces.Of(v)) {
      if (chosen.chosen[f] != kNoView) {
        around += chosen.costs.consensus[f];
        ++count;
      }
    }
    if (count > 0) {
      seen.colors[v] = around / float(count);
      seen.mean += seen.colors[v].cast<double>().transpose();
    } else {
      seen.unknowns[v] = seen.num_unknown++;
    }
  }
  const auto num_known = int64_t(num_vertices) - seen.num_unknown;
  seen.mean /= double(std::max<int64_t>(1, num_known));
  return seen;
}

// Colours of the vertices without: each the mean of those around.
Eigen::MatrixX3d Continue(const IndexedMesh& mesh,
                          const SeenColors& seen,
                          const Context& context) {
  std::vector<Eigen::Triplet<double>> triplets;
  Eigen::MatrixX3d right(seen.num_unknown, 3);
  for (int i = 0; i < seen.num_unknown; ++i) {
    triplets.emplace_back(i, i, kToMean);
    right.row(i) = kToMean * seen.mean;
  }
  for (const auto& corners : mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const int i = seen.unknowns[corners[k]];
      if (i == kKnown) {
        continue;
      }
      for (const uint32_t other :
           {corners[(k + 1) % 3], corners[(k + 2) % 3]}) {
        triplets.emplace_back(i, i, 0.5);
        if (const int j = seen.unknowns[other]; j != kKnown) {
          triplets.emplace_back(i, j, -0.5);
        } else {
          right.row(i) += 0.5 * seen.colors[other].cast<double>().transpose();
        }
      }
    }
  }
  SymmetricMatrix matrix(seen.num_unknown, seen.num_unknown);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::MatrixX3d colors = seen.mean.replicate(seen.num_unknown, 1);
  SolveChannels(matrix, right, "borders of unseen parts", context, &colors);
  return colors;
}

}  // namespace

std::vector<Eigen::Vector3f> FillColors(const IndexedMesh& mesh,
                                        const VertexCorners& vertex_faces,
                                        const FaceChoice& chosen,
                                        const Context& context) {
  const Phase phase(context, "colours of unseen parts");
  SeenColors seen = FindSeenColors(vertex_faces, chosen, mesh.positions.size());
  if (seen.num_unknown > 0) {
    const Eigen::MatrixX3d filled = Continue(mesh, seen, context);
    for (size_t v = 0; v < seen.colors.size(); ++v) {
      if (const int i = seen.unknowns[v]; i != kKnown) {
        seen.colors[v] = filled.row(i).transpose().cast<float>();
      }
    }
  }
  return std::move(seen.colors);
}

}  // namespace octacut
