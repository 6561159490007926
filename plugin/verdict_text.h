// The verdict on a mesh in words: what a run says at its end.
#pragma once

#include <string>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"
#include "core/verdict/judge_mesh.h"

namespace octacut {

// Sentences.
struct VerdictText {
  std::vector<std::string> findings;
  // Where the mesh is poor, each with what would help.
  std::vector<std::string> warnings;
};

// `views` are those of the verdict.
VerdictText DescribeVerdict(const MeshVerdict& verdict,
                            const std::vector<View>& views);

// To the log: findings as information, warnings as such.
void ReportVerdict(const VerdictText& text, const Context& context);

}  // namespace octacut
