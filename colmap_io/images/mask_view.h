// An image's mask as a small view, from which the region is found.
#pragma once

#include "colmap_io/images/mask_content.h"
#include "colmap_io/images/mask_geometry.h"
#include "colmap_io/images/view_files.h"
#include "colmap_io/images/view_window.h"
#include "colmap_io/model/camera_models.h"
#include "core/scene/scene.h"

namespace octacut {

struct MaskView {
  View view;            // without image; empty for a mask without outline
  SparseCamera camera;  // what the mask was made with
  MaskContent content = MaskContent::kOutline;
  bool object_all_around = false;  // the mask's border is all object
};

// Reads the mask of an image and reduces it (ReduceMask). `frame` is that of
// the image's camera. Thread safe. Throws InputError when the mask cannot be
// read or fits no camera.
MaskView ReadMaskView(const ViewFiles& files,
                      const Frame& frame,
                      const MaskCameras& mask_cameras);

}  // namespace octacut
