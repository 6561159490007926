#include "plugin/commands/example_creator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/check_option.h"
#include "core/synthetic/synthetic_scene.h"
#include "plugin/example_workspace.h"
#include "plugin/report.h"

namespace octacut {
namespace {

class ExampleCreator : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  std::filesystem::path output_path_;
  ExampleWorkspaceOptions workspace_;
  SceneSpec scene_;
};

void DeclareDegradation(OptionManager& options, DegradeOptions* degrade) {
  options.Add("Degrade.pixel_noise",
              &degrade->pixel_noise,
              "Standard deviation of the images' noise, grey levels");
  options.Add("Degrade.exposure_noise",
              &degrade->exposure_noise,
              "Standard deviation of each image's exposure, as a factor - 1");
  options.Add("Degrade.mask_offset",
              &degrade->mask_offset,
              "Pixels by which masks are too large, or too small (< 0)");
  options.Add("Degrade.num_mask_holes",
              &degrade->num_mask_holes,
              "Holes in the object of each mask");
  options.Add("Degrade.num_mask_specks",
              &degrade->num_mask_specks,
              "Specks in the background of each mask");
  options.Add("Degrade.mask_defect_radius",
              &degrade->mask_defect_radius,
              "Radius of holes and specks, pixels");
  options.Add("Degrade.pose_noise",
              &degrade->pose_noise,
              "Standard deviation of the poses' error, pixels in the image");
}

// The object's form and what its surface looks like.
void DeclareSurface(OptionManager& options, SceneSpec* scene) {
  options.Add("Scene.cup_depth",
              &scene->parameters.cup_depth,
              "Of the cup's cavity, in its diameters");
  options.Add("Scene.rod_radius",
              &scene->parameters.rod_radius,
              "Of the rods, whose length is 1.8");
  options.Add("Scene.finger_radius",
              &scene->parameters.finger_radius,
              "Of the fingers' tips; the hand is about 1.6 in size");
  options.Add("Scene.fold_width",
              &scene->parameters.fold_width,
              "Of the drapery's widest folds; the narrowest have a fifth");
  options.Add("Scene.fold_depth",
              &scene->parameters.fold_depth,
              "Of the drapery's folds, in their widths");
  options.AddEnum("Scene.material",
                  &scene->material,
                  {{"diffuse", MaterialKind::kDiffuse},
                   {"metal", MaterialKind::kMetal},
                   {"porcelain", MaterialKind::kPorcelain},
                   {"plaster", MaterialKind::kPlaster}},
                  "Of the object; all but diffuse bring their own lights and "
                  "next to no texture");
  options.AddEnum("Scene.texture",
                  &scene->texture.kind,
                  {{"plain", TextureKind::kPlain},
                   {"marble", TextureKind::kMarble},
                   {"speckle", TextureKind::kSpeckle},
                   {"painted", TextureKind::kPainted}},
                  "Texture of the object");
  options.Add("Scene.texture_contrast",
              &scene->texture.contrast,
              "0: plain, 1: in full");
  options.Add("Scene.texture_scale",
              &scene->texture.scale,
              "Size of its largest features; the object is about 2 in size");
  options.Add("Scene.plain_share",
              &scene->texture.plain_share,
              "Of the object's parts those without texture, 0 .. 1");
  options.Add("Scene.plain_size", &scene->texture.plain_size, "Of such parts");
  options.AddEnum(
      "Scene.background",
      &scene->background.kind,
      {{"plain", BackgroundKind::kPlain}, {"room", BackgroundKind::kRoom}},
      "What is behind the object");
  options.Add("Scene.lights_fixed_to_camera",
              &scene->lighting.fixed_to_camera,
              "1: the lights turn with the camera, as on a turntable");
  options.Add("Scene.specular",
              &scene->lighting.specular,
              "Strength of highlights; 0: matte");
}

void ExampleCreator::DeclareOptions(OptionManager& options) {
  options.AddRequired("output_path", &output_path_, "Folder of the workspace");
  options.Add("overwrite",
              &workspace_.overwrite,
              "1: replace an earlier example in that folder");
  options.Add("scene",
              &scene_.object,
              fmt::format("Object {{{}}}", fmt::join(ObjectNames(), ", ")));
  options.Add("num_views", &scene_.rig.num_views, "Number of photographs");
  options.Add("width", &scene_.rig.width, "Of the photographs, pixels");
  options.Add("height", &scene_.rig.height, "Of the photographs, pixels");
  options.Add("image_extension", &scene_.image_extension, ".jpg or .png");
  options.Add("jpeg_quality", &workspace_.jpeg_quality, "1 to 100");
  options.Add("num_points", &scene_.num_points, "Sparse points at most");
  options.Add("observation_noise",
              &scene_.observation_noise,
              "Standard deviation of the sparse points' observations, pixels");
  options.Add("reference_resolution",
              &scene_.reference.resolution,
              "Cells of the reference mesh along its longest side");
  options.AddEnum("Rig.kind",
                  &scene_.rig.kind,
                  {{"sphere", RigKind::kSphere},
                   {"rings", RigKind::kRings},
                   {"turntable", RigKind::kTurntable}},
                  "How the cameras stand around the object");
  options.Add("Rig.min_elevation",
              &scene_.rig.min_elevation,
              "Of the cameras above the object's horizon, degrees");
  options.Add("Rig.max_elevation", &scene_.rig.max_elevation, "Degrees");
  options.Add("Rig.focal_length",
              &scene_.rig.focal_length,
              "In units of the image's larger side");
  options.Add("Rig.fill",
              &scene_.rig.fill,
              "Size of the object in units of the image's smaller side");
  options.Add("Rig.far_factor",
              &scene_.rig.far_factor,
              "Every second camera stands so many times as far");
  options.Add("Rig.k1", &scene_.rig.k1, "Radial distortion (SIMPLE_RADIAL)");
  DeclareSurface(options, &scene_);
  DeclareDegradation(options, &scene_.degrade);
}

void ExampleCreator::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  scene_.seed = context.Seed();
  CheckOption(
      scene_.image_extension == ".jpg" || scene_.image_extension == ".png",
      "image_extension",
      scene_.image_extension,
      "must be .jpg or .png");
  const std::vector<std::string> objects = ObjectNames();
  CheckOption(
      std::find(objects.begin(), objects.end(), scene_.object) != objects.end(),
      "scene",
      scene_.object,
      fmt::format("must be one of {}", fmt::join(objects, ", ")));
  scene_.Check();
  PrepareExampleFolder(output_path_, workspace_);
  const std::filesystem::path report_path = output_path_ / kExampleReportName;
  Json report = MakeReport(environment);
  report["complete"] = false;  // of an interrupted run
  WriteReport(report_path, report);

  const SyntheticScene scene = [&] {
    const Phase phase(context, "Creating the scene");
    return MakeScene(scene_, context);
  }();
  WriteExampleWorkspace(scene, output_path_, workspace_, context);

  report = MakeReport(environment);
  report["views"] = scene.views.size();
  report["points"] = scene.points.size();
  report["reference"] = {{"path", "gt/reference.ply"},
                         {"vertices", scene.reference.positions.size()},
                         {"triangles", scene.reference.triangles.size()},
                         {"genus", scene.object.genus},
                         {"components", scene.object.num_components}};
  report["complete"] = true;
  WriteReport(report_path, report);
  environment.out << fmt::format(
      "{} views, {} sparse points, reference mesh of {} triangles in {}\n",
      scene.views.size(),
      scene.points.size(),
      scene.reference.triangles.size(),
      output_path_.string());
}

}  // namespace

std::unique_ptr<Command> MakeExampleCreator() {
  return std::make_unique<ExampleCreator>();
}

}  // namespace octacut
