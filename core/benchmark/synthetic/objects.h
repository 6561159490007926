// The objects of synthetic scenes, by name. All stand around the origin with
// z upward and are about two units in size.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/benchmark/synthetic/implicit.h"

namespace octacut {

struct ObjectParameters {
  double cup_depth = 1;      // of the cup's cavity, in its diameters
  double rod_radius = 0.04;  // of the rods
  // The radius of the fingers at their tips; they are half as thick again at
  // the palm.
  double finger_radius = 0.065;
  // The width of the drapery's widest folds, and their depth in units of their
  // width. The narrowest folds are a fifth as wide. In photographs of 640 x 480
  // by the default rig, the default is 4 to 20 pixels.
  double fold_width = 0.09;
  double fold_depth = 2;

  void Check() const;  // throws OptionError
};

struct SyntheticObject {
  ImplicitShape shape;
  // Handles (summed over the components) and components of the surface.
  int genus = 0;
  int num_components = 1;
};

// "sphere", "torus", "box" (rotated), "cup" (a round cavity), "rods" (three
// crossed cylinders), "fingers" (a hand), "touching_spheres" (joined by a
// narrow neck), "lump" (a smooth body with folds and relief), "drapery" (a
// column of folds, see drapery.h), "vase" (a solid of revolution with a flat
// bottom, the same from all sides), "example". Throws OptionError for other
// names.
SyntheticObject MakeObject(std::string_view name,
                           const ObjectParameters& parameters = {});
std::vector<std::string> ObjectNames();

}  // namespace octacut
