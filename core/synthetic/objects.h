// The objects of synthetic scenes, by name. All stand around the origin with
// z upward and are about two units in size.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/synthetic/implicit.h"

namespace octacut {

struct ObjectParameters {
  double cup_depth = 1;      // of the cup's cavity, in its diameters
  double rod_radius = 0.04;  // of the rods
  // Of the fingers at their tips; they are half as thick again at the palm.
  double finger_radius = 0.065;

  void Check() const;  // throws OptionError
};

struct SyntheticObject {
  ImplicitShape shape;
  // Of the surface: handles (summed over the components), and components.
  int genus = 0;
  int num_components = 1;
};

// "sphere", "torus", "box" (rotated), "cup" (a round cavity), "rods" (three
// crossed cylinders), "fingers" (a hand), "touching_spheres" (joined by a
// narrow neck), "lump" (a smooth body with folds and relief), "example". Throws
// OptionError for other names.
SyntheticObject MakeObject(std::string_view name,
                           const ObjectParameters& parameters = {});
std::vector<std::string> ObjectNames();

}  // namespace octacut
