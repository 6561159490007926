#include "plugin/page/page_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/benchmark/evaluate/mean_colors.h"
#include "core/mesh/cloud.h"
#include "core/mesh/normals.h"
#include "core/raycast/ray_scene.h"
#include "plugin/report.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

constexpr size_t kNumPlaces = 10;
// The share of the diagonal from which on neighbouring places can be told apart
// at a glance.
constexpr double kPlaceDistance = 0.02;
// Fewer vertices say too little of a place.
constexpr size_t kLeastVertices = 5;

std::string Quoted(const std::string& text) {
  const bool is_plain =
      !text.empty() && text.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWX"
                           "YZ0123456789_-./,=:+@") == std::string::npos;
  if (is_plain) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::string TextOf(const Json& value) {
  if (value.is_string()) {
    return Quoted(value.get<std::string>());
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "1" : "0";
  }
  if (value.is_array()) {
    std::string text;
    for (const Json& item : value) {
      text.append(text.empty() ? "" : ",").append(TextOf(item));
    }
    return text;
  }
  return value.dump();
}

// At most `count` of a cloud's points.
ClusteredMesh TakePoints(const IndexedMesh& cloud, size_t count) {
  ClusteredMesh display;
  display.is_simplified = count < cloud.positions.size();
  for (const SurfaceSample& point : SampleCloud(cloud, count)) {
    display.mesh.positions.push_back(point.point);
    display.sources.push_back(point.triangle);
  }
  return display;
}

}  // namespace

PageMesh MakePageMesh(const std::string& name,
                      const IndexedMesh& mesh,
                      size_t num_meshes,
                      const Context& context) {
  const Phase phase(context, fmt::format("Simplify {} for display", name));
  PageMesh page;
  page.name = name;
  page.num_triangles = mesh.triangles.size();
  page.num_points = mesh.triangles.empty() ? mesh.positions.size() : 0;
  const size_t most = kPageTriangles / num_meshes;
  page.display = mesh.triangles.empty() ? TakePoints(mesh, most)
                                        : ClusterVertices(mesh, most, context);
  return page;
}

void AddDistances(const std::string& other,
                  std::vector<float> distances,
                  PageMesh* page) {
  page->values.push_back({"distance", other, std::move(distances)});
}

void FindDistancePlaces(const IndexedMesh& mesh,
                        const std::vector<float>& values,
                        double diagonal,
                        const Context& context,
                        PageMesh* page) {
  std::vector<float> sizes(values.size());
  std::transform(values.begin(), values.end(), sizes.begin(), [](float value) {
    return std::abs(value);
  });
  page->place_kind = "distance";
  page->places = FindRemarkablePlaces(mesh,
                                      sizes,
                                      ComputeVertexNormals(mesh, context),
                                      kNumPlaces,
                                      kPlaceDistance * diagonal);
  for (RemarkablePlace& place : page->places) {
    place.value = values[place.vertex];
  }
}

void FindUnsupportedPlaces(const IndexedMesh& mesh,
                           const std::vector<float>& values,
                           double diagonal,
                           const Context& context,
                           PageMesh* page) {
  std::vector<float> means =
      CellMeans(mesh, values, kPlaceDistance / 2 * diagonal, kLeastVertices);
  for (float& mean : means) {
    mean = -mean;
  }
  page->place_kind = "support";
  page->places = FindRemarkablePlaces(mesh,
                                      means,
                                      ComputeVertexNormals(mesh, context),
                                      kNumPlaces,
                                      kPlaceDistance * diagonal);
  for (RemarkablePlace& place : page->places) {
    place.value = -place.value;
  }
}

void PaintFromPhotographs(const IndexedMesh& mesh,
                          const std::vector<View>& views,
                          const Context& context,
                          PageMesh* page) {
  const bool has_images =
      std::all_of(views.begin(), views.end(), [](const View& v) {
        return !v.image.empty();
      });
  if (views.empty() || !has_images) {
    return;
  }
  const IndexedMesh& display = page->display.mesh;
  page->colors = MeanColors(display.positions,
                            ComputeVertexNormals(display, context),
                            RayScene(mesh),
                            views,
                            context);
}

std::string CommandLineOf(const CommandEnvironment& environment) {
  std::string line = "octacut " + std::string(environment.command_name);
  for (const Option& option : environment.options.Options()) {
    if (!environment.options.IsSet(option.name)) {
      continue;
    }
    const Json value = option.to_json();
    if (option.repeatable) {
      for (const Json& item : value) {
        line += fmt::format(" --{} {}", option.name, TextOf(item));
      }
    } else {
      line += fmt::format(" --{} {}", option.name, TextOf(value));
    }
  }
  return line;
}

std::vector<std::string> ProcedureOfRun(const CommandEnvironment& environment) {
  return {fmt::format("Program: octacut {}, command {}, random seed {}.",
                      OctacutVersion(),
                      environment.command_name,
                      environment.context.Seed())};
}

}  // namespace octacut
