#include "plugin/help_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "plugin/command_options.h"
#include "plugin/report.h"

namespace octacut {
namespace {

constexpr size_t kLineWidth = 80;

// `text` in lines of at most kLineWidth characters, each after `indent`.
std::string Wrap(const std::string& text, size_t indent) {
  std::istringstream words(text);
  std::string lines;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kLineWidth) {
      lines += fmt::format("{:{}}{}\n", "", indent, line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? lines
                      : lines + fmt::format("{:{}}{}\n", "", indent, line);
}

std::string OptionHelp(const Option& option) {
  std::string value = "arg";
  if (option.required) {
    value += " (required)";
  } else if (!option.default_text.empty()) {
    value += fmt::format(" (={})", option.default_text);
  }
  return fmt::format(
      "  --{} {}\n{}", option.name, value, Wrap(option.description, 8));
}

std::string UsageLine(const RegistryEntry& command,
                      const OptionManager& options) {
  std::string line = fmt::format("octacut {}", command.name);
  for (const Option& option : options.Options()) {
    if (option.required) {
      line += fmt::format(" --{} arg", option.name);
    }
  }
  return Wrap(line + " [options]", 2);
}

}  // namespace

std::string ProgramHelp(std::span<const RegistryEntry> commands) {
  size_t width = 0;
  for (const RegistryEntry& command : commands) {
    width = std::max(width, command.name.size());
  }
  std::string text = fmt::format(
      "octacut {} -- closed meshes from COLMAP sparse models and silhouette "
      "masks\n\n"
      "Usage:\n"
      "  octacut [command] [options]\n"
      "  octacut [command] -h [ --help ]\n"
      "  octacut [command] --help_all 1\n\n"
      "After `colmap mapper`, with silhouette masks in W/masks:\n"
      "  octacut octahedral_mesher --workspace_path W\n",
      OctacutVersion());
  std::string_view purpose;
  for (const RegistryEntry& command : commands) {
    if (command.purpose != purpose) {
      purpose = command.purpose;
      text += fmt::format("\n{}:\n", purpose);
    }
    text += fmt::format("  {:{}}  {}\n", command.name, width, command.summary);
  }
  text += fmt::format("  {:{}}  {}\n",
                      "help",
                      width,
                      "Print this list, or the options of a command");
  return text;
}

std::string CommandHelp(const RegistryEntry& command,
                        const OptionManager& options,
                        bool for_experts) {
  std::string text = fmt::format("octacut {} {}\n\n{}\n\nUsage:\n{}",
                                 OctacutVersion(),
                                 command.name,
                                 command.summary,
                                 UsageLine(command, options));
  text += "\nOptions (on the command line or in the --project_path file):\n";
  // The command's own options first, then each section once.
  std::vector<std::string> sections = {""};
  size_t num_hidden = 0;
  for (const Option& option : options.Options()) {
    if (!IsListed(option, for_experts)) {
      num_hidden += IsListed(option, true);
    } else if (std::find(sections.begin(), sections.end(), option.section) ==
               sections.end()) {
      sections.push_back(option.section);
    }
  }
  for (const std::string& section : sections) {
    if (section.empty()) {
      text += "  -h [ --help ]\n        Print this text.\n";
    } else {
      text += fmt::format("\n{}:\n", section);
    }
    for (const Option& option : options.Options()) {
      if (option.section == section && IsListed(option, for_experts)) {
        text += OptionHelp(option);
      }
    }
  }
  if (num_hidden > 0) {
    text += fmt::format(
        "\n--help_all 1 also lists {} options that are rarely needed.\n",
        num_hidden);
  }
  return text;
}

}  // namespace octacut
