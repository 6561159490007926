#include "colmap_io/mesh/glb_writer.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "colmap_io/mesh/output_buffer.h"
#include "colmap_io/mesh/split_vertices.h"
#include "core/base/error.h"
#include "core/base/srgb.h"

namespace octacut {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of glTF and OpenGL.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kClampToEdge = 33071;

Eigen::Vector3f UnitNormal(const Eigen::Vector3f& normal) {
  const Eigen::Vector3f unit = normal.cast<double>().normalized().cast<float>();
  return unit.allFinite() && unit.squaredNorm() > 0.5f
             ? unit
             : Eigen::Vector3f(0, 0, 1);
}

// Collects the JSON part and the bytes behind it.
class GlbBuilder {
 public:
  GlbBuilder() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "octacut"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"nodes", {0}}}};
    json_["nodes"] = {{{"mesh", 0}}};
    json_["meshes"] = {{{"primitives", Json::array()}}};
  }

  Json& Root() { return json_; }

  void AddPrimitive(Json primitive) {
    json_["meshes"][0]["primitives"].push_back(std::move(primitive));
  }

  // The accessor of `count` elements, whose bytes `fill` appends.
  template <typename Fill>
  int AddAccessor(const char* type,
                  int component,
                  size_t count,
                  int target,
                  const Fill& fill) {
    const size_t begin = bytes_.size();
    fill();
    json_["accessors"].push_back({{"bufferView", AddView(begin, target)},
                                  {"componentType", component},
                                  {"count", count},
                                  {"type", type}});
    return int(json_["accessors"].size()) - 1;
  }

  int AddPositions(const IndexedMesh& mesh,
                   const std::vector<uint32_t>& vertices) {
    Eigen::Vector3f low =
        Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Vector3f high = -low;
    const int accessor =
        AddAccessor("VEC3", kFloat, vertices.size(), kVertexBuffer, [&] {
          for (const uint32_t v : vertices) {
            const Eigen::Vector3f p = mesh.positions[v].cast<float>();
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
            Floats(p);
          }
        });
    json_["accessors"].back()["min"] = {low.x(), low.y(), low.z()};
    json_["accessors"].back()["max"] = {high.x(), high.y(), high.z()};
    return accessor;
  }

  int AddNormals(const IndexedMesh& mesh,
                 const std::vector<uint32_t>& vertices) {
    return AddAccessor("VEC3", kFloat, vertices.size(), kVertexBuffer, [&] {
      for (const uint32_t v : vertices) {
        Floats(UnitNormal(mesh.normals[v]));
      }
    });
  }

  // All four channels: vertices must begin at multiples of four bytes.
  int AddColors(const IndexedMesh& mesh,
                const std::vector<uint32_t>& vertices) {
    std::array<uint16_t, 256> linear;
    for (size_t i = 0; i < linear.size(); ++i) {
      linear[i] = uint16_t(std::lround(65535 * DecodeSrgb(double(i) / 255)));
    }
    const int accessor = AddAccessor(
        "VEC4", kUnsignedShort, vertices.size(), kVertexBuffer, [&] {
          for (const uint32_t v : vertices) {
            for (const uint8_t channel : mesh.colors[v]) {
              Short(linear[channel]);
            }
            Short(0xffff);
          }
        });
    json_["accessors"].back()["normalized"] = true;
    return accessor;
  }

  int AddIndices(const std::vector<std::array<uint32_t, 3>>& triangles) {
    return AddAccessor(
        "SCALAR", kUnsignedInt, 3 * triangles.size(), kIndexBuffer, [&] {
          for (const auto& triangle : triangles) {
            for (const uint32_t corner : triangle) {
              Word(corner);
            }
          }
        });
  }

  int AddTexture(const EncodedImage& image) {
    const size_t begin = bytes_.size();
    bytes_.append(image.bytes.begin(), image.bytes.end());
    const int view = AddView(begin, 0);
    json_["images"].push_back(
        {{"bufferView", view}, {"mimeType", image.mime_type}});
    if (!json_.contains("samplers")) {
      json_["samplers"] = {{{"magFilter", kLinear},
                            {"minFilter", kLinearMipmapLinear},
                            {"wrapS", kClampToEdge},
                            {"wrapT", kClampToEdge}}};
    }
    const int source = int(json_["images"].size()) - 1;
    json_["textures"].push_back({{"sampler", 0}, {"source", source}});
    return int(json_["textures"].size()) - 1;
  }

  template <typename Vector>
  void Floats(const Vector& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      Word(std::bit_cast<uint32_t>(values[i]));
    }
  }
  void Word(uint32_t value) {
    for (int byte = 0; byte < 4; ++byte) {
      bytes_.push_back(char(value >> (8 * byte) & 0xff));
    }
  }
  void Short(uint16_t value) {
    bytes_.push_back(char(value & 0xff));
    bytes_.push_back(char(value >> 8));
  }

  void Write(std::ostream& stream) {
    Pad(&bytes_, '\0');
    json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = json_.dump();
    Pad(&text, ' ');
    const size_t total = 12 + 8 + text.size() + 8 + bytes_.size();
    if (total > std::numeric_limits<uint32_t>::max()) {
      throw InputError(
          "a .glb file holds at most 4 GB; choose JPEG images, fewer texels or "
          "fewer triangles, or write .ply or .obj");
    }
    OutputBuffer out(&stream);
    out.Uint32(0x46546c67);  // "glTF"
    out.Uint32(2);
    out.Uint32(uint32_t(total));
    out.Uint32(uint32_t(text.size()));
    out.Uint32(0x4e4f534a);  // "JSON"
    out.Print("{}", text);
    out.Uint32(uint32_t(bytes_.size()));
    out.Uint32(0x004e4942);  // "BIN"
    out.Flush();
    stream.write(bytes_.data(), std::streamsize(bytes_.size()));
  }

 private:
  static void Pad(std::string* bytes, char filler) {
    bytes->resize((bytes->size() + 3) / 4 * 4, filler);
  }

  int AddView(size_t begin, int target) {
    Json view = {{"buffer", 0},
                 {"byteOffset", begin},
                 {"byteLength", bytes_.size() - begin}};
    if (target != 0) {
      view["target"] = target;
    }
    Pad(&bytes_, '\0');
    json_["bufferViews"].push_back(std::move(view));
    return int(json_["bufferViews"].size()) - 1;
  }

  Json json_;
  std::string bytes_;
};

