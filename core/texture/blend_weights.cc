#include "core/texture/blend_weights.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "core/base/parallel.h"
#include "core/texture/charts.h"

namespace octacut {
namespace {

constexpr size_t kVerticesAtOnce = 4096;
// A view that costs more than this (ViewCosts) takes no part in cross-fades: it
// would blur, or bring a highlight in.
constexpr float kMaxFadeCost = 0.75f;
// The share of the best resolution with which `view` shows a triangle: 0 where
// it does not, or in another colour than the others.
float Suitability(const FaceChoice& chosen, size_t face, uint32_t view) {
  const std::span<const FaceView> views = chosen.views.Of(face);
  for (size_t i = 0; i < views.size(); ++i) {
    if (views[i].view == view) {
      return views[i].is_sure ? std::max(0.0f, 1 - chosen.costs.costs[face][i])
                              : 0.0f;
    }
  }
  return 0;
}

VertexViews ToVertexViews(size_t num_vertices,
                          std::vector<VertexView> entries) {
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return std::tie(a.vertex, a.view) < std::tie(b.vertex, b.view);
  });
  VertexViews result;
  result.first.assign(num_vertices + 1, 0);
  for (const VertexView& entry : entries) {
    ++result.first[entry.vertex + 1];
  }
  for (size_t v = 0; v < num_vertices; ++v) {
    result.first[v + 1] += result.first[v];
  }
  result.entries = std::move(entries);
  return result;
}

// Distances, in pixels, from the borders of the region of one view after
// another.
class Fader {
 public:
  Fader(const IndexedMesh& mesh,
        const VertexCorners& vertex_faces,
        const FaceChoice& chosen)
      : mesh_(mesh),
        vertex_faces_(vertex_faces),
        chosen_(chosen),
        density_(mesh.positions.size(), 0),
        distance_(mesh.positions.size()),
        stamp_(mesh.positions.size(), 0) {
    for (size_t f = 0; f < mesh.triangles.size(); ++f) {
      for (const uint32_t v : mesh.triangles[f]) {
        density_[v] = std::max(density_[v], chosen.costs.resolution[f]);
      }
    }
  }

  VertexViews Run(const Context& context) {
    CollectOwn();
    Phase phase(context, "cross-fades", sources_.size());
    for (const auto& [view, vertices] : sources_) {
      Spread(view, vertices);
      phase.Advance();
    }
    std::vector<VertexView> entries;
    for (const VertexView& own : own_) {
      entries.push_back(own);
    }
    MergeFaded(&entries);
    return ToVertexViews(mesh_.positions.size(), std::move(entries));
  }

 private:
  // Entries of the views chosen around each vertex with weight 1, and the
  // vertices at which several meet.
  void CollectOwn() {
    std::vector<std::pair<uint32_t, uint32_t>> sources;
    std::vector<uint32_t> around;
    for (uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      around.clear();
      for (const uint32_t f : vertex_faces_.Of(v)) {
        if (chosen_.chosen[f] != kNoView) {
          around.push_back(chosen_.chosen[f]);
        }
      }
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      for (const uint32_t view : around) {
        own_.push_back({v, view, 1});
        if (around.size() > 1) {
          sources.emplace_back(view, v);
        }
      }
    }
    std::sort(sources.begin(), sources.end());
    for (const auto& [view, vertex] : sources) {
      if (sources_.empty() || sources_.back().first != view) {
        sources_.push_back({view, {}});
      }
      sources_.back().second.push_back(vertex);
    }
  }

  bool MayShow(uint32_t v, uint32_t view) const {
    for (const uint32_t f : vertex_faces_.Of(v)) {
      if (chosen_.chosen[f] != view && chosen_.chosen[f] != kNoView &&
          Suitability(chosen_, f, view) < 1 - kMaxFadeCost) {
        return false;
      }
    }
    return true;
  }

  bool IsInside(uint32_t v, uint32_t view) const {
    for (const uint32_t f : vertex_faces_.Of(v)) {
      if (chosen_.chosen[f] == view) {
        return true;
      }
    }
    return false;
  }

