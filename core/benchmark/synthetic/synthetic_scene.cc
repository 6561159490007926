#include "core/benchmark/synthetic/synthetic_scene.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <utility>

#include "core/base/check_option.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/base/srgb.h"
#include "core/benchmark/synthetic/sparse_points.h"
#include "core/mesh/audit.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/normals.h"

namespace octacut {

void StandOptions::Check() const {
  CheckOption(radius >= 0.2 && radius <= 10,
              "stand.radius",
              radius,
              "must be in [0.2, 10]");
  texture.Check();
}

void SceneSpec::Check() const {
  parameters.Check();
  reference.Check();
  rig.Check();
  texture.Check();
  lighting.Check();
  stand.Check();
  degrade.Check();
  CheckOption(
      num_points >= 0, "num_points", num_points, "must not be negative");
  CheckOption(observation_noise >= 0,
              "observation_noise",
              observation_noise,
              "must not be negative");
}

namespace {

IndexedMesh MeshOfTwoUnits(const IndexedMesh& given, const Context& context) {
  const Eigen::AlignedBox3d box = BoundingBox(given);
  IndexedMesh mesh;
  mesh.triangles = given.triangles;
  mesh.positions.reserve(given.positions.size());
  const double scale = 2 / box.sizes().maxCoeff();
  for (const Eigen::Vector3d& position : given.positions) {
    mesh.positions.emplace_back(scale * (position - box.center()));
  }
  mesh.normals = ComputeVertexNormals(mesh, context);
  return mesh;
}

void ColorReference(const TextureOptions& texture,
                    const Context& context,
                    IndexedMesh& mesh) {
  mesh.colors.resize(mesh.positions.size());
  ParallelEach(context, mesh.positions.size(), 1024, [&](size_t i) {
    const Eigen::Vector3f color =
        TextureColor(texture, mesh.positions[i].cast<float>());
    for (int k = 0; k < 3; ++k) {
      mesh.colors[i][k] =
          static_cast<uint8_t>(std::lround(255 * EncodeSrgb(color[k])));
    }
  });
}

}  // namespace

namespace {

// A mesh that holds first the object, then the stand.
IndexedMesh AddStand(const IndexedMesh& object,
                     const StandOptions& stand,
                     const PolygonizeOptions& reference,
                     const Context& context) {
  IndexedMesh mesh = object;
  if (!stand.is_there) {
    return mesh;
  }
  const Eigen::AlignedBox3d box = BoundingBox(object);
  double radius = 0;
  for (const Eigen::Vector3d& position : object.positions) {
    radius = std::max(radius, (position - box.center()).head<2>().norm());
  }
  constexpr double kHalfThickness = 0.04;  // of the radius
  radius *= stand.radius;
  const double half_height = kHalfThickness * radius;
  const ImplicitShape plate =
      Move(MakeCylinder(radius, half_height, half_height / 4),
           {box.center().x(), box.center().y(), box.min().z() - half_height});
  IndexedMesh part = Polygonize(plate, reference, context);
  ColorReference(stand.texture, context, part);
  const auto offset = uint32_t(mesh.positions.size());
  mesh.positions.insert(
      mesh.positions.end(), part.positions.begin(), part.positions.end());
  mesh.normals.insert(
      mesh.normals.end(), part.normals.begin(), part.normals.end());
  mesh.colors.insert(mesh.colors.end(), part.colors.begin(), part.colors.end());
  for (const auto& [a, b, c] : part.triangles) {
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return mesh;
}

// The sphere that the cameras are set up for, which is around the object alone.
void FrameObject(const IndexedMesh& object, RenderSubject* subject) {
  const Eigen::AlignedBox3d box = BoundingBox(object);
  subject->center = box.center();
  subject->radius = 0;
  for (const Eigen::Vector3d& position : object.positions) {
    subject->radius =
        std::max(subject->radius, (position - subject->center).norm());
  }
}

void RequireCamerasAbove(const std::vector<Rigid3d>& rig,
                         const IndexedMesh& object,
                         double min_elevation) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& position : object.positions) {
    lowest = std::min(lowest, position.z());
  }
  for (const Rigid3d& pose : rig) {
    CheckOption(pose.Inverse().translation.z() > lowest,
                "rig.min_elevation",
                min_elevation,
                "must be higher for a scene with a stand, which would hide the "
                "object from cameras below it");
  }
}

void AddViews(const RenderSubject& subject,
              const std::vector<Rigid3d>& rig,
              SyntheticScene* scene,
              const Context& context) {
  const SceneSpec& spec = scene->spec;
  Phase phase(context, "rendering", rig.size());
  for (size_t i = 0; i < rig.size(); ++i) {
    SyntheticView view;
    view.name = fmt::format("view_{:03}{}", i, spec.image_extension);
    view.lens = MakeLens(spec.rig);
    view.true_cam_from_world = rig[i];
    const uint64_t seed = HashBits(spec.seed, i);
    view.cam_from_world =
        DegradePose(spec.degrade, seed, view.lens.camera, rig[i]);
    RenderedView rendered = RenderView(subject, view.lens, rig[i], context);
    view.image = rendered.image;
    view.mask = rendered.mask;
    DegradeImage(spec.degrade, seed, view.image);
    DegradeMask(spec.degrade, seed, view.mask);
    scene->views.push_back(std::move(view));
    phase.Advance();
  }
}

// Four photographs, evenly over the turn. Without a stand there is no mesh to
// render, and none of what it would hide is missing behind a far, tiny one.
void AddEmptySet(const RenderSubject& subject,
                 const IndexedMesh& whole,
                 const std::vector<Rigid3d>& rig,
                 SyntheticScene* scene,
                 const Context& context) {
  constexpr size_t kNumPhotographs = 4;
  IndexedMesh stand;
  if (scene->spec.stand.is_there) {
    stand = whole;
    stand.triangles.erase(
        stand.triangles.begin(),
        stand.triangles.begin() + ptrdiff_t(subject.num_object_triangles));
  } else {
    stand.positions = {{0, 0, -1e4}, {1e-3, 0, -1e4}, {0, 1e-3, -1e4}};
    stand.normals.assign(3, Eigen::Vector3f::UnitZ());
    stand.triangles = {{0, 1, 2}};
  }
  const RayScene rays(stand);
  RenderSubject empty = MakeRenderSubject(stand,
                                          rays,
                                          scene->spec.stand.texture,
                                          subject.lighting,
                                          subject.background,
                                          context);
  empty.center = subject.center;
  empty.radius = subject.radius;
  // The wall is painted with what the object's texture says.
  empty.texture = subject.texture;
  empty.stand_texture = subject.stand_texture;
  empty.num_object_triangles = 0;
  for (size_t k = 0; k < kNumPhotographs; ++k) {
    const size_t i = k * rig.size() / kNumPhotographs;
    cv::Mat image =
        RenderView(empty, MakeLens(scene->spec.rig), rig[i], context).image;
    DegradeImage(scene->spec.degrade, HashBits(scene->spec.seed, i, 55), image);
    scene->empty_set.push_back(image);
  }
}

}  // namespace

