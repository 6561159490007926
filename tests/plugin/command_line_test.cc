// The executable as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <map>

#include "colmap_io/files/read_file.h"
#include "plugin/common_options.h"
#include "plugin/registry.h"
#include "plugin/report.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Matches;
using ::testing::MatchesRegex;
using ::testing::Not;

TEST(CommandLine, HelpListsEveryCommand) {
  const ProgramResult help = RunOctacut({"help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.err, IsEmpty());
  for (const RegistryEntry& command : CommandRegistry()) {
    EXPECT_THAT(help.out, HasSubstr("  " + std::string(command.name) + " "));
  }
  EXPECT_EQ(RunOctacut({}).out, help.out);
}

TEST(CommandLine, HelpOfEveryCommandListsItsOptionsWithTheirDefaults) {
  for (const RegistryEntry& entry : CommandRegistry()) {
    SCOPED_TRACE(entry.name);
    const std::string name(entry.name);
    const ProgramResult help = RunOctacut({name, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.err, IsEmpty());
    EXPECT_EQ(RunOctacut({name, "-h"}).out, help.out);
    const ProgramResult all = RunOctacut({name, "--help_all", "1"});
    EXPECT_EQ(all.exit_code, 0);
    OptionManager options;
    const std::unique_ptr<Command> command = entry.make();
    command->DeclareOptions(options);
    CommonOptions common;
    common.Declare(options, command->UsesRandomSeed());
    for (const Option& option : options.Options()) {
      const std::string value = option.required ? " (required)"
                                : option.default_text.empty()
                                    ? ""
                                    : " (=" + option.default_text + ")";
      const auto listed =
          HasSubstr("  --" + option.name + " arg" + value + "\n");
      const bool for_all = option.audience == OptionAudience::kEveryone;
      const bool for_experts = option.audience == OptionAudience::kExperts;
      EXPECT_EQ(Matches(listed)(help.out), for_all) << option.name;
      EXPECT_EQ(Matches(listed)(all.out), for_all || for_experts)
          << option.name;
      EXPECT_FALSE(option.description.empty()) << option.name;
    }
  }
}

// What a newcomer has to read.
TEST(CommandLine, HelpIsShort) {
  for (const RegistryEntry& entry : CommandRegistry()) {
    OptionManager options;
    const std::unique_ptr<Command> command = entry.make();
    command->DeclareOptions(options);
    CommonOptions common;
    common.Declare(options, command->UsesRandomSeed());
    std::map<OptionAudience, int> counts = {{OptionAudience::kEveryone, 1}};
    for (const Option& option : options.Options()) {
      ++counts[option.audience];  // and -h
    }
    EXPECT_LE(counts[OptionAudience::kEveryone], 24) << entry.name;
    // Examples have a family of options for each kind of scene.
    EXPECT_LE(counts[OptionAudience::kExperts],
              entry.name == "example_creator" ? 30 : 20)
        << entry.name;
  }
}

TEST(CommandLine, TheSeedIsAcceptedEverywhereAndListedWhereItIsUsed) {
  EXPECT_EQ(RunOctacut({"version", "--random_seed", "3"}).exit_code, 0);
  for (const auto& [command, is_listed] :
       {std::pair("version", false),
        std::pair("octahedral_mesher", false),
        std::pair("mesh_comparer", true),
        std::pair("example_creator", true)}) {
    const std::string help = RunOctacut({command, "--help_all", "1"}).out;
    EXPECT_EQ(help.find("--random_seed") != std::string::npos, is_listed)
        << command;
  }
}

TEST(CommandLine, OptionsOfEarlierVersionsAreExplained) {
  const std::vector<std::vector<std::string>> cases = {
      {"octahedral_mesher",
       "--Refinement.step",
       "option `--Refinement.step` is a constant now (0.5)"},
      {"mesh_refiner",
       "--Refinement.hue_weight",
       "is called `--OctahedralMeshing.chroma_weight` now"},
      {"octahedral_mesher",
       "--OctahedralMeshing.hue_weight",
       "is called `--OctahedralMeshing.chroma_weight` now"},
      {"octahedral_mesher",
       "--DepthSweep.num_neighbors",
       "can only be set in a project file (--project_path)"},
      {"visual_hull_mesher", "--Smoothing.iterations", "constant now (2)"},
      {"mesh_evaluator", "--Reprojection.min_angle", "constant now (5)"},
      {"mesh_comparer", "--Alignment.tolerance", "constant now (1e-06)"}};
  for (const std::vector<std::string>& example : cases) {
    const ProgramResult result = RunOctacut({example[0], example[1], "1"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, MatchesRegex("ERROR: [^\n]+\n"));
    EXPECT_THAT(result.err, HasSubstr(example[2]));
  }
}

TEST(CommandLine, VersionInBothForms) {
  const ProgramResult version = RunOctacut({"version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, HasSubstr("octacut " + OctacutVersion() + "\n"));
  EXPECT_EQ(RunOctacut({"--version"}).out, version.out);
}

TEST(CommandLine, MistakesAreOneLineAndExitOne) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"vershion"}, "`vershion`; did you mean `version`?"},
      {{"version", "--num_thread", "1"}, "did you mean `--num_threads`?"},
      {{"version", "--num_threads"}, "--num_threads needs a value"},
      {{"version", "--num_threads", "two"}, "--num_threads = two: must be"},
      {{"version", "--num_threads", "0"}, "--num_threads = 0: must be"},
      {{"version", "--log_target", "printer"}, "--log_target = printer: must"},
      {{"version", "--log_level", "-1"}, "--log_level = -1: must be"},
      {{"version", "--random_seed", "-1"}, "--random_seed = -1: must be"},
      {{"version", "--log_color", "maybe"}, "--log_color = maybe: must be"},
      {{"version", "extra"}, "unexpected argument `extra`"},
      {{"version", "--project_path", "/gone.ini"},
       "/gone.ini: the file cannot be"}};
  for (const auto& [arguments, message] : cases) {
    const ProgramResult result = RunOctacut(arguments);
    EXPECT_EQ(result.exit_code, 1) << message;
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, MatchesRegex("ERROR: [^\n]+\n"));
    EXPECT_THAT(result.err, HasSubstr(message));
  }
}

TEST(CommandLine, LogsGoWhereTheOptionsSay) {
  const TemporaryFolder folder;
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"version", "--log_level", "1"});
    return RunOctacut(options);
  };
  const std::string detail = "version with options";
  EXPECT_THAT(run({}).err, HasSubstr(detail));
  EXPECT_THAT(run({"--log_target", "stdout"}).out, HasSubstr(detail));
  EXPECT_THAT(run({"--log_target", "stdout"}).err, IsEmpty());

  const std::string file = (folder / "run.log").string();
  const ProgramResult to_file =
      run({"--log_target", "file", "--log_path", file});
  EXPECT_THAT(to_file.out + to_file.err, Not(HasSubstr(detail)));
  EXPECT_THAT(ReadFile(file), HasSubstr(detail));

  const std::string alone = (folder / "alone.log").string();
  EXPECT_THAT(run({"--log_path", alone}).err, HasSubstr(detail));
  EXPECT_THAT(ReadFile(alone), HasSubstr(detail));

  const std::string both = (folder / "both.log").string();
  EXPECT_THAT(run({"--log_target", "stderr_and_file", "--log_path", both}).err,
              HasSubstr(detail));
  EXPECT_THAT(ReadFile(both), HasSubstr(detail));
  EXPECT_THAT(run({"--log_target",
                   "file",
                   "--log_path",
                   both,
                   "--log_to_stderr",
                   "1",
                   "--log_color",
                   "0"})
                  .err,
              HasSubstr(detail));
}

TEST(CommandLine, ErrorsGoToTheLogFileToo) {
  const TemporaryFolder folder;
  const std::string file = (folder / "run.log").string();
  folder.Write("occupied", "");
  const ProgramResult result = RunOctacut({"example_creator",
                                           "--output_path",
                                           (folder / "occupied").string(),
                                           "--log_target",
                                           "file",
                                           "--log_path",
                                           file});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("ERROR: "));
  EXPECT_THAT(ReadFile(file), HasSubstr("ERROR: "));
}

TEST(CommandLine, SignalsStopARunWithExitCode130) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    RunningOctacut octacut({"example_creator",
                            "--output_path",
                            (folder / "w").string(),
                            "--num_views",
                            "500",
                            "--num_threads",
                            "1",
                            "--log_level",
                            "1"});
    // The first message says that the handler is there.
    while (octacut.Err().empty() && !octacut.HasEnded()) {
      usleep(20000);
    }
    octacut.Signal(signal);
    const ProgramResult result = octacut.Wait();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_THAT(result.err, HasSubstr("ERROR: interrupted\n"));
  }
}

}  // namespace
}  // namespace octacut
