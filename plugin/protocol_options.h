// Benchmarks whose rules mesh_comparer can follow, and its options for them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

// "metro", ..., as the option has it.
std::string ProtocolName(BenchmarkProtocol protocol);

// Alignment, crop, sampling and source of the protocol in a sentence or two.
std::string ProtocolRules(const ProtocolOptions& protocol);

}  // namespace octacut
