// Scenes that many tests look at.
#pragma once

#include <map>

#include "core/benchmark/synthetic/synthetic_scene.h"

namespace octacut::testing {

// The scene of `spec_of(key)`, a lambda that captures nothing, rendered at the
// first call with this key; each lambda has a store of its own. Pixels are the
// caller's, who may change them.
template <typename Key>
SyntheticScene RenderOnce(const Key& key, const auto& spec_of) {
  static std::map<Key, SyntheticScene> rendered;
  auto place = rendered.find(key);
  if (place == rendered.end()) {
    place = rendered.emplace(key, MakeScene(spec_of(key), Context(2))).first;
  }
  SyntheticScene scene = place->second;
  for (SyntheticView& view : scene.views) {
    view.image = view.image.clone();
    view.mask = view.mask.clone();
  }
  return scene;
}

}  // namespace octacut::testing
