#include <fmt/format.h>
#include <Model/COM/NMR_DLLInterfaces.h>

#include <bit>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "colmap_io/mesh/mesh_writers.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/mesh/bounding_box.h"

namespace octacut {
namespace {

// Throws with the library's own words about `object`.
void Require(int result, NMR::PLib3MFBase* object) {
  if (result == 0) {
    return;
  }
  uint32_t code = 0;
  const char* message = nullptr;
  NMR::lib3mf_getlasterror(object, &code, &message);
  throw Error(fmt::format(
      "lib3mf: error {}: {}", code, message == nullptr ? "" : message));
}

struct Release {
  void operator()(NMR::PLib3MFBase* object) const {
    NMR::lib3mf_release(object);
  }
};
using Object = std::unique_ptr<NMR::PLib3MFBase, Release>;

// The library writes millionths of a millimetre.
void CheckSize(const IndexedMesh& mesh) {
  constexpr double kLeast = 0.1;
  constexpr double kLargest = 1e9;  // NMR_MESH_MAXCOORDINATE
  const Eigen::AlignedBox3d box = BoundingBox(mesh);
  if (mesh.triangles.empty()) {
    return;
  }
  if (box.sizes().maxCoeff() < kLeast) {
    throw InputError(
        fmt::format("3MF has six decimals of a millimetre, and the mesh has a "
                    "size of {:g} mm: it must be at least {:g}",
                    box.sizes().maxCoeff(),
                    kLeast));
  }
  const double farthest =
      box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  if (farthest > kLargest) {
    throw InputError(
        fmt::format("the mesh has coordinates up to {:g} mm: 3MF files of "
                    "lib3mf hold at most {:g}",
                    farthest,
                    kLargest));
  }
}

// An identifier made from what the mesh holds, so that the same mesh gives the
// same file; the library would draw one at random.
std::string Uuid(const IndexedMesh& mesh, uint64_t part) {
  uint64_t high = HashBits(part, mesh.positions.size());
  for (const Eigen::Vector3d& position : mesh.positions) {
    high = HashBits(high,
                    std::bit_cast<uint64_t>(position.x()),
                    std::bit_cast<uint64_t>(position.y()),
                    std::bit_cast<uint64_t>(position.z()));
  }
  const uint64_t low = HashBits(high);
  // Version 8 of RFC 9562: anything.
  return fmt::format("{:08x}-{:04x}-8{:03x}-8{:03x}-{:012x}",
                     high >> 32,
                     high >> 16 & 0xffff,
                     high & 0xfff,
                     low >> 52,
                     low & 0xffffffffffff);
}

NMR::MODELMESHCOLOR_SRGB ToColor(const std::array<uint8_t, 3>& color) {
  return {color[0], color[1], color[2], 255};
}

void AddGeometry(const IndexedMesh& mesh, NMR::PLib3MFBase* object) {
  std::vector<NMR::MODELMESHVERTEX> vertices(mesh.positions.size());
  for (size_t v = 0; v < vertices.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      vertices[v].m_fPosition[axis] = float(mesh.positions[v][axis]);
    }
  }
  std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      triangles[t].m_nIndices[i] = mesh.triangles[t][i];
    }
  }
  Require(NMR::lib3mf_meshobject_setgeometry(object,
                                             vertices.data(),
                                             uint32_t(vertices.size()),
                                             triangles.data(),
                                             uint32_t(triangles.size())),
          object);
}

// Colours of the corners; programs that know none see their mean.
void AddColors(const IndexedMesh& mesh, NMR::PLib3MFBase* object) {
  std::vector<NMR::MODELMESH_TRIANGLECOLOR_SRGB> colors(mesh.triangles.size());
  std::array<uint64_t, 3> sums = {0, 0, 0};
  for (size_t t = 0; t < colors.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto& color = mesh.colors[mesh.triangles[t][i]];
      colors[t].m_Colors[i] = ToColor(color);
      for (int channel = 0; channel < 3; ++channel) {
        sums[channel] += color[channel];
      }
    }
  }
  NMR::PLib3MFBase* raw = nullptr;
  Require(NMR::lib3mf_meshobject_createpropertyhandler(object, &raw), object);
  const Object handler(raw);
  Require(NMR::lib3mf_propertyhandler_setgradientcolorarray(handler.get(),
                                                            colors.data()),
          handler.get());
  Require(NMR::lib3mf_object_createdefaultpropertyhandler(object, &raw),
          object);
  const Object default_handler(raw);
  const uint64_t count = 3 * colors.size();
  NMR::MODELMESHCOLOR_SRGB mean = ToColor({uint8_t(sums[0] / count),
                                           uint8_t(sums[1] / count),
                                           uint8_t(sums[2] / count)});
  Require(
      NMR::lib3mf_defaultpropertyhandler_setcolor(default_handler.get(), &mean),
      default_handler.get());
}

// Callbacks of the library; they return 0 on success.
uint32_t WriteBytes(uint8_t* bytes, uint32_t size, void* stream) {
  auto* const out = static_cast<std::ostream*>(stream);
  out->write(reinterpret_cast<const char*>(bytes), std::streamsize(size));
  return out->good() ? 0 : 1;
}
uint32_t SeekTo(uint64_t position, void* stream) {
  auto* const out = static_cast<std::ostream*>(stream);
  out->seekp(std::streamoff(position));
  return out->good() ? 0 : 1;
}

}  // namespace

void Write3mf(const IndexedMesh& mesh, std::ostream& stream) {
  CheckSize(mesh);
  NMR::PLib3MFBase* raw = nullptr;
  if (NMR::lib3mf_createmodel(&raw) != 0) {
    throw Error("lib3mf: no model could be made");
  }
  const Object model(raw);
  Require(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER),
          model.get());
  Require(NMR::lib3mf_model_addmeshobject(model.get(), &raw), model.get());
  const Object object(raw);
  AddGeometry(mesh, object.get());
  if (!mesh.colors.empty() && !mesh.triangles.empty()) {
    AddColors(mesh, object.get());
  }
  Require(
      NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, &raw),
      model.get());
  const Object item(raw);
  Require(NMR::lib3mf_object_setuuidutf8(object.get(), Uuid(mesh, 1).c_str()),
          object.get());
  Require(
      NMR::lib3mf_model_setbuilduuidutf8(model.get(), Uuid(mesh, 2).c_str()),
      model.get());
  Require(NMR::lib3mf_builditem_setuuidutf8(item.get(), Uuid(mesh, 3).c_str()),
          item.get());
  Require(NMR::lib3mf_model_querywriter(model.get(), "3mf", &raw), model.get());
  const Object writer(raw);
  // In memory: the library ends the program where a callback fails.
  std::ostringstream bytes;
  Require(
      NMR::lib3mf_writer_writetocallback(writer.get(),
                                         reinterpret_cast<void*>(&WriteBytes),
                                         reinterpret_cast<void*>(&SeekTo),
                                         static_cast<std::ostream*>(&bytes)),
      writer.get());
  stream << bytes.view();
}

}  // namespace octacut
