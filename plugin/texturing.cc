#include "plugin/texturing.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <opencv2/core.hpp>

#include "colmap_io/images/write_image.h"
#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/mesh/bounding_box.h"
#include "core/raycast/ray_scene.h"
#include "core/texture/bake_normals.h"
#include "core/texture/held_out_scores.h"
#include "core/texture/render_unlit.h"
#include "plugin/read_mesh.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// An object of which only one side was photographed may be half unseen.
constexpr double kMostUnseen = 0.5;

// In the order of their names, the first photograph of each `step` of them, or
// all others.
Photographs Subset(const Photographs& all, size_t step, bool first) {
  std::vector<size_t> order(all.poses.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return all.poses[a].name < all.poses[b].name;
  });
  Photographs subset;
  std::vector<size_t> numbers;
  for (size_t i = 0; i < order.size(); ++i) {
    if ((i % step == 0) == first) {
      numbers.push_back(order[i]);
      subset.poses.push_back(all.poses[order[i]]);
    }
  }
  subset.max_held = all.max_held;
  subset.load = [load = all.load, numbers](size_t i) {
    return load(numbers[i]);
  };
  return subset;
}

Json SummaryToJson(const TextureSummary& summary,
                   const PhotographSummary& files,
                   const Photographs& photographs) {
  Json views = Json::array();
  for (size_t v = 0; v < photographs.poses.size(); ++v) {
    const Eigen::Vector3f& gain = summary.gains[v];
    views.push_back({{"name", photographs.poses[v].name},
                     {"triangles", summary.triangles_of_view[v]},
                     {"exposure", {gain[2], gain[1], gain[0]}}});
  }
  return {{"photographs",
           {{"image_path", files.image_path.string()},
            {"model_path", files.model_path.string()},
            {"mask_path", files.mask_path.string()},
            {"registered_images", files.num_images},
            {"missing", files.num_missing},
            {"without_mask", files.num_without_mask},
            {"elsewhere", files.num_elsewhere},
            {"used", photographs.poses.size()}}},
          {"triangles", summary.num_triangles},
          {"unseen_triangles", summary.num_unseen},
          {"unseen_area_fraction", summary.unseen_area},
          {"unsure_triangles", summary.num_unsure},
          {"charts", summary.num_charts},
          {"unseen_charts", summary.num_unseen_charts},
          {"pages", summary.num_pages},
          {"page_texels", summary.page_texels},
          {"texels", summary.num_texels},
          {"unfilled_texels", summary.num_unfilled_texels},
          {"labelling_energy", summary.energy},
          {"seams",
           {{"points", summary.seams.num_points},
            {"mean_jump_before", summary.seams.before},
            {"mean_jump_after", summary.seams.after}}},
          {"views", views}};
}

TexturingResult Texture(const IndexedMesh& mesh,
                        const std::string& mesh_name,
                        const Photographs& photographs,
                        const TexturingOptions& options,
                        const Context& context) {
  try {
    TexturingResult result = TextureMesh(mesh, photographs, options, context);
    if (result.summary.unseen_area > kMostUnseen) {
      context.Warn(fmt::format(
          "{}: the photographs show only {:.0f} % of the surface; the rest "
          "continues the colours around it. Check that the mesh is in the "
          "frame of the sparse model.",
          mesh_name,
          100 * (1 - result.summary.unseen_area)));
    }
    return result;
  } catch (const MeshNotSeenError& error) {
    throw InputError(fmt::format("{}: {}", mesh_name, error.what()));
  }
}

