// Textures a mesh from photographs: the step as a whole.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/base/error.h"
#include "core/mesh/indexed_mesh.h"
#include "core/texture/atlas_layout.h"
#include "core/texture/paint_atlas.h"
#include "core/texture/photographs.h"
#include "core/texture/seam_jumps.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

struct TexturingOptions {
  ViewBlending view_blending = ViewBlending::kBest;
  // Pages have at most so many texels along a side, and there are at most so
  // many; 8192 is what graphics cards of today take.
  int texture_size = 8192;
  int max_pages = 16;
  // Texels per pixel of the photographs.
  double texel_scale = 1;

  void Check() const;  // throws OptionError
};

struct TextureSummary {
  size_t num_triangles = 0;
  size_t num_unseen = 0;   // triangles that no photograph shows
  double unseen_area = 0;  // share of the surface
  size_t num_unsure = 0;   // seen near a mask's border or at a low angle only
  size_t num_charts = 0;
  size_t num_unseen_charts = 0;  // of triangles that no photograph shows
  size_t num_pages = 0;
  size_t num_texels = 0;  // within triangles
  size_t num_unfilled_texels = 0;
  size_t page_texels = 0;  // of the pages as a whole
  double energy = 0;       // of the choice of views, pixels
  // For each photograph: the triangles textured from it, and its exposure
  // (blue, green, red) relative to the mean.
  std::vector<size_t> triangles_of_view;
  std::vector<Eigen::Vector3f> gains;
  SeamJumps seams;
};

struct TexturingResult {
  TexturedMesh textured;
  AtlasLayout layout;  // where its pages show which triangle
  TextureSummary summary;
};

// No photograph shows any of the mesh.
class MeshNotSeenError : public InputError {
 public:
  using InputError::InputError;
};

// The mesh may be open or closed, in the frame of the cameras. A photograph is
// chosen for each triangle (FindFaceViews, ComputeViewCosts, ChooseLabels),
// connected triangles of one photograph become charts (MakeCharts, PackCharts),
// colours are adjusted along their borders (LevelColors, FadeViews) and painted
// (PaintAtlas); what no photograph shows continues its surroundings
// (FillColors). The same bytes for any number of threads.
//
// Throws MeshNotSeenError when no triangle is seen, OptionError when the pages
// do not suffice, and InputError when the mesh has no triangles or when there
// are no photographs or more than 65535.
TexturingResult TextureMesh(const IndexedMesh& mesh,
                            const Photographs& photographs,
                            const TexturingOptions& options,
                            const Context& context);

}  // namespace octacut
