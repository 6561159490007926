#include "colmap_io/images/for_each_file.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {

void ForEachFile(const FileLoop& loop,
                 std::string_view phase_name,
                 const Context& context,
                 const std::function<void(size_t i)>& body) {
  const size_t in_flight = std::clamp(loop.byte_budget / loop.bytes_per_file,
                                      size_t{1},
                                      size_t(context.NumThreads()));
  std::vector<std::optional<std::string>> errors(loop.count);
  Phase phase(context, phase_name, loop.count);
  const size_t batch = 4 * in_flight;
  for (size_t first = 0; first < loop.count; first += batch) {
    const size_t count = std::min(batch, loop.count - first);
    const size_t grain = (count + in_flight - 1) / in_flight;
    ParallelEach(context, count, grain, [&](size_t k) {
      const size_t i = first + k;
      try {
        body(i);
      } catch (const InputError& error) {
        errors[i] = error.what();
      }
      phase.Advance();
    });
    for (const auto& error : errors) {
      if (error) {
        throw InputError(*error);
      }
    }
  }
}

}  // namespace octacut
