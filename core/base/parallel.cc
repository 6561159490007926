#include "core/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace octacut {

void ParallelChunks(const Context& context,
                    size_t count,
                    size_t grain,
                    const std::function<void(size_t, size_t, size_t)>& body) {
  const size_t num_chunks = NumChunks(count, grain);
  const auto run_chunk = [&](size_t chunk) {
    context.ThrowIfCancelled();
    const size_t begin = chunk * grain;
    body(chunk, begin, std::min(count, begin + grain));
  };
  if (context.NumThreads() == 1 || num_chunks <= 1) {
    for (size_t chunk = 0; chunk < num_chunks; ++chunk) {
      run_chunk(chunk);
    }
    return;
  }
  // No more threads than cores, or than WithThreads allows: oneTBB would not
  // give them, and complain.
  tbb::task_arena arena(
      std::min(context.NumThreads(), tbb::this_task_arena::max_concurrency()));
  arena.execute([&] { tbb::parallel_for(size_t{0}, num_chunks, run_chunk); });
}

void ParallelFor(const Context& context,
                 size_t count,
                 size_t grain,
                 const std::function<void(size_t, size_t)>& body) {
  ParallelChunks(context, count, grain, [&](size_t, size_t begin, size_t end) {
    body(begin, end);
  });
}

}  // namespace octacut
