#include "plugin/application.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <opencv2/core.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/base/with_threads.h"
#include "plugin/common_options.h"
#include "plugin/help_text.h"
#include "plugin/log.h"
#include "plugin/option_naming.h"
#include "plugin/progress.h"
#include "plugin/suggestion.h"

namespace octacut {
namespace {

// What went wrong, as one line and an exit code.
struct Failure {
  std::string message;
  int exit_code = kExitFailure;
};

std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Failure OutOfMemory() {
  return {
      "out of memory; fewer images, a coarser mesh, or in meshers a lower "
      "--OctahedralMeshing.target_level need less"};
}

// To be called in a catch block.
Failure DescribeCurrentException(const OptionManager& options) {
  try {
    throw;
  } catch (const CancelledError& error) {
    return {error.what(), kExitInterrupted};
  } catch (const OptionError& error) {
    return {options.NameOption(OneLine(error.what()))};
  } catch (const InvariantError& error) {
    return {OneLine(
        fmt::format("an internal check failed, please report this as a bug: {}",
                    error.what()))};
  } catch (const std::bad_alloc&) {
    return OutOfMemory();
  } catch (const cv::Exception& error) {
    return error.code == cv::Error::StsNoMem ? OutOfMemory()
                                             : Failure{OneLine(error.what())};
  } catch (const std::exception& error) {
    return {options.NameOptionsIn(OneLine(error.what()))};
  } catch (...) {
    return {"unknown error"};
  }
}

const RegistryEntry& FindCommand(std::span<const RegistryEntry> commands,
                                 const std::string& name) {
  std::vector<std::string> names = {"help"};
  for (const RegistryEntry& command : commands) {
    if (command.name == name) {
      return command;
    }
    names.emplace_back(command.name);
  }
  const std::string nearest = NearestName(name, names);
  throw OptionError(fmt::format(
      "unknown command `{}`; {}to list the commands, run `octacut help`",
      name,
      nearest.empty() ? "" : fmt::format("did you mean `{}`? ", nearest)));
}

// What a run has besides its command.
struct RunSettings {
  const OptionManager& options;
  const CommonOptions& common;
  std::ostream& out;
  const std::atomic<bool>* cancelled;
};

void RunWithProgress(const RegistryEntry& entry,
                     const RunSettings& settings,
                     Command& command,
                     Log& log) {
  const auto& [options, common, out, cancelled] = settings;
  ProgressReporter progress(log);
  PhaseTimer timer(&progress);
  OptionNaming naming(options, &timer);
  const Context context(
      common.num_threads, &naming, cancelled, common.random_seed);
  const CommandEnvironment environment{
      entry.name, options, context, timer, out};
  WithThreads(context.NumThreads(), [&] { command.Run(environment); });
}

// The part of a run that has a log; errors go to its file, too.
void RunLogged(const RegistryEntry& entry,
               const RunSettings& settings,
               Command& command) {
  const OptionManager& options = settings.options;
  Log log(settings.common.log, entry.name);
  log.Debug(fmt::format(
      "{} with options {}",
      entry.name,
      options.ToJson().dump(-1, ' ', false, Json::error_handler_t::replace)));
  try {
    RunWithProgress(entry, settings, command, log);
  } catch (...) {
    log.ErrorToFile(DescribeCurrentException(options).message);
    throw;
  }
}

void FlushOrThrow(std::ostream& out) {
  out.flush();
  if (!out) {
    throw Error("cannot write to standard output");
  }
}

int RunCommand(const RegistryEntry& entry,
               std::span<const std::string> arguments,
               std::ostream& out,
               std::ostream& err,
               const std::atomic<bool>* cancelled) {
  OptionManager options;
  try {
    const std::unique_ptr<Command> command = entry.make();
    command->DeclareOptions(options);
    CommonOptions common;
    common.Declare(options, command->UsesRandomSeed());
    const OptionManager::ParseResult parsed = options.Parse(arguments);
    if (parsed != OptionManager::ParseResult::kRun) {
      out << CommandHelp(entry,
                         options,
                         parsed == OptionManager::ParseResult::kHelpForExperts);
    } else {
      common.Check();
      RunLogged(entry, {options, common, out, cancelled}, *command);
    }
    FlushOrThrow(out);
    return kExitSuccess;
  } catch (...) {
    const Failure failure = DescribeCurrentException(options);
    err << "ERROR: " << failure.message << std::endl;
    return failure.exit_code;
  }
}

}  // namespace

int RunApplication(std::span<const std::string> arguments,
                   std::span<const RegistryEntry> commands,
                   std::ostream& out,
                   std::ostream& err,
                   const std::atomic<bool>* cancelled) {
  try {
    std::string name = arguments.empty() ? "help" : arguments.front();
    arguments = arguments.empty() ? arguments : arguments.subspan(1);
    if (name == "--version") {
      name = "version";
    }
    const bool is_help = name == "help" || name == "-h" || name == "--help";
    if (is_help && (arguments.empty() || arguments.front() == "help" ||
                    arguments.front().starts_with('-'))) {
      out << ProgramHelp(commands);
      FlushOrThrow(out);
      return kExitSuccess;
    }
    if (is_help) {
      const std::vector<std::string> help = {"--help"};
      return RunCommand(
          FindCommand(commands, arguments.front()), help, out, err, cancelled);
    }
    return RunCommand(
        FindCommand(commands, name), arguments, out, err, cancelled);
  } catch (...) {
    err << "ERROR: " << DescribeCurrentException(OptionManager()).message
        << std::endl;
    return kExitFailure;
  }
}

}  // namespace octacut
