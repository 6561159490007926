// Loops over files whose decoded content is large.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "core/base/context.h"

namespace octacut {

struct FileLoop {
  size_t count = 0;           // of files
  size_t bytes_per_file = 1;  // that decoding one takes, at most
  size_t byte_budget = 1;     // that all in flight may take; one always may
};

// Calls body(i) for every file, on as many threads as the budget allows, in a
// phase of that name. Of several InputErrors that of the first file in order is
// thrown, so that the message does not depend on the threads.
void ForEachFile(const FileLoop& loop,
                 std::string_view phase_name,
                 const Context& context,
                 const std::function<void(size_t i)>& body);

}  // namespace octacut
