#include "plugin/man_page.h"

#include <fmt/format.h>

#include "plugin/command_options.h"
#include "plugin/report.h"

namespace octacut {
namespace {

// A backslash and a hyphen mean something to roff, and so does a dot or an
// apostrophe at the beginning of a line.
std::string Escaped(std::string_view text) {
  std::string escaped =
      text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string OptionEntry(const Option& option) {
  std::string value = "\\fIarg\\fR";
  if (option.required) {
    value += " (required)";
  } else if (!option.default_text.empty()) {
    value += fmt::format(" (={})", Escaped(option.default_text));
  }
  return fmt::format(".TP\n\\fB{}\\fR {}\n{}\n",
                     Escaped("--" + option.name),
                     value,
                     Escaped(option.description));
}

std::string CommandSection(const RegistryEntry& entry) {
  std::string text =
      fmt::format(".SS {}\n{}.\n", Escaped(entry.name), Escaped(entry.summary));
  const CommandOptions options(entry);
  for (const Option& option : options.Manager().Options()) {
    if (IsListed(option, true)) {
      text += OptionEntry(option);
    }
  }
  return text;
}

}  // namespace

std::string ManPage(std::span<const RegistryEntry> commands) {
  std::string text = fmt::format(
      ".TH OCTACUT 1 \"\" \"octacut {}\" \"User Commands\"\n"
      ".SH NAME\n"
      "octacut \\- closed meshes from COLMAP sparse models and silhouette "
      "masks\n"
      ".SH SYNOPSIS\n"
      "\\fBoctacut\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n"
      ".SH DESCRIPTION\n"
      "Reconstructs an object from photographs, their cameras (a sparse model "
      "of\n\\fBcolmap\\fR(1)) and one silhouette mask for each photograph. "
      "The result is a closed triangle mesh.\n"
      ".SH COMMANDS\n",
      OctacutVersion());
  for (const RegistryEntry& entry : commands) {
    text += CommandSection(entry);
  }
  text +=
      ".SH EXIT STATUS\n"
      "0 if the command succeeded, 1 after an error, and 130 if it was "
      "interrupted.\n"
      ".SH SEE ALSO\n"
      "\\fBcolmap\\fR(1)\n";
  return text;
}

}  // namespace octacut
