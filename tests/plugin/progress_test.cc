#include "plugin/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>

#include <cstdio>
#include <sstream>

#include "core/base/error.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

// Every status and line at once, whatever the machine's speed.
ProgressReporter::Intervals NoIntervals() { return {{}, {}, {}}; }

// Ended phases alone.
ProgressReporter::Intervals LongIntervals() {
  return {std::chrono::hours(1), std::chrono::hours(1), {}};
}

spdlog::sink_ptr SinkTo(std::ostringstream& stream) {
  return std::make_shared<spdlog::sinks::ostream_sink_mt>(stream);
}

std::vector<std::string> LinesOf(const std::ostringstream& stream) {
  std::vector<std::string> lines;
  std::istringstream text(stream.str());
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

// As a level does: some phases twice, one with an inner phase.
void RunPhases(ProgressReporter& reporter) {
  const Context context(1, &reporter);
  for (int run = 0; run < 2; ++run) {
    {
      const Phase outer(context, "photo-consistency");
      Phase inner(context, "patches", 40);
      for (int i = 0; i < 40; ++i) {
        inner.Advance();
      }
    }
    const Phase cut(context, run == 0 ? "cut" : "cut again");
  }
  context.Warn("careful");
  const Phase last(context, "colours");
}

TEST(FormatDuration, ReadsLikeAClock) {
  using std::chrono::seconds;
  EXPECT_EQ(FormatDuration(seconds(0)), "0:00");
  EXPECT_EQ(FormatDuration(seconds(7)), "0:07");
  EXPECT_EQ(FormatDuration(seconds(750)), "12:30");
  EXPECT_EQ(FormatDuration(seconds(3723)), "1:02:03");
  EXPECT_EQ(FormatDuration(std::chrono::milliseconds(59700)), "1:00");
}

TEST(ProgressReporter, EndedPhasesAreSummedBeforeTheNextMessage) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  {
    ProgressReporter reporter(log, LongIntervals());
    RunPhases(reporter);
    EXPECT_EQ(LinesOf(console).size(), 4u) << "colours may be repeated";
  }
  const std::vector<std::string> lines = LinesOf(console);
  ASSERT_EQ(lines.size(), 5u) << console.str();
  EXPECT_THAT(lines[0],
              MatchesRegex("Photo-consistency: [0-9]+.[0-9] s in 2 runs"));
  EXPECT_THAT(lines[1], MatchesRegex("Cut: [0-9]+.[0-9] s"));
  EXPECT_THAT(lines[2], MatchesRegex("Cut again: [0-9]+.[0-9] s"));
  EXPECT_EQ(lines[3], "WARNING: careful");
  EXPECT_THAT(lines[4], MatchesRegex("Colours: [0-9]+.[0-9] s"));
}

TEST(ProgressReporter, PhasesThatTookNoTimeAreLeftOut) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  {
    ProgressReporter reporter(log);
    RunPhases(reporter);
  }
  EXPECT_THAT(LinesOf(console), ElementsAre("WARNING: careful"));
}

TEST(ProgressReporter, LongPhasesHaveLinesOfProgressWithoutATerminal) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  ProgressReporter reporter(log, NoIntervals());
  reporter.BeginPhase("masks", 0);
  reporter.EndPhase();
  reporter.BeginPhase("cut", 4);
  reporter.Advance(1);
  const std::vector<std::string> lines = LinesOf(console);
  ASSERT_EQ(lines.size(), 2u) << console.str();
  EXPECT_THAT(lines[0], HasSubstr("Masks: "));
  EXPECT_THAT(lines[1],
              MatchesRegex("Cut  25 %, [0-9:]+ elapsed, about [0-9:]+ left"));
  reporter.EndPhase();
}

TEST(ProgressReporter, PhasesThatAnErrorEndsAreStopped) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  try {
    ProgressReporter reporter(log);
    const Context context(1, &reporter);
    const Phase phase(context, "cut");
    throw CancelledError();
  } catch (const CancelledError&) {
  }
  EXPECT_THAT(LinesOf(console), ElementsAre("Cut: stopped after 0.0 s"));
}

TEST(ProgressReporter, ABarThatIsUpdatedOnATerminal) {
  std::ostringstream console;
  std::ostringstream file;
  char* text = nullptr;
  size_t size = 0;
  std::FILE* const terminal = open_memstream(&text, &size);
  {
    Log log(SinkTo(console), SinkTo(file), terminal);
    ProgressReporter reporter(log,
                              {{}, std::chrono::hours(1), /*shortest=*/{}});
    RunPhases(reporter);
  }
  std::fclose(terminal);
  const std::string screen(text, size);
  std::free(text);
  EXPECT_THAT(screen, Not(HasSubstr("\n")));
  EXPECT_THAT(screen,
              HasSubstr("\r\033[KPatches [##########----------]  50 %, 0:00 "
                        "elapsed, about "));
  EXPECT_TRUE(screen.ends_with("\r\033[K")) << "the last status stays";
  // Lines that stay are the same everywhere.
  EXPECT_EQ(LinesOf(console).size(), 5u) << console.str();
  EXPECT_EQ(LinesOf(file), LinesOf(console));
}

TEST(ProgressReporter, ReportsThatOvertakeEachOtherDoNoHarm) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  ProgressReporter reporter(log, NoIntervals());
  reporter.Advance(3);  // no phase: ignored
  reporter.EndPhase();
  reporter.BeginPhase("x", 10);
  reporter.Advance(5);
  reporter.Advance(3);    // late
  reporter.Advance(100);  // more than announced
  reporter.EndPhase();
  EXPECT_THAT(
      console.str(),
      AllOf(
          HasSubstr("50 %"), Not(HasSubstr("30 %")), Not(HasSubstr("1000 %"))));
}

TEST(ProgressReporter, PhasesOfUnknownSizeHaveNoPercentage) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  ProgressReporter reporter(log, NoIntervals());
  reporter.BeginPhase("x", 0);
  reporter.Advance(5);
  reporter.EndPhase();
  EXPECT_THAT(console.str(), Not(HasSubstr("%")));
}

}  // namespace
}  // namespace octacut
