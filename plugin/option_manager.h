// Options of a command: bound to fields, read from the command line and from
// a project file, listed for help and report.
//
//   options.AddRequired("workspace_path", &workspace_path_, "Workspace.");
//   options.Add("OctahedralMeshing.hull_level", &hull_level_, "Level.");
//   options
//       .AddEnum("OctahedralMeshing.consistency", &measure_,
//                {{"variance", ...}, {"ncc", ...}}, "Measure.")
//       .ForExperts();
//   options.AddRepeatable("input_path", &input_paths_, "Meshes.");
//   options.AddConstant("Refinement.step", RefineOptions::kStep);
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugin/option.h"

namespace octacut {

class OptionManager {
 public:
  // Declares --project_path and --help_all, which Parse() follows.
  OptionManager();
  // The bound fields' addresses make copies meaningless.
  OptionManager(const OptionManager&) = delete;
  OptionManager& operator=(const OptionManager&) = delete;

  // Binds an option to *value, which must outlive the manager; its present
  // value is the default. For the types of option_value.h. What is returned
  // is valid until the next option is added.
  template <typename T>
  Option& Add(std::string name, T* value, std::string description);

  // The same, but a run without it is refused.
  template <typename T>
  Option& AddRequired(std::string name, T* value, std::string description);

  // An option whose value is one of `names`.
  template <typename E>
  Option& AddEnum(std::string name,
                  E* value,
                  std::vector<std::pair<std::string, E>> names,
                  const std::string& description);

  // May be given several times; each time adds one element. Giving it at all
  // replaces the default.
  template <typename T>
  Option& AddRepeatable(std::string name,
                        std::vector<T>* values,
                        const std::string& description);

  // As AddRepeatable, at least once.
  template <typename T>
  Option& AddRequiredRepeatable(std::string name,
                                std::vector<T>* values,
                                std::string description);

  // For an option of an earlier version that is fixed at `value` now, that has
  // a new name or that has gone: whoever still uses it gets an error that says
  // so.
  template <typename T>
  void AddConstant(std::string name, const T& value);
  void AddRenamed(std::string old_name, const std::string& new_name);
  void AddRemoved(std::string name, const std::string& reason);

  // Heading of the help for ungrouped options added from now on.
  void BeginSection(std::string heading) { section_ = std::move(heading); }

  enum class ParseResult { kRun, kHelp, kHelpForExperts };

  // Reads `arguments` (without the program's and the command's name) and the
  // project file that they name; the command line wins. An argument is
  // `--name value`, where the value does not begin with two dashes, or
  // `--name=value`. Keys for project files only are refused on the command
  // line. Throws OptionError that names the option or file, line and key.
  ParseResult Parse(std::span<const std::string> arguments);

  // In the order of declaration.
  const std::vector<Option>& Options() const { return options_; }

  // The project file that was read; empty if none was.
  const std::filesystem::path& ProjectPath() const { return project_path_; }

  // Whether the command line or a project file has set an option.
  bool IsSet(std::string_view name) const;

  // For options that nothing uses unless another one is given: throws
  // OptionError where one of `names` is set.
  void RefuseUnused(std::initializer_list<std::string_view> names,
                    std::string_view without) const;

  // Every option with its value at the time of the call: grouped ones in an
  // object of their group.
  Json ToJson() const;

  // Completes a message "field = value: constraint" of a step's Check() with
  // the option that is bound to such a field: "--Group.field = value: ...",
  // without dashes for keys of project files.
  // A field may also be "group.field", as of an options struct inside another
  // one; an option of that full name goes before one that shares the last part
  // only. Messages about other fields are returned as they are.
  std::string NameOption(const std::string& message) const;
  // `message` with the full names of the options for `field`s in backticks, as
  // core names them: "--Group.field". Others are left as they are.
  std::string NameOptionsIn(std::string_view message) const;

 private:
  struct Given {
    size_t option;
    std::vector<std::string> texts;
    std::string origin;  // "--name" or "file:line: name"
  };

