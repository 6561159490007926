#include "core/texture/texture_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <Eigen/Geometry>
#include <limits>

#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/mesh/normals.h"
#include "core/mesh/triangle_normal.h"
#include "core/raycast/ray_scene.h"
#include "core/texture/atlas_layout.h"
#include "core/texture/blend_weights.h"
#include "core/texture/choose_labels.h"
#include "core/texture/face_neighbors.h"
#include "core/texture/face_views.h"
#include "core/texture/fill_colors.h"
#include "core/texture/level_colors.h"
#include "core/texture/view_costs.h"

namespace octacut {
namespace {

// Pixels along a border between charts that cost as much as a square pixel of
// the worst view: charts are some 40 of them across where views differ by a
// twentieth, so that few borders are needed and most texels are from about the
// best view.
constexpr float kBorderCost = 1;

// The problem of the triangles that some view shows; `node_of_face` tells
// which.
LabelingProblem MakeProblem(
    const IndexedMesh& mesh,
    const std::vector<std::array<uint32_t, 3>>& neighbors,
    const FaceViews& views,
    const ViewCosts& costs,
    std::vector<uint32_t>* node_of_face) {
  LabelingProblem problem;
  node_of_face->assign(mesh.triangles.size(), kNoFace);
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto candidates = views.Of(f);
    if (candidates.empty()) {
      continue;
    }
    (*node_of_face)[f] = uint32_t(problem.NumNodes());
    const float resolution = costs.resolution[f];
    const float pixels =
        float(TriangleArea(mesh, mesh.triangles[f])) * resolution * resolution;
    for (size_t i = 0; i < candidates.size(); ++i) {
      problem.choices.push_back(
          {candidates[i].view, pixels * costs.costs[f][i]});
    }
    problem.first.push_back(uint32_t(problem.choices.size()));
  }
  for (uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t other = neighbors[f][k];
      if (other == kNoFace || other < f || (*node_of_face)[f] == kNoFace ||
          (*node_of_face)[other] == kNoFace) {
        continue;
      }
      const Eigen::Vector3d edge =
          mesh.positions[mesh.triangles[f][(k + 1) % 3]] -
          mesh.positions[mesh.triangles[f][k]];
      const float pixels = float(edge.norm()) *
                           (costs.resolution[f] + costs.resolution[other]) / 2;
      problem.edges.push_back(
          {(*node_of_face)[f], (*node_of_face)[other], kBorderCost * pixels});
    }
  }
  return problem;
}

std::vector<uint32_t> ChooseViews(
    const IndexedMesh& mesh,
    const std::vector<std::array<uint32_t, 3>>& neighbors,
    const FaceViews& views,
    const ViewCosts& costs,
    const Context& context,
    TextureSummary* summary) {
  std::vector<uint32_t> node_of_face;
  const LabelingProblem problem =
      MakeProblem(mesh, neighbors, views, costs, &node_of_face);
  const std::vector<uint32_t> labels = ChooseLabels(problem, context);
  summary->energy = LabelingEnergy(problem, labels);
  std::vector<uint32_t> chosen(mesh.triangles.size(), kNoView);
  for (size_t f = 0; f < chosen.size(); ++f) {
    if (node_of_face[f] != kNoFace) {
      chosen[f] = labels[node_of_face[f]];
    }
  }
  return chosen;
}

void Summarize(const IndexedMesh& mesh,
               const FaceViews& views,
               const std::vector<uint32_t>& chosen,
               TextureSummary* summary) {
  summary->num_triangles = mesh.triangles.size();
  double area = 0;
  for (size_t f = 0; f < chosen.size(); ++f) {
    const double own = TriangleArea(mesh, mesh.triangles[f]);
    area += own;
    if (chosen[f] == kNoView) {
      ++summary->num_unseen;
      summary->unseen_area += own;
    } else {
      ++summary->triangles_of_view[chosen[f]];
      summary->num_unsure += views.Of(f)[0].is_sure ? 0 : 1;
    }
  }
  summary->unseen_area /= std::max(area, std::numeric_limits<double>::min());
}

void CountPages(const AtlasLayout& layout,
                const PaintedPages& painted,
                TextureSummary* summary) {
  summary->num_charts = layout.charts.charts.size();
  for (const Chart& chart : layout.charts.charts) {
    summary->num_unseen_charts += chart.view == kNoView;
  }
  summary->num_pages = layout.packed.pages.size();
  summary->num_texels = painted.num_texels;
  summary->num_unfilled_texels = painted.num_unfilled;
  for (const PageSize& page : layout.packed.pages) {
    summary->page_texels += size_t(page.width) * size_t(page.height);
  }
}

