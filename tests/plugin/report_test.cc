#include "plugin/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;

TEST(PhaseTimer, KeepsPhasesInOrderWithTheirDepth) {
  PhaseTimer timer(nullptr);
  const Context context(1, &timer);
  {
    const Phase a(context, "a");
    { const Phase b(context, "b"); }
    const Phase c(context, "c");
  }
  const Phase d(context, "d");
  context.Warn("careful");
  const std::vector<PhaseTiming> timings = timer.Timings();
  ASSERT_EQ(timings.size(), 4u);
  std::string order;
  for (const PhaseTiming& timing : timings) {
    order += timing.name + std::to_string(timing.depth);
  }
  EXPECT_EQ(order, "a0b1c1d0");
  EXPECT_GE(timings[0].seconds, timings[1].seconds + timings[2].seconds);
  EXPECT_GE(timer.TotalSeconds(), timings[0].seconds);
  EXPECT_THAT(timer.Warnings(), ElementsAre("careful"));
}

TEST(Report, HoldsWhatEveryCommandHasInCommon) {
  OptionManager options;
  int level = 7;
  options.Add("Group.level", &level, "");
  level = 8;
  PhaseTimer timer(nullptr);
  const Context context(3, &timer);
  { const Phase phase(context, "cut"); }
  std::ostringstream out;
  const Json report =
      MakeReport({"test_command", options, context, timer, out});
  EXPECT_EQ(report["program"], "octacut");
  EXPECT_EQ(report["version"], OctacutVersion());
  EXPECT_EQ(report["command"], "test_command");
  EXPECT_EQ(report["options"]["Group"]["level"], 8);
  EXPECT_EQ(report["num_threads"], 3);
  EXPECT_EQ(report["phases"][0]["name"], "cut");
  EXPECT_GT(report["peak_memory_bytes"], 1000000);
  EXPECT_GE(report["seconds"], report["phases"][0]["seconds"]);
}

TEST(PeakMemory, GrowsWithUse) {
  const uint64_t before = PeakMemoryBytes();
  const size_t size = before + (size_t(64) << 20);
  const std::vector<char> block(size, 1);
  EXPECT_GE(PeakMemoryBytes(), size);
  EXPECT_EQ(block.back(), 1);
}

TEST(WriteReport, ReplacesTheFileAsAWhole) {
  const TemporaryFolder folder;
  const auto path = folder.Write("r.json", "an older, much longer report\n\n");
  Json report;
  report["name"] = "not \xff UTF-8";
  WriteReport(path, report);
  EXPECT_EQ(Json::parse(ReadFile(path))["name"], "not \xEF\xBF\xBD UTF-8");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.Path()),
                          std::filesystem::directory_iterator()),
            1);
  EXPECT_THROW(WriteReport(folder / "gone" / "r.json", report), Error);
  EXPECT_THROW(WriteReport(folder.Path(), report), Error);
}

}  // namespace
}  // namespace octacut