Json Material(GlbBuilder* builder, const EncodedPages& pages, size_t page) {
  Json material = {{"name", "page_" + std::to_string(page)},
                   {"pbrMetallicRoughness",
                    {{"baseColorTexture",
                      {{"index", builder->AddTexture(pages.colors[page])}}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 1.0}}}};
  if (!pages.normals.empty()) {
    material["normalTexture"] = {
        {"index", builder->AddTexture(pages.normals[page])}};
  }
  return material;
}

}  // namespace

void WriteGlb(const IndexedMesh& mesh, std::ostream& stream) {
  GlbBuilder builder;
  std::vector<uint32_t> vertices(mesh.positions.size());
  for (size_t v = 0; v < vertices.size(); ++v) {
    vertices[v] = uint32_t(v);
  }
  Json attributes;
  attributes["POSITION"] = builder.AddPositions(mesh, vertices);
  if (!mesh.normals.empty()) {
    attributes["NORMAL"] = builder.AddNormals(mesh, vertices);
  }
  if (!mesh.colors.empty()) {
    attributes["COLOR_0"] = builder.AddColors(mesh, vertices);
  }
  const int indices = builder.AddIndices(mesh.triangles);
  builder.Root()["materials"] = {
      {{"pbrMetallicRoughness",
        {{"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}}};
  builder.AddPrimitive(
      {{"attributes", attributes}, {"indices", indices}, {"material", 0}});
  builder.Write(stream);
}

void WriteTexturedGlb(const TexturedMesh& mesh,
                      const EncodedPages& pages,
                      std::ostream& stream) {
  GlbBuilder builder;
  for (uint32_t page = 0; page < pages.colors.size(); ++page) {
    const SplitVertices split = SplitPage(mesh, page);
    if (split.triangles.empty()) {
      continue;
    }
    Json attributes;
    attributes["POSITION"] = builder.AddPositions(mesh.mesh, split.vertices);
    attributes["NORMAL"] = builder.AddNormals(mesh.mesh, split.vertices);
    attributes["TEXCOORD_0"] = builder.AddAccessor(
        "VEC2", kFloat, split.corners.size(), kVertexBuffer, [&] {
          for (const CornerOfTriangle& corner : split.corners) {
            builder.Floats(mesh.texcoords[corner.triangle][corner.corner]);
          }
        });
    if (!mesh.tangents.empty()) {
      attributes["TANGENT"] = builder.AddAccessor(
          "VEC4", kFloat, split.corners.size(), kVertexBuffer, [&] {
            for (const CornerOfTriangle& corner : split.corners) {
              builder.Floats(mesh.tangents[corner.triangle][corner.corner]);
            }
          });
    }
    const int indices = builder.AddIndices(split.triangles);
    // Making it adds members to the root, which moves those that are there.
    Json material = Material(&builder, pages, page);
    builder.Root()["materials"].push_back(std::move(material));
    builder.AddPrimitive(
        {{"attributes", attributes},
         {"indices", indices},
         {"material", builder.Root()["materials"].size() - 1}});
  }
  builder.Write(stream);
}

}  // namespace octacut