SyntheticScene MakeScene(const SceneSpec& spec, const Context& context) {
  spec.Check();
  SyntheticScene scene;
  scene.spec = spec;
  if (spec.mesh) {
    scene.reference = MeshOfTwoUnits(*spec.mesh, context);
    const MeshAudit audit = AuditMesh(scene.reference, context);
    scene.object.genus = int(audit.genus);
    scene.object.num_components = int(audit.num_components);
  } else {
    scene.object = MakeObject(spec.object, spec.parameters);
    scene.reference = Polygonize(scene.object.shape, spec.reference, context);
  }
  const Material material =
      MakeMaterial(spec.material, spec.texture, spec.lighting);
  ColorReference(material.texture, context, scene.reference);
  const IndexedMesh whole =
      AddStand(scene.reference, spec.stand, spec.reference, context);
  const RayScene rays(whole);
  RenderSubject subject = MakeRenderSubject(whole,
                                            rays,
                                            material.texture,
                                            material.lighting,
                                            spec.background,
                                            context);
  subject.finish = material.finish;
  subject.num_object_triangles = scene.reference.triangles.size();
  subject.stand_texture = spec.stand.texture;
  FrameObject(scene.reference, &subject);
  const bool is_turntable = spec.rig.kind == RigKind::kTurntable;
  subject.background.fixed_to_camera |= is_turntable;
  const std::vector<Rigid3d> rig =
      MakeRig(spec.rig, subject.center, subject.radius);
  if (spec.stand.is_there) {
    RequireCamerasAbove(rig, scene.reference, spec.rig.min_elevation);
  }
  AddViews(subject, rig, &scene, context);
  if (is_turntable) {
    AddEmptySet(subject, whole, rig, &scene, context);
  }
  scene.points = SampleSparsePoints(scene, subject);
  return scene;
}

}  // namespace octacut
