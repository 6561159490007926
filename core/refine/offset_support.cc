#include "core/refine/offset_support.h"

#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/ramp.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 8192;
// Steps between neighbouring places, two pixels each, to those that are asked:
// patches of seven pixels do not overlap there.
constexpr int kFirstRing = 4;
constexpr int kLastRing = 5;
// Shares of supporting places: up to the first, offsets are chance, from the
// second on they are believed (docs/refinement.md).
constexpr float kChance = 0.3f;
constexpr float kSupported = 0.6f;

// The places that are kFirstRing .. kLastRing steps away from another one.
class Surroundings {
 public:
  explicit Surroundings(const VertexCorners& neighbors, size_t num_places)
      : neighbors_(neighbors), reached_from_(num_places, kNowhere) {}

  template <typename Visit>
  void ForEach(uint32_t place, const Visit& visit) {
    front_.assign(1, place);
    reached_from_[place] = place;
    for (int ring = 1; ring <= kLastRing; ++ring) {
      next_.clear();
      for (const uint32_t from : front_) {
        for (const uint32_t to : neighbors_.Of(from)) {
          if (reached_from_[to] != place) {
            reached_from_[to] = place;
            next_.push_back(to);
            if (ring >= kFirstRing) {
              visit(to);
            }
          }
        }
      }
      front_.swap(next_);
    }
  }

 private:
  static constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();

  const VertexCorners& neighbors_;
  std::vector<uint32_t> reached_from_;
  std::vector<uint32_t> front_;
  std::vector<uint32_t> next_;
};

}  // namespace

void WeighBySupport(const VertexCorners& neighbors,
                    const std::vector<uint8_t>& is_seen,
                    double tolerance,
                    const Context& context,
                    std::vector<OffsetMeasurement>* measurements) {
  const std::vector<OffsetMeasurement>& all = *measurements;
  std::vector<float> support(all.size(), 1);
  ParallelFor(context, all.size(), kGrain, [&](size_t begin, size_t end) {
    Surroundings surroundings(neighbors, all.size());
    for (size_t i = begin; i < end; ++i) {
      if (!(all[i].weight > 0)) {
        continue;
      }
      int num_seen = 0;
      int num_alike = 0;
      surroundings.ForEach(uint32_t(i), [&](uint32_t other) {
        num_seen += is_seen[other];
        num_alike +=
            all[other].weight > 0 &&
                    std::abs(all[other].offset - all[i].offset) <= tolerance
                ? 1
                : 0;
      });
      if (num_seen > 0) {
        support[i] =
            Ramp(float(num_alike) / float(num_seen), kChance, kSupported);
      }
    }
  });
  for (size_t i = 0; i < support.size(); ++i) {
    (*measurements)[i].weight *= support[i];
  }
}

}  // namespace octacut
