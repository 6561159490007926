// Runs octacut as a user would: in this process, which saves loading its many
// libraries again and again, or the executable that the environment variable
// OCTACUT_EXECUTABLE names (an installed one).
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {

struct ProgramResult {
  int exit_code = -1;  // 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

// The path of the executable under test, which is the built one if the
// environment names no other.
std::string ExecutablePath();

// An executable that is running, for what needs a process: signals.
class RunningOctacut {
 public:
  explicit RunningOctacut(const std::vector<std::string>& arguments);
  ~RunningOctacut();
  RunningOctacut(const RunningOctacut&) = delete;
  RunningOctacut& operator=(const RunningOctacut&) = delete;

  void Signal(int signal);
  // What it has written to stderr so far.
  std::string Err() const;
  bool HasEnded();
  ProgramResult Wait();

 private:
  TemporaryFolder folder_;
  pid_t process_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

// Runs it to its end.
ProgramResult RunOctacut(const std::vector<std::string>& arguments);

}  // namespace octacut
