// The bundled example: a horned beast that is a vessel, as bronze founders
// made them. It has what is hard to reconstruct: a cavity as deep as its
// mouth is wide, a handle (genus 1), thin legs and antlers, fine relief.
#pragma once

#include "core/benchmark/synthetic/implicit.h"

namespace octacut {

// About 2.3 x 1.2 x 2.3 units; it looks along x, z is upward. The antlers'
// tips are some 0.06 units thick.
ImplicitShape MakeBeastEwer();

}  // namespace octacut
