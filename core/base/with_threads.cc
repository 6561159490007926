#include "core/base/with_threads.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace octacut {

void WithThreads(int num_threads, const std::function<void()>& body) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  size_t(num_threads));
  tbb::task_arena arena(num_threads);
  arena.execute(body);
}

}  // namespace octacut
