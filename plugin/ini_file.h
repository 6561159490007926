// Reader of project files as COLMAP has them: `key = value` lines, first
// those of no section, then `[Section]`s whose keys mean `Section.key`.
// Blank lines and comments (from a `#` at the beginning of a line or after a
// blank) are skipped.
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace octacut {

struct IniEntry {
  std::string key;  // with its section: "OctahedralMeshing.hull_level"
  std::string value;
  int line = 0;  // from 1
};

// Throws OptionError that names `file_name` and the line.
std::vector<IniEntry> ReadIni(std::istream& stream, std::string_view file_name);

}  // namespace octacut
