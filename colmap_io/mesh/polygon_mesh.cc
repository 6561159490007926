#include "colmap_io/mesh/polygon_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numeric>
#include <utility>

#include "core/base/error.h"

namespace octacut {
namespace {

using Triangle = std::array<uint32_t, 3>;

// Clipping ears is quadratic.
constexpr size_t kMostCornersToClip = 512;

Eigen::Vector3d NewellNormal(const std::vector<Eigen::Vector3d>& positions,
                             std::span<const uint32_t> face) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& origin = positions[face[0]];
  for (size_t i = 1; i + 1 < face.size(); ++i) {
    normal +=
        (positions[face[i]] - origin).cross(positions[face[i + 1]] - origin);
  }
  return normal;
}

void AppendFan(std::span<const uint32_t> face,
               std::vector<Triangle>* triangles) {
  for (size_t i = 1; i + 1 < face.size(); ++i) {
    triangles->push_back({face[0], face[i], face[i + 1]});
  }
}

void AppendQuad(const std::vector<Eigen::Vector3d>& positions,
                std::span<const uint32_t> face,
                std::vector<Triangle>* triangles) {
  const Eigen::Vector3d normal = NewellNormal(positions, face);
  const auto area = [&](int a, int b, int c) {
    const Eigen::Vector3d& origin = positions[face[a]];
    return (positions[face[b]] - origin)
        .cross(positions[face[c]] - origin)
        .dot(normal);
  };
  const auto length = [&](int a, int b) {
    return (positions[face[a]] - positions[face[b]]).squaredNorm();
  };
  // A diagonal is inside when neither of its triangles is turned over.
  const double worst_02 = std::min(area(0, 1, 2), area(0, 2, 3));
  const double worst_13 = std::min(area(1, 2, 3), area(1, 3, 0));
  const bool both_inside = worst_02 > 0 && worst_13 > 0;
  const bool use_02 =
      both_inside ? length(0, 2) <= length(1, 3) : worst_02 >= worst_13;
  if (use_02) {
    AppendFan(face, triangles);
  } else {
    triangles->push_back({face[1], face[2], face[3]});
    triangles->push_back({face[1], face[3], face[0]});
  }
}

// A polygon in the plane, as a ring that loses an ear at a time.
class EarClipper {
 public:
  EarClipper(const std::vector<Eigen::Vector3d>& positions,
             std::span<const uint32_t> face)
      : face_(face) {
    const Eigen::Vector3d normal = NewellNormal(positions, face);
    int drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    const int u = (drop + 1) % 3;
    const int v = (drop + 2) % 3;
    const double sign = normal[drop] < 0 ? -1 : 1;
    for (const uint32_t vertex : face) {
      const Eigen::Vector3d p = positions[vertex] - positions[face[0]];
      points_.emplace_back(p[u], sign * p[v]);
    }
    ring_.resize(face.size());
    std::iota(ring_.begin(), ring_.end(), size_t{0});
  }

  void Run(std::vector<Triangle>* triangles) {
    size_t at = 0;
    size_t misses = 0;
    while (ring_.size() > 3) {
      // A polygon that crosses itself may have no ear: then any will do.
      if (!IsEar(at) && misses < ring_.size()) {
        at = (at + 1) % ring_.size();
        ++misses;
        continue;
      }
      Append(at, triangles);
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
      at = at == 0 ? 0 : (at + 1) % ring_.size();
      misses = 0;
    }
    Append(1, triangles);
  }

 private:
  std::array<size_t, 3> Corners(size_t at) const {
    const size_t n = ring_.size();
    return {ring_[(at + n - 1) % n], ring_[at], ring_[(at + 1) % n]};
  }

  double Area(size_t a, size_t b, size_t c) const {
    const Eigen::Vector2d ab = points_[b] - points_[a];
    const Eigen::Vector2d ac = points_[c] - points_[a];
    return ab.x() * ac.y() - ab.y() * ac.x();
  }

  bool IsEar(size_t at) const {
    const auto [a, b, c] = Corners(at);
    if (Area(a, b, c) <= 0) {
      return false;
    }
    for (const size_t p : ring_) {
      const bool is_corner = points_[p] == points_[a] ||
                             points_[p] == points_[b] ||
                             points_[p] == points_[c];
      if (!is_corner && Area(a, b, p) >= 0 && Area(b, c, p) >= 0 &&
          Area(c, a, p) >= 0) {
        return false;
      }
    }
    return true;
  }

  void Append(size_t at, std::vector<Triangle>* triangles) const {
    const auto [a, b, c] = Corners(at);
    triangles->push_back({face_[a], face_[b], face_[c]});
  }

