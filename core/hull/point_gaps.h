// Background of masks where the object's sparse points lie: dark or overexposed
// parts of the object that a threshold or a network takes for background.
#pragma once

#include "core/base/context.h"
#include "core/hull/repaired_scene.h"
#include "core/scene/scene.h"

namespace octacut {

// Fills the background of the masks around points of the scene. A point of the
// object is matter wherever it is seen from, so that no mask may show
// background there; and views that share a shadow, which would confirm each
// other's gaps, do not matter. Since single points may be wrong, three have to
// lie within a disc that holds twelve on average inside of the mask, and deeper
// in the background than `mask_tolerance` (pixels of the photographs) and two
// pixels. Nothing is filled in a view with so few points that the disc is
// larger than narrow parts of the object are, or where more than a twentieth of
// the object would be. Logs what it fills, and which masks it leaves alone for
// the last reason.
RepairedScene FillGapsAtPoints(const Scene& scene,
                               double mask_tolerance,
                               const Context& context);

}  // namespace octacut
