#include "plugin/support_ranking.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/benchmark/evaluate/paired_bootstrap.h"

namespace octacut {
namespace {

// Of the views that can tell.
std::vector<double> SupportByView(const SupportedMesh& mesh) {
  std::vector<double> values;
  for (const ViewSupport& view : mesh.views) {
    if (view.textured_pixels > 0) {
      values.push_back(view.support);
    }
  }
  return values;
}

}  // namespace

Json RankBySupport(const std::vector<SupportedMesh>& meshes, uint64_t seed) {
  std::vector<const SupportedMesh*> order;
  order.reserve(meshes.size());
  for (const SupportedMesh& mesh : meshes) {
    order.push_back(&mesh);
  }
  std::stable_sort(order.begin(),
                   order.end(),
                   [](const SupportedMesh* a, const SupportedMesh* b) {
                     return MeanSupport(a->views) > MeanSupport(b->views);
                   });
  Json json;
  json["order"] = Json::array();
  json["pairs"] = Json::array();
  for (size_t k = 0; k < order.size(); ++k) {
    json["order"].push_back(order[k]->name);
    const std::vector<double> values = SupportByView(*order[k]);
    if (k + 1 < order.size() && values.size() >= 2) {
      const BootstrapDifference difference =
          PairedBootstrap(values, SupportByView(*order[k + 1]), seed);
      json["pairs"].push_back(
          {{"better", order[k]->name},
           {"worse", order[k + 1]->name},
           {"mean", difference.mean},
           {"low", difference.low},
           {"high", difference.high},
           {"p_value", difference.p_value},
           {"more_than_chance", difference.IsMoreThanChance()}});
    }
  }
  return json;
}

std::string RankingText(const Json& ranking) {
  std::string text;
  for (const Json& pair : ranking["pairs"]) {
    const std::string better = pair["better"];
    const std::string worse = pair["worse"];
    const std::string figures = fmt::format("{:.4f}, 95 %: {:.4f} to {:.4f}",
                                            pair["mean"].get<double>(),
                                            pair["low"].get<double>(),
                                            pair["high"].get<double>());
    text +=
        pair["more_than_chance"].get<bool>()
            ? fmt::format("The photographs support {} better than {} ({}).\n",
                          better,
                          worse,
                          figures)
            : fmt::format(
                  "The photographs do not decide between {} and {} "
                  "({}).\n",
                  better,
                  worse,
                  figures);
  }
  return text;
}

}  // namespace octacut
