#include "plugin/option_manager.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "plugin/ini_file.h"
#include "plugin/suggestion.h"

namespace octacut {
namespace {

constexpr std::string_view kProjectPath = "project_path";

std::string_view GroupOf(std::string_view name) {
  const size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view()
                                       : name.substr(0, dot);
}

std::string ToLower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : char(c);
  });
  return text;
}

}  // namespace

OptionManager::OptionManager() {
  Add(std::string(kProjectPath),
      &project_path_,
      "File with options as `key = value` lines under [Group] headings. "
      "Options on the command line take precedence.");
}

Option& OptionManager::AddOption(std::string name, std::string description) {
  if (Find(name) != nullptr) {
    throw InvariantError(fmt::format("option {} is declared twice", name));
  }
  Option& option = options_.emplace_back();
  const std::string_view group = GroupOf(name);
  option.section = group.empty() ? section_ : std::string(group);
  option.name = std::move(name);
  option.description = std::move(description);
  return option;
}

const Option* OptionManager::Find(std::string_view name) const {
  const auto found =
      std::find_if(options_.begin(), options_.end(), [&](const Option& option) {
        return option.name == name;
      });
  return found == options_.end() ? nullptr : &*found;
}

std::string OptionManager::Suggestion(std::string_view name,
                                      std::string_view dashes) const {
  std::vector<std::string> names;
  for (const Option& option : options_) {
    names.push_back(option.name);
  }
  const std::string nearest = NearestName(name, names);
  return nearest.empty()
             ? ""
             : fmt::format("; did you mean `{}{}`?", dashes, nearest);
}

void OptionManager::AddGiven(const Option& option,
                             std::string text,
                             std::string origin,
                             std::vector<Given>* given) const {
  const size_t index = size_t(&option - options_.data());
  for (Given& earlier : *given) {
    if (earlier.option == index) {
      earlier.texts.push_back(std::move(text));
      return;
    }
  }
  given->push_back({index, {std::move(text)}, std::move(origin)});
}

OptionManager::ParseResult OptionManager::ReadCommandLine(
    std::span<const std::string> arguments, std::vector<Given>* given) const {
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& token = arguments[i];
    if (token == "-h" || token == "--help") {
      return ParseResult::kHelp;
    }
    if (token.starts_with('-') && !token.starts_with("--")) {
      throw OptionError(fmt::format("unknown option `{}`", token));
    }
    if (!token.starts_with("--")) {
      throw OptionError(fmt::format("unexpected argument `{}`", token));
    }
    const size_t equals = token.find('=');
    const std::string name = token.substr(2, equals - 2);
    const Option* const option = Find(name);
    if (option == nullptr) {
      throw OptionError(
          fmt::format("unknown option `--{}`{}", name, Suggestion(name, "--")));
    }
    if (equals != std::string::npos) {
      AddGiven(*option, token.substr(equals + 1), "--" + name, given);
    } else if (i + 1 < arguments.size() &&
               !arguments[i + 1].starts_with("--")) {
      AddGiven(*option, arguments[++i], "--" + name, given);
    } else {
      throw OptionError(fmt::format("option --{} needs a value", name));
    }
  }
  return ParseResult::kRun;
}

std::vector<OptionManager::Given> OptionManager::ReadProjectFile() const {
  std::ifstream file(project_path_);
  if (!file) {
    throw OptionError(
        fmt::format("--project_path = {}: the file cannot be opened",
                    project_path_.string()));
  }
  const std::string file_name = project_path_.string();
  std::vector<Given> given;
  for (const IniEntry& entry : ReadIni(file, file_name)) {
    const std::string place = fmt::format("{}:{}: ", file_name, entry.line);
    const Option* const option = Find(entry.key);
    if (option == nullptr || option->name == kProjectPath) {
      throw OptionError(fmt::format(
          "{}unknown key `{}`{}", place, entry.key, Suggestion(entry.key, "")));
    }
    AddGiven(*option, entry.value, place + entry.key, &given);
  }
  return given;
}

void OptionManager::Assign(const Given& given) {
  Option& option = options_[given.option];
  if (given.texts.size() > 1 && !option.repeatable) {
    throw OptionError(
        fmt::format("{} is given {} times, but accepts only one value",
                    given.origin,
                    given.texts.size()));
  }
  try {
    option.assign(given.texts);
  } catch (const OptionError& error) {
    throw OptionError(fmt::format("{} = {}: {}",
                                  given.origin,
                                  fmt::join(given.texts, " "),
                                  error.what()));
  }
  option.is_set = true;
}

OptionManager::ParseResult OptionManager::Parse(
    std::span<const std::string> arguments) {
  std::vector<Given> command_line;
  if (ReadCommandLine(arguments, &command_line) == ParseResult::kHelp) {
    return ParseResult::kHelp;
  }
  for (const Given& given : command_line) {
    Assign(given);
  }
  if (!project_path_.empty()) {
    for (const Given& given : ReadProjectFile()) {
      if (!options_[given.option].is_set) {
        Assign(given);
      }
    }
  }
  for (const Option& option : options_) {
    if (option.required && !option.is_set) {
      throw OptionError(fmt::format("option --{} is required", option.name));
    }
  }
  return ParseResult::kRun;
}

Json OptionManager::ToJson() const {
  Json json = Json::object();
  for (const Option& option : options_) {
    const std::string group(GroupOf(option.name));
    if (group.empty()) {
      json[option.name] = option.to_json();
    } else {
      json[group][option.name.substr(group.size() + 1)] = option.to_json();
    }
  }
  return json;
}

std::string OptionManager::NameOption(const std::string& message) const {
  const size_t field_size = message.find(" = ");
  if (field_size == std::string::npos) {
    return message;
  }
  // Groups are named DepthSweep, structs depth_sweep.
  const auto plain = [](std::string name) {
    std::erase(name, '_');
    return ToLower(name);
  };
  const std::string field = plain(message.substr(0, field_size));
  const auto last_part = [](const std::string& name) {
    return name.substr(name.rfind('.') + 1);
  };
  const Option* named = nullptr;
  for (const Option& option : options_) {
    const std::string name = plain(option.name);
    if (name == field) {
      named = &option;
      break;
    }
    if (named == nullptr && last_part(name) == last_part(field)) {
      named = &option;
    }
  }
  if (named != nullptr) {
    return fmt::format("--{}{}", named->name, message.substr(field_size));
  }
  return message;
}

}  // namespace octacut
