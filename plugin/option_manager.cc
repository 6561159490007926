#include "plugin/option_manager.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "plugin/ini_file.h"
#include "plugin/suggestion.h"

namespace octacut {
namespace {

constexpr std::string_view kProjectPath = "project_path";
constexpr std::string_view kHelpAll = "help_all";

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
  Add(std::string(kHelpAll),
      &help_all_,
      "If 1, print this text with the options that are rarely needed.");
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

void OptionManager::AddRenamed(std::string old_name,
                               const std::string& new_name) {
  renamed_.insert_or_assign(std::move(old_name), new_name);
}

void OptionManager::AddRemoved(std::string name, const std::string& reason) {
  retired_.insert_or_assign(std::move(name),
                            fmt::format("has been removed: {}", reason));
}

bool OptionManager::IsSet(std::string_view name) const {
  const Option* const option = Find(name);
  return option != nullptr && option->is_set;
}

void OptionManager::RefuseUnused(std::initializer_list<std::string_view> names,
                                 std::string_view without) const {
  for (const std::string_view name : names) {
    if (IsSet(name)) {
      throw OptionError(
          fmt::format("--{} has no effect without --{}", name, without));
    }
  }
}

OptionError OptionManager::UnknownName(std::string_view name,
                                       std::string_view noun,
                                       std::string_view dashes) const {
  if (const auto found = retired_.find(name); found != retired_.end()) {
    return OptionError(
        fmt::format("{} `{}{}` {}", noun, dashes, name, found->second));
  }
  if (const auto found = renamed_.find(name); found != renamed_.end()) {
    return OptionError(fmt::format("{} `{}{}` is called `{}{}` now",
                                   noun,
                                   dashes,
                                   name,
                                   dashes,
                                   found->second));
  }
  std::vector<std::string> names;
  for (const Option& option : options_) {
    if (dashes.empty() || option.audience != OptionAudience::kProjectFiles) {
      names.push_back(option.name);
    }
  }
  const std::string nearest = NearestName(name, names);
  return OptionError(fmt::format(
      "unknown {} `{}{}`{}",
      noun,
      dashes,
      name,
      nearest.empty()
          ? ""
          : fmt::format("; did you mean `{}{}`?", dashes, nearest)));
}

const Option& OptionManager::FindForCommandLine(const std::string& name) const {
  const Option* const option = Find(name);
  if (option == nullptr) {
    throw UnknownName(name, "option", "--");
  }
  if (option->audience == OptionAudience::kProjectFiles) {
    throw OptionError(
        fmt::format("option `--{}` can only be set in a project file "
                    "(--project_path), as `{}`",
                    name,
                    name));
  }
  return *option;
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
    const Option& option = FindForCommandLine(name);
    if (equals != std::string::npos) {
      AddGiven(option, token.substr(equals + 1), "--" + name, given);
    } else if (i + 1 < arguments.size() &&
               !arguments[i + 1].starts_with("--")) {
      AddGiven(option, arguments[++i], "--" + name, given);
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
    if (option == nullptr) {
      throw OptionError(place + UnknownName(entry.key, "key", "").what());
    }
    if (option->name == kProjectPath || option->name == kHelpAll) {
      throw OptionError(fmt::format(
          "{}{} can only be set on the command line", place, option->name));
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
  if (help_all_) {
    return ParseResult::kHelpForExperts;
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
    if (option.name == kHelpAll) {
      continue;
    }
    const std::string group(GroupOf(option.name));
    if (group.empty()) {
      json[option.name] = option.to_json();
    } else {
      json[group][option.name.substr(group.size() + 1)] = option.to_json();
    }
  }
  return json;
}

const Option* OptionManager::FindByField(std::string_view wanted) const {
  // Groups are named DepthSweep, structs depth_sweep.
  const auto plain = [](std::string name) {
    std::erase(name, '_');
    return ToLower(name);
  };
  const auto last_part = [](const std::string& name) {
    return name.substr(name.rfind('.') + 1);
  };
  const std::string field = plain(std::string(wanted));
  std::string joined = field;  // texture.contrast is Scene.texture_contrast
  std::erase(joined, '.');
  const Option* named = nullptr;
  for (const Option& option : options_) {
    const std::string name = plain(option.name);
    if (name == field) {
      return &option;
    }
    if (named == nullptr &&
        (last_part(name) == last_part(field) || last_part(name) == joined)) {
      named = &option;
    }
  }
  return named;
}

namespace {

std::string FullName(const Option& option) {
  return option.audience == OptionAudience::kProjectFiles ? option.name
                                                          : "--" + option.name;
}

}  // namespace

std::string OptionManager::NameOption(const std::string& message) const {
  const size_t field_size = message.find(" = ");
  // A field is a name; what has a file and a line before it says enough, and so
  // does an option.
  if (field_size == std::string::npos || message.starts_with("--") ||
      message.find_first_of(" :`") < field_size) {
    return message;
  }
  const Option* const named = FindByField(message.substr(0, field_size));
  return named == nullptr ? message
                          : FullName(*named) + message.substr(field_size);
}

std::string OptionManager::NameOptionsIn(std::string_view message) const {
  std::string result;
  size_t next = 0;
  while (next < message.size()) {
    const size_t begin = message.find('`', next);
    const size_t end =
        begin == std::string_view::npos ? begin : message.find('`', begin + 1);
    if (end == std::string_view::npos) {
      break;
    }
    const Option* const named =
        FindByField(message.substr(begin + 1, end - begin - 1));
    if (named == nullptr) {
      // The second backtick may begin a name.
      result += message.substr(next, end - next);
      next = end;
      continue;
    }
    result += message.substr(next, begin - next);
    result += FullName(*named);
    next = end + 1;
  }
  return result.append(message.substr(next));
}

}  // namespace octacut
