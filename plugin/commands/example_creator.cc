#include "plugin/commands/example_creator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "colmap_io/files/resolved_path.h"
#include "core/base/check_option.h"
#include "core/benchmark/synthetic/synthetic_scene.h"
#include "plugin/closed_mesh.h"
#include "plugin/example_workspace.h"
#include "plugin/report.h"

namespace octacut {
namespace {

class ExampleCreator : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  bool UsesRandomSeed() const override { return true; }
  void Run(const CommandEnvironment& environment) override;

 private:
  std::filesystem::path output_path_;
  std::filesystem::path mesh_path_;
  ExampleWorkspaceOptions workspace_;
  SceneSpec scene_;
};

void DeclareDegradation(OptionManager& options, DegradeOptions* degrade) {
  options.Add("Degrade.pixel_noise",
              &degrade->pixel_noise,
              "Standard deviation of the image noise in grey levels.");
  options
      .Add("Degrade.exposure_noise",
           &degrade->exposure_noise,
           "Standard deviation of the exposure of the images relative to 1.")
      .ForExperts();
  options.Add("Degrade.mask_offset",
              &degrade->mask_offset,
              "Number of pixels by which all masks are too large, or too small "
              "if negative.");
  options.Add("Degrade.num_mask_holes",
              &degrade->num_mask_holes,
              "Number of holes inside the object of each mask.");
  options
      .Add("Degrade.num_mask_specks",
           &degrade->num_mask_specks,
           "Number of specks in the background of each mask.")
      .ForExperts();
  options
      .Add("Degrade.mask_defect_radius",
           &degrade->mask_defect_radius,
           "Radius of holes and specks in pixels.")
      .ForExperts();
  options.Add("Degrade.pose_noise",
              &degrade->pose_noise,
              "Standard deviation of the pose errors, measured in pixels in "
              "the image.");
}

void DeclareForm(OptionManager& options, SceneSpec* scene) {
  options
      .Add("Scene.cup_depth",
           &scene->parameters.cup_depth,
           "Depth of the cup's cavity relative to its diameter.")
      .ForExperts();
  options
      .Add("Scene.rod_radius",
           &scene->parameters.rod_radius,
           "Radius of the rods, whose length is 1.8.")
      .ForExperts();
  options
      .Add("Scene.finger_radius",
           &scene->parameters.finger_radius,
           "Radius of the fingertips of the hand, whose size is about 1.6.")
      .ForExperts();
  options
      .Add("Scene.fold_width",
           &scene->parameters.fold_width,
           "Width of the widest folds of the drapery; the narrowest are a "
           "fifth as wide.")
      .ForExperts();
  options
      .Add("Scene.fold_depth",
           &scene->parameters.fold_depth,
           "Depth of the folds of the drapery relative to their width.")
      .ForExperts();
}

// What the object's surface looks like.
void DeclareSurface(OptionManager& options, SceneSpec* scene) {
  options.AddEnum("Scene.material",
                  &scene->material,
                  {{"diffuse", MaterialKind::kDiffuse},
                   {"metal", MaterialKind::kMetal},
                   {"porcelain", MaterialKind::kPorcelain},
                   {"plaster", MaterialKind::kPlaster}},
                  "Material of the object. All except diffuse come with their "
                  "own lights and almost no texture.");
  options.AddEnum("Scene.texture",
                  &scene->texture.kind,
                  {{"plain", TextureKind::kPlain},
                   {"marble", TextureKind::kMarble},
                   {"speckle", TextureKind::kSpeckle},
                   {"painted", TextureKind::kPainted}},
                  "Texture of the object.");
  options
      .Add("Scene.texture_contrast",
           &scene->texture.contrast,
           "Contrast of the texture, from 0 (none) to 1 (full).")
      .ForExperts();
  options
      .Add("Scene.texture_scale",
           &scene->texture.scale,
           "Size of the largest texture features; the object is about 2 in "
           "size.")
      .ForExperts();
  options
      .Add("Scene.plain_share",
           &scene->texture.plain_share,
           "Share of the surface without texture, 0 to 1.")
      .ForExperts();
  options
      .Add("Scene.plain_size",
           &scene->texture.plain_size,
           "Size of the parts without texture; the object is about 2 in size.")
      .ForExperts();
}

// What is around the object.
void DeclareSurroundings(OptionManager& options, SceneSpec* scene) {
  options
      .AddEnum(
          "Scene.background",
          &scene->background.kind,
          {{"plain", BackgroundKind::kPlain}, {"room", BackgroundKind::kRoom}},
          "Background behind the object.")
      .ForExperts();
  options
      .Add("Scene.stand",
           &scene->stand.is_there,
           "If 1, the object stands on a round plate, which turns with it "
           "and is not in the masks.")
      .ForExperts();
  options.Add("Scene.lights_fixed_to_camera",
              &scene->lighting.fixed_to_camera,
              "If 1, the lights move with the camera, as if the object stood "
              "on a turntable.");
  options.Add("Scene.specular",
              &scene->lighting.specular,
              "Strength of the highlights; 0 is matt.");
}

// How the cameras stand around the object.
void DeclareRig(OptionManager& options, RigOptions* rig) {
  options.AddEnum(
      "Rig.kind",
      &rig->kind,
      {{"sphere", RigKind::kSphere},
       {"rings", RigKind::kRings},
       {"turntable", RigKind::kTurntable}},
      "Arrangement of the cameras around the object. On a turntable, a "
      "room stands still with the camera.");
  options
      .Add("Rig.min_elevation",
           &rig->min_elevation,
           "Minimum elevation of the cameras above the horizon of the "
           "object in degrees.")
      .ForExperts();
  options
      .Add("Rig.max_elevation",
           &rig->max_elevation,
           "Maximum elevation of the cameras above the horizon of the "
           "object in degrees.")
      .ForExperts();
  options
      .Add("Rig.focal_length",
           &rig->focal_length,
           "Focal length relative to the larger side of the image.")
      .ForExperts();
  options
      .Add("Rig.fill",
           &rig->fill,
           "Size of the object relative to the smaller side of the image.")
      .ForExperts();
  options
      .Add("Rig.far_factor",
           &rig->far_factor,
           "Factor by which every second camera is farther away.")
      .ForExperts();
  options
      .Add("Rig.k1",
           &rig->k1,
           "Coefficient of radial distortion (SIMPLE_RADIAL).")
      .ForExperts();
}

void ExampleCreator::DeclareOptions(OptionManager& options) {
  options.AddRequired("output_path",
                      &output_path_,
                      "Folder in which the workspace is created.");
  options.Add("overwrite",
              &workspace_.overwrite,
              "If 1, replace an earlier example in output_path: its folders "
              "images, masks, background, sparse/0 and gt are deleted.");
  options.Add("scene",
              &scene_.object,
              fmt::format("Object to create. One of: {}.",
                          fmt::join(ObjectNames(), ", ")));
  options.Add("mesh_path",
              &mesh_path_,
              "Closed mesh (PLY, OBJ, OFF or STL) to photograph instead of an "
              "object of --scene, z upward. It is scaled to two units.");
  options.Add("num_views", &scene_.rig.num_views, "Number of photographs.");
  options.Add(
      "width", &scene_.rig.width, "Width of the photographs in pixels.");
  options.Add(
      "height", &scene_.rig.height, "Height of the photographs in pixels.");
  options
      .Add("image_extension",
           &scene_.image_extension,
           "File format of the photographs, .jpg or .png.")
      .ForExperts();
  options
      .Add("jpeg_quality",
           &workspace_.jpeg_quality,
           "Quality of JPEG files, 1 to 100.")
      .ForExperts();
  options
      .Add("num_points", &scene_.num_points, "Maximum number of sparse points.")
      .ForExperts();
  options
      .Add("observation_noise",
           &scene_.observation_noise,
           "Standard deviation in pixels of the observations of sparse points.")
      .ForExperts();
  options.Add("reference_resolution",
              &scene_.reference.resolution,
              "Number of cells along the longest side of the reference mesh.");
  DeclareRig(options, &scene_.rig);
  DeclareForm(options, &scene_);
  DeclareSurface(options, &scene_);
  DeclareSurroundings(options, &scene_);
  DeclareDegradation(options, &scene_.degrade);
}

bool IsInFolder(const std::filesystem::path& path,
                const std::filesystem::path& folder) {
  const auto relative =
      ResolvedPath(path).lexically_relative(ResolvedPath(folder));
  return !relative.empty() && *relative.begin() != "..";
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
  CheckExampleFolder(output_path_, workspace_);
  if (!mesh_path_.empty()) {
    CheckOption(!IsInFolder(mesh_path_, output_path_),
                "mesh_path",
                mesh_path_.string(),
                "must not lie in output_path");
    scene_.mesh = ReadClosedMesh(mesh_path_, context);
  }
  const SyntheticScene scene = [&] {
    const Phase phase(context, "creation of the scene");
    return MakeScene(scene_, context);
  }();
  PrepareExampleFolder(output_path_, workspace_);
  const std::filesystem::path report_path = output_path_ / kExampleReportName;
  Json report = MakeReport(environment);
  report["complete"] = false;  // of an interrupted run
  WriteReport(report_path, report);
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
