#include "core/simplify/collapse_sequence.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <string>

#include "core/simplify/collapse_rules.h"

namespace octacut {
namespace {

namespace decimater = OpenMesh::Decimater;

// Collapses between two looks at whether the run is to stop.
constexpr size_t kInterval = 4096;

// Refuses collapses that spoil triangles and notes those that are made.
template <typename MeshT>
class ModRecorderT : public decimater::ModBaseT<MeshT> {
 public:
  // The macro's names are OpenMesh's.
  DECIMATING_MODULE(ModRecorderT, MeshT, Recorder);  // NOLINT

  explicit ModRecorderT(MeshT& mesh) : Base(mesh, /*_is_binary=*/true) {}

  float collapse_priority(const CollapseInfo& collapse) override {
    return KeepsTriangleShapes(Base::mesh(), collapse.v0v1)
               ? float(Base::LEGAL_COLLAPSE)
               : float(Base::ILLEGAL_COLLAPSE);
  }
  void postprocess_collapse(const CollapseInfo& collapse) override {
    collapses.push_back(
        {uint32_t(collapse.v0.idx()), uint32_t(collapse.v1.idx())});
  }

  std::vector<Collapse> collapses;
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
SurfaceMesh CenteredMesh(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : mesh.positions) {
    box.extend(position);
  }
  const double scale =
      std::exp2(-std::floor(std::log2(box.sizes().maxCoeff())));
  IndexedMesh centered;
  centered.triangles = mesh.triangles;
  centered.positions = mesh.positions;
  for (Eigen::Vector3d& position : centered.positions) {
    position = scale * (position - box.center());
  }
  return ToSurfaceMesh(centered);
}

}  // namespace

std::vector<Collapse> FindCollapses(const IndexedMesh& mesh,
                                    size_t num_triangles,
                                    const Context& context) {
  if (mesh.triangles.size() <= num_triangles) {
    return {};
  }
  SurfaceMesh surface = CenteredMesh(mesh);
  Phase phase(context,
              "simplification",
              (mesh.triangles.size() - num_triangles) / 2);
  decimater::DecimaterT<SurfaceMesh> decimate(surface);
  decimater::ModQuadricT<SurfaceMesh>::Handle quadric;
  ModRecorderT<SurfaceMesh>::Handle recorder;
  decimate.add(recorder);
  decimate.add(quadric);
  ProgressObserver observer(&phase);
  decimate.set_observer(&observer);
  decimate.initialize();
  decimate.decimate_to_faces(0, num_triangles);
  return std::move(decimate.module(recorder).collapses);
}

}  // namespace octacut
