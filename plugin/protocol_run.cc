#include "plugin/protocol_run.h"

#include <fmt/format.h>

#include "colmap_io/benchmark/crop_polygon_file.h"
#include "colmap_io/benchmark/laser_scans.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"
#include "core/benchmark/protocols/dtu.h"
#include "core/benchmark/protocols/metro.h"
#include "core/benchmark/protocols/middlebury.h"
#include "core/benchmark/protocols/tanks_and_temples.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

}  // namespace

ProtocolRun::ProtocolRun(const ProtocolOptions& protocol) : options_(protocol) {
  const std::vector<fs::path>& crops = protocol.crop_paths;
  if (protocol.protocol == BenchmarkProtocol::kTanksAndTemples) {
    crop_polygon_ = ReadCropPolygon(crops[0]);
  } else if (protocol.protocol == BenchmarkProtocol::kDtu) {
    dtu_ = ReadDtuCrop(crops);
  } else if (protocol.protocol == BenchmarkProtocol::kMiddlebury &&
             !crops.empty()) {
    hole_filler_ = ReadMesh(crops[0]).mesh;
    if (hole_filler_.triangles.empty()) {
      throw InputError(fmt::format(
          "{}: the mesh that fills the reference's holes has no faces",
          crops[0].string()));
    }
  }
}

std::optional<IndexedMesh> ProtocolRun::ReadReference(
    const fs::path& reference_path) {
  if (options_.protocol != BenchmarkProtocol::kEth3d) {
    return std::nullopt;
  }
  scans_ = ReadLaserScans(reference_path);
  IndexedMesh cloud;
  cloud.positions = MergeScans(scans_);
  return cloud;
}

ProtocolResult ProtocolRun::Measure(const IndexedMesh& mesh,
                                    const IndexedMesh& reference,
                                    const Context& context) const {
  const std::vector<double>& tolerances = options_.tolerances;
  switch (options_.protocol) {
    case BenchmarkProtocol::kMetro:
      return MeasureMetro(mesh, reference, context);
    case BenchmarkProtocol::kMiddlebury: {
      const bool has_filler = !hole_filler_.triangles.empty();
      if (!has_filler && NeedsHoleFiller(reference, context)) {
        throw InputError(
            "crop_path is missing: the reference has holes or a border, so the "
            "protocol middlebury needs --crop_path with a mesh that fills "
            "them");
      }
      return MeasureMiddlebury(mesh,
                               reference,
                               has_filler ? &hole_filler_ : nullptr,
                               tolerances[0],
                               context);
    }
    case BenchmarkProtocol::kTanksAndTemples:
      return MeasureTanksAndTemples(
          mesh, reference, crop_polygon_, tolerances[0], context);
    case BenchmarkProtocol::kEth3d:
      return MeasureEth3d(mesh, scans_, tolerances, context);
    case BenchmarkProtocol::kDtu:
      return MeasureDtu(mesh, reference, dtu_.mask, dtu_.plane, context);
    case BenchmarkProtocol::kNone:
      break;
  }
  throw InvariantError("no protocol to measure by");
}

}  // namespace octacut
