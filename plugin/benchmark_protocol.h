// The protocols of benchmarks as options, tables and members of a report.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "colmap_io/benchmark/dtu_files.h"
#include "core/base/context.h"
#include "core/benchmark/protocols/crop_polygon.h"
#include "core/benchmark/protocols/eth3d.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"
#include "plugin/option_manager.h"

namespace octacut {

enum class BenchmarkProtocol {
  kNone,
  kMetro,
  kMiddlebury,
  kTanksAndTemples,
  kEth3d,
  kDtu
};

struct ProtocolOptions {
  BenchmarkProtocol protocol = BenchmarkProtocol::kNone;
  std::vector<double> tolerances;  // in the reference's units
  // What limits the comparison: files that depend on the protocol.
  std::vector<std::filesystem::path> crop_paths;
};

// Adds protocol, tolerances and crop_path.
void DeclareProtocolOptions(OptionManager& options, ProtocolOptions* protocol);

// Throws OptionError where the protocol needs what is not given, or excludes
// what is: an option with rules of its own for alignment, crop or sampling.
void CheckProtocolOptions(const ProtocolOptions& protocol,
                          const std::filesystem::path& reference_path,
                          const OptionManager& options);

// Files of a protocol, and measuring by it.
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

// "metro", ..., as the option has it.
std::string ProtocolName(BenchmarkProtocol protocol);

// A row for each name with its result.
std::string ProtocolTable(
    const ProtocolOptions& protocol,
    std::span<const std::pair<std::string, ProtocolResult>> results);

// {"name", "rules", "tolerances", "crop_paths"} for the report.
Json ProtocolToJson(const ProtocolOptions& protocol);
// {"figures": [{"name", "kind", "value"}, ...], "scores": [{"tolerance",
// "precision", "recall", "f_score"}, ...], "matrix" where it was aligned}
Json ProtocolResultToJson(const ProtocolResult& result);

// Alignment, crop, sampling and source of the protocol in a sentence or two.
std::string ProtocolRules(const ProtocolOptions& protocol);

}  // namespace octacut
