#include "tests/plugin/run_octacut.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "colmap_io/files/read_file.h"
#include "plugin/application.h"

namespace octacut {
namespace {

// In the child: everything here is safe after fork.
[[noreturn]] void Execute(const char* out,
                          const char* err,
                          char* const* arguments) {
  const int out_file = open(out, O_CREAT | O_WRONLY | O_TRUNC, 0600);
  const int err_file = open(err, O_CREAT | O_WRONLY | O_TRUNC, 0600);
  dup2(out_file, STDOUT_FILENO);
  dup2(err_file, STDERR_FILENO);
  execv(arguments[0], arguments);
  _exit(127);
}

void FlushStandardStreams() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

// Writes what comes to a standard stream into a file instead.
class Redirection {
 public:
  Redirection(int stream, const std::filesystem::path& path)
      : stream_(stream), original_(dup(stream)) {
    FlushStandardStreams();
    const int file = open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    if (original_ < 0 || file < 0) {
      throw std::runtime_error("cannot redirect a standard stream");
    }
    dup2(file, stream);
    close(file);
  }
  ~Redirection() {
    FlushStandardStreams();
    dup2(original_, stream_);
    close(original_);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

 private:
  int stream_;
  int original_;
};

// What main() does.
ProgramResult RunInThisProcess(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  ProgramResult result;
  {
    const Redirection out(STDOUT_FILENO, folder / "out");
    const Redirection err(STDERR_FILENO, folder / "err");
    result.exit_code = RunApplication(
        arguments, CommandRegistry(), std::cout, std::cerr, nullptr);
  }
  result.out = ReadFile(folder / "out");
  result.err = ReadFile(folder / "err");
  return result;
}

const char* OtherExecutable() { return std::getenv("OCTACUT_EXECUTABLE"); }

}  // namespace

std::string ExecutablePath() {
  return OtherExecutable() != nullptr ? OtherExecutable() : OCTACUT_EXECUTABLE;
}

RunningOctacut::RunningOctacut(const std::vector<std::string>& arguments) {
  std::vector<std::string> texts = {ExecutablePath()};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  pointers.push_back(nullptr);
  const std::string out = (folder_ / "out").string();
  const std::string err = (folder_ / "err").string();
  process_ = fork();
  if (process_ == 0) {
    Execute(out.c_str(), err.c_str(), pointers.data());
  }
  if (process_ < 0) {
    throw std::runtime_error("cannot fork");
  }
}

RunningOctacut::~RunningOctacut() {
  if (!ended_) {
    Signal(SIGKILL);
    Wait();
  }
}

void RunningOctacut::Signal(int signal) {
  if (!HasEnded()) {
    kill(process_, signal);
  }
}

std::string RunningOctacut::Err() const {
  // The child may not have opened it yet.
  const std::filesystem::path path = folder_ / "err";
  return std::filesystem::exists(path) ? ReadFile(path) : "";
}

bool RunningOctacut::HasEnded() {
  ended_ = ended_ || waitpid(process_, &status_, WNOHANG) == process_;
  return ended_;
}

ProgramResult RunningOctacut::Wait() {
  if (!ended_) {
    waitpid(process_, &status_, 0);
    ended_ = true;
  }
  return {WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_),
          ReadFile(folder_ / "out"),
          ReadFile(folder_ / "err")};
}

ProgramResult RunOctacut(const std::vector<std::string>& arguments) {
  return OtherExecutable() != nullptr ? RunningOctacut(arguments).Wait()
                                      : RunInThisProcess(arguments);
}

}  // namespace octacut
