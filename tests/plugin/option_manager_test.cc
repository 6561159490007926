#include "plugin/option_manager.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;

enum class Color { kRed, kGreen };

// Options as a command has them.
struct Bound {
  Bound() {
    manager.AddRequired("workspace_path", &workspace_path, "Workspace");
    manager.Add("verbose", &verbose, "A flag");
    manager.AddRepeatable("input_path", &input_paths, "Meshes");
    manager.Add("Meshing.level", &level, "Level");
    manager.Add("Meshing.box", &box, "Box");
    manager.AddEnum("Meshing.color",
                    &color,
                    {{"red", Color::kRed}, {"green", Color::kGreen}},
                    "Colour");
    manager.Add("Meshing.smooth", &smooth, "Smoothing").ForExperts();
    manager.Add("Meshing.rounds", &rounds, "Rounds").ForProjectFiles();
    manager.AddConstant("Meshing.step", 0.5);
    manager.AddRenamed("Meshing.depth", "Meshing.level");
    manager.AddRemoved("Meshing.width", "it is estimated");
  }

  OptionManager::ParseResult Parse(std::vector<std::string> arguments) {
    return manager.Parse(arguments);
  }
  std::string ErrorOf(std::vector<std::string> arguments) {
    try {
      manager.Parse(arguments);
    } catch (const OptionError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path workspace_path;
  bool verbose = false;
  std::vector<std::string> input_paths = {"default.ply"};
  int level = 7;
  std::vector<double> box;
  Color color = Color::kGreen;
  bool smooth = true;
  int rounds = 3;
  OptionManager manager;
};

TEST(OptionManager, DefaultsStayWhenNothingIsGiven) {
  Bound bound;
  EXPECT_EQ(bound.Parse({"--workspace_path", "w"}),
            OptionManager::ParseResult::kRun);
  EXPECT_EQ(bound.workspace_path, "w");
  EXPECT_FALSE(bound.verbose);
  EXPECT_THAT(bound.input_paths, ElementsAre("default.ply"));
  EXPECT_EQ(bound.level, 7);
  EXPECT_THAT(bound.box, ElementsAre());
  EXPECT_EQ(bound.color, Color::kGreen);
}

TEST(OptionManager, ReadsEveryKind) {
  Bound bound;
  bound.Parse({"--workspace_path=a=b",
               "--verbose",
               "1",
               "--Meshing.level",
               "-1",
               "--Meshing.box",
               "-1,-1,-1,1,1,1",
               "--Meshing.color",
               "red",
               "--input_path",
               "a.ply",
               "--input_path=b.ply"});
  EXPECT_EQ(bound.workspace_path, "a=b");
  EXPECT_TRUE(bound.verbose);
  EXPECT_EQ(bound.level, -1);
  EXPECT_THAT(bound.box, ElementsAre(-1, -1, -1, 1, 1, 1));
  EXPECT_EQ(bound.color, Color::kRed);
  EXPECT_THAT(bound.input_paths, ElementsAre("a.ply", "b.ply"));
}

TEST(OptionManager, HelpWinsOverTheRest) {
  EXPECT_EQ(Bound().Parse({"-h"}), OptionManager::ParseResult::kHelp);
  EXPECT_EQ(Bound().Parse({"--verbose", "7", "--help"}),
            OptionManager::ParseResult::kHelp);
}

TEST(OptionManager, RefusesWithOptionValueAndConstraint) {
  EXPECT_EQ(Bound().ErrorOf({}), "option --workspace_path is required");
  EXPECT_EQ(Bound().ErrorOf({"--verbose", "x"}),
            "--verbose = x: must be 0 or 1");
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.color", "blue"}),
            "--Meshing.color = blue: must be one of red, green");
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.level"}),
            "option --Meshing.level needs a value");
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.level", "--verbose", "1"}),
            "option --Meshing.level needs a value");
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.level", "1", "--Meshing.level", "2"}),
            "--Meshing.level is given 2 times, but accepts only one value");
  EXPECT_EQ(Bound().ErrorOf({"--level", "1"}),
            "unknown option `--level`; did you mean `--Meshing.level`?");
  EXPECT_EQ(Bound().ErrorOf({"--zzz", "1"}), "unknown option `--zzz`");
  EXPECT_EQ(Bound().ErrorOf({"-v"}), "unknown option `-v`");
  EXPECT_EQ(Bound().ErrorOf({"word"}), "unexpected argument `word`");
}

