#include "plugin/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>

#include <cstdio>
#include <sstream>

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

// Every status and line at once, whatever the machine's speed.
ProgressReporter::Intervals NoIntervals() { return {{}, {}}; }

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

void RunPhases(ProgressReporter& reporter) {
  const Context context(1, &reporter);
  Phase outer(context, "level 8");
  {
    Phase inner(context, "cut", 40);
    for (int i = 0; i < 40; ++i) {
      inner.Advance();
    }
  }
  context.Warn("careful");
}

TEST(FormatDuration, ReadsLikeAClock) {
  using std::chrono::seconds;
  EXPECT_EQ(FormatDuration(seconds(0)), "0:00");
  EXPECT_EQ(FormatDuration(seconds(7)), "0:07");
  EXPECT_EQ(FormatDuration(seconds(750)), "12:30");
  EXPECT_EQ(FormatDuration(seconds(3723)), "1:02:03");
  EXPECT_EQ(FormatDuration(std::chrono::milliseconds(59700)), "1:00");
}

TEST(ProgressReporter, PlainLinesWithoutATerminal) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  ProgressReporter reporter(log, NoIntervals());
  RunPhases(reporter);
  const std::vector<std::string> lines = LinesOf(console);
  ASSERT_EQ(lines.size(), 14u) << console.str();
  EXPECT_EQ(lines[0], "level 8 ...");
  EXPECT_EQ(lines[1], "  cut ...");
  for (size_t tenth = 1; tenth < 10; ++tenth) {
    EXPECT_THAT(lines[1 + tenth],
                HasSubstr("  cut  " + std::to_string(10 * tenth) + " %, "));
    EXPECT_THAT(lines[1 + tenth], HasSubstr(" left"));
  }
  EXPECT_THAT(lines[11], MatchesRegex("  cut: [0-9]+.[0-9]+ s"));
  EXPECT_EQ(lines[12], "WARNING: careful");
  EXPECT_THAT(lines[13], MatchesRegex("level 8: [0-9]+.[0-9]+ s"));
}

TEST(ProgressReporter, FewLinesOfFastPhases) {
  std::ostringstream console;
  Log log(SinkTo(console), nullptr, nullptr);
  ProgressReporter reporter(log,
                            {std::chrono::hours(1), std::chrono::hours(1)});
  RunPhases(reporter);
  EXPECT_EQ(LinesOf(console).size(), 5u) << console.str();
}

TEST(ProgressReporter, OneLineThatIsUpdatedOnATerminal) {
  std::ostringstream console;
  std::ostringstream file;
  char* text = nullptr;
  size_t size = 0;
  std::FILE* const terminal = open_memstream(&text, &size);
  {
    Log log(SinkTo(console), SinkTo(file), terminal);
    ProgressReporter reporter(log, NoIntervals());
    RunPhases(reporter);
  }
  std::fclose(terminal);
  const std::string screen(text, size);
  std::free(text);
  EXPECT_THAT(screen, Not(HasSubstr("\n")));
  EXPECT_THAT(screen, HasSubstr("\r\033[Kcut  50 %, 0:00 elapsed, about "));
  EXPECT_TRUE(screen.ends_with("\r\033[K")) << "the last status stays";
  // Lines that stay: messages and the end of outer phases.
  EXPECT_EQ(LinesOf(console).size(), 2u) << console.str();
  // The file gets the plain lines all the same.
  EXPECT_EQ(LinesOf(file).size(), 14u) << file.str();
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