  // Dijkstra's search from the border, on both sides, kFadePixels far.
  void Spread(uint32_t view, const std::vector<uint32_t>& border) {
    ++now_;
    using Item = std::pair<float, uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    const auto reach = [&](float distance, uint32_t v) {
      if (stamp_[v] != now_ || distance < distance_[v]) {
        stamp_[v] = now_;
        distance_[v] = distance;
        queue.emplace(distance, v);
      }
    };
    for (const uint32_t v : border) {
      reach(0, v);
    }
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (distance > distance_[v]) {
        continue;
      }
      AddFaded(view, v, distance);
      for (const uint32_t f : vertex_faces_.Of(v)) {
        for (const uint32_t other : mesh_.triangles[f]) {
          const float next =
              distance +
              float((mesh_.positions[other] - mesh_.positions[v]).norm()) *
                  (density_[v] + density_[other]) / 2;
          // No view fades into what no view shows, which has no pixels.
          if (other != v && density_[other] > 0 && next < kFadePixels) {
            reach(next, other);
          }
        }
      }
    }
  }

  void AddFaded(uint32_t view, uint32_t v, float distance) {
    const float part = distance / (2 * kFadePixels);
    const bool inside = IsInside(v, view);
    const float weight = inside ? 0.5f + part : 0.5f - part;
    if (MayShow(v, view)) {
      faded_.push_back({v, view, weight});
    } else if (inside) {
      faded_.push_back({v, view, 0});
    }
  }

  // Takes the faded weights for those of vertices that have some.
  void MergeFaded(std::vector<VertexView>* entries) const {
    std::vector<VertexView> faded = faded_;
    std::sort(faded.begin(), faded.end(), [](const auto& a, const auto& b) {
      return std::tie(a.vertex, a.view) < std::tie(b.vertex, b.view);
    });
    // Own entries are in that order, too.
    size_t next = 0;
    for (const VertexView& entry : faded) {
      while (next < own_.size() &&
             std::tie(own_[next].vertex, own_[next].view) <
                 std::tie(entry.vertex, entry.view)) {
        ++next;
      }
      if (next < own_.size() && own_[next].vertex == entry.vertex &&
          own_[next].view == entry.view) {
        (*entries)[next].weight = entry.weight;
      } else {
        entries->push_back(entry);
      }
    }
  }

  const IndexedMesh& mesh_;
  const VertexCorners& vertex_faces_;
  const FaceChoice& chosen_;
  std::vector<float> density_;  // pixels per unit of length, of vertices
  std::vector<VertexView> own_;
  std::vector<VertexView> faded_;
  std::vector<std::pair<uint32_t, std::vector<uint32_t>>> sources_;
  std::vector<float> distance_;
  std::vector<uint32_t> stamp_;
  uint32_t now_ = 0;
};

}  // namespace

int64_t VertexViews::Find(uint32_t vertex, uint32_t view) const {
  for (uint32_t i = first[vertex]; i < first[vertex + 1]; ++i) {
    if (entries[i].view == view) {
      return i;
    }
  }
  return -1;
}

VertexViews FadeViews(const IndexedMesh& mesh,
                      const VertexCorners& vertex_faces,
                      const FaceChoice& chosen,
                      const Context& context) {
  return Fader(mesh, vertex_faces, chosen).Run(context);
}

VertexViews AllViews(const IndexedMesh& mesh,
                     const VertexCorners& vertex_faces,
                     const FaceChoice& chosen,
                     const Context& context) {
  const size_t num_vertices = mesh.positions.size();
  std::vector<std::vector<VertexView>> chunks(
      NumChunks(num_vertices, kVerticesAtOnce));
  ParallelChunks(
      context,
      num_vertices,
      kVerticesAtOnce,
      [&](size_t chunk, size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          const std::span<const uint32_t> faces = vertex_faces.Of(v);
          std::vector<uint32_t> views;
          for (const uint32_t f : faces) {
            for (const FaceView& view : chosen.views.Of(f)) {
              views.push_back(view.view);
            }
          }
          std::sort(views.begin(), views.end());
          views.erase(std::unique(views.begin(), views.end()), views.end());
          for (const uint32_t view : views) {
            float least = 1;
            for (const uint32_t f : faces) {
              if (chosen.chosen[f] != kNoView) {
                least = std::min(least, Suitability(chosen, f, view));
              }
            }
            const float weight = std::max(0.0f, least - kMinShare);
            if (weight > 0) {
              chunks[chunk].push_back({uint32_t(v), view, weight * weight});
            }
          }
        }
      });
  std::vector<VertexView> entries;
  for (const auto& chunk : chunks) {
    entries.insert(entries.end(), chunk.begin(), chunk.end());
  }
  return ToVertexViews(num_vertices, std::move(entries));
}

}  // namespace octacut
