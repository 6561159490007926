// Options of a command: bound to fields, read from the command line and from
// a project file, listed for help and report.
//
//   options.AddRequired("workspace_path", &workspace_path_, "Workspace.");
//   options.Add("num_threads", &num_threads_, "Number of threads; -1 uses all
//   cores."); options.Add("OctahedralMeshing.hull_level", &meshing_.hull_level,
//   "..."); options.AddEnum("OctahedralMeshing.consistency",
//   &meshing_.consistency,
//                   {{"variance", ...}, {"ncc", ...}}, "...");
//   options.AddRepeatable("input_path", &input_paths_, "...");
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugin/option_value.h"

namespace octacut {

struct Option {
  std::string name;     // without dashes; "Group.field" or "field"
  std::string section;  // heading of the help
  std::string description;
  std::string default_text;
  bool required = false;
  bool repeatable = false;
  bool is_set = false;  // by the command line or a project file
  // Assigns the bound field; several texts only when repeatable. Throws
  // OptionError with the constraint alone.
  std::function<void(std::span<const std::string> texts)> assign;
  // The field's value at the time of the call.
  std::function<Json()> to_json;
};

class OptionManager {
 public:
  // Declares --project_path, which Parse() follows.
  OptionManager();
  // The bound fields' addresses make copies meaningless.
  OptionManager(const OptionManager&) = delete;
  OptionManager& operator=(const OptionManager&) = delete;

  // Binds an option to *value, which must outlive the manager; its present
  // value is the default. For the types of option_value.h.
  template <typename T>
  void Add(std::string name, T* value, std::string description);

  // The same, but a run without it is refused.
  template <typename T>
  void AddRequired(std::string name, T* value, std::string description);

  // An option whose value is one of `names`.
  template <typename E>
  void AddEnum(std::string name,
               E* value,
               std::vector<std::pair<std::string, E>> names,
               const std::string& description);

  // May be given several times; each time adds one element. Giving it at all
  // replaces the default.
  template <typename T>
  void AddRepeatable(std::string name,
                     std::vector<T>* values,
                     const std::string& description);

  // As AddRepeatable, at least once.
  template <typename T>
  void AddRequiredRepeatable(std::string name,
                             std::vector<T>* values,
                             std::string description);

  // Heading of the help for ungrouped options added from now on.
  void BeginSection(std::string heading) { section_ = std::move(heading); }

  enum class ParseResult { kRun, kHelp };

  // Reads `arguments` (without the program's and the command's name) and the
  // project file that they name; the command line wins. An argument is
  // `--name value`, where the value does not begin with two dashes, or
  // `--name=value`. Throws OptionError that names the option or file, line and
  // key.
  ParseResult Parse(std::span<const std::string> arguments);

  // In the order of declaration.
  const std::vector<Option>& Options() const { return options_; }

  // Every option with its value at the time of the call: grouped ones in an
  // object of their group.
  Json ToJson() const;

  // Completes a message "field = value: constraint" of a step's Check() with
  // the option that is bound to such a field: "--Group.field = value: ...".
  // A field may also be "group.field", as of an options struct inside another
  // one; an option of that full name goes before one that shares the last part
  // only. Messages about other fields are returned as they are.
  std::string NameOption(const std::string& message) const;

 private:
  struct Given {
    size_t option;
    std::vector<std::string> texts;
    std::string origin;  // "--name" or "file:line: name"
  };

  Option& AddOption(std::string name, std::string description);
  const Option* Find(std::string_view name) const;
  // "; did you mean ...?" or nothing.
  std::string Suggestion(std::string_view name, std::string_view dashes) const;
  void AddGiven(const Option& option,
                std::string text,
                std::string origin,
                std::vector<Given>* given) const;
  ParseResult ReadCommandLine(std::span<const std::string> arguments,
                              std::vector<Given>* given) const;
  std::vector<Given> ReadProjectFile() const;
  void Assign(const Given& given);

  std::vector<Option> options_;
  std::string section_;
  std::filesystem::path project_path_;
};

// Implementation of the templates.

template <typename T>
void OptionManager::Add(std::string name, T* value, std::string description) {
  Option& option = AddOption(std::move(name), std::move(description));
  option.default_text = FormatOptionValue(*value);
  option.assign = [value](std::span<const std::string> texts) {
    ParseOptionValue(texts.back(), value);
  };
  option.to_json = [value] { return OptionValueToJson(*value); };
}

template <typename T>
void OptionManager::AddRequired(std::string name,
                                T* value,
                                std::string description) {
  Add(std::move(name), value, std::move(description));
  options_.back().required = true;
}

template <typename E>
void OptionManager::AddEnum(std::string name,
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
  option.to_json = [name_of] { return Json(name_of()); };
}

template <typename T>
void OptionManager::AddRepeatable(std::string name,
                                  std::vector<T>* values,
                                  const std::string& description) {
  Option& option =
      AddOption(std::move(name), description + " May be repeated.");
  for (const T& value : *values) {
    option.default_text.append(option.default_text.empty() ? "" : " ")
        .append(FormatOptionValue(value));
  }
  option.repeatable = true;
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
}

template <typename T>
void OptionManager::AddRequiredRepeatable(std::string name,
                                          std::vector<T>* values,
                                          std::string description) {
  AddRepeatable(std::move(name), values, std::move(description));
  options_.back().required = true;
}

}  // namespace octacut
