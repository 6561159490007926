#include "plugin/bash_completion.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "colmap_io/files/read_file.h"
#include "plugin/man_page.h"
#include "plugin/report.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// What bash would offer after these words.
std::string CompletionsOf(const std::string& words) {
  const TemporaryFolder folder;
  const std::string script =
      folder.Write("octacut.bash", BashCompletion(CommandRegistry())).string();
  folder.Write("run.sh",
               fmt::format("compopt() {{ :; }}\n"
                           "source '{}'\n"
                           "cd '{}'\n"
                           "COMP_WORDS=(octacut {})\n"
                           "COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))\n"
                           "_octacut\n"
                           "echo \"${{COMPREPLY[*]}}\"\n",
                           script,
                           folder.Path().string(),
                           words));
  const std::string command = fmt::format("bash '{0}' >'{1}' 2>&1",
                                          (folder / "run.sh").string(),
                                          (folder / "out").string());
  EXPECT_EQ(std::system(command.c_str()), 0);
  return ReadFile(folder / "out");
}

TEST(BashCompletion, OffersCommandsOptionsValuesAndFiles) {
  EXPECT_EQ(CompletionsOf("octa"), "octahedral_mesher\n");
  EXPECT_EQ(CompletionsOf("help mesh_c"), "mesh_comparer\n");
  EXPECT_EQ(CompletionsOf("octahedral_mesher --qual"), "--quality\n");
  EXPECT_EQ(CompletionsOf("octahedral_mesher --quality ''"),
            "low medium high extreme\n");
  EXPECT_EQ(CompletionsOf("octahedral_mesher --output_path run."), "run.sh\n");
  EXPECT_EQ(CompletionsOf("octahedral_mesher --num_threads ''"), "\n");
  // Neither keys of project files nor options without effect.
  EXPECT_EQ(CompletionsOf("octahedral_mesher --DepthSweep"), "\n");
  EXPECT_EQ(CompletionsOf("octahedral_mesher --random"), "\n");
}

TEST(ManPage, DescribesEveryCommandAndItsOptions) {
  const std::string page = ManPage(CommandRegistry());
  EXPECT_THAT(page, HasSubstr("octacut " + OctacutVersion()));
  for (const RegistryEntry& command : CommandRegistry()) {
    EXPECT_THAT(page, HasSubstr(".SS " + std::string(command.name) + "\n"));
  }
  EXPECT_THAT(page,
              AllOf(HasSubstr("\\fB\\-\\-quality\\fR \\fIarg\\fR (=high)\n"),
                    HasSubstr("\\fB\\-\\-workspace_path\\fR \\fIarg\\fR "
                              "(required)\n"),
                    Not(HasSubstr("DepthSweep"))));
}

}  // namespace
}  // namespace octacut
