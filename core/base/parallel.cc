#include "core/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace octacut {
namespace {

#ifdef __SANITIZE_THREAD__

// The thread sanitizer does not see the synchronisation inside Debian's oneTBB
// and would report every loop; plain threads it understands.
template <typename Body>
void RunOnThreads(int num_threads, size_t count, const Body& body) {
  std::atomic<size_t> next(0);
  std::exception_ptr error;
  std::mutex error_mutex;
  std::vector<std::thread> threads;
  for (int i = 0; i < num_threads; ++i) {
    threads.emplace_back([&] {
      try {
        for (size_t k = next++; k < count; k = next++) {
          body(k);
        }
      } catch (...) {
        next = count;
        const std::lock_guard lock(error_mutex);
        error = error ? error : std::current_exception();
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  if (error) {
    std::rethrow_exception(error);
  }
}

#else

template <typename Body>
void RunOnThreads(int num_threads, size_t count, const Body& body) {
  // No more threads than cores, or than WithThreads allows: oneTBB would not
  // give them, and complain.
  tbb::task_arena arena(
      std::min(num_threads, tbb::this_task_arena::max_concurrency()));
  // Chunks are as large as tasks should be: none waits for the one before it.
  arena.execute([&] {
    tbb::parallel_for(size_t{0}, count, body, tbb::simple_partitioner());
  });
}

#endif

}  // namespace

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
  RunOnThreads(context.NumThreads(), num_chunks, run_chunk);
}

void ParallelFor(const Context& context,
                 size_t count,
                 size_t grain,
                 const std::function<void(size_t, size_t)>& body) {
  ParallelChunks(context, count, grain, [&](size_t, size_t begin, size_t end) {
    body(begin, end);
  });
}

int64_t ParallelSum(const Context& context,
                    size_t count,
                    size_t grain,
                    const std::function<int64_t(size_t, size_t)>& body) {
  std::atomic<int64_t> sum(0);
  ParallelChunks(context, count, grain, [&](size_t, size_t begin, size_t end) {
    sum += body(begin, end);
  });
  return sum;
}

}  // namespace octacut