Json AddNormalMap(const IndexedMesh& full,
                  const fs::path& path,
                  const Context& context,
                  TexturingResult* result) {
  const NormalMapSummary summary = NamingErrors(path.string(), [&] {
    return BakeNormals(full, result->layout, context, &result->textured);
  });
  context.Info(fmt::format(
      "Normal map: the normals of the denser mesh differ from those of the "
      "textured mesh by {:.2f} degrees on average. {:.2f} % of the texels are "
      "farther than {:.4g} units from the denser mesh and keep the normals of "
      "the textured mesh.",
      summary.mean_angle,
      100 * double(summary.num_missed) /
          double(std::max<size_t>(1, summary.num_texels)),
      summary.max_distance));
  return {{"path", path.string()},
          {"texels", summary.num_texels},
          {"missed_texels", summary.num_missed},
          {"max_distance", summary.max_distance},
          {"mean_angle_degrees", summary.mean_angle}};
}

Json ScoreMeshes(const TexturedMesh& textured,
                 const TexturingArguments& arguments,
                 const Photographs& held_out,
                 const Context& context) {
  std::vector<IndexedMesh> colored;
  std::vector<std::string> names = {"texture"};
  if (!textured.mesh.colors.empty()) {
    colored.push_back(textured.mesh);
    names.emplace_back("vertex colours of the same mesh");
  }
  for (const fs::path& path : arguments.compare_paths) {
    colored.push_back(ReadMeshAndLog(path, context).mesh);
    if (colored.back().colors.empty()) {
      throw InputError(
          fmt::format("{}: the mesh has no vertex colours", path.string()));
    }
    names.push_back(path.string());
  }
  const HeldOutScores held_out_scores =
      ScoreHeldOut(textured, colored, held_out, context);
  const std::vector<ImageScores>& scores = held_out_scores.meshes;
  Json meshes = Json::array();
  for (size_t i = 0; i < scores.size(); ++i) {
    context.Info(
        fmt::format("Photographs left out, {}: PSNR {:.2f} dB, SSIM "
                    "{:.4f}",
                    names[i],
                    scores[i].Psnr(),
                    scores[i].Ssim()));
    meshes.push_back({{"name", names[i]},
                      {"psnr", scores[i].Psnr()},
                      {"ssim", scores[i].Ssim()},
                      {"pixels", scores[i].num_pixels}});
  }
  return {{"views", held_out.poses.size()},
          {"noise_psnr", held_out_scores.noise.Psnr()},
          {"meshes", meshes}};
}

// In the view that textures most triangles, the first of several.
void WritePicture(const fs::path& path,
                  const TexturingResult& result,
                  const Photographs& photographs,
                  const Context& context,
                  AtomicFiles* files) {
  const auto& counts = result.summary.triangles_of_view;
  const auto view =
      size_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
  const PhotographPose& pose = photographs.poses[view];
  const RayScene rays(result.textured.mesh);
  const UnlitPicture unlit =
      RenderTexture(result.textured, rays, pose, context);
  cv::Mat textured(unlit.color.size(), CV_8UC3, cv::Scalar::all(255));
  unlit.color.copyTo(textured, unlit.covered);
  cv::Mat picture;
  cv::hconcat(
      std::vector<cv::Mat>{photographs.load(view).image,
                           textured,
                           RenderRelit(result.textured, rays, pose, context)},
      picture);
  WriteImage(path, picture, files);
}

}  // namespace

void TexturingArguments::Declare(OptionManager& options) {
  options.AddEnum(
      "view_blending",
      &texture.view_blending,
      {{"best", ViewBlending::kBest}, {"median", ViewBlending::kMedian}},
      "best: take the best photograph for each triangle, averaged with others "
      "that differ from it only by noise. median: take the median of the "
      "photographs at each texel, which removes highlights but loses some "
      "sharpness.");
  options.Add("texture_size",
              &texture.texture_size,
              "Maximum side of a texture image, texels.");
  options.Add(
      "max_pages", &texture.max_pages, "Maximum number of texture images.");
  options.Add("texel_scale",
              &texture.texel_scale,
              "Texels per pixel of the photographs along a side; less than 1 "
              "makes a smaller texture.");
  options.AddEnum(
      "image_format",
      &images.image_format,
      {{"png", TextureImageFormat::kPng}, {"jpeg", TextureImageFormat::kJpeg}},
      "Format of the texture's images.");
  options.Add("picture_path",
              &picture_path,
              "Picture to write (.png or .jpg): a photograph, the textured "
              "mesh from the same camera, and the textured mesh rendered with "
              "a different light. Default: none.");
  options.Add("normal_map_from",
              &normal_map_path,
              "Denser mesh of which mesh_path is a simplified version; its "
              "detail is baked into a normal map. output_path must end "
              "with .glb or .obj. Default: no normal map.");
  options
      .Add("hold_out",
           &hold_out,
           "Leave out every N-th photograph and report how well pictures of "
           "the textured mesh agree with it; 0 for none.")
      .ForExperts();
  options
      .AddRepeatable("compare_path",
                     &compare_paths,
                     "Mesh whose vertex colours are compared with the "
                     "photographs that hold_out leaves out.")
      .ForExperts();
}

