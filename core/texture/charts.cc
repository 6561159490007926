#include "core/texture/charts.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <utility>

#include "core/mesh/triangle_normal.h"
#include "core/texture/triangle_raster.h"

namespace octacut {
namespace {

// Filled colours have no detail of their own.
constexpr double kFilledDensity = 0.25;
// Overlaps are looked for on a grid of so many points per texel along a side.
constexpr int kOverlapGrid = 2;

using Texels = std::array<Eigen::Vector2d, 3>;

class ChartMaker {
 public:
  ChartMaker(const IndexedMesh& mesh,
             const std::vector<std::array<uint32_t, 3>>& neighbors,
             const std::vector<uint32_t>& views,
             const std::vector<PhotographPose>& poses,
             const ChartOptions& options)
      : mesh_(mesh),
        neighbors_(neighbors),
        poses_(poses),
        options_(options),
        planes_(views) {
    texels_.resize(mesh.triangles.size());
    const double density = ProjectSeen();
    ProjectUnseen(density);
    chart_of_face_.assign(mesh.triangles.size(), kNoChart);
  }

  Charts Run(const Context& context) {
    Phase phase(context, "charts", mesh_.triangles.size());
    for (size_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (chart_of_face_[f] == kNoChart) {
        const std::vector<uint32_t> faces = Grow(uint32_t(f));
        phase.Advance(faces.size());
        AddPieces(faces);
      }
    }
    return std::move(result_);
  }

 private:
  static constexpr uint32_t kNoChart = std::numeric_limits<uint32_t>::max();
  static constexpr uint32_t kPending = kNoChart - 1;

  // Returns the mean density, texels per unit of length.
  double ProjectSeen() {
    double area = 0;
    double texel_area = 0;
    for (size_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (planes_[f] == kNoView) {
        continue;
      }
      const PhotographPose& pose = poses_[planes_[f]];
      for (size_t k = 0; k < 3; ++k) {
        texels_[f][k] =
            options_.texel_scale *
            pose.camera.Project(pose.cam_from_world *
                                mesh_.positions[mesh_.triangles[f][k]]);
      }
      area += TriangleArea(mesh_, mesh_.triangles[f]);
      texel_area += std::abs(SignedArea(texels_[f]));
    }
    return area > 0 ? std::sqrt(texel_area / area) : 0;
  }

  void ProjectUnseen(double density) {
    const uint32_t num_views = uint32_t(poses_.size());
    for (size_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (planes_[f] != kNoView) {
        continue;
      }
      const Eigen::Vector3d normal = AreaNormal(mesh_, mesh_.triangles[f]);
      int axis = 0;
      normal.cwiseAbs().maxCoeff(&axis);
      const bool negative = normal[axis] < 0;
      planes_[f] = num_views + 2 * uint32_t(axis) + (negative ? 1 : 0);
      for (size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d& p = mesh_.positions[mesh_.triangles[f][k]];
        // Seen from outside, y down.
        const double x = p[(axis + 1) % 3];
        const double y = p[(axis + 2) % 3];
        texels_[f][k] =
            kFilledDensity * density * Eigen::Vector2d(negative ? -x : x, -y);
      }
      Shrink(uint32_t(f));
    }
  }

  // Until a triangle that no view sees, and which has nothing to show, fits
  // into a chart.
  void Shrink(uint32_t face) {
    const Eigen::AlignedBox2d box = BoxOf({face});
    const double limit = options_.max_size - 2 * (kChartMargin + 1);
    const double size = box.sizes().maxCoeff();
    if (size > limit) {
      for (Eigen::Vector2d& texel : texels_[face]) {
        texel = (texel - box.min()) * (limit / size);
      }
    }
  }

  static double SignedArea(const Texels& t) {
    const Eigen::Vector2d b = t[1] - t[0];
    const Eigen::Vector2d c = t[2] - t[0];
    return (b.x() * c.y() - b.y() * c.x()) / 2;
  }

  // The connected triangles of one plane that have no chart yet.
  std::vector<uint32_t> Grow(uint32_t seed) {
    std::vector<uint32_t> faces = {seed};
    chart_of_face_[seed] = kPending;
    for (size_t i = 0; i < faces.size(); ++i) {
      for (const uint32_t next : neighbors_[faces[i]]) {
        if (next != kNoFace && chart_of_face_[next] == kNoChart &&
            planes_[next] == planes_[seed]) {
          chart_of_face_[next] = kPending;
          faces.push_back(next);
        }
      }
    }
    return faces;
  }

  // The parts of `faces` that hang together, in the order of growing.
  std::vector<std::vector<uint32_t>> Components(
      const std::vector<uint32_t>& faces) {
    for (const uint32_t f : faces) {
      chart_of_face_[f] = kNoChart;
    }
    // Neighbours that are not of these have charts or are pending.
    std::vector<std::vector<uint32_t>> components;
    for (const uint32_t f : faces) {
      if (chart_of_face_[f] == kNoChart) {
        components.push_back(Grow(f));
      }
    }
    return components;
  }