TEST(OptionManager, TheCommandLineWinsOverTheProjectFile) {
  const TemporaryFolder folder;
  const std::string file = folder
                               .Write("p.ini",
                                      "workspace_path = from file\n"
                                      "input_path = 1.ply\n"
                                      "input_path = 2.ply\n"
                                      "[Meshing]\n"
                                      "level = 3\n"
                                      "color = red\n")
                               .string();
  Bound bound;
  bound.Parse({"--Meshing.level", "5", "--project_path", file});
  EXPECT_EQ(bound.workspace_path, "from file");
  EXPECT_EQ(bound.level, 5);
  EXPECT_EQ(bound.color, Color::kRed);
  EXPECT_THAT(bound.input_paths, ElementsAre("1.ply", "2.ply"));

  Bound other;
  other.Parse({"--project_path", file, "--input_path", "mine.ply"});
  EXPECT_EQ(other.level, 3);
  EXPECT_THAT(other.input_paths, ElementsAre("mine.ply"));
}

TEST(OptionManager, ProjectFileErrorsNameFileLineAndKey) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& text) {
    const std::string file = folder.Write("p.ini", text).string();
    const std::string error = Bound().ErrorOf({"--project_path", file});
    EXPECT_EQ(error.find(file), 0u) << error;
    return error.substr(std::min(error.size(), file.size()));
  };
  EXPECT_EQ(error_of("\n[Meshing]\nlevle=3\n"),
            ":3: unknown key `Meshing.levle`; did you mean `Meshing.level`?");
  EXPECT_EQ(error_of("[Meshing]\nlevel=x\n"),
            ":2: Meshing.level = x: must be an integer");
  EXPECT_EQ(error_of("verbose=1\nverbose=0\n"),
            ":1: verbose is given 2 times, but accepts only one value");
  EXPECT_EQ(error_of("[ImageReader]\nx=1\n"),
            ":2: unknown key `ImageReader.x`");
  EXPECT_EQ(error_of("project_path=x\n"),
            ":1: project_path can only be set on the command line");
  EXPECT_EQ(Bound().ErrorOf({"--project_path", "/gone.ini"}),
            "--project_path = /gone.ini: the file cannot be opened");
}

TEST(OptionManager, KeysOfProjectFilesAreNoOptions) {
  const TemporaryFolder folder;
  const std::string file =
      folder.Write("p.ini", "[Meshing]\nrounds = 5\nsmooth = 0\n").string();
  Bound bound;
  bound.Parse({"--workspace_path", "w", "--project_path", file});
  EXPECT_EQ(bound.rounds, 5);
  EXPECT_FALSE(bound.smooth);
  EXPECT_TRUE(bound.manager.IsSet("Meshing.rounds"));
  EXPECT_FALSE(bound.manager.IsSet("Meshing.level"));
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.rounds", "5"}),
            "option `--Meshing.rounds` can only be set in a project file "
            "(--project_path), as `Meshing.rounds`");
  EXPECT_EQ(bound.manager.NameOption("rounds = 9: must be less"),
            "Meshing.rounds = 9: must be less");
  // What names its place in a file says more than the option.
  EXPECT_EQ(bound.manager.NameOption("p.ini:2: Meshing.rounds = 9: too many"),
            "p.ini:2: Meshing.rounds = 9: too many");
  // Nor are they suggested.
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.round", "5"}),
            "unknown option `--Meshing.round`; did you mean `--Meshing.box`?");
}

