// The JSON report of a run: what every command has in common.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "colmap_io/files/atomic_files.h"
#include "plugin/command.h"

namespace octacut {

// Such as "0.2.0".
std::string OctacutVersion();

// The most memory that this process ever held (VmHWM of /proc/self/status),
// bytes; 0 where the system does not tell.
uint64_t PeakMemoryBytes();

// {"program", "version", "command", "options": {...}, "num_threads",
//  "host_threads", "warnings": [...], "phases": [{"name", "depth",
//  "seconds"}, ...], "seconds", "peak_memory_bytes"}: as of the time of the
// call, so the last thing to do before WriteReport. A command adds its own
// members.
Json MakeReport(const CommandEnvironment& environment);

// Replaces `path` as a whole or leaves it as it was. Text that is not UTF-8
// (names of files may be) is written with replacement characters. Throws
// InputError.
void WriteReport(const std::filesystem::path& path, const Json& report);
// Together with `files`, when these are committed.
void WriteReport(const std::filesystem::path& path,
                 const Json& report,
                 AtomicFiles* files);

}  // namespace octacut
