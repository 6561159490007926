// One option of a command, as OptionManager holds it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "plugin/option_value.h"

namespace octacut {

// Who an option is for.
enum class OptionAudience {
  kEveryone,      // listed by -h
  kExperts,       // listed by --help_all 1
  kProjectFiles,  // accepted in project files only; docs/project_file.md
  kNobody,  // accepted as COLMAP has it, but not listed: without effect here,
            // or said better by another option
};

struct Option {
  std::string name;     // without dashes; "Group.field" or "field"
  std::string section;  // heading of the help
  std::string description;
  std::string default_text;
  OptionAudience audience = OptionAudience::kEveryone;
  bool required = false;
  bool repeatable = false;
  bool is_path = false;             // of a file or folder
  bool is_set = false;              // by the command line or a project file
  std::vector<std::string> values;  // all that there are; empty: any
  // Assigns the bound field; several texts only when repeatable. Throws
  // OptionError with the constraint alone.
  std::function<void(std::span<const std::string> texts)> assign;
  // The field's value at the time of the call.
  std::function<Json()> to_json;

  void ForExperts() { audience = OptionAudience::kExperts; }
  void ForProjectFiles() { audience = OptionAudience::kProjectFiles; }
  void ForNobody() { audience = OptionAudience::kNobody; }
};

}  // namespace octacut
