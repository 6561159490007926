#include "plugin/ini_file.h"

#include <fmt/format.h>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/files/trim.h"
#include "core/base/error.h"

namespace octacut {
namespace {

// A '#' inside a word belongs to it: paths may contain one.
std::string_view WithoutComment(std::string_view line) {
  for (size_t i = line.find('#'); i != std::string_view::npos;
       i = line.find('#', i + 1)) {
    if (i == 0 || kBlanks.find(line[i - 1]) != std::string_view::npos) {
      return line.substr(0, i);
    }
  }
  return line;
}

}  // namespace

std::vector<IniEntry> ReadIni(std::istream& stream,
                              std::string_view file_name) {
  std::vector<IniEntry> entries;
  std::string section;
  std::string text;
  for (int line_number = 1; std::getline(stream, text); ++line_number) {
    std::string_view line = text;
    if (line_number == 1) {
      SkipByteOrderMark(&line);
    }
    line = Trim(WithoutComment(line));
    if (line.empty()) {
      continue;
    }
    if (line.front() == '[' && line.back() == ']') {
      section = Trim(line.substr(1, line.size() - 2));
      continue;
    }
    const size_t equals = line.find('=');
    const std::string_view key = Trim(line.substr(0, equals));
    if (equals == std::string_view::npos || key.empty()) {
      throw OptionError(fmt::format("{}:{}: expected `key=value`, not `{}`",
                                    file_name,
                                    line_number,
                                    line));
    }
    entries.push_back({section.empty() ? std::string(key)
                                       : fmt::format("{}.{}", section, key),
                       std::string(Trim(line.substr(equals + 1))),
                       line_number});
  }
  if (stream.bad()) {
    throw OptionError(fmt::format("{}: the file cannot be read", file_name));
  }
  return entries;
}

}  // namespace octacut
