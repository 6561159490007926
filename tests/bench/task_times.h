// CPU seconds of the tasks of a search, and what they let n cores gain.
#pragma once

#include <map>
#include <utility>

#include "core/cut/implicit_cut.h"

namespace octacut {

// Collects from a search on one thread.
class TaskTimes {
 public:
  SearchObserver Observer();

  double Total() const;
  // Seconds that `num_cores` equal cores need when each takes a task as soon
  // as it is free and both halves of the task are done.
  double Makespan(int num_cores) const;

 private:
  using Range = std::pair<size_t, size_t>;  // of regions

  std::map<Range, double> seconds_;
  double begin_ = 0;
};

}  // namespace octacut
