// More threads than cores, for those who ask for them.
#pragma once

#include <functional>

namespace octacut {

// Calls body() such that the parallel loops it runs may use `num_threads`
// threads even where there are fewer cores; outside of it they use one a core
// at most. Within another WithThreads the smaller number counts. Passes on what
// body throws.
void WithThreads(int num_threads, const std::function<void()>& body);

}  // namespace octacut
