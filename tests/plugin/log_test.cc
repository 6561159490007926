#include "plugin/log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

std::string FileTextOf(const LogOptions& options) {
  {
    Log log(options, "test");
    log.Debug("a detail");
    log.Info("a fact");
    log.Warn("a doubt");
    log.ErrorToFile("a failure");
  }
  return ReadFile(options.path);
}

TEST(Log, LevelAndSeverityChooseTheMessages) {
  const TemporaryFolder folder;
  LogOptions options;
  options.target = LogTarget::kFile;
  options.path = folder / "a.log";
  EXPECT_THAT(FileTextOf(options),
              AllOf(Not(HasSubstr("detail")),
                    HasSubstr(" a fact\n"),
                    HasSubstr(" WARNING: a doubt\n"),
                    HasSubstr(" ERROR: a failure\n")));
  options.path = folder / "b.log";
  options.level = 1;
  EXPECT_THAT(FileTextOf(options), HasSubstr("a detail"));
  options.path = folder / "c.log";
  options.severity = 1;
  EXPECT_THAT(FileTextOf(options),
              AllOf(Not(HasSubstr("detail")),
                    Not(HasSubstr("fact")),
                    HasSubstr("doubt")));
  options.path = folder / "d.log";
  options.severity = 2;
  EXPECT_THAT(FileTextOf(options),
              AllOf(Not(HasSubstr("doubt")), HasSubstr("failure")));
}

TEST(Log, MakesFolderAndNameOfTheFile) {
  const TemporaryFolder folder;
  LogOptions options;
  options.target = LogTarget::kFile;
  options.path = folder / "new" / "folder";
  const Log log(options, "mesh_comparer");
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(options.path)) {
    names.push_back(file.path().filename().string());
  }
  EXPECT_THAT(names,
              ElementsAre(AllOf(StartsWith("octacut-mesh_comparer-"),
                                EndsWith(".log"))));
}

TEST(Log, RefusesWhatItCannotDo) {
  LogOptions options;
  options.level = -1;
  EXPECT_THROW(Log(options, "x"), OptionError);
  options.level = 0;
  options.severity = 3;
  EXPECT_THROW(Log(options, "x"), OptionError);
  options.severity = 0;
  options.target = LogTarget::kFile;
  options.path = "/dev/null/folder";
  EXPECT_THROW(Log(options, "x"), Error);
}

TEST(Log, RefusesToWriteWithoutAFolder) {
  const char* const given = getenv("TMPDIR");
  const std::string before = given == nullptr ? "/tmp" : given;
  setenv("TMPDIR", "/dev/null/folder", 1);
  LogOptions options;
  options.target = LogTarget::kFile;
  EXPECT_THAT([&] { Log(options, "x"); },
              ThrowsMessage<Error>(HasSubstr("--log_path")));
  setenv("TMPDIR", before.c_str(), 1);
}

}  // namespace
}  // namespace octacut
