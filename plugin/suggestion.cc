#include "plugin/suggestion.h"

#include <algorithm>
#include <vector>

namespace octacut {

size_t EditDistance(std::string_view a, std::string_view b) {
  // Three rows of the usual table: the two before and the current one.
  std::vector<size_t> before(b.size() + 1);
  std::vector<size_t> previous(b.size() + 1);
  std::vector<size_t> current(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) {
    previous[j] = j;
  }
  for (size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replaced, previous[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before[j - 2] + 1);
      }
    }
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[b.size()];
}

std::string NearestName(std::string_view name,
                        std::span<const std::string> candidates) {
  std::string nearest;
  size_t nearest_distance = name.size() / 3 + 1;
  for (const std::string& candidate : candidates) {
    size_t distance = EditDistance(name, candidate);
    const size_t dot = candidate.find('.');
    if (dot != std::string::npos) {
      // The missing group costs one.
      const std::string_view field =
          std::string_view(candidate).substr(dot + 1);
      distance = std::min(distance, EditDistance(name, field) + 1);
    }
    if (distance < nearest_distance) {
      nearest_distance = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace octacut
