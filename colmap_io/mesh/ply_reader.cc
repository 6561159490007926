#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "colmap_io/mesh/mesh_readers.h"
#include "colmap_io/mesh/ply_header.h"
#include "colmap_io/mesh/ply_values.h"

namespace octacut {
namespace {

// Where a vertex property goes: index into ten values, or nowhere.
constexpr int kNowhere = -1;
constexpr int kNormal = 3;
constexpr int kColor = 6;
constexpr int kConfidence = 9;
constexpr int kNumSlots = 10;

int SlotOf(std::string_view name) {
  constexpr std::array<std::string_view, kNumSlots> kNames = {
      "x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "confidence"};
  constexpr std::array<std::string_view, 3> kShort = {"r", "g", "b"};
  if (name.starts_with("diffuse_")) {
    name.remove_prefix(8);
  }
  for (int i = 0; i < kNumSlots; ++i) {
    if (name == kNames[i] || (i >= kColor && i < kConfidence &&
                              name == kShort[size_t(i - kColor)])) {
      return i;
    }
  }
  return kNowhere;
}

float FullScale(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 255;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 65535;
    default:
      return 0;  // floats: found out from the values
  }
}

struct VertexLayout {
  std::vector<int> slots;  // of the element's properties
  std::array<bool, kNumSlots> has = {};
  float color_scale = 0;

  bool HasAll(int first) const {
    return has[first] && has[first + 1] && has[first + 2];
  }
};

VertexLayout LayoutOf(const PlyElement& element, const ByteSource& source) {
  VertexLayout layout;
  for (const PlyProperty& property : element.properties) {
    int slot = property.is_list ? kNowhere : SlotOf(property.name);
    if (slot != kNowhere && layout.has[slot]) {
      slot = kNowhere;  // a second one of the same meaning
    }
    layout.slots.push_back(slot);
    if (slot != kNowhere) {
      layout.has[slot] = true;
      if (slot >= kColor && slot < kConfidence) {
        layout.color_scale = FullScale(property.type);
      }
    }
  }
  if (!layout.HasAll(0)) {
    source.Fail("element vertex has no properties x, y and z");
  }
  return layout;
}

class PlyBody {
 public:
  PlyBody(ByteSource* source, PlyHeader header)
      : header_(std::move(header)), values_(source, header_.encoding) {}

  PolygonMesh Run(std::vector<std::string>* notes) {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex" && !has_vertices) {
        has_vertices = true;
        ReadVertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        ReadFaces(element);
      } else {
        SkipElements(element);
      }
    }
    if (!has_vertices) {
      values_.Source().Fail("has no element vertex");
    }
    if (num_bad_normals_ > 0) {
      notes->push_back(
          fmt::format("{} vertex normals are not finite and were set to zero",
                      num_bad_normals_));
    }
    return std::move(mesh_);
  }

 private:
  size_t CheckedCount(const PlyElement& element) const {
    if (element.count > UINT32_MAX) {
      values_.Source().Fail(fmt::format(
          "element {} has the count {}", element.name, element.count));
    }
    return values_.Source().CheckedCount(
        element.count,
        element.MinBytes(header_.encoding),
        fmt::format("elements {}", element.name));
  }

  void ReadVertices(const PlyElement& element) {
    if (element.count == 0) {
      return;
    }
    const VertexLayout layout = LayoutOf(element, values_.Source());
    const size_t count = CheckedCount(element);
    const bool has_normals = layout.HasAll(kNormal);
    const bool has_colors = layout.HasAll(kColor);
    std::vector<Eigen::Vector3f> colors;
    std::vector<float> confidence;
    mesh_.positions.reserve(count);
    mesh_.normals.reserve(has_normals ? count : 0);
    colors.reserve(has_colors ? count : 0);
    std::array<double, kNumSlots> read = {};
    for (uint64_t i = 0; i < element.count; ++i) {
      values_.SetElement(&element, i);
      ReadVertex(element, layout, &read);
      mesh_.positions.emplace_back(read[0], read[1], read[2]);
      if (has_normals) {
        AppendNormal(Eigen::Vector3d(read[3], read[4], read[5]).cast<float>());
      }
      if (layout.has[kConfidence]) {
        if (!std::isfinite(read[kConfidence])) {
          values_.Fail("confidence is not finite");
        }
        confidence.push_back(float(read[kConfidence]));
      }
      if (has_colors) {
        colors.push_back(
            Eigen::Vector3d(read[6], read[7], read[8]).cast<float>());
      }
    }
    mesh_.confidence = std::move(confidence);
    mesh_.colors = QuantizeColors(colors, layout.color_scale);
  }

