#include "plugin/bash_completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "plugin/command_options.h"

namespace octacut {
namespace {

// Branches of `case` statements: what a command's options are, and which
// values follow an option of one.
struct Branches {
  std::string options;
  std::string values;
};

void AddCommand(const RegistryEntry& entry, Branches* branches) {
  const CommandOptions options(entry);
  std::vector<std::string> names = {"--help"};
  for (const Option& option : options.Manager().Options()) {
    if (!IsListed(option, true)) {
      continue;
    }
    names.push_back("--" + option.name);
    if (!option.values.empty()) {
      branches->values += fmt::format("    '{} --{}') words=\"{}\" ;;\n",
                                      entry.name,
                                      option.name,
                                      fmt::join(option.values, " "));
    } else if (option.is_path) {
      branches->values +=
          fmt::format("    '{} --{}') files=1 ;;\n", entry.name, option.name);
    }
  }
  branches->options += fmt::format(
      "        {}) words=\"{}\" ;;\n", entry.name, fmt::join(names, " "));
}

}  // namespace

std::string BashCompletion(std::span<const RegistryEntry> commands) {
  std::string names = "help";
  Branches branches;
  for (const RegistryEntry& entry : commands) {
    names += fmt::format(" {}", entry.name);
    AddCommand(entry, &branches);
  }
  return fmt::format(R"(# bash completion for octacut
_octacut() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words= files=0
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "{}" -- "$word")
    return
  fi
  case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{}    'help '*) words="{}" ;;
    *' --'*) ;; # a value that cannot be guessed
    *)
      case "${{COMP_WORDS[1]}}" in
{}      esac
      ;;
  esac
  if ((files)); then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  fi
}}
complete -F _octacut octacut
)",
                     names,
                     branches.values,
                     names,
                     branches.options);
}

}  // namespace octacut