TEST(OptionManager, OptionsOfEarlierVersionsAreExplained) {
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.step", "1"}),
            "option `--Meshing.step` is a constant now (0.5)");
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.depth=1"}),
            "option `--Meshing.depth` is called `--Meshing.level` now");
  EXPECT_EQ(Bound().ErrorOf({"--Meshing.width", "1"}),
            "option `--Meshing.width` has been removed: it is estimated");
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& text) {
    const std::string file = folder.Write("p.ini", text).string();
    return Bound().ErrorOf({"--project_path", file}).substr(file.size());
  };
  EXPECT_EQ(error_of("Meshing.step = 1\n"),
            ":1: key `Meshing.step` is a constant now (0.5)");
  EXPECT_EQ(error_of("[Meshing]\ndepth = 1\n"),
            ":2: key `Meshing.depth` is called `Meshing.level` now");
}

TEST(OptionManager, HelpInBothLengths) {
  using Result = OptionManager::ParseResult;
  EXPECT_EQ(Bound().Parse({"-h"}), Result::kHelp);
  EXPECT_EQ(Bound().Parse({"--help"}), Result::kHelp);
  EXPECT_EQ(Bound().Parse({"--help_all", "1"}), Result::kHelpForExperts);
  EXPECT_EQ(Bound().Parse({"--help_all", "0", "--workspace_path", "w"}),
            Result::kRun);
  EXPECT_EQ(Bound().ErrorOf({"--help_all", "x"}),
            "--help_all = x: must be 0 or 1");
}

TEST(OptionManager, JsonHoldsEveryOptionWithItsValue) {
  Bound bound;
  bound.Parse({"--workspace_path", "w", "--Meshing.level", "8"});
  EXPECT_EQ(bound.manager.ToJson().dump(),
            R"({"project_path":"","workspace_path":"w","verbose":false,)"
            R"("input_path":["default.ply"],"Meshing":{"level":8,)"
            R"("box":[],"color":"green","smooth":true,"rounds":3}})");
}

TEST(OptionManager, CompletesMessagesOfChecks) {
  Bound bound;
  EXPECT_EQ(bound.manager.NameOption("level = 99: must be at most 12"),
            "--Meshing.level = 99: must be at most 12");
  EXPECT_EQ(bound.manager.NameOption("meshing.level = 99: must be less"),
            "--Meshing.level = 99: must be less");
  EXPECT_EQ(bound.manager.NameOption("struct.verbose = 2: must be less"),
            "--verbose = 2: must be less");
  EXPECT_EQ(bound.manager.NameOption("verbose = 1: not now"),
            "--verbose = 1: not now");
  // A struct's name may be a part of the option's.
  bound.manager.Add("box_size", &bound.level, "Size");
  EXPECT_EQ(bound.manager.NameOption("box.size = 0: must be positive"),
            "--box_size = 0: must be positive");
  for (const char* message :
       {"other = 1: no", "no field at all", "--Other.level = 1: no", ""}) {
    EXPECT_EQ(bound.manager.NameOption(message), message);
  }
}

TEST(OptionManager, CompletesFieldsInMessages) {
  const Bound bound;
  EXPECT_EQ(bound.manager.NameOptionsIn("Set `level` or raise `rounds`."),
            "Set --Meshing.level or raise Meshing.rounds.");
  EXPECT_EQ(bound.manager.NameOptionsIn("x`y`level` z"),
            "x`y--Meshing.level z");
  for (const char* message :
       {"", "`", "``", "level", "of `a b` and `", "`x`"}) {
    EXPECT_EQ(bound.manager.NameOptionsIn(message), message);
  }
}

TEST(OptionManager, RefusesADoubleDeclaration) {
  Bound bound;
  EXPECT_THROW(bound.manager.Add("verbose", &bound.verbose, ""),
               InvariantError);
}

}  // namespace
}  // namespace octacut
