#include "core/benchmark/synthetic/synthetic_scene.h"

#include <cmath>

#include "core/base/check_option.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/benchmark/synthetic/sparse_points.h"
#include "core/raycast/tone_curve.h"

namespace octacut {

void SceneSpec::Check() const {
  parameters.Check();
  reference.Check();
  rig.Check();
  texture.Check();
  lighting.Check();
  degrade.Check();
  CheckOption(
      num_points >= 0, "num_points", num_points, "must not be negative");
  CheckOption(observation_noise >= 0,
              "observation_noise",
              observation_noise,
              "must not be negative");
}

SceneSpec QuickScene(const std::string& object,
                     int width,
                     int height,
                     int num_views) {
  SceneSpec spec;
  spec.object = object;
  spec.rig.width = width;
  spec.rig.height = height;
  spec.rig.num_views = num_views;
  spec.reference.resolution = 64;
  // Details of the texture must span pixels to be of use.
  spec.texture.scale *= std::max(1.0, 400.0 / width);
  spec.lighting.num_samples = 8;
  spec.num_points = 300;
  return spec;
}

namespace {

void ColorReference(const TextureOptions& texture,
                    const Context& context,
                    IndexedMesh& mesh) {
  mesh.colors.resize(mesh.positions.size());
  ParallelFor(
      context, mesh.positions.size(), 1024, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const Eigen::Vector3f color =
              TextureColor(texture, mesh.positions[i].cast<float>());
          for (int k = 0; k < 3; ++k) {
            mesh.colors[i][k] = static_cast<uint8_t>(
                std::lround(255 * ToneCurve::Encode(color[k])));
          }
        }
      });
}

}  // namespace

SyntheticScene MakeScene(const SceneSpec& spec, const Context& context) {
  spec.Check();
  SyntheticScene scene;
  scene.spec = spec;
  scene.object = MakeObject(spec.object, spec.parameters);
  scene.reference = Polygonize(scene.object.shape, spec.reference, context);
  const Material material =
      MakeMaterial(spec.material, spec.texture, spec.lighting);
  ColorReference(material.texture, context, scene.reference);
  const RayScene rays(scene.reference);
  RenderSubject subject = MakeRenderSubject(scene.reference,
                                            rays,
                                            material.texture,
                                            material.lighting,
                                            spec.background,
                                            context);
  subject.finish = material.finish;
  const std::vector<Rigid3d> rig =
      MakeRig(spec.rig, subject.center, subject.radius);
  Phase phase(context, "Rendering", rig.size());
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
    scene.views.push_back(std::move(view));
    phase.Advance();
  }
  scene.points = SampleSparsePoints(scene, rays);
  return scene;
}

Scene ToScene(const SyntheticScene& synthetic) {
  Scene scene;
  for (const SyntheticView& view : synthetic.views) {
    if (view.lens.k1 != 0) {
      throw InputError(
          fmt::format("synthetic view {}: k1 = {}, but the core's views are "
                      "undistorted",
                      view.name,
                      view.lens.k1));
    }
    scene.views.push_back({view.name,
                           view.lens.camera,
                           view.cam_from_world,
                           view.image,
                           view.mask});
  }
  for (const SyntheticPoint& point : synthetic.points) {
    scene.points.push_back(point.position);
  }
  return scene;
}

}  // namespace octacut
