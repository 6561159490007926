// The verdict on a mesh in words: what a run says at its end.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"
#include "core/verdict/judge_mesh.h"

namespace octacut {

// Lines of information, and warnings where the mesh is poor, with what would
// help. `views` are those of the verdict.
void ReportVerdict(const MeshVerdict& verdict,
                   const std::vector<View>& views,
                   const Context& context);

}  // namespace octacut
