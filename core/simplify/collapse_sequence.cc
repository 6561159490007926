#include "core/simplify/collapse_sequence.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <string>
#include <utility>

#include "core/simplify/collapse_rules.h"

namespace octacut {
namespace {

namespace decimater = OpenMesh::Decimater;

// Collapses between two looks at whether the run is to stop.
constexpr size_t kInterval = 4096;

// Quadric errors of the collapses that do not spoil triangles; notes those that
// are made.
template <typename MeshT>
class ModShapedQuadricT : public decimater::ModQuadricT<MeshT> {
 public:
  using Quadric = decimater::ModQuadricT<MeshT>;
  // The macro's names are OpenMesh's.
  DECIMATING_MODULE(ModShapedQuadricT, MeshT, ShapedQuadric);  // NOLINT

  explicit ModShapedQuadricT(MeshT& mesh) : Quadric(mesh) {}

  // Called for all edges of a vertex one after another, of which the decimater
  // takes the one with the least error: shapes matter only where that is less
  // than before.
  float collapse_priority(const CollapseInfo& collapse) override {
    // In a plane, rounding can leave less than nothing, which is not allowed.
    const float error = std::max(Quadric::collapse_priority(collapse), 0.0f);
    if (collapse.v0 != vertex_) {
      vertex_ = collapse.v0;
      least_error_ = std::numeric_limits<float>::infinity();
    }
    if (error >= least_error_) {
      return error;
    }
    if (!KeepsTriangleShapes(Base::mesh(), collapse.v0v1)) {
      return float(Base::ILLEGAL_COLLAPSE);
    }
    least_error_ = error;
    return error;
  }
  void postprocess_collapse(const CollapseInfo& collapse) override {
    Quadric::postprocess_collapse(collapse);
    vertex_.invalidate();
    collapses.push_back(
        {uint32_t(collapse.v0.idx()), uint32_t(collapse.v1.idx())});
  }

  std::vector<Collapse> collapses;

 private:
  typename MeshT::VertexHandle vertex_;
  float least_error_ = 0;
};

class ProgressObserver : public decimater::Observer {
 public:
  explicit ProgressObserver(Phase* phase)
      : Observer(kInterval), phase_(phase) {}
  void notify(size_t /*step*/) override { phase_->Advance(kInterval); }

 private:
  Phase* phase_;
};

// Errors are areas times squared distances in floats: coordinates around one
// keep them from overflow and underflow. A power of two changes no digit.
void Center(SurfaceMesh* mesh) {
  Eigen::AlignedBox3d box;
  for (const auto vertex : mesh->vertices()) {
    box.extend(mesh->point(vertex));
  }
  const double scale =
      std::exp2(-std::floor(std::log2(box.sizes().maxCoeff())));
  for (const auto vertex : mesh->vertices()) {
    mesh->set_point(vertex, scale * (mesh->point(vertex) - box.center()));
  }
}

}  // namespace

std::vector<Collapse> FindCollapses(SurfaceMesh mesh,
                                    size_t num_triangles,
                                    const Context& context) {
  if (mesh.n_faces() <= num_triangles) {
    return {};
  }
  Center(&mesh);
  Phase phase(context, "simplification", (mesh.n_faces() - num_triangles) / 2);
  decimater::DecimaterT<SurfaceMesh> decimate(mesh);
  ModShapedQuadricT<SurfaceMesh>::Handle module;
  decimate.add(module);
  ProgressObserver observer(&phase);
  decimate.set_observer(&observer);
  decimate.initialize();
  decimate.decimate_to_faces(0, num_triangles);
  return std::move(decimate.module(module).collapses);
}

}  // namespace octacut
