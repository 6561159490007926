#include "tests/bench/task_times.h"

#include <algorithm>
#include <ctime>
#include <queue>
#include <vector>

namespace octacut {
namespace {

double ThreadCpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}  // namespace

SearchObserver TaskTimes::Observer() {
  return [this](size_t begin, size_t end, bool begins) {
    if (begins) {
      begin_ = ThreadCpuSeconds();
    } else {
      seconds_[{begin, end}] = ThreadCpuSeconds() - begin_;
    }
  };
}

double TaskTimes::Total() const {
  double total = 0;
  for (const auto& [range, seconds] : seconds_) {
    total += seconds;
  }
  return total;
}

double TaskTimes::Makespan(int num_cores) const {
  // A range waits for its halves; both meet at the middle.
  std::map<Range, Range> parents;
  std::map<Range, int> waits;
  std::vector<Range> ready;
  for (const auto& [range, seconds] : seconds_) {
    const size_t middle = (range.first + range.second) / 2;
    if (range.second - range.first == 1) {
      ready.push_back(range);
    } else {
      parents[{range.first, middle}] = range;
      parents[{middle, range.second}] = range;
      waits[range] = 2;
    }
  }
  std::reverse(ready.begin(), ready.end());  // the first is taken first
  using Event = std::pair<double, Range>;    // end of a task
  std::priority_queue<Event, std::vector<Event>, std::greater<Event>> running;
  double now = 0;
  while (!ready.empty() || !running.empty()) {
    while (!ready.empty() && int(running.size()) < num_cores) {
      running.push({now + seconds_.at(ready.back()), ready.back()});
      ready.pop_back();
    }
    const auto [end, range] = running.top();
    running.pop();
    now = end;
    const auto parent = parents.find(range);
    if (parent != parents.end() && --waits[parent->second] == 0) {
      ready.push_back(parent->second);
    }
  }
  return now;
}

}  // namespace octacut
