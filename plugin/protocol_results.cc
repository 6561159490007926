#include "plugin/protocol_results.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "plugin/text_table.h"
#include "plugin/transform_file.h"

namespace octacut {
namespace {

const char* KindName(FigureKind kind) {
  switch (kind) {
    case FigureKind::kDistance:
      return "distance";
    case FigureKind::kFraction:
      return "fraction";
    case FigureKind::kCount:
      return "count";
  }
  return "";
}

std::string FigureText(const ProtocolFigure& figure) {
  switch (figure.kind) {
    case FigureKind::kDistance:
      return fmt::format("{:.6g}", figure.value);
    case FigureKind::kFraction:
      return fmt::format("{:.2f} %", 100 * figure.value);
    case FigureKind::kCount:
      return fmt::format("{:.0f}", figure.value);
  }
  return "";
}

}  // namespace

std::string ProtocolTable(
    const ProtocolOptions& protocol,
    std::span<const std::pair<std::string, ProtocolResult>> results) {
  const bool is_eth3d = protocol.protocol == BenchmarkProtocol::kEth3d;
  std::vector<std::string> heading = {
      fmt::format("protocol {}", ProtocolName(protocol.protocol))};
  const ProtocolResult& first = results.front().second;
  for (const ProtocolScore& score : first.scores) {
    heading.push_back(fmt::format("at {:g}: {}, %",
                                  score.tolerance,
                                  is_eth3d ? "accuracy" : "precision"));
    heading.emplace_back(is_eth3d ? "completeness" : "recall");
    heading.emplace_back("F");
  }
  for (const ProtocolFigure& figure : first.figures) {
    heading.push_back(figure.name);
  }
  TextTable table(std::move(heading));
  for (const auto& [name, result] : results) {
    std::vector<std::string> row = {name};
    for (const ProtocolScore& score : result.scores) {
      for (const double value :
           {score.precision, score.recall, score.f_score}) {
        row.push_back(fmt::format("{:.2f}", 100 * value));
      }
    }
    for (const ProtocolFigure& figure : result.figures) {
      row.push_back(FigureText(figure));
    }
    table.AddRow(std::move(row));
  }
  return table.ToString();
}

Json ProtocolToJson(const ProtocolOptions& protocol) {
  Json crop_paths = Json::array();
  for (const std::filesystem::path& path : protocol.crop_paths) {
    crop_paths.push_back(path.string());
  }
  return {{"name", ProtocolName(protocol.protocol)},
          {"rules", ProtocolRules(protocol)},
          {"tolerances", protocol.tolerances},
          {"crop_paths", std::move(crop_paths)}};
}

Json ProtocolResultToJson(const ProtocolResult& result) {
  Json json;
  json["figures"] = Json::array();
  for (const ProtocolFigure& figure : result.figures) {
    json["figures"].push_back({{"name", figure.name},
                               {"kind", KindName(figure.kind)},
                               {"value", figure.value}});
  }
  json["scores"] = Json::array();
  for (const ProtocolScore& score : result.scores) {
    json["scores"].push_back({{"tolerance", score.tolerance},
                              {"precision", score.precision},
                              {"recall", score.recall},
                              {"f_score", score.f_score}});
  }
  if (result.reference_from_mesh) {
    json["matrix"] = TransformToJson(*result.reference_from_mesh);
  }
  return json;
}

}  // namespace octacut