  std::span<const uint32_t> face_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<size_t> ring_;
};

constexpr uint32_t kRemoved = UINT32_MAX;

template <typename Value>
void Keep(const std::vector<uint32_t>& kept, std::vector<Value>* values) {
  if (values->empty()) {
    return;
  }
  for (size_t i = 0; i < kept.size(); ++i) {
    (*values)[i] = (*values)[kept[i]];
  }
  values->resize(kept.size());
}

void CheckCorners(const PolygonMesh& mesh, const std::string& name) {
  for (size_t face = 0; face < mesh.NumFaces(); ++face) {
    for (const uint32_t vertex : mesh.Face(face)) {
      if (vertex >= mesh.positions.size()) {
        throw InputError(
            fmt::format("{}: face {}: vertex index {} is out of range, there "
                        "are {} vertices",
                        name,
                        face,
                        vertex,
                        mesh.positions.size()));
      }
    }
  }
}

}  // namespace

void RemoveNonFinite(const std::string& name,
                     PolygonMesh* mesh,
                     std::vector<std::string>* notes) {
  const size_t num_vertices = mesh->positions.size();
  std::vector<uint32_t> kept;
  std::vector<uint32_t> numbers(num_vertices, kRemoved);
  for (size_t v = 0; v < num_vertices; ++v) {
    if (mesh->positions[v].allFinite()) {
      numbers[v] = uint32_t(kept.size());
      kept.push_back(uint32_t(v));
    }
  }
  if (kept.size() == num_vertices) {
    return;
  }
  CheckCorners(*mesh, name);
  if (kept.empty()) {
    throw InputError(fmt::format("{}: no vertex has finite coordinates", name));
  }
  Keep(kept, &mesh->positions);
  Keep(kept, &mesh->normals);
  Keep(kept, &mesh->colors);
  Keep(kept, &mesh->confidence);
  PolygonMesh faces;
  for (size_t i = 0; i < mesh->NumFaces(); ++i) {
    const std::span<const uint32_t> face = mesh->Face(i);
    const auto is_removed = [&](uint32_t vertex) {
      return numbers[vertex] == kRemoved;
    };
    if (std::any_of(face.begin(), face.end(), is_removed)) {
      continue;
    }
    for (const uint32_t vertex : face) {
      faces.corners.push_back(numbers[vertex]);
    }
    faces.EndFace();
  }
  notes->push_back(fmt::format(
      "{} vertices whose coordinates are not finite, and the {} faces at them, "
      "are left out",
      num_vertices - kept.size(),
      mesh->NumFaces() - faces.NumFaces()));
  mesh->face_begins = std::move(faces.face_begins);
  mesh->corners = std::move(faces.corners);
}

IndexedMesh Triangulate(PolygonMesh mesh,
                        const std::string& name,
                        std::vector<std::string>* notes) {
  CheckCorners(mesh, name);
  IndexedMesh result;
  result.triangles.reserve(mesh.NumFaces());
  size_t num_polygons = 0;
  size_t num_too_small = 0;
  for (size_t i = 0; i < mesh.NumFaces(); ++i) {
    const std::span<const uint32_t> face = mesh.Face(i);
    num_polygons += face.size() > 3;
    num_too_small += face.size() < 3;
    if (face.size() == 4) {
      AppendQuad(mesh.positions, face, &result.triangles);
    } else if (face.size() > 4 && face.size() <= kMostCornersToClip) {
      EarClipper(mesh.positions, face).Run(&result.triangles);
    } else {
      AppendFan(face, &result.triangles);
    }
  }
  if (num_polygons > 0) {
    notes->push_back(fmt::format(
        "triangulated {} faces with more than three corners", num_polygons));
  }
  if (num_too_small > 0) {
    notes->push_back(fmt::format(
        "ignored {} faces with fewer than three corners", num_too_small));
  }
  result.positions = std::move(mesh.positions);
  result.normals = std::move(mesh.normals);
  result.colors = std::move(mesh.colors);
  result.confidence = std::move(mesh.confidence);
  return result;
}

std::vector<std::array<uint8_t, 3>> QuantizeColors(
    std::span<const Eigen::Vector3f> colors, float full_scale) {
  if (full_scale == 0) {
    const auto exceeds_one = [](const Eigen::Vector3f& color) {
      return color.maxCoeff() > 1;
    };
    const bool is_of_255 =
        std::any_of(colors.begin(), colors.end(), exceeds_one);
    full_scale = is_of_255 ? 255.f : 1.f;
  }
  std::vector<std::array<uint8_t, 3>> result(colors.size());
  for (size_t i = 0; i < colors.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const float value = colors[i][channel] / full_scale * 255.f;
      // Not a number becomes 0.
      result[i][channel] = static_cast<uint8_t>(
          value > 0 ? std::lround(std::min(value, 255.f)) : 0);
    }
  }
  return result;
}

}  // namespace octacut