void TexturingArguments::Check(FileRoles* files) const {
  texture.Check();
  CheckOption(hold_out == 0 || hold_out >= 2,
              "hold_out",
              hold_out,
              "must be 0, or at least 2");
  CheckOption(compare_paths.empty() || hold_out > 0,
              "compare_path",
              compare_paths.empty() ? "" : compare_paths[0].string(),
              "needs hold_out");
  CheckTexturedMeshPath(output_path);
  CheckOption(normal_map_path.empty() || CanHoldNormalMaps(output_path),
              "normal_map_from",
              normal_map_path.string(),
              "needs an output_path that ends with .glb or .obj: .ply files "
              "have no normal maps");
  files->Read(normal_map_path, "the mesh of normal_map_from");
  for (const fs::path& path : compare_paths) {
    files->Read(path, "a mesh of compare_path");
  }
  for (const fs::path& path : TexturedMeshPaths(
           output_path, images, texture.max_pages, !normal_map_path.empty())) {
    files->Write("output_path",
                 path,
                 path == output_path ? "the textured mesh"
                                     : "a file of the textured mesh");
  }
  if (!picture_path.empty()) {
    CheckImagePath("picture_path", picture_path);
    files->Write("picture_path", picture_path, "the picture");
  }
}

Json TextureAndWrite(const NamedMesh& mesh,
                     const fs::path& workspace_path,
                     PhotographOptions options,
                     const TexturingArguments& arguments,
                     const Context& context,
                     AtomicFiles* files) {
  if (mesh.mesh.triangles.empty()) {
    throw InputError(fmt::format("{}: the mesh has no faces", mesh.name));
  }
  options.box = BoxOfTriangles(mesh.mesh);
  const PhotographFiles opened =
      OpenPhotographs(workspace_path, options, context);
  const Photographs photographs =
      arguments.hold_out > 0
          ? Subset(opened.photographs, size_t(arguments.hold_out), false)
          : opened.photographs;
  // Errors of this file come before the long work.
  const IndexedMesh full =
      arguments.normal_map_path.empty()
          ? IndexedMesh()
          : ReadMeshAndLog(arguments.normal_map_path, context).mesh;
  TexturingResult result =
      Texture(mesh.mesh, mesh.name, photographs, arguments.texture, context);
  Json json = SummaryToJson(result.summary, opened.summary, photographs);
  if (!arguments.normal_map_path.empty()) {
    json["normal_map"] =
        AddNormalMap(full, arguments.normal_map_path, context, &result);
  }
  if (arguments.hold_out > 0) {
    json["held_out"] = ScoreMeshes(
        result.textured,
        arguments,
        Subset(opened.photographs, size_t(arguments.hold_out), true),
        context);
  }
  Json written = Json::array();
  for (const fs::path& path : WriteTexturedMesh(
           arguments.output_path, result.textured, arguments.images, files)) {
    written.push_back(path.string());
  }
  json["files"] = written;
  if (!arguments.picture_path.empty()) {
    WritePicture(arguments.picture_path, result, photographs, context, files);
  }
  return json;
}

}  // namespace octacut
