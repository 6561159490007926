// Meshes in the order in which the photographs support them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/benchmark/evaluate/photo_support.h"
#include "plugin/option_value.h"

namespace octacut {

struct SupportedMesh {
  std::string name;
  std::vector<ViewSupport> views;
};

// {"order": [name, ...], "pairs": [{"better", "worse", "mean", "low", "high",
// "p_value", "more_than_chance"}, ...]}: each pair is a mesh and the next in
// the order, compared view by view.
Json RankBySupport(const std::vector<SupportedMesh>& meshes, uint64_t seed);

// A line for each pair of a ranking.
std::string RankingText(const Json& ranking);

}  // namespace octacut
