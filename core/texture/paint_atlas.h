// Colours of the texels of an atlas.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/texture/atlas_layout.h"
#include "core/texture/blend_weights.h"
#include "core/texture/photographs.h"
#include "core/texture/seam_jumps.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

enum class ViewBlending {
  // The chosen view, cross-faded along seams, and the mean of it and of those
  // other views that differ from it by noise alone.
  kBest,
  kMedian,  // the weighted median of the views at each texel
};

struct PaintInput {
  const IndexedMesh& mesh;
  const AtlasLayout& layout;
  const VertexViews& fading;     // FadeViews
  const VertexViews& all_views;  // AllViews
  // What to add to a photograph's colour at each entry of `fading`.
  const std::vector<Eigen::Vector3f>& corrections;
  // Exposures of the views, by which their colours are divided where several
  // are compared.
  const std::vector<Eigen::Vector3f>& gains;
  const std::vector<Eigen::Vector3f>& fill;  // colours of vertices
  double texel_scale = 1;
  ViewBlending blending = ViewBlending::kBest;
};

struct PaintedPages {
  std::vector<TexturePage> pages;
  size_t num_texels = 0;  // within triangles
  // Those left without a colour: always 0, reported as a check.
  size_t num_unfilled = 0;
};

// One page after another; reads the photographs that a page needs, as many at a
// time as they allow. Takes 52 bytes per texel of a page. Texels
// outside of charts get the mean of what is around them.
PaintedPages PaintAtlas(const PaintInput& input,
                        const Photographs& photographs,
                        const Context& context,
                        SeamPoints* seams);

}  // namespace octacut
