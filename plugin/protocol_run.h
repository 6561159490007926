// Reads the files of a benchmark's protocol and measures meshes by it.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "colmap_io/benchmark/dtu_files.h"
#include "core/base/context.h"
#include "core/benchmark/protocols/crop_polygon.h"
#include "core/benchmark/protocols/eth3d.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"
#include "plugin/protocol_options.h"

namespace octacut {

class ProtocolRun {
 public:
  // Reads crop_paths. `protocol` must outlive the run and be checked.
  explicit ProtocolRun(const ProtocolOptions& protocol);

  bool IsActive() const {
    return options_.protocol != BenchmarkProtocol::kNone;
  }
  bool Aligns() const {
    return options_.protocol == BenchmarkProtocol::kTanksAndTemples;
  }
  // ETH3D's references are projects with several scans: reads them, and returns
  // their points as a cloud. Nothing for the other protocols.
  std::optional<IndexedMesh> ReadReference(
      const std::filesystem::path& reference_path);

  // Throws InputError where the reference needs what is not given.
  ProtocolResult Measure(const IndexedMesh& mesh,
                         const IndexedMesh& reference,
                         const Context& context) const;

 private:
  const ProtocolOptions& options_;
  IndexedMesh hole_filler_;
  CropPolygon crop_polygon_;
  DtuCrop dtu_;
  std::vector<LaserScan> scans_;
};

}  // namespace octacut
