// Parallel loops over index ranges on at most Context::NumThreads() threads.
//
// The chunks depend on the sizes alone, never on the number of threads, so a
// body that writes only what its indices own gives the same bytes for any
// number of threads; reductions go through ParallelChunks and are combined by
// the caller in the order of the chunks, sums of integers through ParallelSum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/base/context.h"

namespace octacut {

// Calls body(begin, end) for consecutive chunks of at most `grain` indices
// that cover [0, count). An exception of a body ends the loop and is thrown
// on. Asks for cancellation between chunks.
void ParallelFor(const Context& context,
                 size_t count,
                 size_t grain,
                 const std::function<void(size_t begin, size_t end)>& body);

// Calls body(i) for each index of those chunks, in their order within a chunk.
template <typename Body>
void ParallelEach(const Context& context,
                  size_t count,
                  size_t grain,
                  Body&& body) {
  ParallelFor(context, count, grain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      body(i);
    }
  });
}

// Number of chunks that ParallelFor makes of `count` with `grain`; chunk k
// begins at k * grain.
inline size_t NumChunks(size_t count, size_t grain) {
  return (count + grain - 1) / grain;
}

// Calls body(chunk, begin, end) like ParallelFor, with the chunk's number.
void ParallelChunks(
    const Context& context,
    size_t count,
    size_t grain,
    const std::function<void(size_t chunk, size_t begin, size_t end)>& body);

// The sum of body(begin, end) over those chunks.
int64_t ParallelSum(
    const Context& context,
    size_t count,
    size_t grain,
    const std::function<int64_t(size_t begin, size_t end)>& body);

}  // namespace octacut