  void ReadVertex(const PlyElement& element,
                  const VertexLayout& layout,
                  std::array<double, kNumSlots>* read) {
    for (size_t p = 0; p < layout.slots.size(); ++p) {
      if (layout.slots[p] == kNowhere) {
        values_.SkipProperty(element.properties[p]);
      } else {
        (*read)[layout.slots[p]] = values_.Read(element.properties[p].type);
      }
    }
  }

  void AppendNormal(const Eigen::Vector3f& normal) {
    const bool is_finite = normal.allFinite();
    num_bad_normals_ += !is_finite;
    mesh_.normals.push_back(is_finite ? normal : Eigen::Vector3f::Zero());
  }

  void ReadFaces(const PlyElement& element) {
    size_t indices = element.properties.size();
    for (size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.is_list && (property.name == "vertex_indices" ||
                               property.name == "vertex_index")) {
        indices = p;
      }
    }
    if (indices == element.properties.size() && element.count > 0) {
      values_.Source().Fail(
          fmt::format("element {} has no list vertex_indices", element.name));
    }
    const size_t count = CheckedCount(element);
    mesh_.face_begins.reserve(mesh_.face_begins.size() + count);
    // Corners of triangles, as far as the file can hold them.
    mesh_.corners.reserve(
        mesh_.corners.size() +
        std::min<uint64_t>(3 * count, values_.Source().Remaining()));
    const bool are_strips = element.name == "tristrips";
    for (uint64_t i = 0; i < element.count; ++i) {
      values_.SetElement(&element, i);
      for (size_t p = 0; p < element.properties.size(); ++p) {
        if (p != indices) {
          values_.SkipProperty(element.properties[p]);
        } else if (are_strips) {
          ReadStrip(element.properties[p]);
        } else {
          ReadFace(element.properties[p]);
        }
      }
    }
  }

  uint32_t ToIndex(double value) const {
    if (!(value >= 0 && value < UINT32_MAX) || value != std::floor(value)) {
      values_.Fail(fmt::format("vertex index {} is invalid", value));
    }
    return static_cast<uint32_t>(value);
  }

  void ReadFace(const PlyProperty& list) {
    const uint64_t count = values_.ReadCount(list);
    for (uint64_t i = 0; i < count; ++i) {
      mesh_.corners.push_back(ToIndex(values_.Read(list.type)));
    }
    mesh_.EndFace();
  }

  // Every further vertex of a strip makes a triangle with the two before it,
  // turned over every other time; -1 begins a new strip.
  void ReadStrip(const PlyProperty& list) {
    const uint64_t count = values_.ReadCount(list);
    std::array<uint32_t, 2> last = {};
    uint64_t length = 0;
    for (uint64_t i = 0; i < count; ++i) {
      const double value = values_.Read(list.type);
      if (value == -1) {
        length = 0;
        continue;
      }
      const uint32_t vertex = ToIndex(value);
      if (length >= 2) {
        const bool is_turned = length % 2 != 0;
        mesh_.corners.push_back(last[is_turned ? 1 : 0]);
        mesh_.corners.push_back(last[is_turned ? 0 : 1]);
        mesh_.corners.push_back(vertex);
        mesh_.EndFace();
      }
      last = {last[1], vertex};
      ++length;
    }
  }

  void SkipElements(const PlyElement& element) {
    if (element.properties.empty()) {
      return;
    }
    values_.Source().CheckedCount(element.count,
                                  element.MinBytes(header_.encoding),
                                  fmt::format("elements {}", element.name));
    for (uint64_t i = 0; i < element.count; ++i) {
      values_.SetElement(&element, i);
      for (const PlyProperty& property : element.properties) {
        values_.SkipProperty(property);
      }
    }
  }

  PlyHeader header_;
  PlyValues values_;
  PolygonMesh mesh_;
  size_t num_bad_normals_ = 0;
};

}  // namespace

PolygonMesh ReadPly(ByteSource* source, std::vector<std::string>* notes) {
  PlyHeader header = ReadPlyHeader(source);
  return PlyBody(source, std::move(header)).Run(notes);
}

}  // namespace octacut