TexturedMesh MakeTexturedMesh(const IndexedMesh& mesh,
                              const AtlasLayout& layout,
                              const Context& context) {
  TexturedMesh textured;
  textured.mesh = mesh;
  if (mesh.normals.empty()) {
    textured.mesh.normals = ComputeVertexNormals(mesh, context);
  }
  textured.charts = layout.charts.chart_of_face;
  for (const ChartPlace& place : layout.packed.places) {
    textured.page_of_chart.push_back(place.page);
  }
  textured.texcoords.resize(mesh.triangles.size());
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    const PageSize& size = layout.packed.pages[textured.PageOf(f)];
    const auto texels = layout.TexelsOf(f);
    for (size_t k = 0; k < 3; ++k) {
      textured.texcoords[f][k] = {float(texels[k].x() / size.width),
                                  float(texels[k].y() / size.height)};
    }
  }
  return textured;
}

void CheckInput(const IndexedMesh& mesh, const Photographs& photographs) {
  if (mesh.triangles.empty()) {
    throw InputError("the mesh has no triangles");
  }
  if (photographs.poses.empty()) {
    throw InputError("there are no photographs");
  }
  constexpr size_t kMost = std::numeric_limits<uint16_t>::max();
  if (photographs.poses.size() > kMost) {
    throw InputError(fmt::format(
        "{} photographs; at most {}", photographs.poses.size(), kMost));
  }
}

void RequireSeen(const TextureSummary& summary) {
  if (summary.num_unseen == summary.num_triangles) {
    throw MeshNotSeenError(fmt::format(
        "none of the {} photographs shows a triangle of the mesh: it is not in "
        "the frame of the sparse model, its triangles face inward, or the "
        "masks leave it out",
        summary.triangles_of_view.size()));
  }
}

AtlasLayout LayOut(const IndexedMesh& mesh,
                   const std::vector<std::array<uint32_t, 3>>& neighbors,
                   const std::vector<uint32_t>& chosen,
                   const std::vector<PhotographPose>& poses,
                   const TexturingOptions& options,
                   const Context& context) {
  AtlasLayout layout;
  const int chart_size = options.texture_size / kPackingCell * kPackingCell;
  layout.charts = MakeCharts(mesh,
                             neighbors,
                             chosen,
                             poses,
                             {options.texel_scale, chart_size},
                             context);
  layout.packed = PackCharts(
      layout.charts, {options.texture_size, options.max_pages}, context);
  return layout;
}

}  // namespace

void TexturingOptions::Check() const {
  CheckOption(texture_size >= 64 && texture_size <= 8192,
              "texture_size",
              texture_size,
              "must be in [64, 8192]");
  CheckOption(max_pages >= 1 && max_pages <= 1000,
              "max_pages",
              max_pages,
              "must be in [1, 1000]");
  CheckOption(texel_scale >= 0.01 && texel_scale <= 4,
              "texel_scale",
              texel_scale,
              "must be in [0.01, 4]");
}

TexturingResult TextureMesh(const IndexedMesh& mesh,
                            const Photographs& photographs,
                            const TexturingOptions& options,
                            const Context& context) {
  options.Check();
  CheckInput(mesh, photographs);
  TexturingResult result;
  TextureSummary& summary = result.summary;
  summary.triangles_of_view.resize(photographs.poses.size());
  const auto neighbors = FindFaceNeighbors(mesh);
  const VertexCorners vertex_faces =
      FindVertexFaces(mesh.positions.size(), mesh.triangles);
  const FaceViews views =
      FindFaceViews(mesh, RayScene(mesh), photographs, context);
  const ViewCosts costs =
      ComputeViewCosts(mesh, views, photographs.poses, context);
  const std::vector<uint32_t> chosen =
      ChooseViews(mesh, neighbors, views, costs, context, &summary);
  Summarize(mesh, views, chosen, &summary);
  RequireSeen(summary);
  summary.gains = costs.gains;
  AtlasLayout layout =
      LayOut(mesh, neighbors, chosen, photographs.poses, options, context);
  const FaceChoice known{views, costs, chosen};
  const VertexViews fading = FadeViews(mesh, vertex_faces, known, context);
  const VertexViews all_views = AllViews(mesh, vertex_faces, known, context);
  const std::vector<Eigen::Vector3f> corrections =
      LevelColors(mesh, vertex_faces, known, fading, context);
  const std::vector<Eigen::Vector3f> fill =
      FillColors(mesh, vertex_faces, known, context);
  SeamPoints seams(mesh, neighbors, layout);
  PaintedPages painted = PaintAtlas({mesh,
                                     layout,
                                     fading,
                                     all_views,
                                     corrections,
                                     costs.gains,
                                     fill,
                                     options.texel_scale,
                                     options.view_blending},
                                    photographs,
                                    context,
                                    &seams);
  result.textured = MakeTexturedMesh(mesh, layout, context);
  result.textured.pages = std::move(painted.pages);
  CountPages(layout, painted, &summary);
  summary.seams = seams.Measure(result.textured);
  result.layout = std::move(layout);
  return result;
}

}  // namespace octacut
