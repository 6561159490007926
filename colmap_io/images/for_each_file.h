// Loops over files whose decoded content is large.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "core/base/context.h"

namespace octacut {

// Bytes that decoded files may take, where nothing else is asked for: a few
// photographs of a phone with what is computed from them.
inline constexpr size_t kDecodeBudget = size_t{1} << 30;

struct FileLoop {
  size_t count = 0;           // of files
  size_t bytes_per_file = 1;  // that decoding one takes, at most
  // What all in flight may take; one always may.
  size_t byte_budget = kDecodeBudget;
};

// Calls body(i) for every file, on as many threads as the budget allows, in a
// phase of that name. Of several InputErrors that of the first file in order is
// thrown, so that the message does not depend on the threads.
void ForEachFile(const FileLoop& loop,
                 std::string_view phase_name,
                 const Context& context,
                 const std::function<void(size_t i)>& body);

}  // namespace octacut
