#include "tests/architecture/source_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

namespace octacut {
namespace {

namespace fs = std::filesystem;

constexpr auto kTopFolders =
    std::to_array<std::string_view>({"core", "colmap_io", "plugin", "tests"});

// Beside the data flow: nothing of core includes them.
constexpr auto kCoreBeside =
    std::to_array<std::string_view>({"benchmark/compare",
                                     "benchmark/evaluate",
                                     "benchmark/protocols",
                                     "benchmark/synthetic",
                                     "print",
                                     "segment",
                                     "simplify"});
constexpr auto kBesideMayInclude = std::to_array<std::string_view>(
    {"base", "scene", "mesh", "raycast", "grid"});

// Headers that only some folders may include: all others see octacut's own
// types instead.
struct Confined {
  std::string_view prefix;
  std::vector<std::string_view> folders;
};
const std::vector<Confined>& ConfinedHeaders() {
  static const std::vector<Confined> kConfined = {
      {"OpenMesh/", {"core/mesh/", "core/refine/", "core/simplify/", "tests/"}},
      {"ceres/", {"core/refine/", "tests/"}},
      {"embree3/", {"core/raycast/"}},
      {"nanoflann", {"core/benchmark/protocols/"}},
  };
  return kConfined;
}

constexpr auto kForbiddenInCore =
    std::to_array<std::string_view>({"fstream",
                                     "filesystem",
                                     "cstdio",
                                     "opencv2/imgcodecs",
                                     "opencv2/highgui",
                                     "opencv2/opencv.hpp"});

template <typename Range>
std::optional<size_t> IndexOf(const Range& range, std::string_view name) {
  const auto found = std::find(range.begin(), range.end(), name);
  return found == range.end()
             ? std::nullopt
             : std::optional<size_t>(size_t(found - range.begin()));
}

// The top folder and the module below it: "core" and "grid" of
// "core/base/morton.h". The modules of core/benchmark have a folder each.
struct Module {
  std::string_view top;
  std::string_view folder;
};

Module ModuleOf(std::string_view path) {
  constexpr std::string_view kNested = "benchmark/";
  Module module;
  const size_t first = path.find('/');
  module.top = path.substr(0, first);
  if (first != std::string_view::npos) {
    const bool is_nested = path.substr(first + 1).starts_with(kNested);
    const size_t second =
        path.find('/', first + 1 + (is_nested ? kNested.size() : 0));
    if (second != std::string_view::npos) {
      module.folder = path.substr(first + 1, second - first - 1);
    }
  }
  return module;
}

std::string CheckLayers(const Module& from, const Module& to) {
  const auto from_rank = IndexOf(kTopFolders, from.top);
  const auto to_rank = IndexOf(kTopFolders, to.top);
  if (to_rank > from_rank) {
    return fmt::format("{} must not include {}", from.top, to.top);
  }
  return "";
}

// The folders of core in the order of the data flow, which is the order in
// which core/CMakeLists.txt adds them.
std::vector<std::string> ReadCoreOrder(const fs::path& root) {
  static const std::regex kAdd(R"re(^add_subdirectory\((\w+)\)\s*$)re");
  std::ifstream stream(root / "core/CMakeLists.txt");
  std::vector<std::string> order;
  std::string line;
  while (std::getline(stream, line)) {
    std::smatch match;
    if (std::regex_match(line, match, kAdd) &&
        !IndexOf(kCoreBeside, match[1].str())) {
      order.push_back(match[1]);
    }
  }
  return order;
}

std::string CheckCoreOrder(const std::vector<std::string>& order,
                           const Module& from,
                           const Module& to) {
  if (from.folder == to.folder) {
    return "";
  }
  const auto from_rank = IndexOf(order, from.folder);
  const auto to_rank = IndexOf(order, to.folder);
  const bool from_beside = IndexOf(kCoreBeside, from.folder).has_value();
  if (!from_rank && !from_beside) {
    return fmt::format("core/{} has no place in the order of the data flow",
                       from.folder);
  }
  const bool allowed = from_beside
                           ? IndexOf(kBesideMayInclude, to.folder).has_value()
                           : to_rank && *to_rank < *from_rank;
  return allowed
             ? ""
             : fmt::format(
                   "core/{} must not include core/{}", from.folder, to.folder);
}

std::string CheckInclude(const fs::path& root,
                         const std::vector<std::string>& core_order,
                         const std::string& file,
                         const std::string& header,
                         bool quoted) {
  const Module from = ModuleOf(file);
  const Module to = ModuleOf(header);
  if (quoted && !fs::exists(root / header)) {
    return fmt::format("\"{}\" is no path from the top of the tree", header);
  }
  if (IndexOf(kTopFolders, to.top)) {
    std::string problem = CheckLayers(from, to);
    if (!problem.empty()) {
      return problem;
    }
    if (from.top == "core") {
      return CheckCoreOrder(core_order, from, to);
    }
    return "";
  }
  if (from.top == "core") {
    for (const std::string_view forbidden : kForbiddenInCore) {
      if (header.starts_with(forbidden)) {
        return fmt::format("core must not include <{}>", header);
      }
    }
  }
  for (const Confined& confined : ConfinedHeaders()) {
    if (header.starts_with(confined.prefix) &&
        std::none_of(confined.folders.begin(),
                     confined.folders.end(),
                     [&](auto folder) { return file.starts_with(folder); })) {
      return fmt::format(
          "<{}> belongs into {} only", header, confined.folders.front());
    }
  }
  return "";
}

std::vector<fs::path> SourceFiles(const fs::path& root) {
  std::vector<fs::path> files;
  for (const std::string_view top : kTopFolders) {
    if (!fs::is_directory(root / top)) {
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const fs::path extension = entry.path().extension();
      if (entry.is_regular_file() &&
          (extension == ".h" || extension == ".cc")) {
        files.push_back(entry.path());
      }
    }
  }
  return files;
}

void CheckFile(const fs::path& root,
               const std::vector<std::string>& core_order,
               const fs::path& path,
               std::vector<std::string>* violations) {
  static const std::regex kInclude(
      R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  // `--name` in a string.
  static const std::regex kOption(R"re("[^"]*--[A-Za-z][^"]*")re");
  const std::string file = fs::relative(path, root).generic_string();
  std::ifstream stream(path);
  std::string line;
  size_t line_number = 0;
  size_t names_option = 0;
  bool guarded = path.extension() != ".h";
  while (std::getline(stream, line)) {
    ++line_number;
    guarded = guarded || line.starts_with("#pragma once");
    if (file.starts_with("core/") && std::regex_search(line, kOption)) {
      names_option = line_number;
    }
    std::smatch match;
    if (line.find('#') != std::string::npos &&
        std::regex_match(line, match, kInclude)) {
      const std::string problem =
          CheckInclude(root, core_order, file, match[2], match[1] == "\"");
      if (!problem.empty()) {
        violations->push_back(
            fmt::format("{}:{}: {}", file, line_number, problem));
      }
    }
  }
  if (names_option > 0) {
    violations->push_back(
        fmt::format("{}:{}: core must not name an option of the command line",
                    file,
                    names_option));
  }
  if (line_number > kMaxFileLines) {
    violations->push_back(fmt::format(
        "{}:{}: longer than {} lines", file, line_number, kMaxFileLines));
  }
  if (!guarded) {
    violations->push_back(fmt::format("{}:1: no #pragma once", file));
  }
}

// Types of one name in two headers are two definitions of one entity, which a
// linker may mix up without a word.
void CheckTypeNames(const fs::path& root,
                    std::vector<std::string>* violations) {
  static const std::regex kType(
      R"re(^(struct|class|enum class) ([A-Z][A-Za-z0-9]*)[^;]*)re");
  std::map<std::string, std::string> headers;  // by the name of the type
  std::vector<fs::path> files = SourceFiles(root);
  std::sort(files.begin(), files.end());
  for (const fs::path& path : files) {
    const std::string file = fs::relative(path, root).generic_string();
    if (path.extension() != ".h" || file.starts_with("tests/")) {
      continue;
    }
    std::ifstream stream(path);
    std::string line;
    for (size_t number = 1; std::getline(stream, line); ++number) {
      std::smatch match;
      if (!std::regex_match(line, match, kType)) {
        continue;
      }
      const auto [other, is_new] = headers.emplace(match[2], file);
      if (!is_new) {
        violations->push_back(fmt::format("{}:{}: {} also defines a type {}",
                                          file,
                                          number,
                                          other->second,
                                          other->first));
      }
    }
  }
}

}  // namespace

std::vector<std::string> FindRuleViolations(const fs::path& root) {
  const std::vector<std::string> core_order = ReadCoreOrder(root);
  std::vector<std::string> violations;
  for (const fs::path& path : SourceFiles(root)) {
    CheckFile(root, core_order, path, &violations);
  }
  CheckTypeNames(root, &violations);
  std::sort(violations.begin(), violations.end());
  return violations;
}

size_t CountSourceFiles(const fs::path& root) {
  return SourceFiles(root).size();
}

}  // namespace octacut