  void AddPieces(std::vector<uint32_t> faces) {
    std::vector<std::vector<uint32_t>> pieces = {std::move(faces)};
    while (!pieces.empty()) {
      std::vector<uint32_t> piece = std::move(pieces.back());
      pieces.pop_back();
      std::vector<uint32_t> rest = TooLarge(&piece);
      if (rest.empty()) {
        rest = Overlapping(&piece);
      } else {
        // What was cut off may leave several pieces.
        Pend(rest);
        for (auto& component : Components(piece)) {
          pieces.push_back(std::move(component));
        }
        piece.clear();
      }
      if (!piece.empty()) {
        AddChart(std::move(piece));
      }
      if (!rest.empty()) {
        for (auto& component : Components(rest)) {
          pieces.push_back(std::move(component));
        }
      }
    }
  }

  void Pend(const std::vector<uint32_t>& faces) {
    for (const uint32_t f : faces) {
      chart_of_face_[f] = kPending;
    }
  }

  Eigen::AlignedBox2d BoxOf(const std::vector<uint32_t>& faces) const {
    Eigen::AlignedBox2d box;
    for (const uint32_t f : faces) {
      for (const Eigen::Vector2d& texel : texels_[f]) {
        box.extend(texel);
      }
    }
    return box;
  }

  static int SizeOf(double low, double high) {
    return int(std::ceil(high) - std::floor(low)) + 2 * kChartMargin;
  }

  // Takes half of the triangles away where the box exceeds the limit.
  std::vector<uint32_t> TooLarge(std::vector<uint32_t>* faces) const {
    const Eigen::AlignedBox2d box = BoxOf(*faces);
    const Eigen::Array2i size(SizeOf(box.min().x(), box.max().x()),
                              SizeOf(box.min().y(), box.max().y()));
    int axis = 0;
    if (size.maxCoeff(&axis) <= options_.max_size || faces->size() == 1) {
      return {};
    }
    const auto center = [&](uint32_t f) {
      return texels_[f][0][axis] + texels_[f][1][axis] + texels_[f][2][axis];
    };
    const auto middle = faces->begin() + faces->size() / 2;
    std::nth_element(
        faces->begin(), middle, faces->end(), [&](uint32_t a, uint32_t b) {
          return std::make_pair(center(a), a) < std::make_pair(center(b), b);
        });
    std::vector<uint32_t> rest(middle, faces->end());
    faces->erase(middle, faces->end());
    return rest;
  }

  // Takes the triangles away that overlap earlier ones.
  std::vector<uint32_t> Overlapping(std::vector<uint32_t>* faces) {
    if (faces->size() == 1) {
      return {};
    }
    const Eigen::AlignedBox2d box = BoxOf(*faces);
    const Eigen::Vector2d& low = box.min();
    const size_t width = size_t(box.sizes().x() * kOverlapGrid) + 2;
    const size_t height = size_t(box.sizes().y() * kOverlapGrid) + 2;
    taken_.assign(width * height, 0);
    std::vector<uint32_t> kept;
    std::vector<uint32_t> rest;
    for (const uint32_t f : *faces) {
      Texels grid;
      for (size_t k = 0; k < 3; ++k) {
        grid[k] = kOverlapGrid * (texels_[f][k] - low);
      }
      bool overlaps = false;
      ForPixelsInside(grid, int(width), int(height), [&](int x, int y) {
        overlaps = overlaps || taken_[size_t(y) * width + size_t(x)] != 0;
      });
      (overlaps ? rest : kept).push_back(f);
      if (!overlaps) {
        ForPixelsInside(grid, int(width), int(height), [&](int x, int y) {
          taken_[size_t(y) * width + size_t(x)] = 1;
        });
      }
    }
    *faces = std::move(kept);
    return rest;
  }

  void AddChart(std::vector<uint32_t> faces) {
    Chart chart;
    const Eigen::AlignedBox2d box = BoxOf(faces);
    const uint32_t plane = planes_[faces[0]];
    chart.view = plane < poses_.size() ? plane : kNoView;
    chart.width = SizeOf(box.min().x(), box.max().x());
    chart.height = SizeOf(box.min().y(), box.max().y());
    const Eigen::Vector2d origin =
        box.min().array().floor() - double(kChartMargin);
    result_.texels.resize(texels_.size());
    result_.chart_of_face.resize(texels_.size());
    for (const uint32_t f : faces) {
      chart_of_face_[f] = uint32_t(result_.charts.size());
      result_.chart_of_face[f] = chart_of_face_[f];
      for (size_t k = 0; k < 3; ++k) {
        result_.texels[f][k] = (texels_[f][k] - origin).cast<float>();
      }
    }
    std::sort(faces.begin(), faces.end());
    chart.faces = std::move(faces);
    result_.charts.push_back(std::move(chart));
  }

  const IndexedMesh& mesh_;
  const std::vector<std::array<uint32_t, 3>>& neighbors_;
  const std::vector<PhotographPose>& poses_;
  const ChartOptions& options_;
  // Views, and behind them six planes for triangles that no view shows.
  std::vector<uint32_t> planes_;
  std::vector<Texels> texels_;
  std::vector<uint32_t> chart_of_face_;
  std::vector<uint8_t> taken_;
  Charts result_;
};

}  // namespace

Charts MakeCharts(const IndexedMesh& mesh,
                  const std::vector<std::array<uint32_t, 3>>& neighbors,
                  const std::vector<uint32_t>& views,
                  const std::vector<PhotographPose>& poses,
                  const ChartOptions& options,
                  const Context& context) {
  return ChartMaker(mesh, neighbors, views, poses, options).Run(context);
}

}  // namespace octacut
