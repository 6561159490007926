// What this process has used so far.
#pragma once

#include <ctime>
#include <fstream>
#include <string>

namespace octacut {

inline double CpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Resident bytes now ("VmRSS") or at most so far ("VmHWM").
inline double ResidentBytes(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(field + ":")) {
      return 1024 * std::stod(line.substr(field.size() + 1));
    }
  }
  return 0;
}

}  // namespace octacut