  Option& AddOption(std::string name, std::string description);
  const Option* Find(std::string_view name) const;
  // As NameOption finds it; null where no option is bound to such a field.
  const Option* FindByField(std::string_view field) const;
  // The error for a name that is not declared: what became of it, or a similar
  // name. `noun` is what names are called where it was found, `dashes` precede
  // them.
  OptionError UnknownName(std::string_view name,
                          std::string_view noun,
                          std::string_view dashes) const;
  const Option& FindForCommandLine(const std::string& name) const;
  void AddGiven(const Option& option,
                std::string text,
                std::string origin,
                std::vector<Given>* given) const;
  ParseResult ReadCommandLine(std::span<const std::string> arguments,
                              std::vector<Given>* given) const;
  std::vector<Given> ReadProjectFile() const;
  void Assign(const Given& given);

  std::vector<Option> options_;
  // Options of earlier versions, with what became of them.
  std::map<std::string, std::string, std::less<>> retired_;
  std::map<std::string, std::string, std::less<>> renamed_;
  std::string section_;
  std::filesystem::path project_path_;
  bool help_all_ = false;
};

// Implementation of the templates.

template <typename T>
Option& OptionManager::Add(std::string name,
                           T* value,
                           std::string description) {
  Option& option = AddOption(std::move(name), std::move(description));
  option.default_text = FormatOptionValue(*value);
  option.is_path = std::is_same_v<T, std::filesystem::path>;
  option.assign = [value](std::span<const std::string> texts) {
    ParseOptionValue(texts.back(), value);
  };
  option.to_json = [value] { return OptionValueToJson(*value); };
  return option;
}

template <typename T>
Option& OptionManager::AddRequired(std::string name,
                                   T* value,
                                   std::string description) {
  Option& option = Add(std::move(name), value, std::move(description));
  option.required = true;
  return option;
}

template <typename E>
Option& OptionManager::AddEnum(std::string name,
                               E* value,
                               std::vector<std::pair<std::string, E>> names,
                               const std::string& description) {
  std::string all;
  for (const auto& [text, element] : names) {
    all.append(all.empty() ? "" : ", ").append(text);
  }
  const auto name_of = [value, names] {
    for (const auto& [text, element] : names) {
      if (element == *value) {
        return text;
      }
    }
    return std::string();
  };
  Option& option =
      AddOption(std::move(name), description + " One of: " + all + ".");
  option.default_text = name_of();
  option.assign = [value, names, all](std::span<const std::string> texts) {
    for (const auto& [text, element] : names) {
      if (text == texts.back()) {
        *value = element;
        return;
      }
    }
    throw OptionError("must be one of " + all);
  };
  option.values.reserve(names.size());
  for (const auto& [text, element] : names) {
    option.values.push_back(text);
  }
  option.to_json = [name_of] { return Json(name_of()); };
  return option;
}

template <typename T>
Option& OptionManager::AddRepeatable(std::string name,
                                     std::vector<T>* values,
                                     const std::string& description) {
  Option& option =
      AddOption(std::move(name), description + " May be repeated.");
  for (const T& value : *values) {
    option.default_text.append(option.default_text.empty() ? "" : " ")
        .append(FormatOptionValue(value));
  }
  option.repeatable = true;
  option.is_path = std::is_same_v<T, std::filesystem::path>;
  option.assign = [values](std::span<const std::string> texts) {
    values->clear();
    for (const std::string& text : texts) {
      ParseOptionValue(text, &values->emplace_back());
    }
  };
  option.to_json = [values] {
    Json json = Json::array();
    for (const T& value : *values) {
      json.push_back(OptionValueToJson(value));
    }
    return json;
  };
  return option;
}

template <typename T>
Option& OptionManager::AddRequiredRepeatable(std::string name,
                                             std::vector<T>* values,
                                             std::string description) {
  Option& option =
      AddRepeatable(std::move(name), values, std::move(description));
  option.required = true;
  return option;
}

template <typename T>
void OptionManager::AddConstant(std::string name, const T& value) {
  retired_.insert_or_assign(
      std::move(name),
      fmt::format("is a constant now ({})", FormatOptionValue(value)));
}

}  // namespace octacut
