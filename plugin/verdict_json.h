// The verdict on a mesh as a member of a report.
#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "core/verdict/judge_mesh.h"
#include "plugin/option_value.h"
#include "plugin/verdict_text.h"

namespace octacut {

// `words` are what DescribeVerdict has for it, `views` those of the verdict.
Json VerdictToJson(const MeshVerdict& verdict,
                   const VerdictText& words,
                   const std::vector<View>& views);

}  // namespace octacut
