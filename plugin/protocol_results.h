// What a benchmark's protocol has measured, as a table and in the report.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "core/benchmark/protocols/protocol_result.h"
#include "plugin/option_value.h"
#include "plugin/protocol_options.h"

namespace octacut {

// A row for each name with its result.
std::string ProtocolTable(
    const ProtocolOptions& protocol,
    std::span<const std::pair<std::string, ProtocolResult>> results);

// {"name", "rules", "tolerances", "crop_paths"} for the report.
Json ProtocolToJson(const ProtocolOptions& protocol);
// {"figures": [{"name", "kind", "value"}, ...], "scores": [{"tolerance",
// "precision", "recall", "f_score"}, ...], "matrix" where it was aligned}
Json ProtocolResultToJson(const ProtocolResult& result);

}  // namespace octacut
