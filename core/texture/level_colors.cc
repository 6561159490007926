#include "core/texture/level_colors.h"

#include <algorithm>
#include <array>
#include <Eigen/Core>

#include "core/mesh/triangle_normal.h"
#include "core/texture/solve_channels.h"

namespace octacut {
namespace {

// Pixels over which a correction varies.
constexpr double kDetail = 12;
// Weight of seams against the pull toward the consensus.
constexpr double kSeam = 16;
// Each triangle's part of an edge's weight in the Laplacian: the cotangent of
// 60 degrees, halved; meshes of poor triangles may do with it, since smoothness
// is all that is asked.
constexpr double kEdgeOfTriangle = 0.29;

using Triplets = std::vector<Eigen::Triplet<double>>;

class Leveler {
 public:
  Leveler(const IndexedMesh& mesh,
          const VertexCorners& vertex_faces,
          const FaceChoice& chosen,
          const VertexViews& vertex_views)
      : mesh_(mesh),
        vertex_faces_(vertex_faces),
        chosen_(chosen),
        vertex_views_(vertex_views) {}

  std::vector<Eigen::Vector3f> Run(const Context& context) {
    const Phase phase(context, "seam levelling");
    const auto count = Eigen::Index(vertex_views_.entries.size());
    right_ = Eigen::MatrixX3d::Zero(count, 3);
    start_ = Eigen::MatrixX3d::Zero(count, 3);
    for (uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      AddVertex(v);
    }
    for (size_t f = 0; f < mesh_.triangles.size(); ++f) {
      AddSmoothness(f);
    }
    SymmetricMatrix matrix(count, count);
    matrix.setFromTriplets(triplets_.begin(), triplets_.end());
    triplets_ = {};
    SolveChannels(matrix, right_, "seams", context, &start_);
    std::vector<Eigen::Vector3f> corrections(vertex_views_.entries.size());
    for (size_t i = 0; i < corrections.size(); ++i) {
      corrections[i] = start_.row(Eigen::Index(i)).transpose().cast<float>();
    }
    return corrections;
  }

 private:
  // Pixels of a triangle in its best view.
  double PixelArea(size_t f) const {
    const double resolution = chosen_.costs.resolution[f];
    return TriangleArea(mesh_, mesh_.triangles[f]) * resolution * resolution;
  }

  void AddVertex(uint32_t v) {
    double pixels = 0;
    for (const uint32_t f : vertex_faces_.Of(v)) {
      pixels += PixelArea(f) / 3;
    }
    const uint32_t begin = vertex_views_.first[v];
    const uint32_t end = vertex_views_.first[v + 1];
    for (uint32_t i = begin; i < end; ++i) {
      AddTarget(v, i, pixels);
      for (uint32_t j = i + 1; j < end; ++j) {
        AddSeam(v, i, j, kSeam * pixels);
      }
    }
  }

  void AddTarget(uint32_t v, uint32_t entry, double pixels) {
    const uint32_t view = vertex_views_.entries[entry].view;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int count = 0;
    for (const uint32_t f : vertex_faces_.Of(v)) {
      if (const FaceView* const found = chosen_.views.Find(f, view)) {
        sum += chosen_.costs.consensus[f] - found->Color();
        ++count;
      }
    }
    // An empty row would make the matrix singular.
    const double weight = std::max(pixels, 1e-9);
    triplets_.emplace_back(int(entry), int(entry), weight);
    if (count > 0) {
      const Eigen::RowVector3d target =
          (sum / float(count)).cast<double>().transpose();
      right_.row(entry) += weight * target;
      start_.row(entry) = target;
    }
  }

  // The difference of two views' colours around a vertex: over the triangles
  // that both show or, failing these, each over those that it shows.
  Eigen::Vector3f Difference(uint32_t v, uint32_t a, uint32_t b) const {
    Eigen::Vector3f both = Eigen::Vector3f::Zero();
    std::array<Eigen::Vector3f, 2> each = {both, both};
    std::array<int, 2> counts = {0, 0};
    int count = 0;
    for (const uint32_t f : vertex_faces_.Of(v)) {
      const FaceView* const of_a = chosen_.views.Find(f, a);
      const FaceView* const of_b = chosen_.views.Find(f, b);
      if (of_a != nullptr) {
        each[0] += of_a->Color();
        ++counts[0];
      }
      if (of_b != nullptr) {
        each[1] += of_b->Color();
        ++counts[1];
      }
      if (of_a != nullptr && of_b != nullptr) {
        both += of_a->Color() - of_b->Color();
        ++count;
      }
    }
    if (count > 0) {
      return both / float(count);
    }
    return each[0] / float(std::max(1, counts[0])) -
           each[1] / float(std::max(1, counts[1]));
  }

  void AddSeam(uint32_t v, uint32_t i, uint32_t j, double weight) {
    const Eigen::RowVector3d difference =
        Difference(
            v, vertex_views_.entries[i].view, vertex_views_.entries[j].view)
            .cast<double>()
            .transpose();
    AddPair(i, j, weight);
    right_.row(i) -= weight * difference;
    right_.row(j) += weight * difference;
  }

  void AddPair(uint32_t i, uint32_t j, double weight) {
    triplets_.emplace_back(int(i), int(i), weight);
    triplets_.emplace_back(int(j), int(j), weight);
    triplets_.emplace_back(int(i), int(j), -weight);
    triplets_.emplace_back(int(j), int(i), -weight);
  }

  void AddSmoothness(size_t f) {
    const auto& corners = mesh_.triangles[f];
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = corners[k];
      const uint32_t b = corners[(k + 1) % 3];
      for (uint32_t i = vertex_views_.first[a]; i < vertex_views_.first[a + 1];
           ++i) {
        const int64_t j = vertex_views_.Find(b, vertex_views_.entries[i].view);
        if (j >= 0) {
          AddPair(i, uint32_t(j), kDetail * kDetail * kEdgeOfTriangle);
        }
      }
    }
  }

  const IndexedMesh& mesh_;
  const VertexCorners& vertex_faces_;
  const FaceChoice& chosen_;
  const VertexViews& vertex_views_;
  Triplets triplets_;
  Eigen::MatrixX3d right_;
  Eigen::MatrixX3d start_;
};

}  // namespace

std::vector<Eigen::Vector3f> LevelColors(const IndexedMesh& mesh,
                                         const VertexCorners& vertex_faces,
                                         const FaceChoice& chosen,
                                         const VertexViews& vertex_views,
                                         const Context& context) {
  return Leveler(mesh, vertex_faces, chosen, vertex_views).Run(context);
}

}  // namespace octacut
