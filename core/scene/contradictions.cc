#include "core/scene/contradictions.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "core/scene/silhouette_box.h"

namespace octacut {
namespace {

// At most one in so many of the views may be wrong, so that the others can
// tell.
constexpr size_t kMaxWrongDivisor = 3;
// The other views that lose most to a view do not count: one, and one in so
// many.
constexpr size_t kIgnoredDivisor = 20;
constexpr size_t kManyViews = 100;
// A view contradicts the others when its shares (ViewFit), over these, add up
// to more than 1, and to so many times as much as the median view's: where all
// masks are poor, none stands out.
constexpr double kMaxUnexplained = 0.05;
constexpr double kMaxTaken = 0.0025;
constexpr double kOverMedian = 4;
// From here on a mask shows another object, or from elsewhere; below it may be
// that of the object and of what touches it.
constexpr double kGraveUnexplained = 0.2;

ViewBits ToBits(const std::vector<bool>& active, size_t num_words) {
  ViewBits bits(num_words, 0);
  for (size_t v = 0; v < active.size(); ++v) {
    if (active[v]) {
      bits[v / 64] |= uint64_t{1} << v % 64;
    }
  }
  return bits;
}

// The fewest of the active views that deny a point of the line; `common`
// becomes those that deny every such point.
size_t FewestDenials(const SightLine& line,
                     const ViewBits& active,
                     ViewBits* common) {
  const size_t num_words = active.size();
  size_t fewest = std::numeric_limits<size_t>::max();
  for (size_t k = 0; k < line.denials.size(); k += num_words) {
    size_t count = 0;
    for (size_t w = 0; w < num_words; ++w) {
      count += size_t(std::popcount(line.denials[k + w] & active[w]));
    }
    if (count < fewest) {
      fewest = count;
      *common = active;
    }
    if (count == fewest) {
      for (size_t w = 0; w < num_words; ++w) {
        (*common)[w] &= line.denials[k + w];
      }
    }
  }
  return fewest;
}

// What the lines of one view say.
struct Testimony {
  double unexplained = 0;
  std::vector<double> taken;  // by each of the views
};

Testimony TestimonyOf(const std::vector<SightLine>& lines,
                      const ViewBits& active,
                      size_t num_views,
                      size_t max_wrong) {
  Testimony result;
  result.taken.resize(num_views);
  const double share = 1 / double(std::max<size_t>(1, lines.size()));
  ViewBits common(active.size());
  for (const SightLine& line : lines) {
    const size_t fewest = FewestDenials(line, active, &common);
    if (fewest > max_wrong) {
      result.unexplained += share;
    } else if (fewest > 0) {
      for (size_t w = 0; w < common.size(); ++w) {
        for (uint64_t rest = common[w]; rest != 0; rest &= rest - 1) {
          result.taken[w * 64 + size_t(std::countr_zero(rest))] += share;
        }
      }
    }
  }
  return result;
}

// Mean of all but the largest.
double MeanOfMost(std::vector<double> values) {
  const size_t ignored = 1 + values.size() / kIgnoredDivisor;
  if (values.size() <= ignored) {
    return 0;
  }
  std::sort(values.begin(), values.end());
  values.resize(values.size() - ignored);
  return std::accumulate(values.begin(), values.end(), 0.0) /
         double(values.size());
}

// Sorts out the views, the worst first.
class Sorter {
 public:
  explicit Sorter(const SightLines& lines)
      : lines_(lines), active_(lines.of_views.size(), true) {}

