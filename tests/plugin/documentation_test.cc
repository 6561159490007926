// What README, docs and messages say of options, against the tables of options.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "colmap_io/files/read_file.h"
#include "plugin/command_options.h"
#include "plugin/report.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::IsSubsetOf;
using ::testing::StartsWith;

std::string ReadDocument(const std::string& path) {
  return ReadFile(fs::path(OCTACUT_SOURCE_DIR) / path);
}

// The names of all commands' options, for one audience or for all.
std::set<std::string> OptionNames(
    std::initializer_list<OptionAudience> audiences) {
  std::set<std::string> names;
  for (const RegistryEntry& entry : CommandRegistry()) {
    const CommandOptions options(entry);
    for (const Option& option : options.Manager().Options()) {
      for (const OptionAudience audience : audiences) {
        if (option.audience == audience) {
          names.insert(option.name);
        }
      }
    }
  }
  return names;
}

std::set<std::string> FindAll(const std::string& text,
                              const std::string& pattern) {
  std::set<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end;
       match != end;
       ++match) {
    found.insert((*match)[1]);
  }
  return found;
}

TEST(Documentation, ListsTheKeysOfProjectFiles) {
  EXPECT_EQ(
      FindAll(ReadDocument("docs/project_file.md"), R"(\| `(\w+\.\w+)` \|)"),
      OptionNames({OptionAudience::kProjectFiles}));
}

TEST(Documentation, NamesOnlyOptionsOfTheCommandLine) {
  const std::set<std::string> names =
      OptionNames({OptionAudience::kEveryone, OptionAudience::kExperts});
  const std::string grouped = R"(--([A-Z]\w+\.\w+))";
  for (const char* document : {"README.md", "docs/usage.md"}) {
    for (const std::string& name : FindAll(ReadDocument(document), grouped)) {
      // COLMAP's own groups.
      if (!std::regex_match(
              name, std::regex("(Sift|Feature|Image)[A-Z][a-z]+\\..*"))) {
        EXPECT_EQ(names.count(name), 1u) << document << ": " << name;
      }
    }
  }
}

TEST(Documentation, MessagesNameOnlyOptionsOfTheCommandLine) {
  const std::set<std::string> names =
      OptionNames({OptionAudience::kEveryone, OptionAudience::kExperts});
  for (const char* layer : {"core", "colmap_io", "plugin"}) {
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(
             fs::path(OCTACUT_SOURCE_DIR) / layer)) {
      if (file.path().extension() == ".cc") {
        EXPECT_THAT(
            FindAll(ReadFile(file.path()), R"(--([A-Z][A-Za-z]+\.[a-z_]+))"),
            IsSubsetOf(names))
            << file.path();
      }
    }
  }
}

TEST(Documentation, ChangelogBeginsWithThisVersion) {
  const std::string changelog = ReadDocument("CHANGELOG.md");
  EXPECT_THAT(changelog.substr(changelog.find("## ")),
              StartsWith("## " + OctacutVersion()));
}

}  // namespace
}  // namespace octacut
