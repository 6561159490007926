#include "plugin/application.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <new>
#include <sstream>

#include "core/base/check_option.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Fails in the way that its option says.
class Failing : public Command {
 public:
  void DeclareOptions(OptionManager& options) override {
    options.Add("how", &how_, "How to fail");
    options.Add("Group.level", &level_, "A level");
  }
  void Run(const CommandEnvironment& environment) override {
    CheckOption(level_ < 10, "level", level_, "must be less than 10");
    if (how_ == "input") throw InputError("cameras.bin: truncated");
    if (how_ == "lines") throw Error("one\ntwo");
    if (how_ == "invariant") throw InvariantError("not manifold");
    if (how_ == "memory") throw std::bad_alloc();
    if (how_ == "standard") throw std::out_of_range("vector");
    if (how_ == "other") throw 5;
    if (how_ == "cancelled") environment.context.ThrowIfCancelled();
    environment.out << "ran with " << environment.context.NumThreads();
  }

 private:
  std::string how_;
  int level_ = 1;
};

constexpr RegistryEntry kCommands[] = {
    {"failing_command",
     "Fails",
     []() -> std::unique_ptr<Command> { return std::make_unique<Failing>(); },
     "Failing"}};

struct Outcome {
  int exit_code;
  std::string out;
  std::string err;
};

Outcome RunFakes(const std::vector<std::string>& arguments,
                 bool interrupted = false) {
  std::ostringstream out;
  std::ostringstream err;
  const std::atomic<bool> cancelled(interrupted);
  const int exit_code =
      RunApplication(arguments, kCommands, out, err, &cancelled);
  return {exit_code, out.str(), err.str()};
}

TEST(RunApplication, RunsACommand) {
  const Outcome outcome = RunFakes({"failing_command", "--num_threads", "3"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "ran with 3");
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST(RunApplication, EveryFailureIsOneLineAndAnExitCode) {
  const auto failure = [](const std::string& how) {
    const Outcome outcome = RunFakes({"failing_command", "--how", how});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_EQ(failure("input"), "ERROR: cameras.bin: truncated\n");
  EXPECT_EQ(failure("lines"), "ERROR: one two\n");
  EXPECT_EQ(failure("invariant"),
            "ERROR: an internal check failed, please report this as a bug: not "
            "manifold\n");
  EXPECT_THAT(failure("memory"), HasSubstr("ERROR: out of memory"));
  EXPECT_EQ(failure("standard"), "ERROR: vector\n");
  EXPECT_EQ(failure("other"), "ERROR: unknown error\n");
}

TEST(RunApplication, ChecksOfStepsNameTheOption) {
  const Outcome outcome = RunFakes({"failing_command", "--Group.level", "10"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "ERROR: --Group.level = 10: must be less than 10\n");
}

TEST(RunApplication, CancellationHasItsOwnExitCode) {
  const Outcome outcome =
      RunFakes({"failing_command", "--how", "cancelled"}, true);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err, "ERROR: interrupted\n");
}

TEST(RunApplication, FailsWhenOutputIsLost) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  const std::vector<std::string> arguments = {"failing_command"};
  EXPECT_EQ(RunApplication(arguments, kCommands, out, err, nullptr), 1);
  EXPECT_EQ(err.str(), "ERROR: cannot write to standard output\n");
  const std::vector<std::string> help = {"help"};
  EXPECT_EQ(RunApplication(help, kCommands, out, err, nullptr), 1);
}

TEST(RunApplication, HelpInAllItsForms) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {}, {"help"}, {"-h"}, {"--help"}, {"help", "-h"}}) {
    const Outcome outcome = RunFakes(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("  failing_command  Fails\n"));
  }
  const Outcome help = RunFakes({"failing_command", "-h"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(RunFakes({"failing_command", "--help"}).out, help.out);
  EXPECT_EQ(RunFakes({"help", "failing_command"}).out, help.out);
  EXPECT_THAT(help.out,
              AllOf(HasSubstr("  --how arg\n        How to fail\n"),
                    HasSubstr("\nGroup:\n  --Group.level arg (=1)\n"),
                    HasSubstr("\nCommon options:\n  --num_threads arg (=-1)")));
}

TEST(RunApplication, UnknownCommandsAreSuggested) {
  EXPECT_EQ(RunFakes({"faling_command"}).err,
            "ERROR: unknown command `faling_command`; did you mean "
            "`failing_command`? to list the commands, run `octacut help`\n");
  EXPECT_EQ(RunFakes({"xyz"}).err,
            "ERROR: unknown command `xyz`; to list the commands, run "
            "`octacut help`\n");
  EXPECT_EQ(RunFakes({"help", "xyz"}).exit_code, 1);
}

}  // namespace
}  // namespace octacut