  // Points that no more than max_wrong views deny may be the object. With many
  // allowed to be wrong no good view is in doubt as long as there are fewer bad
  // ones, and grossly wrong views are found; with fewer, slighter faults are.
  Contradictions Run() {
    const size_t count = active_.size();
    for (size_t max_wrong = std::max<size_t>(1, count / kMaxWrongDivisor);
         max_wrong > 0;
         --max_wrong) {
      while (LeaveOutWorst(max_wrong)) {
      }
    }
    TakeBackGood();
    Contradictions result;
    result.is_judged = true;
    for (size_t v = 0; v < count; ++v) {
      if (!active_[v]) {
        const ViewFit fit = FitAmongActive(v);
        result.views.push_back(
            {v,
             fit,
             fit.taken > kMaxTaken || fit.unexplained > kGraveUnexplained});
      }
    }
    const std::vector<ViewFit> fits = FitOfViews(lines_, active_, 1);
    for (size_t v = 0; v < count; ++v) {
      if (active_[v]) {
        ViewFit& largest = result.largest_left;
        largest.unexplained =
            std::max(largest.unexplained, fits[v].unexplained);
        largest.taken = std::max(largest.taken, fits[v].taken);
      }
    }
    return result;
  }

 private:
  double Score(const ViewFit& fit) const {
    return fit.unexplained / kMaxUnexplained + fit.taken / kMaxTaken;
  }

  bool LeaveOutWorst(size_t max_wrong) {
    const std::vector<ViewFit> fits = FitOfViews(lines_, active_, max_wrong);
    std::vector<std::pair<double, size_t>> scores;
    for (size_t v = 0; v < active_.size(); ++v) {
      if (active_[v]) {
        scores.emplace_back(Score(fits[v]), v);
      }
    }
    std::sort(scores.begin(), scores.end());
    const auto [worst, view] = scores.back();
    const double limit = Limit(scores[scores.size() / 2].first);
    // Three are too few to tell anything.
    if (worst <= limit || scores.size() <= 3) {
      return false;
    }
    active_[view] = false;
    return true;
  }

  double Limit(double median_score) const {
    return std::max(1.0, kOverMedian * median_score);
  }

  ViewFit FitAmongActive(size_t view) const {
    std::vector<bool> active = active_;
    active[view] = true;
    return FitOfViews(lines_, active, 1)[view];
  }

  // Those that were taken for bad while bad ones were still among the others.
  void TakeBackGood() {
    for (size_t v = 0; v < active_.size(); ++v) {
      if (!active_[v] && Score(FitAmongActive(v)) <= 1) {
        active_[v] = true;
      }
    }
  }

  const SightLines& lines_;
  std::vector<bool> active_;
};

// The box that holds the object however many views are wrong; where that is
// unbounded, if fewer are.
Eigen::AlignedBox3d SearchedBox(const std::vector<View>& views,
                                const Context& context) {
  const int level = views.size() > kManyViews ? 4 : 5;
  for (size_t max_wrong = std::max<size_t>(1, views.size() / kMaxWrongDivisor);
       max_wrong > 0;
       max_wrong /= 2) {
    const Eigen::AlignedBox3d box =
        BoxOfMostSilhouettes(views, max_wrong, level, context);
    if (!box.isEmpty()) {
      return box;
    }
  }
  return {};
}

}  // namespace

std::vector<ViewFit> FitOfViews(const SightLines& lines,
                                const std::vector<bool>& active,
                                size_t max_wrong) {
  const ViewBits bits = ToBits(active, lines.num_words);
  const size_t count = active.size();
  std::vector<ViewFit> fits(count);
  std::vector<std::vector<double>> taken(count);
  for (size_t v = 0; v < count; ++v) {
    const Testimony testimony =
        TestimonyOf(lines.of_views[v], bits, count, max_wrong);
    fits[v].unexplained = testimony.unexplained;
    for (size_t u = 0; active[v] && u < count; ++u) {
      if (u != v) {
        taken[u].push_back(testimony.taken[u]);
      }
    }
  }
  for (size_t v = 0; v < count; ++v) {
    fits[v].taken = MeanOfMost(std::move(taken[v]));
  }
  return fits;
}

Contradictions FindContradictions(const std::vector<View>& views,
                                  const Context& context) {
  // With three views, any of them could be the wrong one.
  if (views.size() <= 3) {
    return {};
  }
  const Eigen::AlignedBox3d box = SearchedBox(views, context);
  if (box.isEmpty()) {
    return {};
  }
  const SightLines lines = TraceSightLines(views, box, context);
  return Sorter(lines).Run();
}

}  // namespace octacut
